#include "base/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>
#include <system_error>
#include <thread>

#include "base/error.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void failWriting(const fs::path& file, int error) {
  // A stream does not always say why; without a reason a full disk is the likely one.
  throw InputError(file.string(), 0,
                   std::string("cannot be written: ") + std::strerror(error != 0 ? error : ENOSPC),
                   "a writable file");
}

constexpr const char* kPartMark = ".part-";

// The file that a path leads to, over links that may lead nowhere yet.
fs::path followLinks(fs::path file) {
  constexpr int kMostLinks = 40;  // as the system follows
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(file, error); ++i) {
    const fs::path target = fs::read_symlink(file, error);
    if (error) break;
    file = target.is_absolute() ? target : file.parent_path() / target;
  }
  return file;
}

// Owner and mode of the file that is replaced. Who may not give a file away keeps it.
void takeRights(int handle, const fs::path& file) {
  struct stat old = {};
  if (::stat(file.c_str(), &old) != 0 || !S_ISREG(old.st_mode)) return;
  constexpr mode_t kRights = 07777;
  if (::fchown(handle, old.st_uid, old.st_gid) != 0) errno = 0;
  if (::fchmod(handle, old.st_mode & kRights) != 0) errno = 0;
}

// The process that a half-written file is named for; 0 where the name is none of ours.
pid_t writerOf(const std::string& name, const std::string& begin) {
  if (!name.starts_with(begin)) return 0;
  pid_t process = 0;
  const char* const end = name.data() + name.size();
  const auto parsed = std::from_chars(name.data() + begin.size(), end, process);
  return parsed.ec == std::errc() && parsed.ptr != end && *parsed.ptr == '-' ? process : 0;
}

// Removes what killed programs left beside the file. Who still writes holds a lock, on whichever
// machine it runs.
void clearLeftovers(const fs::path& file) {
  const std::string begin = file.filename().string() + kPartMark;
  std::error_code error;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const pid_t writer = writerOf(entry.path().filename().string(), begin);
    if (writer <= 0 || ::kill(writer, 0) == 0 || errno != ESRCH) continue;
    const int handle = ::open(entry.path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
    if (handle < 0) continue;
    if (::flock(handle, LOCK_EX | LOCK_NB) == 0) ::unlink(entry.path().c_str());
    ::close(handle);
  }
}

// Paths of the half-written files, for removeHalfWritten: a handler of signals may neither wait nor
// ask for memory. More at once than there are places are left to clearLeftovers.
constexpr size_t kMostHalfWritten = 64;
std::array<std::atomic<const char*>, kMostHalfWritten> half_written{};

void remember(const char* path) {
  for (std::atomic<const char*>& place : half_written) {
    const char* none = nullptr;
    if (place.compare_exchange_strong(none, path)) return;
  }
}

void forget(const char* path) {
  for (std::atomic<const char*>& place : half_written) {
    const char* same = path;
    if (place.compare_exchange_strong(same, nullptr)) return;
  }
}

