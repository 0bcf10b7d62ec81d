#include "base/guarded_run.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <string_view>
#include <system_error>

namespace amble {
namespace {

// A copy that waits for good, for a lock that nobody holds there, is ended after so much more than
// its time [s].
constexpr int kPatience = 10;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif
#else
constexpr bool kSanitized = false;
#endif

/// Address space of this process; 0 where the system does not say [bytes].
size_t addressSpace() {
  std::ifstream statm("/proc/self/statm");
  size_t pages = 0;
  return statm >> pages ? pages * static_cast<size_t>(sysconf(_SC_PAGESIZE)) : 0;
}

void bound(int resource, size_t most) {
  rlimit limit{};
  if (getrlimit(resource, &limit) != 0) return;
  if (limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur > most) limit.rlim_cur = most;
  setrlimit(resource, &limit);
}

bool writeAll(int to, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(to, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<size_t>(written));
  }
  return true;
}

std::string readAll(int from) {
  std::string bytes;
  std::array<char, 1 << 16> piece;
  for (;;) {
    const ssize_t got = read(from, piece.data(), piece.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return bytes;
    bytes.append(piece.data(), static_cast<size_t>(got));
  }
}

[[noreturn]] void runCopy(const std::function<std::string()>& work, const GuardLimits& limits,
                          int to) {
  for (const int sign : {SIGINT, SIGTERM, SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGALRM, SIGPIPE}) {
    std::signal(sign, SIG_DFL);
  }
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  bound(RLIMIT_CORE, 0);
  bound(RLIMIT_CPU, static_cast<size_t>(limits.cpu_time));
  if (const size_t space = addressSpace(); space > 0 && !kSanitized) {
    bound(RLIMIT_AS, space + limits.memory);
  }
  alarm(static_cast<unsigned>(kPatience * limits.cpu_time));
  try {
    _exit(writeAll(to, work()) ? 0 : 1);
  } catch (...) {
    _exit(1);
  }
}

}  // namespace

std::optional<std::string> runGuarded(const std::function<std::string()>& work,
                                      const GuardLimits& limits) {
  std::array<int, 2> pipe_ends;
  if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) {
    throw std::system_error(errno, std::generic_category(), "pipe");
  }
  const pid_t copy = fork();
  if (copy == 0) {
    close(pipe_ends[0]);
    runCopy(work, limits, pipe_ends[1]);
  }
  const int problem = errno;
  close(pipe_ends[1]);
  if (copy < 0) {
    close(pipe_ends[0]);
    throw std::system_error(problem, std::generic_category(), "fork");
  }
  std::string bytes = readAll(pipe_ends[0]);
  close(pipe_ends[0]);
  int status = 0;
  while (waitpid(copy, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return {};
  return bytes;
}

}  // namespace amble
