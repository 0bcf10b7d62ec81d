#include "animation/analysis/gait_measures.h"

#include <gtest/gtest.h>

#include "animation/captures/bvh.h"
#include "animation/captures/motion_reader.h"
#include "animation/clips/floor_fit.h"
#include "animation/clips/mirror_clip.h"
#include "animation/library/motion_library_reader.h"
#include "animation/quality/walk_quality.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "base/rotation.h"
#include "base/strict_yaml.h"
#include "tests/animation/captures.h"
#include "tests/animation/puppet.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

GaitMeasures measured(const Puppet& puppet, const Ground* ground = nullptr) {
  return measureGait(puppet.clip(), Puppet::roles(), puppet.plants(), ground);
}

TEST(GaitMeasures, OfNothingAreNothing) {
  Clip clip = Puppet().clip();
  clip.poses.clear();
  clip.joint_positions.clear();
  EXPECT_EQ(measureGait(clip, Puppet::roles(), FootPlants()).speed, 0.0);
}

TEST(GaitMeasures, OfAClipWithoutPlantsSayNothingOfFeet) {
  const Puppet puppet;
  FootPlants none;
  none.frames = puppet.clip().frames();
  const GaitMeasures gait = measureGait(puppet.clip(), Puppet::roles(), none);
  EXPECT_EQ(gait.toe_skate, 0.0);
  EXPECT_EQ(gait.penetration, 0.0);
  EXPECT_TRUE(gait.steps.empty());
  EXPECT_EQ(gait.flight, 1.0);
  EXPECT_NEAR(gait.speed, puppet.speed, 1e-9);
}

TEST(GaitMeasures, OfADrawnWalkAreThoseItWasDrawnWith) {
  for (const double speed : {0.6, 1.2, 1.7}) {
    const Puppet puppet{.speed = speed};
    const GaitMeasures gait = measured(puppet);
    EXPECT_NEAR(gait.speed, speed, 1e-6);
    EXPECT_NEAR(gait.turn_rate, 0.0, 1e-9);
    EXPECT_NEAR(gait.step_length, 0.5 * speed * puppet.period, 1e-6);
    EXPECT_NEAR(gait.step_width, puppet.width, 1e-6);
    EXPECT_NEAR(gait.step_time, 0.5 * puppet.period, 0.005);
    EXPECT_NEAR(gait.cadence, 120.0 / puppet.period, 0.01 * 120.0 / puppet.period);
    EXPECT_NEAR(gait.lift, puppet.lift, 0.001);
    EXPECT_NEAR(gait.double_support, 2.0 * puppet.stance - 1.0, 0.02);
    EXPECT_EQ(gait.flight, 0.0);
    EXPECT_LT(gait.length_asymmetry.value(), 1e-6);
    EXPECT_LT(gait.time_asymmetry.value(), 0.02);
    EXPECT_NEAR(gait.toe_height[kRight], Puppet::kToe, 1e-12);
    EXPECT_NEAR(gait.ankle_height[kLeft], Puppet::kAnkle, 1e-12);
  }
}

TEST(GaitMeasures, APlantedFootThatStaysDoesNotSkateDriftOrSink) {
  const GaitMeasures gait = measured(Puppet{.turn_rate = 0.6});
  EXPECT_LT(gait.toe_skate, 1e-9);
  EXPECT_LT(gait.largest_drift, 1e-9);
  EXPECT_LT(gait.penetration, 1e-9);
}

TEST(GaitMeasures, ASlidingFootSkatesAsFastAsItSlides) {
  const Puppet puppet{.slide = 0.05};
  const GaitMeasures gait = measured(puppet);
  EXPECT_NEAR(gait.toe_skate, 0.05, 1e-6);
  // The plant without 15 % at both ends, half of it to either side of the median.
  EXPECT_NEAR(gait.drift, 0.5 * 0.7 * puppet.stance * puppet.period * 0.05, 0.001);
}

