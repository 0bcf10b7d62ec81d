// What is read off a motion is the walker's: it does not depend on where the walker is, which way
// the way goes, which hand is left or how large the walker is. Of captures of every kind.

#include <gtest/gtest.h>

#include <cmath>

#include "animation/analysis/classify_clip.h"
#include "animation/analysis/gait_events.h"
#include "animation/analysis/gait_measures.h"
#include "animation/analysis/gait_phase.h"
#include "animation/analysis/motion_measures.h"
#include "base/rotation.h"
#include "tests/animation/moved_clip.h"
#include "tests/animation/some_captures.h"

namespace amble {
namespace {

/// Feet seen elsewhere: turned about the vertical, then shifted.
FootPaths elsewhere(const FootPaths& paths, double turn, const Eigen::Vector3d& shift) {
  const Eigen::Matrix3d R = aboutZ(turn).toRotationMatrix();
  FootPaths moved = paths;
  for (Eigen::MatrixXd& path : moved) {
    for (const int joint : {0, 3}) {
      path.middleCols(joint, 3) =
          (path.middleCols(joint, 3) * R.transpose()).rowwise() + shift.transpose();
    }
  }
  return moved;
}

/// Feet seen in a mirror along the way: left is right.
FootPaths mirroredPaths(const FootPaths& paths) {
  FootPaths image = {paths[kRight], paths[kLeft]};
  for (Eigen::MatrixXd& path : image) {
    path.col(1) *= -1.0;
    path.col(4) *= -1.0;
  }
  return image;
}

FootPaths enlarged(const FootPaths& paths, double scale) {
  return {scale * paths[kLeft], scale * paths[kRight]};
}

FootPlants exchanged(const FootPlants& plants) {
  return {{plants.plants[kRight], plants.plants[kLeft]}, plants.frames};
}

void expectSamePlants(const FootPlants& found, const FootPlants& wanted, const std::string& path) {
  ASSERT_EQ(found.frames, wanted.frames) << path;
  for (const Side side : {kLeft, kRight}) {
    ASSERT_EQ(found.plants[side].size(), wanted.plants[side].size()) << path;
    for (size_t i = 0; i < wanted.plants[side].size(); ++i) {
      const FootPlant &a = found.plants[side][i], &b = wanted.plants[side][i];
      EXPECT_EQ(a.first, b.first) << path;
      EXPECT_EQ(a.last, b.last) << path;
      EXPECT_NEAR(a.strike, b.strike, 1e-5) << path;
      EXPECT_NEAR(a.lift_off, b.lift_off, 1e-5) << path;
    }
  }
}

class Symmetries : public testing::Test {
 protected:
  void SetUp() override { AMBLE_NEEDS_CAPTURES(); }
};

TEST_F(Symmetries, ManyKindsOfMotionAreLookedAt) {
  std::set<std::string> kinds;
  for (const SomeCapture& one : someCaptures()) kinds.insert(one.kind);
  EXPECT_GT(kinds.size(), 10u);
}

TEST_F(Symmetries, PlantsAreTheSameWhereverAWalkIsAndWhicheverWayItGoes) {
  for (const SomeCapture& one : someCaptures()) {
    for (const double turn : {0.5, 2.0, -1.3}) {
      const FootPaths moved = elsewhere(one.paths, turn, {3.0, -2.0, 0.7});
      expectSamePlants(detectPlants(moved, one.legs, one.clip.frame_time), one.plants, one.path);
    }
  }
}

TEST_F(Symmetries, PlantsOfAMirrorImageAreThoseOfTheOtherFoot) {
  for (const SomeCapture& one : someCaptures()) {
    const FootPlants image = detectPlants(mirroredPaths(one.paths),
                                          {one.legs[kRight], one.legs[kLeft]}, one.clip.frame_time);
    expectSamePlants(image, exchanged(one.plants), one.path);
  }
}

// But for the floor, whose tilt is held towards level by a spread in metres (floor_fit.h): strikes
// move by a part of a frame.
TEST_F(Symmetries, PlantsOfAGiantAndOfADwarfAreThoseOfThePerson) {
  for (const SomeCapture& one : someCaptures()) {
    for (const double scale : {0.7, 1.4}) {
      const FootPlants found =
          detectPlants(enlarged(one.paths, scale), {scale * one.legs[0], scale * one.legs[1]},
                       one.clip.frame_time);
      for (const Side side : {kLeft, kRight}) {
        const auto &here = one.plants.plants[side], &there = found.plants[side];
        ASSERT_EQ(there.size(), here.size()) << one.path;
        for (size_t i = 0; i < here.size(); ++i) {
          EXPECT_NEAR(there[i].strike, here[i].strike, 0.01 / one.clip.frame_time) << one.path;
          EXPECT_NEAR(there[i].lift_off, here[i].lift_off, 0.01 / one.clip.frame_time) << one.path;
        }
      }
    }
  }
}

TEST_F(Symmetries, PlantsAreRunsOfTheFramesThatTheyMark) {
  for (const SomeCapture& one : someCaptures()) {
    for (const Side side : {kLeft, kRight}) {
      const std::vector<bool> marked = one.plants.planted(side);
      ASSERT_EQ(static_cast<int>(marked.size()), one.clip.frames());
      int frames = 0, last = -2;
      for (const FootPlant& plant : one.plants.plants[side]) {
        EXPECT_GT(plant.first, last + 1) << one.path << ": plants that touch are one";
        EXPECT_LE(plant.first - 1, plant.strike) << one.path;
        EXPECT_LT(plant.last, plant.lift_off) << one.path;
        last = plant.last;
        for (int i = plant.first; i <= plant.last; ++i) {
          EXPECT_TRUE(marked[i] && one.plants.planted(side, i)) << one.path;
        }
        frames += plant.last - plant.first + 1;
      }
      EXPECT_EQ(std::count(marked.begin(), marked.end(), true), frames) << one.path;
    }
  }
}

TEST_F(Symmetries, NoPlantOrGapIsShorterThanTheOptionsAllow) {
  const PlantOptions options;
  for (const SomeCapture& one : someCaptures()) {
    for (const std::vector<FootPlant>& plants : one.plants.plants) {
      for (size_t i = 1; i < plants.size(); ++i) {
        EXPECT_GT(plants[i].strike - plants[i - 1].lift_off, 0.0) << one.path;
      }
      for (const FootPlant& plant : plants) {
        if (plant.first == 0 || plant.last == one.plants.frames - 1) continue;
        EXPECT_GT((plant.lift_off - plant.strike) * one.clip.frame_time,
                  0.3 * options.shortest_plant)
            << one.path;
      }
    }
  }
}

TEST_F(Symmetries, AMirrorImageIsOfTheSameKindFrameByFrame) {
  for (const SomeCapture& one : someCaptures()) {
    const ClipClass here = classifyClip(one.plants, one.clip.frame_time);
    const ClipClass image = classifyClip(exchanged(one.plants), one.clip.frame_time);
    EXPECT_EQ(image.type, here.type) << one.path;
    EXPECT_EQ(image.frames, here.frames) << one.path;
    EXPECT_EQ(image.share, here.share) << one.path;
  }
}

TEST_F(Symmetries, TokensSayWhichFeetArePlanted) {
  for (const SomeCapture& one : someCaptures()) {
    const std::vector<Support> tokens = supportTokens(one.plants);
    ASSERT_EQ(static_cast<int>(tokens.size()), one.plants.frames) << one.path;
    for (int i = 0; i < one.plants.frames; ++i) {
      const bool left = one.plants.planted(kLeft, i), right = one.plants.planted(kRight, i);
      EXPECT_EQ(tokens[i] == Support::kLeft || tokens[i] == Support::kBoth, left) << one.path;
      EXPECT_EQ(tokens[i] == Support::kRight || tokens[i] == Support::kBoth, right) << one.path;
    }
  }
}

TEST_F(Symmetries, PhaseOfAMirrorImageIsHalfACycleOff) {
  int seen = 0;
  for (const SomeCapture& one : someCaptures()) {
    const std::vector<PhaseMoment> here = gaitPhase(one.plants);
    const std::vector<PhaseMoment> image = gaitPhase(exchanged(one.plants));
    ASSERT_EQ(image.size(), here.size()) << one.path;
    for (size_t i = 0; i < here.size(); ++i) {
      EXPECT_EQ(image[i].frame, here[i].frame) << one.path;
      const double off = image[i].phase - here[i].phase;
      EXPECT_NEAR(std::abs(std::remainder(off, 1.0)), 0.5, 1e-12) << one.path;
      ++seen;
    }
  }
  EXPECT_GT(seen, 50);
}

TEST_F(Symmetries, PhaseMomentsAreInOrderHalfACycleApart) {
  for (const SomeCapture& one : someCaptures()) {
    const std::vector<PhaseMoment> moments = gaitPhase(one.plants);
    for (size_t i = 0; i < moments.size(); ++i) {
      EXPECT_GE(moments[i].frame, 0.0) << one.path;
      EXPECT_LE(moments[i].frame, one.clip.frames() - 1.0) << one.path;
      if (i == 0) continue;
      EXPECT_GT(moments[i].frame, moments[i - 1].frame) << one.path;
      EXPECT_NEAR(moments[i].phase - moments[i - 1].phase, 0.5, 1e-12) << one.path;
    }
  }
}

bool sameMoment(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || std::abs(a - b) < 1e-4;
}

TEST_F(Symmetries, EventsAreTheSameWhereverAWalkIsAndOfTheOtherFootInAMirror) {
  for (const SomeCapture& one : someCaptures()) {
    const double time = one.clip.frame_time;
    const GaitEvents here = findGaitEvents(footCurves(one.paths, one.legs, time, one.plants), time,
                                           one.plants, one.paths);
    const FootPaths moved = elsewhere(one.paths, 1.1, {-7.0, 4.0, 0.0});
    const GaitEvents there =
        findGaitEvents(footCurves(moved, one.legs, time, one.plants), time, one.plants, moved);
    const FootPaths mirror = mirroredPaths(one.paths);
    const FootPlants other_plants = exchanged(one.plants);
    const GaitEvents image =
        findGaitEvents(footCurves(mirror, {one.legs[kRight], one.legs[kLeft]}, time, other_plants),
                       time, other_plants, mirror);
    for (const Side side : {kLeft, kRight}) {
      ASSERT_EQ(there.swings[side].size(), here.swings[side].size()) << one.path;
      ASSERT_EQ(image.swings[other(side)].size(), here.swings[side].size()) << one.path;
      for (size_t i = 0; i < here.swings[side].size(); ++i) {
        for (const auto event : {&SwingEvents::lift, &SwingEvents::lift_off, &SwingEvents::strike,
                                 &SwingEvents::landing}) {
          const double wanted = here.swings[side][i].*event;
          EXPECT_TRUE(sameMoment(there.swings[side][i].*event, wanted)) << one.path;
          EXPECT_TRUE(sameMoment(image.swings[other(side)][i].*event, wanted)) << one.path;
        }
      }
    }
  }
}

/// The same motion of a body `scale` times as large.
Clip enlarged(const Clip& clip, double scale) {
  Clip large = clip;
  large.skeleton = clip.skeleton.scaled(scale);
  for (int i = 0; i < clip.frames(); ++i) large.poses.p_WR(i) *= scale;
  for (Eigen::Vector3d& p : large.joint_positions) p *= scale;
  return large;
}

void expectNear(double found, double wanted, const std::string& what) {
  EXPECT_NEAR(found, wanted, 1e-6 * std::max(1.0, std::abs(wanted))) << what;
}

TEST_F(Symmetries, LengthsSpeedsAndJerkGrowWithTheBodyAndTimesDoNot) {
  for (const SomeCapture& one : someCaptures()) {
    const double s = 1.6;
    const GaitMeasures small = measureGait(one.clip, one.roles, one.plants);
    const GaitMeasures large = measureGait(enlarged(one.clip, s), one.roles, one.plants);
    expectNear(large.speed, s * small.speed, one.path + " speed");
    expectNear(large.toe_skate, s * small.toe_skate, one.path + " skate");
    expectNear(large.drift, s * small.drift, one.path + " drift");
    expectNear(large.largest_drift, s * small.largest_drift, one.path + " largest drift");
    expectNear(large.penetration, s * small.penetration, one.path + " penetration");
    expectNear(large.root_acceleration, s * small.root_acceleration, one.path + " acceleration");
    expectNear(large.joint_jerk, s * small.joint_jerk, one.path + " jerk");
    expectNear(large.leg_length, s * small.leg_length, one.path + " leg");
    expectNear(large.normalised_speed, small.normalised_speed, one.path + " V");
    expectNear(large.cadence, small.cadence, one.path + " cadence");
    expectNear(large.double_support, small.double_support, one.path + " double support");
    expectNear(large.flight, small.flight, one.path + " flight");
    expectNear(large.turn_rate, small.turn_rate, one.path + " turn rate");
    expectNear(large.pops, small.pops, one.path + " pops");
    ASSERT_EQ(large.steps.size(), small.steps.size()) << one.path;
    for (size_t i = 0; i < small.steps.size(); ++i) {
      expectNear(large.steps[i].stride, s * small.steps[i].stride, one.path + " stride");
      expectNear(large.steps[i].width, s * small.steps[i].width, one.path + " width");
      expectNear(large.steps[i].lift, s * small.steps[i].lift, one.path + " lift");
      expectNear(large.steps[i].duration, small.steps[i].duration, one.path + " duration");
    }
  }
}

TEST_F(Symmetries, SharesAreSharesAndNoMeasureIsNegativeOrNoNumber) {
  for (const SomeCapture& one : someCaptures()) {
    const GaitMeasures gait = measureGait(one.clip, one.roles, one.plants);
    for (const double share : {gait.double_support, gait.flight, gait.knee_backwards}) {
      EXPECT_TRUE(share >= 0.0 && share <= 1.0) << one.path << ' ' << share;
    }
    EXPECT_LE(gait.double_support + gait.flight, 1.0 + 1e-12) << one.path;
    for (const double size : {gait.toe_skate, gait.drift, gait.penetration, gait.speed,
                              gait.root_acceleration, gait.joint_jerk, gait.pops, gait.cadence}) {
      EXPECT_TRUE(size >= 0.0 && std::isfinite(size)) << one.path << ' ' << size;
    }
    EXPECT_LE(gait.drift, gait.largest_drift) << one.path;
    EXPECT_TRUE(0.0 <= gait.begin && gait.begin <= gait.end) << one.path;
    EXPECT_LE(gait.end, one.clip.frames() - 1.0) << one.path;
    expectNear(gait.normalised_speed * gait.leg_length, gait.speed, one.path);
    expectNear(gait.cycle_frequency * 120.0, gait.cadence, one.path);
  }
}

// Twice as slow is half as fast, and the captures' own frame rate is no part of it.
TEST_F(Symmetries, ShownSlowlyAWalkHasTheSameStepsAtHalfTheSpeed) {
  for (const SomeCapture& one : someCaptures()) {
    Clip slow = one.clip;
    slow.frame_time *= 2.0;
    const GaitMeasures fast_gait = measureGait(one.clip, one.roles, one.plants);
    const GaitMeasures slow_gait = measureGait(slow, one.roles, one.plants);
    ASSERT_EQ(slow_gait.steps.size(), fast_gait.steps.size()) << one.path;
    expectNear(2.0 * slow_gait.toe_skate, fast_gait.toe_skate, one.path + " skate");
    expectNear(2.0 * slow_gait.cadence, fast_gait.cadence, one.path + " cadence");
    expectNear(slow_gait.drift, fast_gait.drift, one.path + " drift");
    expectNear(slow_gait.double_support, fast_gait.double_support, one.path + " support");
    for (size_t i = 0; i < fast_gait.steps.size(); ++i) {
      expectNear(slow_gait.steps[i].stride, fast_gait.steps[i].stride, one.path + " stride");
      expectNear(slow_gait.steps[i].duration, 2.0 * fast_gait.steps[i].duration, one.path);
    }
  }
}

TEST_F(Symmetries, SmoothnessDoesNotDependOnTheCamera) {
  const Eigen::Quaterniond any = Eigen::Quaterniond(0.3, -0.7, 0.2, 0.6).normalized();
  for (const SomeCapture& one : someCaptures()) {
    const Clip turned = moved(one.clip, any, {4.0, -1.0, 9.0});
    expectNear(rootAcceleration(turned), rootAcceleration(one.clip), one.path);
    expectNear(jointJerk(turned), jointJerk(one.clip), one.path);
    EXPECT_NEAR(pops(turned), pops(one.clip), 1e-4 * pops(one.clip)) << one.path;
    EXPECT_EQ(boneLengthChange(turned), boneLengthChange(one.clip)) << one.path;
  }
}

TEST_F(Symmetries, KneesBendTheSameWayWhereverTheyGo) {
  for (const SomeCapture& one : someCaptures()) {
    EXPECT_EQ(kneeBackwardsShare(moved(one.clip, aboutZ(2.2), {1, 2, 3}), one.roles),
              kneeBackwardsShare(one.clip, one.roles))
        << one.path;
  }
}

TEST_F(Symmetries, AFloorTurnsWithItsCaptureAndGrowsWithIt) {
  for (const SomeCapture& one : someCaptures()) {
    const FloorFit floor = fitFloor(one.paths, one.legs, one.clip.frame_time);
    const FootPaths there = elsewhere(one.paths, 0.9, {0.0, 0.0, 0.4});
    const FloorFit turned = fitFloor(there, one.legs, one.clip.frame_time);
    EXPECT_LT((turned.normal - aboutZ(0.9) * floor.normal).norm(), 1e-9) << one.path;
    EXPECT_NEAR(turned.residual, floor.residual, 1e-9) << one.path;
    EXPECT_NEAR(turned.ankle_mean, floor.ankle_mean + 0.4, 1e-9) << one.path;
    EXPECT_EQ(turned.samples, floor.samples) << one.path;
    EXPECT_EQ(turned.plants, floor.plants) << one.path;
    EXPECT_EQ(doubtOf(turned).empty(), doubtOf(floor).empty()) << one.path;
  }
}

}  // namespace
}  // namespace amble
