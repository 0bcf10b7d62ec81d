#include "planner/why/obstruction_text.h"

#include <gtest/gtest.h>

#include <set>

#include "base/rotation.h"

namespace amble {
namespace {

using Lack = Obstruction::Lack;

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

Obstruction lacking(Lack lack, double width, double needed) {
  Obstruction why;
  why.rule = WalkRule::kContact;
  why.lack = lack;
  why.part = "left hand";
  why.object = "wall";
  why.other = "cupboard";
  why.at = {1, 2, 0.8};
  why.width = width;
  why.needed = needed;
  why.slope = 30 * kDegree;
  why.max_slope = 20 * kDegree;
  return why;
}

TEST(ObstructionText, OfAGapSaysBetweenWhatHowWideAndWhatWouldDoAtWhatSpeed) {
  Obstruction why = lacking(Lack::kGap, 0.5, 0.612);
  why.speed = 1.2;
  why.overlap = 0.031;
  EXPECT_EQ(
      describe(why),
      "the gap between wall and cupboard is 0.50 m wide at (1.00, 2.00, 0.80); 0.62 m would do "
      "at 1.2 m/s; the walk that came nearest had its left hand 0.031 m in wall");
  why.other = "wall";
  EXPECT_TRUE(says(describe(why), "between two sides of wall is")) << describe(why);
}

// Who makes it as wide as it says has made it wide enough, and who lowers it low enough.
TEST(ObstructionText, RoundsToWhatWouldDo) {
  EXPECT_TRUE(says(describe(lacking(Lack::kGap, 0.5, 0.6101)), "0.62 m would do"));
  EXPECT_TRUE(says(describe(lacking(Lack::kGap, 0.5, 0.61)), "0.61 m would do"));
  EXPECT_TRUE(says(describe(lacking(Lack::kStep, 0.5, 0.259)), "at most 0.25 m"));
  EXPECT_TRUE(says(describe(lacking(Lack::kGround, 1.3, 0.77)), "at most 0.77 m"));
  EXPECT_TRUE(says(describe(lacking(Lack::kHeadroom, 1.6, 1.634)), "1.64 m would do"));
}

TEST(ObstructionText, WhatThereIsNeverLooksLikeWhatWouldDo) {
  for (const double width : {0.6149, 0.618, 0.6151}) {
    const std::string line = describe(lacking(Lack::kGap, width, 0.6175));
    EXPECT_FALSE(says(line, "is 0.62 m wide")) << line;
  }
}

TEST(ObstructionText, OfWhatIsMeasuredEveryLineSaysTheThingAndThePlace) {
  const std::set<Lack> nameless = {Lack::kGround};  // it is where there is nothing
  for (const Lack lack : {Lack::kGap, Lack::kHeadroom, Lack::kStep, Lack::kDrop, Lack::kGround,
                          Lack::kTread, Lack::kSlope, Lack::kUnknown}) {
    const std::string line = describe(lacking(lack, 0.5, 0.6));
    EXPECT_TRUE(says(line, "(1.00, 2.00, 0.80)")) << line;
    EXPECT_TRUE(nameless.contains(lack) || says(line, "wall")) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
  EXPECT_TRUE(says(describe(lacking(Lack::kSlope, 0, 0)), "30 degrees steep"));
}

TEST(ObstructionText, WhatIsTooHighToStepDownIsNotSaidToBeClimbed) {
  Obstruction why = lacking(Lack::kDrop, 0.5, 0.25);
  EXPECT_EQ(describe(why),
            "the ground beside wall is 0.50 m lower at (1.00, 2.00, 0.80); at most 0.25 m is "
            "stepped down");
  why.object.clear();  // another storey
  why.body = {3, 2, 0.3};
  EXPECT_EQ(describe(why),
            "no ground leads from (1.00, 2.00, 0.80) to (3.00, 2.00, 0.30), 0.50 m lower; at most "
            "0.25 m is stepped down");
  why.lack = Lack::kStep;
  EXPECT_TRUE(says(describe(why), "0.50 m higher; at most 0.25 m is stepped up")) << describe(why);
}

TEST(ObstructionText, AnEndInAThingIsInIt) {
  EXPECT_EQ(describe(lacking(Lack::kDistance, 0.0, 0.28)), "it is in wall");
  EXPECT_EQ(describe(lacking(Lack::kDistance, 0.05, 0.28)), "wall is 0.05 m away; 0.28 m would do");
}

TEST(ObstructionText, WhereNothingWasTouchedTheRuleIsNamed) {
  for (int i = 1; i < kWalkRules; ++i) {
    Obstruction why;
    why.rule = static_cast<WalkRule>(i);
    why.at = why.body = {1.25, -2.5, 0};
    const std::string line = describe(why);
    EXPECT_TRUE(says(line, std::string(walkRuleName(why.rule)))) << line;
    EXPECT_TRUE(says(line, "(1.25, -2.50, 0.00)")) << line;
  }
}

TEST(ObstructionText, EveryLackHasANameOfItsOwn) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(Lack::kDistance); ++i)
    names.insert(lackName(static_cast<Lack>(i)));
  EXPECT_EQ(names.size(), 1 + static_cast<size_t>(Lack::kDistance));
}

}  // namespace
}  // namespace amble