// Feet are seen to stand some frames before they do, and after: within 15 % of a plant that is no
// slide, of a plant that the clip cuts short as well.
TEST(GaitMeasures, AFootSlidesNoMoreForTheClipThatIsCut) {
  const Puppet puppet;
  const Clip clip = puppet.clip();
  FootPlants plants = puppet.plants();
  for (std::vector<FootPlant>& of_foot : plants.plants) {
    for (FootPlant& plant : of_foot) {
      plant.first = std::max(0, plant.first - 4);
      plant.last = std::min(plants.frames - 1, plant.last + 4);
    }
  }
  for (int cut = 0; cut < 120; ++cut) {
    FootPlants seen;
    seen.frames = clip.frames() - 2 * cut;
    for (const Side side : {kLeft, kRight}) {
      for (FootPlant plant : plants.plants[side]) {
        plant.first = std::max(0, plant.first - cut);
        plant.last = std::min(seen.frames - 1, plant.last - cut);
        if (plant.first <= plant.last) seen.plants[side].push_back(plant);
      }
    }
    Clip part = clip;
    part.poses.clear();
    part.poses.append(clip.poses, cut, seen.frames);
    const auto joints = static_cast<std::ptrdiff_t>(clip.skeleton.size());
    part.joint_positions.assign(clip.joint_positions.begin() + cut * joints,
                                clip.joint_positions.end() - cut * joints);
    const GaitMeasures gait = measureGait(part, Puppet::roles(), seen);
    EXPECT_LT(gait.largest_drift, 1e-9) << cut;
    EXPECT_LT(gait.toe_skate, 1e-9) << cut;
  }
}

TEST(GaitMeasures, AFootThatSwingsThroughTheGroundPenetratesIt) {
  EXPECT_NEAR(measured(Puppet{.lift = 0.0, .sink = 0.02}).penetration, 0.02, 1e-4);
}

TEST(GaitMeasures, EachStepOfASteadyWalkMeasuresWhatTheClipDoes) {
  const Puppet puppet{.turn_rate = 0.3};
  const GaitMeasures gait = measured(puppet);
  ASSERT_GE(gait.steps.size(), 6u);
  for (size_t i = 2; i + 2 < gait.steps.size(); ++i) {
    const StepMeasure& step = gait.steps[i];
    EXPECT_NEAR(step.speed, gait.speed, 1e-6);
    EXPECT_NEAR(step.turn_rate, puppet.turn_rate, 1e-6);
    EXPECT_NEAR(step.double_support, 2.0 * (puppet.stance - 0.5), 0.05);
    EXPECT_NEAR(step.two_steps, 2.0 * step.stride, 0.02 * step.two_steps);
  }
  EXPECT_NEAR(gait.cycle_frequency, 1.0 / puppet.period, 0.01);
  EXPECT_NEAR(gait.leg_length, Puppet::kThigh + Puppet::kShank, 1e-12);
  EXPECT_NEAR(gait.normalised_speed, gait.speed / gait.leg_length, 1e-12);
}

TEST(GaitMeasures, TheToeOfAFlatFootClearsTheGroundByItsLiftInTheMiddleOfTheSwing) {
  const Puppet puppet{.lift = 0.1};
  // Drawn as lift * sin(pi u): at 0.3 of the swing, and at 0.7, lowest in between.
  EXPECT_NEAR(measured(puppet).toe_clearance, 0.1 * std::sin(0.3 * kPi), 0.006);
}

TEST(GaitMeasures, FootprintsOfACircleTurnWithIt) {
  const Puppet puppet{.turn_rate = 0.5, .duration = 12.0};
  const GaitMeasures gait = measured(puppet);
  EXPECT_NEAR(gait.turn_rate, 0.5, 1e-6);
  EXPECT_NEAR(gait.peak_turn_rate, 0.5, 1e-6);
  EXPECT_NEAR(gait.speed, puppet.speed, 0.01 * puppet.speed);
  EXPECT_NEAR(measured(Puppet{.turn_rate = -0.5}).turn_rate, -0.5, 1e-6);
}

TEST(GaitMeasures, ALimpIsAsymmetric) {
  const Puppet puppet{.right_phase = 0.55};
  const GaitMeasures gait = measured(puppet);
  EXPECT_NEAR(gait.time_asymmetry.value(), 0.2, 0.02);  // 0.55 against 0.45 of the period
  EXPECT_NEAR(gait.step_time_variation, 0.1, 0.01);
  EXPECT_NEAR(gait.length_asymmetry.value(), 0.2, 1e-6);  // and of the way
}

