#include "base/sha256.h"

#include <nettle/base16.h>
#include <nettle/sha2.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <vector>

#include "base/error.h"

namespace amble {
namespace {

// Nettle asks the processor whether it has instructions for this.
class Sha256 {
 public:
  Sha256() { sha256_init(&context_); }

  void update(std::string_view bytes) {
    sha256_update(&context_, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  }

  std::string hexDigest() {
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest;
    sha256_digest(&context_, digest.size(), digest.data());
    std::string digits(BASE16_ENCODE_LENGTH(digest.size()), '0');
    base16_encode_update(digits.data(), digest.size(), digest.data());
    return digits;
  }

 private:
  sha256_ctx context_;
};

}  // namespace

std::string sha256(std::string_view bytes) {
  Sha256 sum;
  sum.update(bytes);
  return sum.hexDigest();
}

std::string sha256OfFile(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file.string(), 0, "cannot be opened", "a file that can be read");
  Sha256 sum;
  std::vector<char> piece(1 << 16);
  while (in) {
    in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    sum.update({piece.data(), static_cast<size_t>(in.gcount())});
  }
  if (in.bad()) throw InputError(file.string(), 0, "cannot be read", "a file that can be read");
  return sum.hexDigest();
}

}  // namespace amble
