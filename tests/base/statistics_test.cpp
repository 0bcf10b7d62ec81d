#include "base/statistics.h"

#include <gtest/gtest.h>

namespace amble {
namespace {

TEST(Statistics, MeanAndMedianOfNoneAreZero) {
  EXPECT_EQ(mean({}), 0.0);
  EXPECT_EQ(median({}), 0.0);
}

TEST(Statistics, TheMedianIsTheMiddleOrTheMeanOfTheTwoMiddles) {
  EXPECT_EQ(median({5, 1, 9}), 5.0);
  EXPECT_EQ(median({5, 1, 9, 7}), 6.0);
  EXPECT_EQ(median({2}), 2.0);
  EXPECT_EQ(upperMedian({5, 1, 9, 7}), 7.0);
  EXPECT_EQ(upperMedian({5, 1, 9}), 5.0);
}

TEST(Statistics, QuantilesGoFromTheLeastToTheLargest) {
  const std::vector<double> values = {4, 0, 3, 1, 2};
  for (int i = 0; i <= 4; ++i) EXPECT_EQ(quantile(values, 0.25 * i), i);
}

}  // namespace
}  // namespace amble
