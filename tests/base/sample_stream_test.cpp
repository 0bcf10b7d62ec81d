#include "base/sample_stream.h"

#include <gtest/gtest.h>

#include <vector>

namespace amble {
namespace {

TEST(SampleStream, RepeatsUnderItsSeedAndIndex) {
  SampleStream a(7, 42), b(7, 42);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.bits(), b.bits());
}

TEST(SampleStream, DiffersByIndexAndBySeed) {
  SampleStream a(7, 42), b(7, 43), c(8, 42);
  EXPECT_NE(a.bits(), b.bits());
  EXPECT_NE(SampleStream(7, 42).bits(), c.bits());
}

TEST(SampleStream, FirstNumbersOfManyStreamsAreUniform) {
  // 20,000 numbers in 10 bins: 2000 each, standard deviation 42.
  std::vector<int> bins(10, 0);
  for (int index = 0; index < 20000; ++index) ++bins[SampleStream(1, index).below(10)];
  for (const int count : bins) EXPECT_NEAR(count, 2000, 200);
}

TEST(SampleStream, StaysWithinItsRange) {
  SampleStream stream(3, 0);
  for (int i = 0; i < 1000; ++i) {
    const double x = stream.uniform(-2.0, 5.0);
    EXPECT_GE(x, -2.0);
    EXPECT_LT(x, 5.0);
  }
}

}  // namespace
}  // namespace amble
