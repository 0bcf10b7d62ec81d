#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace amble {

void parallelFor(int count, int threads, const std::function<void(int i, int thread)>& task) {
  threads = std::min(threads, count);
  if (threads <= 1) {
    for (int i = 0; i < count; ++i) task(i, 0);
    return;
  }
  std::atomic<int> next{0};
  std::vector<std::exception_ptr> errors(threads);
  const auto work = [&](int thread) {
    try {
      for (int i = next++; i < count; i = next++) task(i, thread);
    } catch (...) {
      errors[thread] = std::current_exception();
    }
  };
  std::vector<std::thread> pool;
  for (int thread = 1; thread < threads; ++thread) pool.emplace_back(work, thread);
  work(0);
  for (std::thread& thread : pool) thread.join();
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

}  // namespace amble