TEST(GaitMeasures, StepsOnTheSpotHaveNoAsymmetryOfLength) {
  const Puppet puppet{.speed = 0.0, .right_phase = 0.55};
  const GaitMeasures gait = measured(puppet);
  ASSERT_GE(gait.steps.size(), 6u);
  EXPECT_FALSE(gait.length_asymmetry.has_value());
  EXPECT_NEAR(gait.time_asymmetry.value(), 0.2, 0.02);
}

// A walk of the default library that ends standing, and the same cut off in its last step but one.
TEST(GaitMeasures, TheStepThatClosesAWalkIsNoneOfItsMeans) {
  const MotionLibrary library = openMotionLibrary("default");
  const FlatGround ground;
  const WalkSynthesizer walker(library, ground, {});
  Stance from, to;
  to.position.x() = 6.0;
  const RootPath path({makeBezier(from.position.head<2>(), 0.0, to.position.head<2>(), 0.0)});
  AnimationBuffer walk;
  ASSERT_EQ(walker.walk(from, to, path, true, walk).refused, WalkRule::kNone);
  Clip clip{"walk", walker.skeleton(), walk.frame_time, walk.poses, {}};
  const auto measuredTo = [&](int frames) {
    std::array<std::vector<bool>, 2> planted;
    for (int i = 0; i < frames; ++i) {
      for (const Side side : {kLeft, kRight}) {
        planted[side].push_back(walk.states[i].planted[side]);
      }
    }
    clip.poses.resize(frames);
    return measureGait(clip, walker.roles(), plantsOf(planted));
  };
  const GaitMeasures whole = measuredTo(walk.size());
  ASSERT_LT(whole.steps.back().stride, 0.1);
  const int close = static_cast<int>(whole.plants.back().plant.first);
  const GaitMeasures open = measuredTo(close);
  ASSERT_EQ(open.steps.size() + 1, whole.steps.size());
  EXPECT_NEAR(whole.step_length, open.step_length, 1e-4);
  EXPECT_NEAR(whole.step_time, open.step_time, 1e-4);
  EXPECT_NEAR(whole.length_asymmetry.value(), open.length_asymmetry.value(),
              2.0 * 1e-4 / open.step_length);  // of the means of two feet, each off by as little
  EXPECT_LT(whole.length_asymmetry.value(), 0.08);
}

TEST(GaitMeasures, ShortStancesAreFlight) {
  const Puppet puppet{.speed = 2.8, .period = 0.7, .stance = 0.4};
  const GaitMeasures gait = measured(puppet);
  EXPECT_NEAR(gait.flight, 0.2, 0.03);
  EXPECT_EQ(gait.double_support, 0.0);
}

TEST(GaitMeasures, HeightsAreOverTheGroundThatIsGiven) {
  const FlatGround lower(-0.25);
  const GaitMeasures gait = measured(Puppet(), &lower);
  EXPECT_NEAR(gait.toe_height[kLeft], Puppet::kToe + 0.25, 1e-12);
  for (const PlantMeasures& plant : gait.plants) EXPECT_NEAR(plant.at.z(), -0.25, 1e-12);
}

/// Level but for a hole under one end of each print of the left foot: what stands over the nosing
/// of a tread.
class Holes : public Ground {
 public:
  /// @param ahead  of the ankle [m]
  Holes(const Puppet& puppet, double ahead) {
    const FootPlants plants = puppet.plants();
    for (const FootPlant& plant : plants.plants[kLeft]) {
      const double cycle = (plant.strike / puppet.rate - puppet.strike(kLeft, 0)) / puppet.period;
      const int whole = static_cast<int>(std::lround(cycle));
      holes_.emplace_back(puppet.footprint(kLeft, whole) + Eigen::Vector3d(ahead, 0.0, 0.0));
    }
  }
  std::optional<SurfacePoint> surface(double x, double y, double, double) const override {
    for (const Eigen::Vector3d& hole : holes_) {
      if ((hole.head<2>() - Eigen::Vector2d(x, y)).norm() < 0.05) return SurfacePoint{-0.2};
    }
    return SurfacePoint{};
  }

