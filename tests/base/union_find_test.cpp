#include "base/union_find.h"

#include <gtest/gtest.h>

#include "base/sample_stream.h"

namespace amble {
namespace {

TEST(UnionFind, OfNothingHasNoSets) { EXPECT_EQ(UnionFind(0).size(), 0); }

TEST(UnionFind, JoiningTwiceJoinsOnce) {
  UnionFind sets(3);
  EXPECT_TRUE(sets.join(2, 1));
  EXPECT_FALSE(sets.join(1, 2));
  EXPECT_EQ(sets.find(2), 1);
  EXPECT_EQ(sets.find(0), 0);
}

// Against labels that are rewritten whole at each join.
TEST(UnionFind, SetsAreThoseOfLabelsAndNamedByTheirSmallest) {
  constexpr int kCount = 60;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SampleStream random(seed, 0);
    UnionFind sets(kCount);
    std::vector<int> label(kCount);
    for (int i = 0; i < kCount; ++i) label[i] = i;
    for (int joins = 0; joins < 45; ++joins) {
      const int a = random.below(kCount), b = random.below(kCount);
      const int low = std::min(label[a], label[b]), high = std::max(label[a], label[b]);
      EXPECT_EQ(sets.join(a, b), low != high);
      std::replace(label.begin(), label.end(), high, low);
    }
    for (int i = 0; i < kCount; ++i) EXPECT_EQ(sets.find(i), label[i]);
  }
}

}  // namespace
}  // namespace amble
