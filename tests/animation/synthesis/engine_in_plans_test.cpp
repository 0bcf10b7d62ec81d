// Walks of a speed engine as plans have them: held, at any speed and at several along one walk.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "animation/library/harmonics.h"
#include "animation/synthesis/gait_blend.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "base/rotation.h"
#include "tests/animation/carried_walk.h"
#include "tests/animation/engine_library.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

const FlatGround kLevel;

Carried carriedBy(const SpeedEngine& engine, double speed, double phase) {
  Pose pose;
  pose.rotations.resize(engine.joints());
  engine.poseAt(speed, phase, pose);
  std::vector<JointFrame> joints(engine.joints());
  forwardKinematics(engine.data().skeleton, pose, joints);
  return carriedIn(joints, engine.data().roles, 0.0);
}

CarriedWalk straightWalk(const MotionLibrary& library, double speed) {
  const WalkSynthesizer walker(library, kLevel, {.speed = speed, .frame_time = 1.0 / 240.0});
  const RootPath path = straightPath(12 * walker.stepLength());
  AnimationBuffer buffer;
  EXPECT_EQ(
      walker.walk(stanceAt(path, false, false), stanceAt(path, true, false), path, false, buffer)
          .refused,
      WalkRule::kNone);
  return carriedWalk(buffer, library.skeleton, library.roles);
}

// The bars of captured walks at their own speed (Fidelity), at speeds between those of captures and
// down to half of the slowest, where the piece to standing begins: there the engine's feet slide,
// and hips that hold them are up to a fifth of a degree beyond.
TEST(EngineInPlans, AtAnySpeedThatItWasAskedForAWalkIsTheEngines) {
  AMBLE_NEEDS_CAPTURES();
  for (const auto& [clips, speeds] :
       {std::pair(kWalksOf07, std::vector{0.5, 0.8, 1.15, 1.5, 1.9}),
        std::pair(kWalksOf08, std::vector{0.6, 0.9, 1.3, 1.6, 1.75})}) {
    const EngineInFile made(fitSpeedEngine(engineRequestOf(clips)));
    for (const double speed : speeds) {
      SCOPED_TRACE(speed);
      const MotionLibrary library = made.library({speed});
      const WalkCycle& cycle = library.motions.back().cycle;
      EXPECT_NEAR(cycle.speed, speed, 1e-6);
      EXPECT_NEAR(cycle.period, 1.0 / made.engine().frequency(speed), 1e-6);
      const CarriedWalk walk = straightWalk(library, speed);
      EXPECT_NEAR(walk.period, cycle.period, 0.01 * cycle.period);
      std::vector<Carried> engines;
      for (int i = 0; i < kCompared; ++i) {
        engines.push_back(carriedBy(made.engine(), speed, static_cast<double>(i) / kCompared));
      }
      const bool captured = speed >= made.engine().data().walk->clips.front().speed;
      for (const Side side : {kLeft, kRight}) {
        EXPECT_LT(rmsBetween(walk.at, engines, &Carried::hip, side), captured ? 2.5 : 2.7) << side;
        EXPECT_LT(rmsBetween(walk.at, engines, &Carried::knee, side), 2.5) << side;
        EXPECT_NEAR(leastKnee(walk.at, side), leastKnee(engines, side), 2.0) << side;
      }
    }
  }
}

/// Root mean square over hips and knees [degrees].
double legsBetween(const std::vector<Carried>& a, const std::vector<Carried>& b) {
  double squares = 0.0;
  for (const Side side : {kLeft, kRight}) {
    squares += std::pow(rmsBetween(a, b, &Carried::hip, side), 2) / 4.0;
    squares += std::pow(rmsBetween(a, b, &Carried::knee, side), 2) / 4.0;
  }
  return std::sqrt(squares);
}

/// A planned walk at the speed of a capture that nothing of it is made of, against that capture.
struct LeftOutOfPlan {
  double by_engine = 0.0;   ///< of all other captures of the person [degrees]
  double by_nearest = 0.0;  ///< by the capture that is nearest in speed

  LeftOutOfPlan(const std::vector<std::string>& clips, const std::string& out,
                const std::string& nearest) {
    std::vector<std::string> others = clips;
    std::erase(others, out);
    const EngineInFile made(fitSpeedEngine(engineRequestOf(others)));
    const MotionLibrary stands = [&] {  // all on one skeleton, that of the engine
      MotionLibrary library = made.library({1.0});
      library.motions.pop_back();
      return library;
    }();
    MotionLibrary captured = stands, beside = stands;
    add(captured, out);
    add(beside, nearest);
    const double speed = captured.motions.back().cycle.speed;
    const std::vector<Carried> truth =
        carriedInCapture(captured, captured.motions.back(), sharedFolder() / "mocap" / out);
    by_engine = legsBetween(straightWalk(made.library({speed}), speed).at, truth);
    by_nearest = legsBetween(straightWalk(beside, speed).at, truth);
  }