// Removes the half-written file unless it was renamed.
class TemporaryFile {
 public:
  // A name that no other thread or program has, in the same folder, since a rename works within a
  // disk only.
  explicit TemporaryFile(const fs::path& asked) : file_(followLinks(asked)) {
    static std::atomic<unsigned> count{0};
    for (int error = EEXIST; error == EEXIST;) {
      path_ = file_;
      path_ += kPartMark + std::to_string(::getpid()) + "-" + std::to_string(count++);
      handle_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      error = handle_ < 0 ? errno : 0;
      if (error != 0 && error != EEXIST) failWriting(asked, error);
    }
    remember(path_.c_str());
    ::flock(handle_, LOCK_EX | LOCK_NB);
    takeRights(handle_, file_);
  }
  ~TemporaryFile() {
    forget(path_.c_str());
    if (!renamed_) ::unlink(path_.c_str());
    ::close(handle_);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const fs::path& path() const { return path_; }
  void giveName() {
    if (::rename(path_.c_str(), file_.c_str()) != 0) failWriting(file_, errno);
    renamed_ = true;
  }

 private:
  const fs::path file_;
  fs::path path_;  // stays as it is: its text is remembered
  int handle_ = -1;
  bool renamed_ = false;
};

void writeStream(std::ostream& out, const fs::path& file,
                 const std::function<void(std::ostream&)>& write) {
  write(out);
  out.flush();
  if (out) return;
  out.clear();  // once more, for the reason: errno may have changed since
  errno = 0;
  out << ' ' << std::flush;
  failWriting(file, errno);
}

// A device or a pipe (`/dev/full`) must not be replaced by a file, nor what standard output was
// redirected to (`/dev/stdout`).
enum class Place { kFile, kFolder, kDevice, kPipe, kStandardOutput };

Place placeOf(const fs::path& file) {
  struct stat there = {}, out = {};
  if (file == "-") return Place::kStandardOutput;
  if (::stat(file.c_str(), &there) != 0) return Place::kFile;
  const bool same =
      ::fstat(STDOUT_FILENO, &out) == 0 && out.st_dev == there.st_dev && out.st_ino == there.st_ino;
  if (S_ISDIR(there.st_mode)) return Place::kFolder;
  if (same) return Place::kStandardOutput;
  if (S_ISREG(there.st_mode)) return Place::kFile;
  return S_ISFIFO(there.st_mode) ? Place::kPipe : Place::kDevice;
}

// Opening a pipe waits for a reader, for ever if need be. @return a handle that keeps it open
int awaitReader(const fs::path& pipe) {
  constexpr auto kLook = std::chrono::milliseconds(20);
  for (auto waited = std::chrono::milliseconds(0);; waited += kLook) {
    const int handle = ::open(pipe.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    if (handle >= 0) return handle;
    if (errno != ENXIO) failWriting(pipe, errno);
    if (waited >= std::chrono::seconds(kReaderPatience)) {
      throw InputError(pipe.string(), 0, "nobody reads from the pipe",
                       "a reader within " + std::to_string(kReaderPatience) + " s");
    }
    std::this_thread::sleep_for(kLook);
  }
}

void writeDevice(const fs::path& file, bool is_pipe,
                 const std::function<void(std::ostream&)>& write) {
  const int handle = is_pipe ? awaitReader(file) : -1;
  std::ofstream device(file, std::ios::binary);
  const int error = errno;
  if (handle >= 0) ::close(handle);
  if (!device) failWriting(file, error);
  writeStream(device, file, write);
}

// Writes all of it beside `file`, or at once where there is no beside. @return null in that case
std::unique_ptr<TemporaryFile> prepare(const fs::path& file,
                                       const std::function<void(std::ostream&)>& write) {
  const Place place = placeOf(file);
  if (place == Place::kStandardOutput) {
    writeStream(std::cout, file, write);
    return nullptr;
  }
  if (place == Place::kDevice || place == Place::kPipe) {
    writeDevice(file, place == Place::kPipe, write);
    return nullptr;
  }
  if (place == Place::kFolder) failWriting(file, EISDIR);
  if (::access(file.c_str(), W_OK) != 0 && errno != ENOENT) failWriting(file, errno);
  clearLeftovers(followLinks(file));
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

bool isStream(const std::filesystem::path& file) {
  std::error_code unknown;
  return std::filesystem::is_other(std::filesystem::status(file, unknown));
}

void writeFile(const fs::path& file, const std::function<void(std::ostream&)>& write) {
  if (const auto temporary = prepare(file, write)) temporary->giveName();
}

void removeHalfWritten() {
  for (const std::atomic<const char*>& place : half_written) {
    if (const char* const path = place) ::unlink(path);
  }
}

void writeFiles(const std::vector<ResultFile>& files, const std::vector<fs::path>& obsolete) {
  std::vector<std::unique_ptr<TemporaryFile>> prepared;
  for (const ResultFile& each : files) prepared.push_back(prepare(each.file, each.write));
  std::error_code not_there;
  for (const fs::path& old : obsolete) {
    clearLeftovers(old);
    fs::remove(old, not_there);
  }
  for (const auto& temporary : prepared) {
    if (temporary) temporary->giveName();
  }
}

}  // namespace amble
