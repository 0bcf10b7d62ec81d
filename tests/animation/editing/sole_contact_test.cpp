#include "animation/editing/sole_contact.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "animation/analysis/motion_measures.h"
#include "animation/clips/level_capture.h"
#include "base/rotation.h"
#include "tests/animation/captures.h"
#include "tests/animation/rig.h"

namespace amble {
namespace {

/// Lowest point of a sole: heel, ball and, of its toes, the tip [m].
struct Soles {
  const JointRoles& roles;
  std::array<FootShape, 2> shapes;

  double lowest(const Clip& clip, int frame, Side side) const {
    std::vector<JointFrame> joints(clip.skeleton.size());
    forwardKinematics(clip, frame, joints);
    const FootShape& shape = shapes[side];
    const JointFrame &foot = joints[roles.legs[side].foot], &toe = joints[roles.legs[side].toe];
    const SoleEnds ends = soleEnds(shape, foot.p_WJ, foot.q_WJ);
    const Eigen::Vector3d tip =
        toe.q_WJ * shape.q_SF.conjugate() * Eigen::Vector3d(shape.tip_x - shape.ball_x, 0, 0);
    return std::min({ends.heel.z(), ends.ball.z(), ends.ball.z() + tip.z()});
  }
};

Clip rested(const Clip& clip, const JointRoles& roles, const std::array<FootShape, 2>& shapes,
            const FootPlants& plants, TrackFit* fit = nullptr) {
  WalkTracks tracks = tracksOf(clip, roles);
  restOnFloor(clip, roles, shapes, plants, tracks);
  return followTracks(clip, roles, tracks, fit);
}

/// A puppet that rolls from its heels over its balls, so much over the floor, and its toes bent.
struct Sunk {
  Puppet puppet;
  Rig rig;
  Soles soles{rig.roles, rig.feet};
  Clip clip;

  explicit Sunk(double height, double toes = 0.0) {
    puppet.pitch = [](double at) { return 0.3 * std::sin(2.0 * kPi * at); };
    clip = rig.walk(puppet);
    for (int i = 0; i < clip.frames(); ++i) {
      clip.poses.p_WR(i).z() += height;
      for (const LegJoints& leg : rig.roles.legs) {
        clip.poses.rotations(i)[leg.toe] = Eigen::AngleAxisd(toes, Eigen::Vector3d::UnitX());
      }
    }
  }
  Clip on() const { return rested(clip, rig.roles, rig.feet, puppet.plants()); }
};

TEST(SoleContact, ASoleThatStandsIsOnTheFloorAndNoneIsInIt) {
  for (const double height : {-0.03, -0.01, 0.01}) {
    const Sunk walk(height);
    const Clip on = walk.on();
    const FootPlants plants = walk.puppet.plants();
    for (const Side side : {kLeft, kRight}) {
      for (int i = 0; i < on.frames(); ++i) {
        const double lowest = walk.soles.lowest(on, i, side);
        EXPECT_GT(lowest, -1e-3) << height << " " << i;
        EXPECT_LT(lowest, plants.planted(side, i) ? 0.005 : 1.0) << height << " " << i;
      }
    }
  }
}

TEST(SoleContact, TheWholeBodyComesUpWithFeetThatAreAllAsDeep) {
  const Sunk walk(-0.02), as_it_was(0.0);
  const Clip on = walk.on(), was = as_it_was.on();
  for (int i = on.frames() / 4; i < 3 * on.frames() / 4; ++i) {
    EXPECT_NEAR(on.poses.p_WR(i).z(), was.poses.p_WR(i).z(), 0.005);
  }
}

TEST(SoleContact, ToesThatPointIntoTheFloorAreBentUpAndTheirFeetHardlyMoved) {
  const double down = 0.5;  // [rad]
  const Sunk straight(0.0), bent(0.0, down);
  const Clip on = bent.on(), without = straight.on();
  const FootPlants plants = bent.puppet.plants();
  const int toe = bent.rig.roles.legs[kLeft].toe, foot = bent.rig.roles.legs[kLeft].foot;
  std::vector<JointFrame> a(on.skeleton.size()), b(on.skeleton.size());
  for (const FootPlant& plant : plants.plants[kLeft]) {
    const int middle = (plant.first + plant.last) / 2;
    EXPECT_LT(Eigen::AngleAxisd(on.poses.rotations(middle)[toe]).angle(), 0.6 * down);
    forwardKinematics(on, middle, a);
    forwardKinematics(without, middle, b);
    EXPECT_NEAR(a[foot].p_WJ.z(), b[foot].p_WJ.z(), 0.003);
  }
}

TEST(SoleContact, NothingIsMovedAlongTheFloorOrTurned) {
  const Sunk walk(-0.02);
  const WalkTracks before = tracksOf(walk.clip, walk.rig.roles),
                   after = tracksOf(walk.on(), walk.rig.roles);
  for (const Side side : {kLeft, kRight}) {
    for (int i = 0; i < walk.clip.frames(); ++i) {
      const Eigen::Vector3d by = after.feet[side].ankle[i] - before.feet[side].ankle[i];
      EXPECT_LT(by.head<2>().norm(), 1e-6);
      EXPECT_LT(after.feet[side].q_WF[i].angularDistance(before.feet[side].q_WF[i]), 1e-6);
    }
  }
}

// Captured feet know no soles; what they come to is as smooth as they were.
TEST(SoleContact, CapturedWalksAreOnTheFloorAndAsSmoothAsTheyWere) {
  AMBLE_NEEDS_CAPTURES();
  for (const char* const path :
       {"accad_female1/Female1_B03_Walk1.bvh", "cmu_mb2/02_01.bvh", "cmu_mb2/08_01.bvh"}) {
    const LevelCapture capture = readLevelCapture(sharedFolder() / "mocap" / path);
    Clip clip = capture.motion.clip;
    clip.joint_positions.clear();
    const JointRoles& roles = capture.motion.roles;
    const Soles soles{roles, makeFootShapes(clip.skeleton, roles, statureOf(clip.skeleton, roles))};
    const FootPlants plants = detectPlants(clip, roles);
    TrackFit fit;
    const Clip on = rested(clip, roles, soles.shapes, plants, &fit);
    double before = 0.0, after = 0.0;
    for (const Side side : {kLeft, kRight}) {
      for (int i = 0; i < clip.frames(); ++i) {
        before = std::min(before, soles.lowest(clip, i, side));
        after = std::min(after, soles.lowest(on, i, side));
      }
    }
    EXPECT_LT(before, -0.008) << path;
    EXPECT_GT(after, -0.002 - fit.missed) << path;
    EXPECT_LT(jointJerk(on), 1.1 * jointJerk(clip)) << path;
    EXPECT_LT(rootAcceleration(on), 1.15 * rootAcceleration(clip)) << path;
    EXPECT_LT(pops(on), std::max(2.5, 1.05 * pops(clip))) << path;
  }
}

}  // namespace
}  // namespace amble
