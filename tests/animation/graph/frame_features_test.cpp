#include "animation/graph/frame_features.h"

#include <gtest/gtest.h>

#include "animation/clips/mirror_clip.h"
#include "tests/animation/person.h"
#include "tests/animation/planted_clip.h"

namespace amble {
namespace {

struct FrameFeaturesOf : testing::Test {
  const Clip person = walkingPerson();
  const JointRoles roles = guessJointRoles(person.skeleton, "person");
};

TEST_F(FrameFeaturesOf, AFrameIsNoFartherFromItselfThanFromAnyOther) {
  const FrameFeatures features = frameFeatures(person, roles);
  EXPECT_EQ(frameError(features, 7, 7), 0.0f);
  EXPECT_GT(frameError(features, 7, 8), 0.0f);
  EXPECT_EQ(frameError(features, 7, 30), frameError(features, 30, 7));
}

TEST_F(FrameFeaturesOf, WhereSomebodyIsAndFacesDoesNotCount) {
  Clip moved = person;
  moveRoot(moved.poses, 0, moved.frames() - 1, {2.1, {-7.0, 3.0}});
  const FrameFeatures a = frameFeatures(person, roles), b = frameFeatures(moved, roles);
  for (int i = 0; i < person.frames(); ++i)
    EXPECT_LT(frameError(a.col(i).data(), b.col(i).data()), 1e-9f) << i;
}

TEST_F(FrameFeaturesOf, HeightCountsAsADistance) {
  Clip raised = person;
  for (int i = 0; i < raised.frames(); ++i) raised.poses.p_WR(i).z() += 0.1;
  const FrameFeatures a = frameFeatures(person, roles), b = frameFeatures(raised, roles);
  // All end effectors a decimetre higher: a mean square distance of its square.
  EXPECT_NEAR(frameError(a.col(9).data(), b.col(9).data()), 0.01, 1e-6);
}

TEST_F(FrameFeaturesOf, ASpeedCountsAsTheWayItLeadsInTheReach) {
  Clip faster = person;
  for (int i = 0; i < faster.frames(); ++i)
    faster.poses.p_WR(i) += Eigen::Vector3d(0.5 * i * faster.frame_time, 0.0, 0.0);
  const FrameFeatures a = frameFeatures(person, roles), b = frameFeatures(faster, roles);
  const double way = 0.5 * kFeatureReach;
  EXPECT_NEAR(frameError(a.col(9).data(), b.col(9).data()), way * way, 1e-6);
}

TEST_F(FrameFeaturesOf, AWalkIsMostLikeItselfACycleOn) {
  AMBLE_NEEDS_CAPTURES();
  const PlantedClip walk = plantedClip("accad_female1/Female1_B03_Walk1.bvh");
  const FrameFeatures features = frameFeatures(walk.clip, walk.roles);
  for (int i = 60; i < 90; i += 5) {
    int nearest = i + 15;
    for (int j = i + 15; j < i + 60; ++j)
      if (frameError(features, i, j) < frameError(features, i, nearest)) nearest = j;
    EXPECT_NEAR(nearest - i, 37, 1) << i;  // 1.23 s (see the issue of its captured period)
  }
}

}  // namespace
}  // namespace amble
