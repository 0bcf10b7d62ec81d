#include "animation/editing/foot_lock.h"

#include <gtest/gtest.h>

#include "animation/analysis/gait_measures.h"
#include "animation/analysis/motion_measures.h"
#include "animation/clips/good_frames.h"
#include "animation/clips/level_capture.h"
#include "tests/animation/captures.h"
#include "tests/animation/rig.h"

namespace amble {
namespace {

/// Straight walks and turns of three kinds of rigs.
const std::array<std::string, 5> kWalks = {
    "accad_female1/Female1_B03_Walk1.bvh", "accad_female1/Female1_B12_WalkTurnRight90.bvh",
    "accad_male1/Male1_B3_Walk.bvh", "cmu_mb2/02_01.bvh", "cmu_mb2/07_03.bvh"};

struct HeldWalk {
  JointRoles roles;
  Clip before, after;
  FootLock lock;
};

HeldWalk held(const std::string& path) {
  const LevelCapture capture = readLevelCapture(sharedFolder() / "mocap" / path);
  HeldWalk walk{capture.motion.roles, capture.motion.clip, {}, {}};
  walk.before.joint_positions.clear();
  const FootPlants plants = detectPlants(walk.before, walk.roles);
  walk.after = lockFeet(walk.before, walk.roles, plants, &walk.lock);
  return walk;
}

GaitMeasures measured(const Clip& clip, const JointRoles& roles) {
  return measureGait(clip, roles, detectPlants(clip, roles));
}

TEST(FootLock, WhoeverFindsPlantsHimselfSeesThemStay) {
  AMBLE_NEEDS_CAPTURES();
  for (const std::string& path : kWalks) {
    const HeldWalk walk = held(path);
    const GaitMeasures gait = measured(walk.after, walk.roles);
    EXPECT_GT(measured(walk.before, walk.roles).largest_drift, 0.004) << path;
    EXPECT_LT(gait.largest_drift, 0.002) << path;
    EXPECT_LT(gait.toe_skate, 0.010) << path;
  }
}

TEST(FootLock, MotionStaysAsSmoothAsItWas) {
  AMBLE_NEEDS_CAPTURES();
  for (const std::string& path : kWalks) {
    const HeldWalk walk = held(path);
    EXPECT_LT(jointJerk(walk.after), 1.1 * jointJerk(walk.before)) << path;
    EXPECT_LT(rootAcceleration(walk.after), 1.15 * rootAcceleration(walk.before)) << path;
    EXPECT_EQ(kneeBackwardsShare(walk.after, walk.roles), 0.0) << path;
    EXPECT_LT(walk.lock.farthest, 0.05) << path;
    EXPECT_LT(walk.lock.fit.lowered, 0.02) << path;
    EXPECT_LT(walk.lock.fit.missed, 1e-9) << path;
  }
}

TEST(FootLock, OnlyLegsAndTheRootsPlaceChangeAndNoFootsHeightOrTurn) {
  AMBLE_NEEDS_CAPTURES();
  const HeldWalk walk = held(kWalks[0]);
  std::vector<bool> of_legs(walk.before.skeleton.size(), false);
  for (const LegJoints& leg : walk.roles.legs) {
    for (const int joint : {leg.up_leg, leg.leg, leg.foot}) of_legs[joint] = true;
  }
  const WalkTracks before = tracksOf(walk.before, walk.roles),
                   after = tracksOf(walk.after, walk.roles);
  for (int i = 0; i < walk.before.frames(); ++i) {
    for (int j = 0; j < walk.before.skeleton.size(); ++j) {
      if (of_legs[j]) continue;
      EXPECT_EQ(walk.after.poses.rotations(i)[j].coeffs(),
                walk.before.poses.rotations(i)[j].coeffs());
    }
    for (const Side side : {kLeft, kRight}) {
      const FootTrack &from = before.feet[side], &to = after.feet[side];
      EXPECT_NEAR(to.ankle[i].z(), from.ankle[i].z(), 1e-9);
      EXPECT_LT(to.q_WF[i].angularDistance(from.q_WF[i]), 1e-7);
    }
  }
}

TEST(FootLock, AFootThatSlidesEvenlyStandsInTheMiddleOfItsSlide) {
  Puppet puppet;
  puppet.slide = 0.03;
  const Rig rig;
  const Clip clip = rig.walk(puppet);
  const FootPlants plants = puppet.plants();
  const Clip still = lockFeet(clip, rig.roles, plants);
  const FootPaths paths = footPaths(still, rig.roles);
  const double toe = Puppet::kFoot;
  for (int cycle = 1; cycle < 4; ++cycle) {
    const double middle = 0.5 * (puppet.strike(kLeft, cycle) + puppet.liftOff(kLeft, cycle));
    const Eigen::Vector3d print = puppet.footprint(kLeft, cycle);
    for (const double from_middle : {-0.2, 0.0, 0.2}) {
      const auto frame =
          static_cast<Eigen::Index>(std::lround((middle + from_middle) * puppet.rate));
      EXPECT_NEAR(paths[kLeft](frame, 3), print.x() + toe, 5e-4) << cycle;
      EXPECT_NEAR(paths[kLeft](frame, 4), print.y(), 1e-6) << cycle;
    }
  }
}

/// Stands still for a while, both feet sliding; then one of them goes on.
struct SlidingStand {
  static constexpr int kFrames = 300, kLifts = 200;  // and is in the air for 30
  static constexpr double kSlide = 0.0002;           // forward a frame [m]
  Rig rig;
  Clip clip;
  FootPlants plants;

