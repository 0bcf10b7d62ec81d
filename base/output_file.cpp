#include "base/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>
#include <system_error>

#include "base/error.h"

namespace amble {
namespace {

[[noreturn]] void failWriting(const std::filesystem::path& file, int error) {
  // A stream does not always say why; without a reason a full disk is the likely one.
  throw InputError(file.string(), 0,
                   std::string("cannot be written: ") + std::strerror(error != 0 ? error : ENOSPC),
                   "a writable file");
}

// Removes the half-written file unless it was renamed.
class TemporaryFile {
 public:
  // A name that no other thread or program has, in the same folder, since a rename works within a
  // disk only.
  explicit TemporaryFile(const std::filesystem::path& file) {
    static std::atomic<unsigned> count{0};
    for (int error = EEXIST; error == EEXIST;) {
      path_ = file;
      path_ += ".part-" + std::to_string(::getpid()) + "-" + std::to_string(count++);
      const int handle = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      error = handle < 0 ? errno : 0;
      if (handle >= 0) ::close(handle);
      if (error != 0 && error != EEXIST) failWriting(file, error);
    }
  }
  ~TemporaryFile() {
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  void renameTo(const std::filesystem::path& file) {
    if (::rename(path_.c_str(), file.c_str()) != 0) failWriting(file, errno);
    path_.clear();
  }

 private:
  std::filesystem::path path_;
};

void writeStream(std::ostream& out, const std::filesystem::path& file,
                 const std::function<void(std::ostream&)>& write) {
  write(out);
  out.flush();
  if (out) return;
  out.clear();  // once more, for the reason: errno may have changed since
  errno = 0;
  out << ' ' << std::flush;
  failWriting(file, errno);
}

// A device or a pipe (`/dev/stdout`, `/dev/full`) must not be replaced by a file.
bool isDevice(const std::filesystem::path& file) {
  std::error_code unknown;
  const auto status = std::filesystem::status(file, unknown);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
         !std::filesystem::is_directory(status);
}

// Writes all of it beside `file`, or at once where there is no beside. @return null in that case
std::unique_ptr<TemporaryFile> prepare(const std::filesystem::path& file,
                                       const std::function<void(std::ostream&)>& write) {
  if (file == "-") {
    writeStream(std::cout, "-", write);
    return nullptr;
  }
  if (isDevice(file)) {
    std::ofstream device(file, std::ios::binary);
    if (!device) failWriting(file, errno);
    writeStream(device, file, write);
    return nullptr;
  }
  std::error_code unknown;
  if (std::filesystem::is_directory(file, unknown)) failWriting(file, EISDIR);
  auto temporary = std::make_unique<TemporaryFile>(file);
  std::ofstream out(temporary->path(), std::ios::binary | std::ios::trunc);
  if (!out) failWriting(file, errno);
  writeStream(out, file, write);
  errno = 0;
  out.close();
  if (!out) failWriting(file, errno);
  return temporary;
}

}  // namespace

void writeFile(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write) {
  if (const auto temporary = prepare(file, write)) temporary->renameTo(file);
}

void writeFiles(const std::vector<ResultFile>& files) {
  std::vector<std::unique_ptr<TemporaryFile>> prepared;
  for (const ResultFile& each : files) prepared.push_back(prepare(each.file, each.write));
  for (size_t i = 0; i < files.size(); ++i) {
    if (prepared[i]) prepared[i]->renameTo(files[i].file);
  }
}

}  // namespace amble
