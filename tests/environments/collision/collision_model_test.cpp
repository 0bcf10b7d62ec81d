#include "environments/collision/collision_model.h"

#include <gtest/gtest.h>

#include "tests/environments/test_scenes.h"
#include "tests/environments/test_walker.h"

namespace amble {
namespace {

struct StandingModel {
  TestWalker walker;
  Scene scene = sceneOf({floorSlab()});
  SceneGround ground{scene};
  CollisionModel model{scene, ground, walker.skeleton, walker.body};
};

constexpr SolePhase kPlanted = SolePhase::kPlanted, kBeside = SolePhase::kBeside,
                    kSwinging = SolePhase::kSwinging;

TEST(CollisionModel, ASoleMaySinkInUnlessItSwingsAtBothEnds) {
  const StandingModel standing;
  const int sole = standing.walker.part("left sole, inside");
  const auto depth = [&](SolePhase a, SolePhase b) {
    return standing.model.allowedDepth(sole, {a, kSwinging}, {b, kSwinging});
  };
  for (const SolePhase down : {kPlanted, kBeside}) {
    EXPECT_EQ(depth(down, down), kSoleDepth);
    EXPECT_EQ(depth(down, kSwinging), kSoleDepth);
    EXPECT_EQ(depth(kSwinging, down), kSoleDepth);
  }
  EXPECT_EQ(depth(kSwinging, kSwinging), kSwingDepth);
}

TEST(CollisionModel, OneFootSaysNothingOfTheOther) {
  const StandingModel standing;
  const int right = standing.walker.part("right toes");
  EXPECT_EQ(standing.model.allowedDepth(right, {kPlanted, kSwinging}, {kPlanted, kSwinging}),
            kSwingDepth);
}

TEST(CollisionModel, WhatIsNoSoleMayNotSinkIn) {
  const StandingModel standing;
  for (const char* name : {"left hand", "right shank", "head"}) {
    const int part = standing.walker.part(name);
    EXPECT_EQ(standing.model.allowedDepth(part, {kPlanted, kPlanted}, {kPlanted, kPlanted}), 0.0)
        << name;
  }
}

}  // namespace
}  // namespace amble
