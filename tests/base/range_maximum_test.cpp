#include "base/range_maximum.h"

#include <gtest/gtest.h>

#include <random>

namespace amble {
namespace {

TEST(RangeMaximum, IsTheGreatestOfEveryRun) {
  std::mt19937 random(5);
  for (const int count : {1, 2, 3, 7, 8, 33}) {
    std::vector<double> values(count);
    for (double& value : values) value = static_cast<double>(random() % 1000);
    const RangeMaximum maximum(values);
    for (int first = 0; first < count; ++first)
      for (int last = first; last < count; ++last)
        EXPECT_EQ(maximum.over(first, last),
                  *std::max_element(values.begin() + first, values.begin() + last + 1));
  }
}

TEST(RangeMaximum, OfNothingIsLessThanAnything) {
  EXPECT_EQ(RangeMaximum().over(0, -1), -std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace amble
