#include "scenarios/export_walk.h"

#include <gtest/gtest.h>

#include "animation/captures/bvh.h"
#include "base/rotation.h"

namespace amble {
namespace {

// Left and right limbs listed level by level: a file lists them limb by limb.
Skeleton levelByLevel() {
  std::vector<Joint> joints(5);
  const char* names[] = {"hips", "left", "right", "left foot", "right foot"};
  const int parents[] = {-1, 0, 0, 1, 2};
  for (int i = 0; i < 5; ++i) {
    joints[i].name = names[i];
    joints[i].parent = parents[i];
    if (i > 0) joints[i].offset = {0.1 * i, 1, 0};
  }
  return Skeleton(std::move(joints));
}

AnimationBuffer someWalk() {
  AnimationBuffer walk;
  walk.poses = PoseArray(5);
  walk.poses.resize(4);
  for (int frame = 0; frame < 4; ++frame) {
    walk.poses.p_WR(frame) = {0.1 * frame, 0.2, 1.0};
    for (int j = 0; j < 5; ++j) {
      walk.poses.rotations(frame)[j] = expRotation({0.1 * j, 0.2, 0.05 * frame * j});
    }
  }
  return walk;
}

TEST(ExportWalk, WhatAReaderSeesIsTheWalkToTheFilesLastDigit) {
  const AnimationBuffer walk = someWalk();
  for (const double unit : {1.0, 0.01}) {
    const ExportedWalk exported = exportWalk("walk", levelByLevel(), walk, unit);
    ASSERT_EQ(exported.poses.size(), 4);
    for (int frame = 0; frame < 4; ++frame) {
      EXPECT_LT((exported.poses.p_WR(frame) - walk.poses.p_WR(frame)).norm(), 2e-6);
      for (int j = 0; j < 5; ++j) {
        EXPECT_LT(
            exported.poses.rotations(frame)[j].angularDistance(walk.poses.rotations(frame)[j]),
            1e-6 * kDegree * 3);
      }
    }
  }
}

TEST(ExportWalk, JointNamesAreTheFilesByOurJoint) {
  const std::vector<std::string> expected = {"hips", "left", "right", "left_foot", "right_foot"};
  EXPECT_EQ(exportWalk("walk", levelByLevel(), someWalk(), 1.0).joint_names, expected);
  EXPECT_EQ(bvhJointNames(levelByLevel()), expected);
}

}  // namespace
}  // namespace amble
