#include "planner/steering/steering.h"

#include <gtest/gtest.h>

#include "base/sample_stream.h"

namespace amble {
namespace {

SteerResult answerOf(SampleStream& stream) {
  SteerResult result;
  result.poses = stream.below(500);
  result.failure.rule = static_cast<WalkRule>(1 + stream.below(kWalkRules - 1));
  if (stream.uniform() < 0.5) result.edge.emplace();
  return result;
}

TEST(SteeringCount, CountsWhatIsRefusedByRuleAndEveryPose) {
  SampleStream stream(1, 0);
  SteeringCount count;
  long long poses = 0, found = 0;
  for (int i = 0; i < 200; ++i) {
    const SteerResult result = answerOf(stream);
    poses += result.poses;
    found += result.edge.has_value();
    count.add(result);
  }
  EXPECT_EQ(count.asked, 200);
  EXPECT_EQ(count.poses, poses);
  long long refused = 0;
  for (const auto& [rule, times] : count.refusals) {
    EXPECT_NE(rule, WalkRule::kNone);
    refused += times;
  }
  EXPECT_EQ(refused + found, count.asked);
}

TEST(SteeringCount, OfPartsAddsUpToThatOfTheWholeInAnyOrder) {
  SampleStream stream(2, 0);
  SteeringCount whole, parts[3], forward, backward;
  for (int i = 0; i < 300; ++i) {
    const SteerResult result = answerOf(stream);
    whole.add(result);
    parts[i % 3].add(result);
  }
  for (int i = 0; i < 3; ++i) {
    forward.add(parts[i]);
    backward.add(parts[2 - i]);
  }
  for (const SteeringCount* sum : {&forward, &backward}) {
    EXPECT_EQ(sum->refusals, whole.refusals);
    EXPECT_EQ(sum->poses, whole.poses);
    EXPECT_EQ(sum->asked, whole.asked);
  }
}

TEST(SteeringCount, ARefusalOfAStanceIsNoQuestion) {
  SteeringCount count;
  count.add(SteeringFailure{WalkRule::kNoGround});
  EXPECT_EQ(count.refusals[WalkRule::kNoGround], 1);
  EXPECT_EQ(count.asked, 0);
}

TEST(WalkEdge, CostIsTimeAndEffort) {
  WalkEdge edge;
  edge.duration = 3.0;
  edge.effort = 0.5;
  EXPECT_EQ(edge.cost(), 3.5);
}

}  // namespace
}  // namespace amble
