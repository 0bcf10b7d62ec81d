#include "base/child_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <ostream>
#include <system_error>

#include "base/text.h"

extern char** environ;

namespace amble {
namespace {

[[noreturn]] void fail(int error, const char* what) {
  throw std::system_error(error, std::generic_category(), what);
}

// A number for an open file that is none of those that a program's first files get, and that no
// other program inherits.
class HighNumber {
 public:
  explicit HighNumber(std::FILE* file) : number(::fcntl(::fileno(file), F_DUPFD_CLOEXEC, kFree)) {
    if (number < 0) fail(errno, "files");
  }
  ~HighNumber() { ::close(number); }
  HighNumber(const HighNumber&) = delete;
  HighNumber& operator=(const HighNumber&) = delete;

  const int number;

 private:
  static constexpr int kFree = 10;
};

// What the program's first four files are, and that it is a group of its own, to which a terminal's
// Ctrl-C does not go.
class SpawnSettings {
 public:
  SpawnSettings(const HighNumber& input, const HighNumber& complaints, const HighNumber& result) {
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, input.number, 0);
    posix_spawn_file_actions_addopen(&files, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, complaints.number, 2);
    posix_spawn_file_actions_adddup2(&files, result.number, 3);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
};

}  // namespace

std::filesystem::path findProgram(const std::string& name) {
  const char* const path = std::getenv("PATH");
  std::string_view left = path == nullptr ? "" : path;
  while (!left.empty()) {
    const auto split = splitAt(left, ":");
    const std::filesystem::path folder = split ? split->first : left;
    left = split ? split->second : std::string_view();
    const std::filesystem::path program = folder / name;
    std::error_code unknown;
    if (std::filesystem::is_regular_file(program, unknown) && ::access(program.c_str(), X_OK) == 0)
      return program;
  }
  return {};
}

// Closed in every other program that starts meanwhile.
ChildProgram::File ChildProgram::namelessFile() {
  File file(std::tmpfile());
  if (!file) fail(errno, "temporary file");
  ::fcntl(::fileno(file.get()), F_SETFD, FD_CLOEXEC);
  return file;
}

ChildProgram::ChildProgram(const std::filesystem::path& program,
                           const std::vector<std::string>& arguments)
    : result_(namelessFile()), complaints_(namelessFile()) {
  std::array<int, 2> ends = {-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail(errno, "socket");
  input_.reset(::fdopen(ends[0], "w"));
  const File its(::fdopen(ends[1], "r"));
  std::vector<std::string> words = {program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const HighNumber input(its.get()), complaints(complaints_.get()), result(result_.get());
  const SpawnSettings how(input, complaints, result);
  const int error =
      posix_spawn(&process_, program.c_str(), &how.files, &how.attributes, argv.data(), environ);
  if (error == 0) return;
  process_ = -1;
  fail(error, program.c_str());
}

ChildProgram::~ChildProgram() {
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  finish();
}

bool ChildProgram::feed(std::string_view bytes) {
  while (!bytes.empty()) {
    // No signal where it has ended.
    const ssize_t sent = ::send(::fileno(input_.get()), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return false;
    bytes.remove_prefix(static_cast<size_t>(sent));
  }
  return true;
}

int ChildProgram::finish() {
  input_.reset();
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void ChildProgram::writeResult(std::ostream& out) {
  std::rewind(result_.get());
  std::array<char, 1 << 16> bytes;
  for (size_t got = 0; (got = std::fread(bytes.data(), 1, bytes.size(), result_.get())) > 0;)
    out.write(bytes.data(), static_cast<std::streamsize>(got));
}

std::string ChildProgram::complaint() {
  std::rewind(complaints_.get());
  std::array<char, 512> line;
  const char* const got = std::fgets(line.data(), static_cast<int>(line.size()), complaints_.get());
  return got == nullptr ? "" : withoutControls(std::string(trimmed(std::string_view(got))));
}

}  // namespace amble
