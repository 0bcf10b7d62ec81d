#include "animation/body/rest_feet.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rotation.h"
#include "tests/animation/rig.h"

namespace amble {
namespace {

// The rig with its toe joint `degrees` below the ankle's level.
Skeleton dropped(const Rig& rig, Side side, double degrees) {
  std::vector<Joint> joints = rig.skeleton.joints();
  Joint& toe = joints[rig.roles.legs[side].toe];
  const double length = toe.offset.norm();
  toe.offset =
      length * Eigen::Vector3d(0.0, -std::sin(degrees * kDegree), std::cos(degrees * kDegree));
  return Skeleton(std::move(joints));
}

TEST(RestFeet, TheWorseFootCountsInAnyUnit) {
  const Rig rig;
  const double own = restFootDrop(rig.skeleton, rig.roles);
  EXPECT_LT(own, kHangingFoot);
  for (const Side side : {kLeft, kRight}) {
    for (const double degrees : {50.0, 78.0, 90.0}) {
      const Skeleton hangs = dropped(rig, side, degrees);
      EXPECT_NEAR(restFootDrop(hangs, rig.roles), degrees * kDegree, 1e-6);
      EXPECT_NEAR(restFootDrop(hangs.scaled(100.0), rig.roles), degrees * kDegree, 1e-6);
      EXPECT_EQ(restFootDrop(hangs, rig.roles) > kHangingFoot, degrees > 70.0);
    }
  }
}

// Toes above the ankle's level, of a foot drawn from the sole up, are no drop.
TEST(RestFeet, ToesAboveTheAnkleDoNotHang) {
  const Rig rig;
  const Skeleton up = dropped(rig, kLeft, -20.0);
  EXPECT_NEAR(restFootDrop(up, rig.roles), restFootDrop(rig.skeleton, rig.roles), 1e-9);
}

TEST(RestFeet, ARigHasTheFootDropsThatItIsGivenAndNothingElseOfItMoves) {
  const Rig rig;
  const std::array<double, 2> drops = {5.0 * kDegree, 38.0 * kDegree};
  const Skeleton other = withFootDrops(rig.skeleton, rig.roles, drops);
  const std::array<double, 2> has = footDrops(other, rig.roles);
  for (const Side side : {kLeft, kRight}) {
    EXPECT_NEAR(has[side], drops[side], 1e-12);
    const int toe = rig.roles.legs[side].toe;
    EXPECT_NEAR(other.joint(toe).offset.norm(), rig.skeleton.joint(toe).offset.norm(), 1e-12);
    EXPECT_EQ(other.joint(toe).end_sites, rig.skeleton.joint(toe).end_sites);
  }
  const Skeleton back = withFootDrops(other, rig.roles, footDrops(rig.skeleton, rig.roles));
  for (int j = 0; j < rig.skeleton.size(); ++j) {
    EXPECT_LT((back.joint(j).offset - rig.skeleton.joint(j).offset).norm(), 1e-12) << j;
    const bool is_toe = j == rig.roles.legs[kLeft].toe || j == rig.roles.legs[kRight].toe;
    EXPECT_EQ(other.joint(j).offset == rig.skeleton.joint(j).offset, !is_toe) << j;
  }
}

}  // namespace
}  // namespace amble