 private:
  std::vector<Eigen::Vector3d> holes_;
};

TEST(GaitMeasures, AFootBeyondTheEdgeOfATreadStandsOnItsOtherEnd) {
  const Puppet puppet;
  const GaitMeasures flat = measured(puppet);
  for (const double ahead : {0.0, Puppet::kFoot}) {
    const Holes ground(puppet, ahead);
    const GaitMeasures gait = measured(puppet, &ground);
    EXPECT_NEAR(gait.ankle_height[kLeft], flat.ankle_height[kLeft], 1e-9);
    EXPECT_NEAR(gait.toe_height[kLeft], flat.toe_height[kLeft], 1e-9);
    EXPECT_LT(gait.penetration, 1e-9);
    ASSERT_EQ(gait.steps.size(), flat.steps.size());
    for (size_t i = 0; i < flat.steps.size(); ++i) {
      EXPECT_NEAR(gait.steps[i].lift, flat.steps[i].lift, 1e-9) << i;
      EXPECT_NEAR(gait.steps[i].climb, 0.0, 1e-9) << i;
    }
  }
}

TEST(GaitMeasures, StepsAlternateAndFootprintsAreWhereFeetStood) {
  const Puppet puppet;
  const GaitMeasures gait = measured(puppet);
  ASSERT_GE(gait.steps.size(), 8u);
  for (size_t i = 1; i < gait.steps.size(); ++i)
    EXPECT_NE(gait.steps[i].side, gait.steps[i - 1].side);
  for (const PlantMeasures& plant : gait.plants) {
    if (plant.plant.first == 0 || plant.plant.last == gait.plants.back().plant.last) continue;
    const double begin = plant.plant.strike / puppet.rate - puppet.strike(plant.side, 0);
    const Eigen::Vector3d print =
        puppet.footprint(plant.side, static_cast<int>(std::lround(begin / puppet.period)));
    EXPECT_LT((plant.at - print - Eigen::Vector3d(0.5 * Puppet::kFoot, 0, 0)).norm(), 1e-9);
  }
}

/// A capture from its first good frame on, level.
Clip levelled(const Capture& capture, JointRoles& roles) {
  const Clip whole = readBvh(capture.file, {.metres_per_unit = capture.metres_per_unit});
  Clip clip = whole;
  clip.poses.clear();
  clip.poses.append(whole.poses, capture.skip, whole.frames() - capture.skip);
  roles = guessJointRoles(clip.skeleton, capture.path);
  return levelClip(clip, fitFloor(clip, roles), 0.08);
}

TEST(GaitMeasuresOfCaptures, SpeedAndStepsOfSteadyWalksAreThoseOfTheManifest) {
  AMBLE_NEEDS_CAPTURES();
  std::map<std::string, YamlNode> facts;
  for (const YamlNode& clip :
       readYaml(sharedFolder() / "mocap/MANIFEST.yaml").at("clips").items()) {
    facts[clip.at("path").asString()] = clip;
  }
  int compared = 0;
  for (const Capture& capture : captures()) {
    const YamlNode fact = facts.at(capture.path), steady = fact["steady_cyclic"];
    if (capture.path.starts_with("cmu_daz")) continue;  // retargeted: feet are not anchored
    if (capture.kind != "walk" || !steady || steady.asString() != "yes") continue;
    JointRoles roles;
    const Clip clip = levelled(capture, roles);
    const GaitMeasures gait = measureGait(clip, roles, detectPlants(clip, roles));
    const double speed = fact.at("measured").at("mean_speed_by_unit_mps").asDouble();
    EXPECT_NEAR(gait.speed, speed, 0.06 * speed) << capture.path;
    const double time = fact.at("measured").at("step_time_s").asDouble();
    EXPECT_NEAR(gait.step_time, time, 0.06 * time) << capture.path;
    EXPECT_LT(std::abs(gait.turn_rate), 5.0 * kDegree) << capture.path;
    ++compared;
  }
  EXPECT_GE(compared, 8);
}

