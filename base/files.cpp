#include "base/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <iostream>
#include <system_error>
#include <thread>
#include <vector>

#include "base/error.h"

namespace amble {
namespace {

[[noreturn]] void failOpening(const std::string& name, const FileKind& kind) {
  throw InputError(name, 0, std::string("cannot be opened: ") + std::strerror(errno), kind.name);
}

[[noreturn]] void failSize(const std::string& name, const FileKind& kind) {
  throw InputError(name, 0, "is larger than " + sizeText(kind.limit),
                   std::string(kind.name) + " of at most that");
}

class OpenPipe {
 public:
  explicit OpenPipe(const std::string& name)
      : handle_(::open(name.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {}
  ~OpenPipe() {
    if (handle_ >= 0) ::close(handle_);
  }
  OpenPipe(const OpenPipe&) = delete;
  OpenPipe& operator=(const OpenPipe&) = delete;
  int handle() const { return handle_; }
  void waitFromNowOn() { ::fcntl(handle_, F_SETFL, 0); }

 private:
  const int handle_;
};

// Opening a pipe as a file would wait for a writer, for ever if need be.
std::string readPipe(const std::string& name, const FileKind& kind) {
  OpenPipe pipe(name);
  if (pipe.handle() < 0) failOpening(name, kind);
  constexpr auto kLook = std::chrono::milliseconds(20);
  std::vector<char> block(1 << 16);
  std::string bytes;
  for (auto waited = std::chrono::milliseconds(0);;) {
    const ssize_t count = ::read(pipe.handle(), block.data(), block.size());
    if (count > 0) {
      bytes.append(block.data(), static_cast<size_t>(count));
      if (bytes.size() > kind.limit) failSize(name, kind);
    } else if (count == 0 && !bytes.empty()) {
      return bytes;
    } else if (count < 0 && errno == EAGAIN) {  // somebody is about to write
      pipe.waitFromNowOn();
    } else if (count < 0) {
      throw InputError(name, 0, std::string("cannot be read: ") + std::strerror(errno), kind.name);
    } else if ((waited += kLook) > std::chrono::seconds(kWriterPatience)) {
      throw InputError(name, 0, "nobody writes to the pipe",
                       "a writer within " + std::to_string(kWriterPatience) + " s");
    } else {
      std::this_thread::sleep_for(kLook);
    }
  }
}

bool isPipe(const std::filesystem::path& file) {
  struct stat there = {};
  return ::stat(file.c_str(), &there) == 0 && S_ISFIFO(there.st_mode);
}

}  // namespace

std::string readWholeStream(std::istream& in, const std::string& name, const FileKind& kind) {
  constexpr size_t kBlock = 1 << 16;
  std::vector<char> block(std::min(kBlock, kind.limit + 1));
  std::string bytes;
  const std::streamsize ready = in.rdbuf()->in_avail();  // of a file, all; -1 where none knows
  if (ready > 0) bytes.reserve(std::min(static_cast<size_t>(ready), kind.limit));
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0) {
    bytes.append(block.data(), static_cast<size_t>(in.gcount()));
    if (bytes.size() > kind.limit) failSize(name, kind);
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
  if (isPipe(file)) return readPipe(file.string(), kind);
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) failOpening(file.string(), kind);
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