  SlidingStand() {
    Puppet puppet;
    puppet.speed = 0.0;
    const Clip walk = rig.walk(puppet);
    clip = walk;
    clip.poses = PoseArray(walk.skeleton.size());
    for (int i = 0; i < kFrames; ++i) {
      clip.poses.append(walk.poses[0]);
      clip.poses.p_WR(i).x() += kSlide * i;
    }
    std::array<std::vector<bool>, 2> planted;
    planted[kLeft].assign(kFrames, true);
    planted[kRight] = planted[kLeft];
    for (int i = kLifts; i < kLifts + 30; ++i) planted[kRight][i] = false;
    plants = plantsOf(planted);
    for (std::vector<FootPlant>& of_foot : plants.plants) {  // before the clip and after it, too
      of_foot.front().strike = -kFrames;
      of_foot.back().lift_off = 2.0 * kFrames;
    }
  }
};

TEST(FootLock, AFootThatStandsOnBeyondTheClipIsHeldToItsEnds) {
  const SlidingStand stand;
  const FootPaths paths =
      footPaths(lockFeet(stand.clip, stand.rig.roles, stand.plants), stand.rig.roles);
  for (int i = 0; i < SlidingStand::kFrames; ++i) {
    EXPECT_NEAR(paths[kLeft](i, 3), paths[kLeft](0, 3), 1e-5) << i;
  }
}

// A marker that jumps as the clip begins: the curve of the correction is as steep there.
TEST(FootLock, AFootThatComesDownAsTheClipBeginsIsNotFlungOffByAJump) {
  constexpr double kJump = 0.04;  // [m]
  Puppet puppet;
  const Rig rig;
  const Clip walk = rig.walk(puppet);
  const int strike = static_cast<int>(std::lround(puppet.strike(kLeft, 1) * puppet.rate));
  const FootPlants all = puppet.plants();
  for (int after = 1; after < 20; ++after) {
    Clip clip = trimmed(walk, strike, walk.frames() - 1);
    for (int i = 0; i < after; ++i) clip.poses.p_WR(i).x() += kJump;
    std::array<std::vector<bool>, 2> planted;
    for (const Side side : {kLeft, kRight}) {
      const std::vector<bool> whole = all.planted(side);
      planted[side].assign(whole.begin() + strike, whole.end());
    }
    const FootPaths before = footPaths(clip, rig.roles);
    const FootPaths held = footPaths(lockFeet(clip, rig.roles, plantsOf(planted)), rig.roles);
    for (int i = 0; i < 25; ++i) {
      EXPECT_LT((held[kLeft].row(i) - before[kLeft].row(i)).tail<3>().norm(), 2.5 * kJump)
          << after << " " << i;
    }
  }
}

// And not in the mean of where it slides: there the legs stand as they do in standing.
TEST(FootLock, WhoStandsAtAnEndIsHeldWhereHeStandsThere) {
  const SlidingStand stand;
  const WalkTracks slid = tracksOf(stand.clip, stand.rig.roles);
  for (const bool at_begin : {true, false}) {
    LockOptions options;
    options.widths.assign(SlidingStand::kFrames, kFootLockWidth);
    options.longest_loose = 0.08;
    options.stands_at_begin = at_begin;
    options.stands_at_end = !at_begin;
    WalkTracks held = slid;
    lockTracks(stand.plants, stand.clip.frame_time, options, held);
    const int end = at_begin ? 0 : SlidingStand::kFrames - 1;
    const auto toe = [&](const WalkTracks& tracks, Side side, int i) {
      return tracks.feet[side].toe[i];
    };
    for (int i = 0; i < SlidingStand::kFrames; ++i) {
      EXPECT_NEAR(toe(held, kLeft, i).x(), toe(slid, kLeft, end).x(), 1e-5) << i;
    }
    EXPECT_NEAR(toe(held, kRight, end).x(), toe(slid, kRight, end).x(), 1e-5);
    // The foot that lifts stands at the other end in the mean of that plant, to the frames that are
    // not held.
    const auto& of_right = stand.plants.plants[kRight];
    const FootPlant& other_plant = at_begin ? of_right.back() : of_right.front();
    const int middle = (other_plant.first + other_plant.last) / 2;
    EXPECT_NEAR(toe(held, kRight, middle).x(), toe(slid, kRight, middle).x(),
                5.0 * SlidingStand::kSlide);
  }
}

TEST(FootLock, FeetThatStandAreGivenBack) {
  Puppet puppet;
  const Rig rig;
  const Clip clip = rig.walk(puppet);
  const Clip same = lockFeet(clip, rig.roles, puppet.plants());
  for (int i = 0; i < clip.frames(); ++i) {
    EXPECT_LT((same.poses.p_WR(i) - clip.poses.p_WR(i)).norm(), 1e-3);
  }
}

}  // namespace
}  // namespace amble
