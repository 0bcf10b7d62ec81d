#include "base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace amble {
namespace {

TEST(ParallelFor, EveryIndexIsDoneOnce) {
  for (const int threads : {1, 2, 7}) {
    std::vector<std::atomic<int>> done(100);
    parallelFor(100, threads, [&](int i, int thread) {
      EXPECT_LT(thread, threads);
      ++done[i];
    });
    for (const auto& count : done) EXPECT_EQ(count, 1);
  }
}

TEST(ParallelFor, ExceptionReachesTheCaller) {
  const auto task = [](int i, int) {
    if (i == 3) throw std::runtime_error("three");
  };
  EXPECT_THROW(parallelFor(10, 2, task), std::runtime_error);
  EXPECT_THROW(parallelFor(10, 1, task), std::runtime_error);
}

TEST(ParallelFor, NothingToDoIsNothingDone) {
  parallelFor(0, 4, [](int, int) { FAIL(); });
}

}  // namespace
}  // namespace amble
