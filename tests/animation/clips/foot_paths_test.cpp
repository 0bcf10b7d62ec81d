#include "animation/clips/foot_paths.h"

#include <gtest/gtest.h>

#include "animation/body/foot_shape.h"
#include "animation/library/motion_library_reader.h"

namespace amble {
namespace {

Clip standing(const MotionLibrary& library, int frames) {
  Clip clip{"stand", library.skeleton, 0.1, PoseArray(library.skeleton.size()), {}};
  Pose pose;
  pose.rotations = library.stand().rotations;
  for (int i = 0; i < frames; ++i) {
    pose.p_WR = {0.1 * i, 0.0, library.stand().root_height};
    clip.poses.append(pose);
  }
  return clip;
}

TEST(FootPaths, MoveWithTheRootOfAStiffBody) {
  const MotionLibrary library = openMotionLibrary("default");
  for (const Eigen::MatrixXd& path : footPaths(standing(library, 3), library.roles)) {
    ASSERT_EQ(path.rows(), 3);
    Eigen::RowVectorXd step = Eigen::RowVectorXd::Zero(6);
    step[0] = step[3] = 0.1;
    EXPECT_LT((path.row(1) - path.row(0) - step).norm(), 1e-12);
    EXPECT_LT((path.row(2) - path.row(1) - step).norm(), 1e-12);
  }
}

// The toe's place is that of its joint, else the foot's tip, else the ankle.
TEST(FootPaths, OfARigWithoutToesEndInTheFootsTipOrTheAnkle) {
  const MotionLibrary library = openMotionLibrary("default");
  JointRoles roles = library.roles;
  const Clip clip = standing(library, 1);
  const Eigen::MatrixXd with_toe = footPaths(clip, roles)[kLeft];
  roles.legs[kLeft].toe = -1;
  const Eigen::MatrixXd without = footPaths(clip, roles)[kLeft];
  EXPECT_EQ(without.leftCols(3), with_toe.leftCols(3));
  EXPECT_EQ(without.rightCols(3), without.leftCols(3));
  std::vector<Joint> joints = library.skeleton.joints();
  joints[roles.legs[kLeft].foot].end_sites = {joints[library.roles.legs[kLeft].toe].offset};
  Clip tipped = clip;
  tipped.skeleton = Skeleton(std::move(joints));
  EXPECT_LT((footPaths(tipped, roles)[kLeft] - with_toe).norm(), 1e-12);
}

TEST(FootPaths, LegsAreAsLongAsThighAndShank) {
  const MotionLibrary library = openMotionLibrary("default");
  const auto lengths = legLengths(standing(library, 1), library.roles);
  for (const Side side : {kLeft, kRight}) {
    EXPECT_NEAR(lengths[side], kLegOfStature * library.stature, 0.03 * library.stature);
  }
  EXPECT_NEAR(lengths[kLeft], lengths[kRight], 0.01);
}

}  // namespace
}  // namespace amble
