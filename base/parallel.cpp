#include "base/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace amble {
namespace {

int machineThreads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

}  // namespace

int usualThreads() {
  return std::clamp(std::min(machineThreads(), tbb::this_task_arena::max_concurrency()), 1,
                    kMostThreads);
}

// Of more than the machine has TBB would warn.
void withThreads(int threads, const std::function<void()>& work) {
  tbb::task_arena(std::min(threads, machineThreads())).execute(work);
}

void parallelFor(int count, int threads, const std::function<void(int i, int thread)>& task) {
  threads = std::min(threads, count);
  if (threads <= 1) {
    for (int i = 0; i < count; ++i) task(i, 0);
    return;
  }
  // What fails first in order is always begun, since all before it are.
  struct Failure {
    int i;
    std::exception_ptr error;
  };
  std::vector<Failure> failures(static_cast<size_t>(threads), Failure{count, nullptr});
  std::atomic<int> next{0};
  const auto work = [&](int thread) {
    int i = next++;
    try {
      for (; i < count; i = next++) task(i, thread);
    } catch (...) {
      failures[static_cast<size_t>(thread)] = {i, std::current_exception()};
      next = count;
    }
  };
  // Who waits for the others of a loop within a task begins no further task of the outer loop.
  tbb::this_task_arena::isolate(
      [&] { tbb::parallel_for(0, threads, work, tbb::simple_partitioner()); });
  const Failure& first =
      *std::min_element(failures.begin(), failures.end(),
                        [](const Failure& a, const Failure& b) { return a.i < b.i; });
  if (first.error) std::rethrow_exception(first.error);
}

int firstOf(int count, int threads, const std::function<bool(int i, int thread)>& task) {
  if (threads <= 1) {
    for (int i = 0; i < count; ++i)
      if (task(i, 0)) return i;
    return count;
  }
  std::atomic<int> first{count};  // of those that said yes, or failed, so far
  std::vector<std::exception_ptr> failures(static_cast<size_t>(count));
  parallelFor(count, threads, [&](int i, int thread) {
    if (i > first) return;
    try {
      if (!task(i, thread)) return;
    } catch (...) {
      failures[i] = std::current_exception();
    }
    for (int known = first; i < known && !first.compare_exchange_weak(known, i);) continue;
  });
  if (first < count && failures[first]) std::rethrow_exception(failures[first]);
  return first;
}

}  // namespace amble
