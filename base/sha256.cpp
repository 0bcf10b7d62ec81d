#include "base/sha256.h"

#include <sha2.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <vector>

#include "base/error.h"

namespace amble {
namespace {

void update(SHA2_CTX& context, std::string_view bytes) {
  SHA256Update(&context, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

std::string hexDigest(SHA2_CTX& context) {
  std::array<char, SHA256_DIGEST_STRING_LENGTH> digits{};  // ends in a zero
  return SHA256End(&context, digits.data());
}

}  // namespace

std::string sha256(std::string_view bytes) {
  SHA2_CTX context;
  SHA256Init(&context);
  update(context, bytes);
  return hexDigest(context);
}

std::string sha256OfFile(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file.string(), 0, "cannot be opened", "a file that can be read");
  SHA2_CTX context;
  SHA256Init(&context);
  std::vector<char> piece(1 << 16);
  while (in) {
    in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    update(context, {piece.data(), static_cast<size_t>(in.gcount())});
  }
  if (in.bad()) throw InputError(file.string(), 0, "cannot be read", "a file that can be read");
  return hexDigest(context);
}

}  // namespace amble
