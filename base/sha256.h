/// SHA-256 (FIPS 180-4): which bytes a report speaks of.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace amble {

/// Bytes in, in pieces of any size; the digest out.
class Sha256 {
 public:
  void update(std::string_view bytes);
  /// 64 lower-case hexadecimal digits. The object has said all that it knows then: ask once.
  std::string hexDigest();

 private:
  void process(std::span<const std::uint8_t, 64> block);

  std::array<std::uint32_t, 8> state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                         0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<std::uint8_t, 64> block_{};
  std::uint64_t bytes_ = 0;
};

std::string sha256(std::string_view bytes);
/// @throws InputError if the file cannot be read.
std::string sha256OfFile(const std::filesystem::path& file);

}  // namespace amble
