#include "app/stop.h"

#include <unistd.h>

#include <csignal>

#include "app/exit_status.h"
#include "base/output_file.h"

namespace amble {
namespace {

std::atomic<bool> stop_flag{false};
std::atomic<int> stoppable{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "a signal handler may not wait");

extern "C" void onStopSignal(int) {
  if (stoppable > 0 && !stop_flag.exchange(true)) return;
  removeHalfWritten();
  ::_exit(kExitStopped);
}

}  // namespace

StoppableWork::StoppableWork() { ++stoppable; }
StoppableWork::~StoppableWork() { --stoppable; }

void stopOnSignals() {
  struct sigaction action = {};
  action.sa_handler = onStopSignal;
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction before = {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);  // nohup
  }
  std::signal(SIGXFSZ, SIG_IGN);
}

const std::atomic<bool>& stopFlag() { return stop_flag; }

}  // namespace amble
