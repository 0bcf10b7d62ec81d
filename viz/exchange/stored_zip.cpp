#include "viz/exchange/stored_zip.h"

#include <cstdint>

#include "base/error.h"

namespace amble {
namespace {

constexpr std::uint32_t kLocalHeader = 0x04034b50, kDirectory = 0x02014b50;
constexpr size_t kHeaderLength = 30;  // without name and extra field

}  // namespace

std::vector<ZipEntry> readStoredZip(std::string_view zip, const std::string& file) {
  const auto fail = [&](const std::string& problem) {
    throw InputError(file, 0, problem, "a ZIP of stored entries, as NumPy's savez writes it");
  };
  const auto number = [&](size_t at, size_t bytes) {
    if (at + bytes > zip.size()) fail("is cut off");
    std::uint32_t value = 0;
    for (size_t i = 0; i < bytes; ++i)
      value |= static_cast<std::uint32_t>(static_cast<unsigned char>(zip[at + i])) << (8 * i);
    return value;
  };
  std::vector<ZipEntry> entries;
  size_t at = 0;
  for (; number(at, 4) == kLocalHeader;) {
    const size_t size = number(at + 18, 4), name = number(at + 26, 2), extra = number(at + 28, 2);
    if (number(at + 8, 2) != 0) fail("has an entry that is deflated");
    const size_t begin = at + kHeaderLength + name + extra;
    if (begin + size > zip.size()) fail("is cut off");
    entries.push_back(
        {std::string(zip.substr(at + kHeaderLength, name)), std::string(zip.substr(begin, size))});
    at = begin + size;
  }
  if (number(at, 4) != kDirectory) fail("is no ZIP");
  return entries;
}

}  // namespace amble
