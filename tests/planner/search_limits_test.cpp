#include "planner/search_limits.h"

#include <gtest/gtest.h>

namespace amble {
namespace {

TEST(SearchLimits, StopNothingUnlessTold) {
  const SearchLimits limits;
  EXPECT_FALSE(limits.stopped());
  EXPECT_FALSE(limits.timeIsUp());
}

TEST(SearchLimits, ADeadlineThatIsPastStops) {
  SearchLimits limits;
  limits.deadline = std::chrono::steady_clock::now() + std::chrono::hours(1);
  EXPECT_FALSE(limits.stopped());
  limits.deadline = std::chrono::steady_clock::now();
  EXPECT_TRUE(limits.timeIsUp());
  EXPECT_TRUE(limits.stopped());
}

TEST(SearchLimits, AFlagOrAnothersWordStopsWithoutTime) {
  SearchLimits limits;
  std::atomic<bool> stop{false};
  bool said = false;
  limits.stop = &stop;
  limits.interrupted = [&] { return said; };
  EXPECT_FALSE(limits.stopped());
  said = true;
  EXPECT_TRUE(limits.stopped());
  said = false;
  stop = true;
  EXPECT_TRUE(limits.stopped());
  EXPECT_FALSE(limits.timeIsUp());
}

}  // namespace
}  // namespace amble
