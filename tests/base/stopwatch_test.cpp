#include "base/stopwatch.h"

#include <gtest/gtest.h>

namespace amble {
namespace {

TEST(Stopwatch, NeverRunsBackwards) {
  Stopwatch watch;
  double before = 0.0;
  for (int i = 0; i < 100; ++i) {
    const double now = watch.seconds();
    EXPECT_GE(now, before);
    before = now;
  }
}

TEST(Stopwatch, LapsAddUpToTheWhole) {
  const Stopwatch whole;
  Stopwatch lap;
  double laps = 0.0;
  for (int i = 0; i < 50; ++i) laps += lap.restart();
  EXPECT_LE(laps, whole.seconds());
}

TEST(Stopwatch, ADeadlineIsAheadByItsSeconds) {
  const auto now = std::chrono::steady_clock::now();
  EXPECT_GE(deadlineIn(60.0) - now, std::chrono::seconds(60));
}

}  // namespace
}  // namespace amble
