#include "base/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
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

TEST(WithThreads, NoMoreWorkAtATimeThanThereAreWhateverLoopsWithinAskFor) {
  for (const int threads : {1, 2}) {
    std::atomic<int> at_work{0}, most{0}, done{0};
    const auto inner = [&](int, int) {
      const int now = ++at_work;
      for (int known = most; now > known && !most.compare_exchange_weak(known, now);) continue;
      std::this_thread::sleep_for(std::chrono::microseconds(200));
      --at_work;
      ++done;
    };
    withThreads(threads, [&] {
      EXPECT_LE(usualThreads(), threads);
      parallelFor(20, 4, [&](int, int) { parallelFor(5, 4, inner); });
    });
    EXPECT_EQ(done, 100);
    EXPECT_LE(most, threads);
  }
}

TEST(WithThreads, OfMoreThanTheMachineHasNothingIsSaid) {
  testing::internal::CaptureStderr();
  withThreads(kMostThreads * kMostThreads, [] { parallelFor(8, 4, [](int, int) {}); });
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(WithThreads, OneIsTheCallerAndFailuresReachHim) {
  const std::thread::id caller = std::this_thread::get_id();
  EXPECT_THROW(withThreads(1,
                           [&] {
                             EXPECT_EQ(std::this_thread::get_id(), caller);
                             parallelFor(10, 4, [&](int i, int) {
                               EXPECT_EQ(std::this_thread::get_id(), caller);
                               if (i == 7) throw std::runtime_error("7");
                             });
                           }),
               std::runtime_error);
}

TEST(ParallelFor, NothingToDoIsNothingDone) {
  parallelFor(0, 4, [](int, int) { FAIL(); });
}

TEST(FirstOf, IsTheSmallestThatSaysYesAndAllBeforeItAreAskedOnce) {
  for (const int threads : {1, 2, 3, 8}) {
    for (int least = 0; least <= 60; least += 7) {
      std::vector<std::atomic<int>> asked(60);
      const int first = firstOf(60, threads, [&](int i, int thread) {
        EXPECT_LT(thread, threads);
        ++asked[i];
        return i >= least && i % 2 == least % 2;  // others after it say yes, too
      });
      EXPECT_EQ(first, std::min(least, 60));
      for (int i = 0; i < 60; ++i) {
        if (i <= first) {
          EXPECT_EQ(asked[i], 1) << i;
        }
        EXPECT_LE(asked[i], threads == 1 && i > first ? 0 : 1) << i;
      }
    }
  }
}

TEST(FirstOf, AThreadThatKnowsTheAnswerBeginsNothingAfterIt) {
  std::atomic<int> begun{0};
  EXPECT_EQ(firstOf(10000, 4,
                    [&](int, int) {
                      ++begun;
                      return true;
                    }),
            0);
  EXPECT_LE(begun, 4);
}

TEST(FirstOf, OfNoneIsNone) {
  for (const int threads : {1, 4}) {
    EXPECT_EQ(firstOf(0, threads, [](int, int) { return true; }), 0);
    EXPECT_EQ(firstOf(5, threads, [](int, int) { return false; }), 5);
  }
}

TEST(FirstOf, AFailureAfterTheAnswerIsAsIfItHadNotBeen) {
  for (int round = 0; round < 50; ++round) {
    for (const int threads : {1, 2, 8}) {
      EXPECT_EQ(firstOf(40, threads,
                        [](int i, int) {
                          if (i == 5) throw std::runtime_error("5");
                          return i == 2;
                        }),
                2);
    }
  }
}

TEST(FirstOf, AFailureReachesTheCaller) {
  for (const int threads : {1, 2, 8}) {
    EXPECT_THROW(firstOf(40, threads,
                         [](int i, int) {
                           if (i == 3) throw std::runtime_error("3");
                           return false;
                         }),
                 std::runtime_error);
  }
}

}  // namespace
}  // namespace amble
