#include "python/stoppable.h"

#include <pybind11/pybind11.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <chrono>
#include <future>
#include <optional>

namespace amble {
namespace {

namespace py = pybind11;

constexpr std::chrono::milliseconds kLookForSignals{50};

bool onMainThread() { return syscall(SYS_gettid) == getpid(); }

}  // namespace

void runStoppable(int threads, const std::function<void(const std::atomic<bool>& stop)>& work) {
  std::atomic<bool> stop{false};
  const auto run = [&] { withThreads(threads, [&] { work(stop); }); };
  if (!onMainThread()) {
    const py::gil_scoped_release released;
    run();
    return;
  }
  std::optional<py::error_already_set> raised;
  std::future<void> done = std::async(std::launch::async, run);
  {
    const py::gil_scoped_release released;
    while (done.wait_for(kLookForSignals) != std::future_status::ready) {
      if (raised) continue;
      const py::gil_scoped_acquire held;
      if (PyErr_CheckSignals() == 0) continue;
      raised.emplace();
      stop = true;
    }
  }
  if (raised) throw py::error_already_set(*raised);
  done.get();
}

}  // namespace amble
