#include "animation/synthesis/engine_walk.h"

#include <gtest/gtest.h>

#include "animation/analysis/clip_analysis.h"
#include "animation/preparation/speed_engine_fit.h"
#include "tests/animation/captures.h"
#include "tests/animation/drawn_engine.h"

namespace amble {
namespace {

EngineWalkRequest steady(double speed) {
  EngineWalkRequest request;
  request.speed = [speed](double) { return speed; };
  return request;
}

TEST(EngineWalk, TheRootGoesAsFarAsTheSpeedSaysAndThePhaseAsTheCadenceDoes) {
  const DrawnEngine drawn;
  const SpeedEngine engine(drawn.data({0.6, 1.2, 1.8}));
  EngineWalkRequest request = steady(1.5);
  EngineWalk walk = engineWalk(engine, request);
  EXPECT_EQ(walk.clip.frames(), 301);
  EXPECT_NEAR(walk.length, 1.5 * 5.0, 1e-9);
  EXPECT_NEAR(walk.phases.back(), 5.0 * drawn.frequency(1.5), 1e-9);
  request.speed = [](double time) { return 0.6 + 0.2 * time; };
  walk = engineWalk(engine, request);
  EXPECT_NEAR(walk.length, 0.6 * 5.0 + 0.1 * 25.0, 1e-9);
  EXPECT_NEAR(walk.clip.poses.p_WR(300).x() - walk.clip.poses.p_WR(0).x(), walk.length, 0.05);
  for (size_t i = 1; i < walk.speeds.size(); ++i) EXPECT_GT(walk.speeds[i], walk.speeds[i - 1]);
}

TEST(EngineWalk, OneWhoIsTallerTakesLongerStepsAtTheSameCadenceAndScaledSpeed) {
  const SpeedEngine engine(DrawnEngine().data({0.6, 1.2, 1.8}));
  const EngineWalk own = engineWalk(engine, steady(1.0));
  EngineWalkRequest request = steady(1.2);
  request.scale = 1.2;
  const EngineWalk tall = engineWalk(engine, request);
  EXPECT_NEAR(tall.phases.back(), own.phases.back(), 1e-9);
  EXPECT_NEAR(tall.length, 1.2 * own.length, 1e-9);
  EXPECT_NEAR(tall.clip.poses.p_WR(7).z(), 1.2 * own.clip.poses.p_WR(7).z(), 1e-9);
}

/// Frames in which a foot swings from where it is seen to leave to where it is seen to come down.
std::vector<std::array<int, 2>> swingsOf(const std::vector<bool>& planted) {
  std::vector<std::array<int, 2>> swings;
  int left = -1;
  for (int i = 1; i < static_cast<int>(planted.size()); ++i) {
    if (planted[i - 1] && !planted[i]) left = i;
    if (!planted[i - 1] && planted[i] && left >= 0) swings.push_back({left, i});
  }
  return swings;
}

/// From `from` to a stand in `duration`, begun as phaseToStand has it; he stands for so long.
EngineWalkRequest toAStand(const SpeedEngine& engine, double from, double duration,
                           double stands = 0.0) {
  EngineWalkRequest request;
  request.duration = duration + stands;
  request.speed = [from, duration](double time) {
    return std::max(0.0, from * (1.0 - time / duration));
  };
  request.phase = phaseToStand(engine, request);
  return request;
}

/// The first swing of a walk, and whose it is.
struct FirstSwing {
  Side side = kLeft;
  int leaves = 0, lands = 0;
};

FirstSwing firstSwing(const EngineWalk& walk) {
  const auto left = swingsOf(walk.planted[kLeft]), right = swingsOf(walk.planted[kRight]);
  const Side side = left.front()[0] < right.front()[0] ? kLeft : kRight;
  const auto& [leaves, lands] = side == kLeft ? left.front() : right.front();
  return {side, leaves, lands};
}

TEST(EngineWalk, FeetStandByTheCapturedTimingButForTheFirstAndLastSwingBelowCapturedSpeeds) {
  const SpeedEngine engine(DrawnEngine().data({0.6, 1.2, 1.8}));
  for (const auto& [from, to] :
       {std::array{0.2, 0.2}, {0.0, 1.5}, {0.2, 1.0}, {1.7, 0.7}, {0.5, 0.1}, {1.2, 0.0}}) {
    EngineWalkRequest request;
    request.speed = [from, to](double time) { return from + (to - from) * time / 5.0; };
    const EngineWalk walk = engineWalk(engine, request);
    const bool slows = to < from && to < 0.6, speeds_up = from < to && from < 0.6;
    int last_swing = slows ? 0 : walk.clip.frames();
    for (const Side side : {kLeft, kRight}) {
      for (const auto& swing : swingsOf(walk.planted[side])) {
        if (slows) last_swing = std::max(last_swing, swing[0]);
      }
    }
    const FirstSwing first = firstSwing(walk);
    for (const Side side : {kLeft, kRight}) {
      const int begin = speeds_up && side == first.side ? first.leaves : 0;
      for (int i = begin; i < last_swing; ++i) {
        EXPECT_EQ(walk.planted[side][i], engine.planted(walk.speeds[i], walk.phases[i], side));
      }
    }
  }
}

/// From a stand to a speed in so long.
EngineWalk fromAStand(const SpeedEngine& engine, double to, double duration) {
  EngineWalkRequest request;
  request.duration = duration;
  request.speed = [to, duration](double time) { return to * time / duration; };
  return engineWalk(engine, request);
}

TEST(EngineWalk, WhoStartsFromAStandLiftsHisFirstFootLaterByAsMuchAsHeIsSlower) {
  const SpeedEngine engine(DrawnEngine().data({0.6, 1.2, 1.8}));
  for (const auto& [to, duration] :
       {std::array{0.8, 3.0}, {0.8, 6.0}, {1.2, 3.0}, {1.7, 2.0}, {1.7, 9.0}}) {
    const EngineWalk walk = fromAStand(engine, to, duration);
    const FirstSwing first = firstSwing(walk);
    const double at = walk.speeds[first.lands], frame_time = walk.clip.frame_time;
    const std::array<double, 2> both = engine.support(at);
    const double usual = (0.5 - 0.5 * (both[0] + both[1])) / engine.frequency(at);
    const double takes = (first.lands - first.leaves) * frame_time;
    EXPECT_LT(takes, usual * walk.speeds[first.leaves] / at + 1.01 * frame_time);
    EXPECT_GT(takes, 0.3 * usual);
    EXPECT_FALSE(engine.planted(walk.speeds[first.leaves], walk.phases[first.leaves], first.side));
  }
}

// Its heel would sink while it stands, as it does in the swing that is over for the phase.
TEST(EngineWalk, AFootThatLeavesLateRollsNoFartherThanThePhaseHasItWhereItLeaves) {
  const DrawnEngine drawn;
  const SpeedEngine engine(drawn.data({0.6, 1.2, 1.8}));
  const EngineWalk walk = fromAStand(engine, 1.2, 3.0);
  const FirstSwing first = firstSwing(walk);
  std::vector<JointFrame> made(drawn.rig.skeleton.size()), by_phase = made;
  Pose pose;
  pose.rotations.resize(engine.joints());
  const int foot = drawn.rig.roles.legs[first.side].foot;
  const auto rolled = [&](int i) {
    forwardKinematics(walk.clip, i, made);
    return made[foot].q_WJ;
  };
  const auto rolls = [&](int i) {
    engine.poseAt(walk.speeds[i], walk.phases[i], pose);
    forwardKinematics(drawn.rig.skeleton, pose, by_phase);
    return by_phase[foot].q_WJ;
  };
  int leaves = first.leaves;
  while (!engine.planted(walk.speeds[leaves - 1], walk.phases[leaves - 1], first.side)) --leaves;
  ASSERT_GT(first.leaves, leaves + 3);
  EXPECT_LT(rolled(first.leaves).angularDistance(rolls(leaves)),
            0.5 * rolls(first.leaves).angularDistance(rolls(leaves)));
  EXPECT_LT(rolled(0).angularDistance(rolls(0)), 1e-9);
  EXPECT_LT(rolled(first.lands).angularDistance(rolls(first.lands)), 1e-9);
  for (int i = 1; i <= first.lands; ++i) {  // nowhere does it jump
    EXPECT_LT(rolled(i).angularDistance(rolled(i - 1)), 0.05);
  }
}

TEST(EngineWalk, WhoComesToAStandPutsHisLastFootDownSoonerByAsMuchAsHeIsSlower) {
  const SpeedEngine engine(DrawnEngine().data({0.6, 1.2, 1.8}));
  for (const auto& [from, duration] :
       {std::array{0.4, 2.0}, {0.8, 2.0}, {0.8, 5.0}, {1.2, 3.0}, {1.7, 2.0}, {1.7, 9.0}}) {
    const EngineWalk walk = engineWalk(engine, toAStand(engine, from, duration));
    const double frame_time = walk.clip.frame_time;
    std::array<int, 2> last = {0, 0};
    Side side = kLeft;
    for (const Side swings : {kLeft, kRight}) {
      EXPECT_TRUE(walk.planted[swings].back());
      for (const auto& swing : swingsOf(walk.planted[swings])) {
        if (swing[0] > last[0]) last = swing, side = swings;
      }
    }
    ASSERT_GT(last[0], 0);
    const double at = walk.speeds[last[0] - 1];
    const std::array<double, 2> both = engine.support(at);
    const double usual = (0.5 - 0.5 * (both[0] + both[1])) / engine.frequency(at);
    EXPECT_LT((last[1] - last[0]) * frame_time,
              usual * walk.speeds[last[1] - 1] / at + 1.01 * frame_time);
    // It comes down after it passed the other foot, before a stand.
    const double passed = walk.phases[last[1]] - (side == kLeft ? 0.75 : 0.25);
    EXPECT_GT(walk.phases.back() - walk.phases[last[1]], 0.02);
    EXPECT_LT(std::abs(passed - std::round(passed)), 0.2);
  }
}

TEST(EngineWalk, WhoSlowsToJustBelowCapturedSpeedsPutsHisFeetDownAsToJustAbove) {
  const SpeedEngine engine(DrawnEngine().data({0.6, 1.2, 1.8}));
  for (double from = 0.7; from < 1.8; from += 0.1) {
    for (double duration = 1.0; duration < 6.0; duration += 0.37) {
      std::array<EngineWalk, 2> walks;
      for (const size_t i : {0, 1}) {
        EngineWalkRequest request;
        request.duration = duration;
        const double to = i == 0 ? 0.599 : 0.601;
        request.speed = [=](double time) { return from + (to - from) * time / duration; };
        walks[i] = engineWalk(engine, request);
      }
      int others = 0;
      for (const Side side : {kLeft, kRight}) {
        for (size_t k = 0; k < walks[0].speeds.size(); ++k) {
          others += walks[0].planted[side][k] != walks[1].planted[side][k];
        }
      }
      EXPECT_LE(others, 4) << from << " for " << duration;
    }
  }
}

TEST(EngineWalk, AStandComesAFifthOfACycleAfterOneFootPassedTheOther) {
  const SpeedEngine engine(DrawnEngine().data({0.6, 1.2, 1.8}));
  for (const double from : {0.3, 0.9, 1.8}) {
    for (const double duration : {2.0, 3.3, 7.0}) {
      for (const double stands : {0.0, 1.0}) {
        const EngineWalk walk = engineWalk(engine, toAStand(engine, from, duration, stands));
        const auto stop = std::find_if(walk.speeds.begin(), walk.speeds.end(), isStanding);
        const double passed = walk.phases[stop - walk.speeds.begin()] - 0.2 - 0.25;
        EXPECT_NEAR(passed, std::round(2.0 * passed) / 2.0, 1e-9);
      }
    }
  }
  EXPECT_EQ(phaseToStand(engine, steady(1.0)), 0.0);
}

TEST(EngineWalk, TheLastFootLiesAsItStandsSoonAfterItCameDown) {
  const DrawnEngine drawn;
  const SpeedEngine engine(drawn.data({0.6, 1.2, 1.8}));
  for (const double from : {0.5, 1.4}) {
    const EngineWalk walk = engineWalk(engine, toAStand(engine, from, 3.0));
    std::array<int, 2> down = {0, 0};
    for (const Side side : {kLeft, kRight}) {
      for (const auto& swing : swingsOf(walk.planted[side])) down[side] = swing[1];
    }
    const Side side = down[kLeft] > down[kRight] ? kLeft : kRight;
    const int foot = drawn.rig.roles.legs[side].foot;
    std::vector<JointFrame> at(drawn.rig.skeleton.size()), end = at;
    forwardKinematics(walk.clip, walk.clip.frames() - 1, end);
    for (int i = down[side] + 15; i < walk.clip.frames(); ++i) {
      forwardKinematics(walk.clip, i, at);
      EXPECT_LT(at[foot].q_WJ.angularDistance(end[foot].q_WJ), 1e-6);
    }
  }
}

// At a speed between the captured ones, and while it rises.
TEST(EngineWalk, FeetSlideNoMoreThanCapturesDoAndStandAsLongAsIsSaid) {
  AMBLE_NEEDS_CAPTURES();
  EngineRequest captures;
  for (const char* clip : {"07_01.bvh", "07_03.bvh", "07_06.bvh", "07_10.bvh", "07_12.bvh"}) {
    captures.captures.push_back({sharedFolder() / "mocap/cmu_mb2" / clip, {}, clip, "", ""});
  }
  const SpeedEngine engine(fitSpeedEngine(captures));
  for (const double faster : {0.0, 0.15}) {
    EngineWalkRequest request;
    request.duration = 4.0;
    request.speed = [faster](double time) { return 1.1 + faster * time; };
    const EngineWalk walk = engineWalk(engine, request);
    const ClipAnalysis seen = analyseClip(walk.clip, engine.data().roles);
    EXPECT_EQ(seen.kind.largest(), MotionType::kWalk);
    EXPECT_LT(seen.gait.toe_skate, 0.106);  // QUALITY.md: CMU walks
    EXPECT_EQ(seen.gait.knee_backwards, 0.0);
    EXPECT_LT(seen.gait.pops, 2.5);
    int alike = 0;
    for (const Side side : {kLeft, kRight}) {
      for (int i = 0; i < walk.clip.frames(); ++i) {
        alike += walk.planted[side][i] == seen.plants.planted(side, i);
      }
    }
    EXPECT_GT(alike, 0.93 * 2 * walk.clip.frames());
  }
}

TEST(EngineWalk, OneWhoSpeedsUpFromStandingWalksAndThenRuns) {
  AMBLE_NEEDS_CAPTURES();
  EngineRequest captures;
  for (const char* clip : {"02_01.bvh", "02_03.bvh"}) {
    captures.captures.push_back({sharedFolder() / "mocap/cmu_mb2" / clip, {}, clip, "", ""});
  }
  const SpeedEngine engine(fitSpeedEngine(captures));
  EngineWalkRequest request;
  request.duration = 8.0;
  request.speed = [](double time) { return 0.35 * time; };
  const EngineWalk walk = engineWalk(engine, request);
  const ClipAnalysis seen = analyseClip(walk.clip, engine.data().roles);
  EXPECT_EQ(seen.kind.frames[180], MotionType::kWalk);
  EXPECT_EQ(seen.kind.frames[450], MotionType::kRun);
  EXPECT_LT(seen.gait.pops, 2.5);
}

}  // namespace
}  // namespace amble
