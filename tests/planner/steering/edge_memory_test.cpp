#include "planner/steering/edge_memory.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

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

// As a table of pairs would, and with one question for each pair however often it is asked.
TEST(EdgeMemory, AnswersAnyOrderOfQuestionsWithOneAskingAPair) {
  std::mt19937 generator(1);
  std::uniform_int_distribution<PlaceId> place(-1, 8);  // -1: a candidate's
  EdgeMemory memory;
  std::map<std::pair<PlaceId, PlaceId>, double> table;
  int asked = 0;
  for (int i = 0; i < 2000; ++i) {
    const PlaceId from = place(generator), to = place(generator);
    const int before = asked;
    const double length = memory.answer(from, to, [&] { return walkOf(++asked); }).edge->length;
    const auto [entry, is_new] = table.try_emplace({from, to}, length);
    EXPECT_EQ(entry->second, length);
    EXPECT_EQ(is_new, asked == before + 1);
  }
  EXPECT_EQ(asked, static_cast<int>(table.size()));
}

TEST(EdgeMemory, WhatIsLearntLastCounts) {
  EdgeMemory memory;
  memory.learn(1, 2, walkOf(3.0));
  memory.learn(1, 2, walkOf(4.0));
  EXPECT_EQ(memory.answer(1, 2, [] { return walkOf(9.0); }).edge->length, 4.0);
}

}  // namespace
}  // namespace amble
