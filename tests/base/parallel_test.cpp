#include "base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
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

TEST(ParallelFor, NoThreadDoesTwoThingsAtATime) {
  std::vector<std::atomic<bool>> busy(4);
  parallelFor(400, 4, [&](int, int thread) {
    EXPECT_FALSE(busy[static_cast<size_t>(thread)].exchange(true));
    busy[static_cast<size_t>(thread)] = false;
  });
}

TEST(ParallelFor, LoopsWithinLoopsEnd) {
  std::atomic<int> done{0};
  parallelFor(8, 4, [&](int, int) { parallelFor(8, 4, [&](int, int) { ++done; }); });
  EXPECT_EQ(done, 64);
}

TEST(ParallelFor, TheFirstFailureInOrderReachesTheCallerAtAnyNumberOfThreads) {
  for (const int threads : {1, 2, 3, 8}) {
    for (int round = 0; round < 20; ++round) {
      std::string said;
      try {
        parallelFor(40, threads, [](int i, int) {
          if (i % 5 == 3) throw std::runtime_error(std::to_string(i));
        });
      } catch (const std::runtime_error& error) {
        said = error.what();
      }
      EXPECT_EQ(said, "3") << threads;
    }
  }
}

TEST(ParallelFor, UsualThreadsAreSomeButNotTooMany) {
  EXPECT_GE(usualThreads(), 1);
  EXPECT_LE(usualThreads(), kMostThreads);
}

TEST(ParallelFor, NothingToDoIsNothingDone) {
  parallelFor(0, 4, [](int, int) { FAIL(); });
}

}  // namespace
}  // namespace amble