/// QUALITY.md's figures for real clips, medians over a set of walks: our definitions give them
/// back.
TEST(GaitMeasuresOfCaptures, OfAMirrorImageAreThoseOfTheOtherFootAndTheOtherTurn) {
  AMBLE_NEEDS_CAPTURES();
  for (const Capture& capture : captures()) {
    if (capture.path != "accad_female1/Female1_B03_Walk1.bvh" &&
        capture.path != "accad_female1/Female1_B09_WalkTurnLeft90.bvh")
      continue;
    JointRoles roles;
    const Clip clip = levelled(capture, roles), image = mirrorClip(clip, roles);
    const FootPlants plants = detectPlants(clip, roles);
    FootPlants mirrored = plants;
    std::swap(mirrored.plants[kLeft], mirrored.plants[kRight]);
    const GaitMeasures a = measureGait(clip, roles, plants);
    const GaitMeasures b = measureGait(image, roles, mirrored);
    // The rig's left and right differ by millimetres.
    EXPECT_NEAR(b.speed, a.speed, 0.005);
    EXPECT_NEAR(b.turn_rate, -a.turn_rate, 0.02);
    EXPECT_NEAR(b.step_length, a.step_length, 0.01);
    EXPECT_NEAR(b.step_width, a.step_width, 0.01);
    EXPECT_NEAR(b.double_support, a.double_support, 1e-9);
    EXPECT_NEAR(b.cadence, a.cadence, 1e-9);
    ASSERT_EQ(b.steps.size(), a.steps.size());
    for (size_t i = 0; i < a.steps.size(); ++i) EXPECT_EQ(b.steps[i].side, other(a.steps[i].side));
  }
}

TEST(GaitMeasuresOfCaptures, WhichWayAWalkFacesIsNothingToThem) {
  AMBLE_NEEDS_CAPTURES();
  const auto file = sharedFolder() / "mocap/accad_female1/Female1_B09_WalkTurnLeft90.bvh";
  std::optional<GaitMeasures> first;
  for (const double facing : {0.0, 1.1, -2.7}) {
    const CapturedMotion motion = readMotion(file, {.facing = facing});
    const GaitMeasures gait =
        measureGait(motion.clip, motion.roles, detectPlants(motion.clip, motion.roles));
    if (!first) first = gait;
    EXPECT_NEAR(gait.speed, first->speed, 1e-6);
    EXPECT_NEAR(gait.turn_rate, first->turn_rate, 1e-6);
    // Where a foot stood is a median, by axis.
    EXPECT_NEAR(gait.step_length, first->step_length, 5e-4);
    EXPECT_NEAR(gait.step_width, first->step_width, 5e-4);
    EXPECT_NEAR(gait.lift, first->lift, 5e-4);
    EXPECT_NEAR(gait.toe_skate, first->toe_skate, 1e-6);
    EXPECT_EQ(gait.steps.size(), first->steps.size());
  }
}

TEST(GaitMeasuresOfCaptures, AreQualitysFiguresForRealClips) {
  AMBLE_NEEDS_CAPTURES();
  std::vector<double> skate, drift, root, pop, support;
  for (const Capture& capture : captures()) {
    if (!capture.path.starts_with("cmu_mb2") || !capture.kind.starts_with("walk") ||
        capture.kind.size() > 9)
      continue;
    JointRoles roles;
    const Clip clip = levelled(capture, roles);
    const GaitMeasures gait = measureGait(clip, roles, detectPlants(clip, roles));
    EXPECT_EQ(gait.knee_backwards, 0.0) << capture.path;
    EXPECT_EQ(gait.bone_length_change, 0.0) << capture.path;
    skate.push_back(gait.toe_skate);
    drift.push_back(gait.drift);
    root.push_back(gait.root_acceleration);
    pop.push_back(gait.pops);
    support.push_back(gait.double_support);
  }
  const auto median = [](std::vector<double>& values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
  };
  ASSERT_GE(skate.size(), 12u);
  EXPECT_NEAR(median(skate), 0.106, 0.25 * 0.106);
  EXPECT_NEAR(median(drift), 0.0126, 0.25 * 0.0126);
  EXPECT_NEAR(median(root), 6.8, 0.25 * 6.8);
  EXPECT_NEAR(median(pop), 3.8, 0.25 * 3.8);
  EXPECT_NEAR(median(support), 0.17, 0.04);
}

}  // namespace
}  // namespace amble
