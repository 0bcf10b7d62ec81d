#include "planner/steering/edge_memory.h"

#include <gtest/gtest.h>

namespace amble {
namespace {

SteerResult walkOf(double length) {
  SteerResult result;
  result.edge.emplace();
  result.edge->length = length;
  return result;
}

TEST(EdgeMemory, AsksOnceForEachDirectedPair) {
  EdgeMemory memory;
  int asked = 0;
  const auto ask = [&] { return walkOf(++asked); };
  EXPECT_EQ(memory.answer(1, 2, ask).edge->length, 1.0);
  EXPECT_EQ(memory.answer(1, 2, ask).edge->length, 1.0);
  EXPECT_EQ(memory.answer(2, 1, ask).edge->length, 2.0);
  EXPECT_EQ(asked, 2);
}

TEST(EdgeMemory, RefusalsAreRememberedToo) {
  EdgeMemory memory;
  memory.learn(1, 2, SteerResult{});
  EXPECT_FALSE(memory.answer(1, 2, [] { return walkOf(1.0); }).edge.has_value());
}

TEST(EdgeMemory, KnowsNothingOfOtherPairsNorAfterClearing) {
  EdgeMemory memory;
  memory.learn(1, 2, walkOf(3.0));
  ASSERT_NE(memory.find(1, 2), nullptr);
  EXPECT_EQ(memory.find(1, 2)->edge->length, 3.0);
  EXPECT_EQ(memory.find(2, 1), nullptr);
  memory.clear();
  EXPECT_EQ(memory.find(1, 2), nullptr);
}

}  // namespace
}  // namespace amble
