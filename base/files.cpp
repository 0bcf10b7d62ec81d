#include "base/files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <system_error>
#include <vector>

#include "base/error.h"

namespace amble {

std::string readWholeStream(std::istream& in, const std::string& name, const FileKind& kind) {
  constexpr size_t kBlock = 1 << 16;
  std::vector<char> block(std::min(kBlock, kind.limit + 1));
  std::string bytes;
  const std::streamsize ready = in.rdbuf()->in_avail();  // of a file, all; -1 where none knows
  if (ready > 0) bytes.reserve(std::min(static_cast<size_t>(ready), kind.limit));
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0) {
    bytes.append(block.data(), static_cast<size_t>(in.gcount()));
    if (bytes.size() <= kind.limit) continue;
    throw InputError(name, 0, "is larger than " + sizeText(kind.limit),
                     std::string(kind.name) + " of at most that");
  }
  if (in.bad()) throw InputError(name, 0, "cannot be read", kind.name);
  return bytes;
}

std::string readWholeFile(const std::filesystem::path& file, const FileKind& kind) {
  if (file == "-") return readWholeStream(std::cin, "-", kind);
  std::error_code unknown;
  if (std::filesystem::is_directory(file, unknown)) {
    throw InputError(file.string(), 0, "is a folder", kind.name);
  }
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw InputError(file.string(), 0, std::string("cannot be opened: ") + std::strerror(errno),
                     kind.name);
  }
  return readWholeStream(in, file.string(), kind);
}

std::string sizeText(size_t bytes) {
  constexpr size_t kUnit = 1024;
  if (bytes > 0 && bytes % (kUnit * kUnit) == 0) {
    return std::to_string(bytes / (kUnit * kUnit)) + " MiB";
  }
  if (bytes > 0 && bytes % kUnit == 0) return std::to_string(bytes / kUnit) + " KiB";
  return std::to_string(bytes) + " bytes";
}

}  // namespace amble
