#include "base/guarded_run.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <new>
#include <string_view>
#include <system_error>

#include "base/freed_memory.h"

namespace amble {
namespace {

// A copy that waits for good, for a lock that nobody holds there, is ended after so much more than
// its time [s].
constexpr int kPatience = 10;

constexpr int kAsked = 100;  // between two questions whether to stop [ms]

// Exit status of a copy that has no memory left; none that a work could give.
constexpr int kExitMemory = 3;

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

/// What comes until the other end is closed; false where the work was stopped before.
bool readAll(int from, const std::function<bool()>& stopped, std::string& bytes) {
  std::array<char, 1 << 16> piece;
  for (;;) {
    pollfd waiting{from, POLLIN, 0};
    const int ready = poll(&waiting, 1, stopped ? kAsked : -1);
    if (stopped && stopped()) return false;
    if (ready <= 0) continue;
    const ssize_t got = read(from, piece.data(), piece.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return true;
    bytes.append(piece.data(), static_cast<size_t>(got));
  }
}

GuardEnd endOf(int status) {
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return GuardEnd::kDone;
  if (WIFEXITED(status) && WEXITSTATUS(status) == kExitMemory) return GuardEnd::kMemory;
  if (!WIFSIGNALED(status)) return GuardEnd::kBroken;
  const int sign = WTERMSIG(status);
  if (sign == SIGINT || sign == SIGTERM) return GuardEnd::kStopped;
  return sign == SIGXCPU || sign == SIGALRM ? GuardEnd::kTime : GuardEnd::kBroken;
}

// What importers ask for first, most of it for each file anew [bytes].
constexpr size_t kFirstMemory = size_t{20} << 20;

[[noreturn]] void runCopy(const std::function<std::string()>& work, const GuardLimits& limits,
                          int to) {
  for (const int sign :
       {SIGINT, SIGTERM, SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGALRM, SIGPIPE, SIGXCPU}) {
    std::signal(sign, SIG_DFL);
  }
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  bound(RLIMIT_CORE, 0);
  bound(RLIMIT_CPU, static_cast<size_t>(limits.cpu_time));
  giveBackFreedMemory();  // of which the program may have kept more than the work may fill
  if (const size_t space = addressSpace(); space > 0 && !kSanitized) {
    bound(RLIMIT_AS, space + limits.memory);
  }
  alarm(static_cast<unsigned>(kPatience * limits.cpu_time));
  keepFreedMemory(kFirstMemory);
  std::set_new_handler([] { _exit(kExitMemory); });
  try {
    _exit(writeAll(to, work()) ? 0 : 1);
  } catch (...) {
    _exit(1);
  }
}

}  // namespace

GuardedWork::GuardedWork(const std::function<std::string()>& work, GuardLimits limits)
    : limits_(std::move(limits)) {
  std::array<int, 2> pipe_ends;
  if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) {
    throw std::system_error(errno, std::generic_category(), "pipe");
  }
  copy_ = fork();
  if (copy_ == 0) {
    close(pipe_ends[0]);
    runCopy(work, limits_, pipe_ends[1]);
  }
  const int problem = errno;
  close(pipe_ends[1]);
  from_ = pipe_ends[0];
  if (copy_ < 0) {
    close(from_);
    throw std::system_error(problem, std::generic_category(), "fork");
  }
}

GuardedWork::~GuardedWork() {
  if (copy_ >= 0) end(true);
}

// Its exit status.
int GuardedWork::end(bool kill_it) {
  close(from_);
  if (kill_it) kill(copy_, SIGKILL);
  int status = 0;
  while (waitpid(copy_, &status, 0) < 0 && errno == EINTR) {
  }
  copy_ = -1;
  return status;
}

GuardedAnswer GuardedWork::answer() {
  GuardedAnswer answer;
  const bool whole = readAll(from_, limits_.stopped, answer.bytes);
  const int status = end(!whole);
  answer.end = whole ? endOf(status) : GuardEnd::kStopped;
  if (!answer.done()) answer.bytes.clear();
  return answer;
}

GuardedAnswer runGuarded(const std::function<std::string()>& work, const GuardLimits& limits) {
  return GuardedWork(work, limits).answer();
}

std::string GuardedAnswer::why(const GuardLimits& limits) const {
  switch (end) {
    case GuardEnd::kDone:
      return "";
    case GuardEnd::kMemory:
      return "it fills more than " + std::to_string(limits.memory >> 20) + " MB of memory";
    case GuardEnd::kTime:
      return "it takes more than " + std::to_string(limits.cpu_time) + " s";
    case GuardEnd::kStopped:
      return "it was stopped";
    case GuardEnd::kBroken:
      break;
  }
  return "it breaks its reader, as nesting without end does";
}

}  // namespace amble
