#include "base/parts.h"

#include <gtest/gtest.h>

namespace amble {
namespace {

TEST(PartsOf, NoneIsLongerThanAsked) {
  EXPECT_EQ(partsOf(0.0, 0.5), 1);
  EXPECT_EQ(partsOf(0.3, 0.5), 1);
  EXPECT_EQ(partsOf(1.01, 0.5), 3);
}

TEST(PartsOf, ARoundingAddsNoPart) {
  for (int count = 1; count < 400; ++count) {
    const double length = count * 0.02;
    EXPECT_EQ(partsOf(length * (1.0 + 1e-15), 0.02), count);
    EXPECT_EQ(partsOf(length * (1.0 - 1e-15), 0.02), count);
  }
}

}  // namespace
}  // namespace amble
