#include "animation/preparation/gait_track.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "tests/animation/random_clip.h"
#include "tests/animation/rig.h"

namespace amble {
namespace {

TEST(GaitTrack, EveryWholePlantIsFoundWhenItIs) {
  const Rig rig;
  for (const double turn_rate : {0.0, 0.4, -0.4}) {
    Puppet puppet;
    puppet.speed = 1.0;
    puppet.turn_rate = turn_rate;
    const Clip clip = rig.walk(puppet);
    const GaitTrack track(clip, rig.roles, rig.feet);
    for (const Side side : {kLeft, kRight}) {
      size_t whole = 0;
      for (int cycle = 1; puppet.liftOff(side, cycle) + 0.1 < puppet.duration; ++cycle) {
        bool found = false;
        for (const Plant& plant : track.plants(side)) {
          // Thresholds of speed lie within a few hundredths of a second of the contact.
          found = found ||
                  (std::abs(plant.strike * clip.frame_time - puppet.strike(side, cycle)) < 0.05 &&
                   std::abs(plant.lift_off * clip.frame_time - puppet.liftOff(side, cycle)) < 0.05);
        }
        EXPECT_TRUE(found) << "side " << side << ", cycle " << cycle;
        ++whole;
      }
      EXPECT_LE(track.plants(side).size(), whole + 2);
    }
  }
}

TEST(GaitTrack, FlatFeetStandOnThePrintsThatWereDrawn) {
  const Rig rig;
  Puppet puppet;
  puppet.speed = 1.0;
  puppet.turn_rate = 0.3;
  const Clip clip = rig.walk(puppet);
  const GaitTrack track(clip, rig.roles, rig.feet);
  for (const Side side : {kLeft, kRight}) {
    for (const Plant& plant : track.plants(side)) {
      const GaitTrack::FlatFoot flat = track.flatFoot(side, plant);
      const double time = 0.5 * (plant.strike + plant.lift_off) * clip.frame_time;
      const auto [ankle, heading] = puppet.ankle(side, time);
      EXPECT_NEAR(wrapAngle(flat.heading - heading), 0.0, 1e-6);
      EXPECT_NEAR(flat.print.z(), 0.0, 1e-4);
      const Eigen::Vector3d on_S(rig.feet[side].ankle_x, 0, 0);
      EXPECT_LT((flat.print + aboutZ(heading) * on_S - ankle).head<2>().norm(), 1e-4);
      EXPECT_LT(flat.correction.angularDistance(Eigen::Quaterniond::Identity()), 1e-4);
    }
  }
}

TEST(GaitTrack, AFootThatPointsUpWhileItStandsIsCorrectedToBeFlat) {
  const Rig rig;
  Clip clip = rig.walk(Puppet());
  for (int i = 0; i < clip.frames(); ++i) {  // markers put 15 degrees too high
    Eigen::Quaterniond& q = clip.poses.rotations(i)[rig.roles.legs[kLeft].foot];
    q = q * expRotation({-15.0 * kDegree, 0, 0});
  }
  const GaitTrack track(clip, rig.roles, rig.feet);
  ASSERT_FALSE(track.plants(kLeft).empty());
  const Plant plant = track.plants(kLeft)[1];
  const GaitTrack::FlatFoot flat = track.flatFoot(kLeft, plant);
  EXPECT_NEAR(flat.correction.angularDistance(Eigen::Quaterniond::Identity()), 15.0 * kDegree,
              1e-4);
  const Eigen::Quaterniond q =
      track.sole(kLeft, 0.5 * (plant.strike + plant.lift_off), flat.correction);
  EXPECT_NEAR((q * Eigen::Vector3d::UnitZ()).z(), 1.0, 1e-6);
}

TEST(GaitTrack, HeadingIsThatOfThePelvis) {
  const Rig rig;
  Puppet puppet;
  puppet.speed = 1.0;
  puppet.turn_rate = -0.7;
  const Clip clip = rig.walk(puppet);
  const GaitTrack track(clip, rig.roles, rig.feet);
  for (const double frame : {0.0, 10.5, 123.25, 599.0}) {
    EXPECT_NEAR(wrapAngle(track.headingAt(frame) - puppet.heading(frame * clip.frame_time)), 0.0,
                1e-6);
  }
}

TEST(GaitTrack, WholeFramesAreTheClipsOwnAndOthersLieBetween) {
  const Rig rig;
  const Clip clip = rig.walk(Puppet());
  const GaitTrack track(clip, rig.roles, rig.feet);
  for (const int frame : {0, 7, clip.frames() - 1}) {
    const auto joints = jointFrames(clip, frame);
    for (size_t j = 0; j < joints.size(); ++j) {
      EXPECT_LT((track.jointsAt(frame)[j].p_WJ - joints[j].p_WJ).norm(), 1e-12);
    }
  }
  Pose between;
  between.rotations.resize(clip.skeleton.size());
  track.poseAt(7.25, between);
  const Eigen::Vector3d p = 0.75 * clip.poses.p_WR(7) + 0.25 * clip.poses.p_WR(8);
  EXPECT_LT((between.p_WR - p).norm(), 1e-14);
}

TEST(GaitTrack, AWalkerThatStandsHasNoPlants) {
  const Rig rig;
  Puppet puppet;
  puppet.speed = 0.0;
  puppet.stance = 1.0;
  puppet.lift = 0.0;
  const Clip clip = rig.walk(puppet);
  const GaitTrack track(clip, rig.roles, rig.feet);
  EXPECT_TRUE(track.plants(kLeft).empty());
  EXPECT_TRUE(track.plants(kRight).empty());
}

}  // namespace
}  // namespace amble
