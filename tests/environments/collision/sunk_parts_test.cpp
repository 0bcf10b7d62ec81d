#include "environments/collision/sunk_parts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "environments/collision/collision_world.h"
#include "tests/environments/test_walker.h"

namespace amble {
namespace {

Pose standing(const TestWalker& walker, double lower) {
  return walker.standing(0.0, 0.0, 0.3, -lower);
}

TEST(SunkParts, AreNoneOfABodyThatStandsOnItsSoles) {
  const TestWalker walker;
  EXPECT_TRUE(sunkParts(walker.body, walker.skeleton, standing(walker, 0.0)).empty());
}

TEST(SunkParts, SolesMayBeAsDeepAsTheGroundGives) {
  const TestWalker walker;
  EXPECT_TRUE(sunkParts(walker.body, walker.skeleton, standing(walker, 0.9 * kSoleDepth)).empty());
  EXPECT_FALSE(sunkParts(walker.body, walker.skeleton, standing(walker, 1.1 * kSoleDepth)).empty());
}

TEST(SunkParts, ComeDeepestFirstWithTheirDepth) {
  const TestWalker walker;
  const auto sunk = sunkParts(walker.body, walker.skeleton, standing(walker, 0.3));
  ASSERT_GT(sunk.size(), 4u);
  EXPECT_NEAR(sunk.front().depth, 0.3, 0.01);
  for (size_t i = 1; i < sunk.size(); ++i) EXPECT_LE(sunk[i].depth, sunk[i - 1].depth);
}

// A rig whose ankle joint lies 29 mm over the sole, as CMU's subject 12: its shank and instep are
// thinner than people's, and stay out of the floor, leaning by thirty degrees too.
TEST(SunkParts, ALowAnkleDoesNotPutTheShankIntoTheFloor) {
  const TestWalker walker;
  for (const double ankle : {0.02, 0.029, 0.04, 0.07}) {
    const Body body =
        makeBody(walker.skeleton, walker.roles, walker.stature, evenSoles({ankle, 0.015}));
    for (const BodyPart& part : body.parts) {
      if (part.name != "left shank") continue;
      const Eigen::Vector3d& p_ankle = walker.skeleton.joint(walker.roles.legs[kLeft].foot).offset;
      const double up = (p_ankle - part.to).norm() * std::cos(30.0 * kDegree);
      EXPECT_GT(ankle + up - part.radius, 0.0) << ankle;
    }
  }
}

}  // namespace
}  // namespace amble