  static void add(MotionLibrary& library, const std::string& clip) {
    MotionRequest request;
    request.name = clip;
    request.file = sharedFolder() / "mocap" / clip;
    request.source = {clip, {0, 0}, false, "none", "none"};
    request.harmonics = kMaxHarmonics;  // 08_01 shakes
    addMotion(library, request);
  }
};

// Those of CMU 07 and 08 that have others slower and faster.
TEST(EngineInPlans, AtASpeedThatWasNotCapturedAWalkIsNearerToThePersonsThanTheNextCapture) {
  AMBLE_NEEDS_CAPTURES();
  const EngineData all[] = {fitSpeedEngine(engineRequestOf(kWalksOf07)),
                            fitSpeedEngine(engineRequestOf(kWalksOf08))};
  double mean = 0.0, mean_nearest = 0.0;
  int count = 0;
  for (const EngineData& engine : all) {
    const std::vector<EngineClip>& clips = engine.walk->clips;
    for (size_t i = 1; i + 1 < clips.size(); ++i) {
      const bool below = clips[i].speed - clips[i - 1].speed < clips[i + 1].speed - clips[i].speed;
      const LeftOutOfPlan plan(&engine == all ? kWalksOf07 : kWalksOf08, clips[i].source.clip,
                               clips[below ? i - 1 : i + 1].source.clip);
      EXPECT_LT(plan.by_engine, plan.by_nearest + 0.2) << clips[i].source.clip;
      mean += plan.by_engine;
      mean_nearest += plan.by_nearest;
      ++count;
    }
  }
  EXPECT_LT(mean / count, 3.8);  // the bar of a speed that is left out, legs
  EXPECT_LT(mean, 0.7 * mean_nearest);
}

/// Around a bend that is walked at 0.8 m/s, between straights at 1.2 m/s.
struct BentWalk {
  static constexpr double kFast = 1.2, kSlow = 0.8;  // [m/s]
  static constexpr double kStraight = 8.0;           // [m]
  double radius = kSlow / GaitBlend::kNoTurns, bend = kPi * radius;
  AnimationBuffer buffer;

  explicit BentWalk(const MotionLibrary& library, double speed = kFast) {
    const WalkSynthesizer walker(library, kLevel, {.speed = speed});
    RootPath path = straightPath(kStraight, 0.0, {-kStraight, 0.0});
    path.append(circlePath(radius, kPi));
    path.append(straightPath(kStraight, kPi, {0.0, 2.0 * radius}));
    EXPECT_EQ(
        walker.walk(stanceAt(path, false, false), stanceAt(path, true, false), path, true, buffer)
            .refused,
        WalkRule::kNone);
  }

  /// Off the engine's walk at the speed and the phase of each frame between two arcs [degrees].
  double offEngine(const SpeedEngine& engine, double from, double to) const {
    std::vector<JointFrame> joints(engine.joints());
    double squares = 0.0, count = 0.0;
    for (int i = 0; i < buffer.size(); ++i) {
      const FrameState& state = buffer.states[i];
      if (state.arc < from || state.arc > to) continue;
      forwardKinematics(engine.data().skeleton, buffer.poses[i], joints);
      const Carried made = carriedIn(joints, engine.data().roles, state.heading);
      const Carried asked = carriedBy(engine, state.speed, state.phase);
      for (const Side side : {kLeft, kRight}) {
        squares += std::pow(made.hip[side] - asked.hip[side], 2);
        squares += std::pow(made.knee[side] - asked.knee[side], 2);
        count += 2.0;
      }
    }
    EXPECT_GT(count, 400.0);
    return std::sqrt(squares / count);
  }
};

TEST(EngineInPlans, WhereAWalkSlowsDownItIsTheEnginesWalkOfThatSpeed) {
  AMBLE_NEEDS_CAPTURES();
  const EngineInFile made(fitSpeedEngine(engineRequestOf(kWalksOf07)));
  const MotionLibrary paces = made.library({0.6, 0.8, 1.0, 1.2});
  const BentWalk by_paces(paces), by_one(made.library({1.2})), always_slow(paces, BentWalk::kSlow);
  const double begin = BentWalk::kStraight, end = begin + by_paces.bend;
  // Slowing down, the bend, and up to speed again.
  EXPECT_LT(by_paces.offEngine(made.engine(), begin - 1.5, end + 1.5),
            0.6 * by_one.offEngine(made.engine(), begin - 1.5, end + 1.5));
  // A bend costs something, but no more than who goes as slowly all the way.
  EXPECT_LT(by_paces.offEngine(made.engine(), begin + 1.3, end - 1.3),
            always_slow.offEngine(made.engine(), begin + 1.3, end - 1.3) + 0.2);
  double slowest = BentWalk::kFast;
  for (const FrameState& state : by_paces.buffer.states) slowest = std::min(slowest, state.speed);
  EXPECT_NEAR(slowest, BentWalk::kSlow, 0.05);
}

}  // namespace
}  // namespace amble
