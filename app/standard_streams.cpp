#include "app/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

namespace amble {
namespace {

// Opens what is closed. A standard output that was closed can be read only: writing fails.
void openClosed(int handle, int how) {
  if (::fcntl(handle, F_GETFD) >= 0 || errno != EBADF) return;
  const int opened = ::open("/dev/null", how);
  if (opened == handle || opened < 0) return;
  ::dup2(opened, handle);
  ::close(opened);
}

// Says that all was written, whether or not it was.
ssize_t writeOrLose(void*, const char* bytes, size_t count) {
  for (size_t done = 0; done < count;) {
    const ssize_t written = ::write(STDERR_FILENO, bytes + done, count - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) break;
    done += static_cast<size_t>(written);
  }
  return static_cast<ssize_t>(count);
}

}  // namespace

void prepareStandardStreams() {
  openClosed(STDIN_FILENO, O_RDONLY);
  openClosed(STDOUT_FILENO, O_RDONLY);
  openClosed(STDERR_FILENO, O_WRONLY);
  cookie_io_functions_t functions = {};
  functions.write = writeOrLose;
  std::FILE* const lossy = ::fopencookie(nullptr, "w", functions);
  if (lossy == nullptr) return;
  std::setvbuf(lossy, nullptr, _IOLBF, BUFSIZ);
  stderr = lossy;  // a variable, as the GNU C library has it
}

}  // namespace amble
