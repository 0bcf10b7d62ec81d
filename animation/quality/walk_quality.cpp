#include "animation/quality/walk_quality.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "animation/analysis/gait_measures.h"
#include "animation/analysis/motion_measures.h"
#include "animation/body/pelvis.h"
#include "animation/library/motion_library.h"
#include "animation/quality/step_measures.h"
#include "animation/steps/stride_law.h"
#include "base/rotation.h"

namespace amble {
namespace {

// QUALITY.md's bars, of which those of a path and of feet that turn are for grown bodies:
// bodyScale.
constexpr double kToeSkate = 0.010;         // with foot lock [m/s]
constexpr double kDrift = 0.002;            // with foot lock [m]
constexpr double kPenetration = 0.005;      // [m]
constexpr double kRootAcceleration = 1.15;  // of the anchor
constexpr double kJointJerk = 1.1;          // of the anchor
constexpr double kPops = 2.5;               // or
constexpr double kPopsOfAnchor = 1.05;      // if more
// Captured feet turn fastest as their toes leave the ground: by 490 to 760 degrees/s on eight lab
// walks, by 475 to 860 on ten of fourteen of CMU's, at 60 Hz.
constexpr double kFootTurn = 900.0;      // [degrees/s]
constexpr double kPathMean = 0.02;       // [m]
constexpr double kPathLargest = 0.06;    // [m]
constexpr double kPathEnd = 0.02;        // [m]
constexpr double kEndHeading = 2.0;      // [degrees]
constexpr double kAchieved = 0.05;       // speed and turn rate, of what was asked
constexpr double kDoubleSupport = 0.04;  // from the norm
constexpr double kStepAchieved = 0.02;   // step length, lift and rise
constexpr double kSoleTilt = 3.0;        // [degrees]
constexpr double kUnsupported = 0.3;     // of its length, on stairs
constexpr double kFlip = 10.0;   // more pops than this is a joint that flips over: no anchor
constexpr double kPace = 0.8;    // of the walk's top speed: slower is starting, stopping or turning
constexpr double kTurns = 0.15;  // slower is straight: walkers sway by as much [rad/s]

// Legs of most grown people, from the 5th percentile of women to the 95th of men: theirs are the
// captures that the bars come from [m].
constexpr double kShortLeg = 0.75, kLongLeg = 1.0;

// Of a body to the nearest grown one: 1 for all of those [1, > 0]. With it lengths grow, and by
// Froude's law times with its root.
double bodyScale(double leg) { return leg / std::clamp(leg, kShortLeg, kLongLeg); }

FootPlants plantsOfWalk(const AnimationBuffer& walk) {
  std::array<std::vector<bool>, 2> planted;
  for (const FrameState& state : walk.states) {
    for (int side = 0; side < 2; ++side) planted[side].push_back(state.planted[side]);
  }
  return plantsOf(planted);
}

PathError pathErrorOf(const Clip& clip, const JointRoles& roles, const AnimationBuffer& walk) {
  std::vector<PlannedPoint> planned;
  for (const FrameState& state : walk.states) {
    planned.push_back({state.position.head<2>(), state.heading});
  }
  return pathError(clip, roles, planned);
}

// What was asked over the span that the gait was measured in.
struct Asked {
  double speed = 0.0;      // [m/s]
  double turn_rate = 0.0;  // [rad/s]
};
Asked askedOver(const AnimationBuffer& walk, const GaitMeasures& gait) {
  const int last_frame = walk.size() - 1;
  const int first = std::clamp(static_cast<int>(std::lround(gait.begin)), 0, last_frame);
  const int last = std::clamp(static_cast<int>(std::lround(gait.end)), first, last_frame);
  if (last == first) return {};
  double turned = 0.0;
  for (int i = first; i < last; ++i) {
    turned += wrapAngle(walk.states[i + 1].heading - walk.states[i].heading);
  }
  const double time = (last - first) * walk.frame_time;
  return {(walk.states[last].arc - walk.states[first].arc) / time, turned / time};
}

// Double support while the walk goes at its pace: starts, stops and turns on the spot have more of
// it, as they should. Over whole strides, since a share over part of one depends on where it is
// cut.
struct Support {
  double share = 0.0;  // [0, 1]
  double speed = 0.0;  // mean [m/s]
  int first = 0;       // frame of a strike
  int strides = 0;     // whole ones
  int frames = 0;      // over which that was; 0 where there is no whole stride at pace
};

Support supportOver(const AnimationBuffer& walk, int first, int end) {
  Support support;
  support.first = first;
  support.frames = end - first;
  for (int i = first; i < end; ++i) {
    const FrameState& state = walk.states[i];
    support.share += (state.planted[kLeft] && state.planted[kRight] ? 1.0 : 0.0) / support.frames;
    support.speed += state.speed / support.frames;
  }
  return support;
}

Support supportAtPace(const AnimationBuffer& walk) {
  double top = 0.0;
  for (const FrameState& state : walk.states) top = std::max(top, state.speed);
  const auto at_pace = [&](const FrameState& state) {
    return state.speed >= kPace * top && !state.start.there && !state.stop.there;
  };
  Support longest;
  std::array<int, 2> strike = {-1, -1};  // the first of this stretch, by Side
  std::array<int, 2> strides = {0, 0};   // since
  for (int i = 1; i < walk.size(); ++i) {
    if (!at_pace(walk.states[i])) strike = {-1, -1};
    for (int side = 0; side < 2; ++side) {
      const bool strikes = walk.states[i].planted[side] && !walk.states[i - 1].planted[side];
      if (!strikes || !at_pace(walk.states[i])) continue;
      strides[side] = strike[side] < 0 ? 0 : strides[side] + 1;
      if (strike[side] < 0) strike[side] = i;
      if (i - strike[side] <= longest.frames) continue;
      longest = supportOver(walk, strike[side], i);
      longest.strides = strides[side];
    }
  }
  return longest;
}

// What the pelvis misses of the path's turn while a walk at pace turns one way: between two moments
// of one phase at which it turns as fast and goes as fast, whole strides apart and as far around as
// there are such. In between it swings by up to 20 degrees to either side, the more the faster the
// walk turns; moments that are nearly alike leave a degree of it, which of less than kEnough would
// be more than kAchieved. 0 where there are none.
double turnMiss(const Clip& clip, const JointRoles& roles, const AnimationBuffer& walk,
                const Support& strides) {
  constexpr double kOneWay = 0.9;              // share of turning that is left [1]
  constexpr double kSameRate = 2.0 * kDegree;  // [rad/s]
  constexpr double kSameSpeed = 0.005;         // in what is blended [m/s]
  constexpr double kEnough = 20.0 * kDegree;
  const double same_phase = 0.55 * strides.strides / strides.frames;  // half of a frame [cycles]
  const std::vector<double> headings = pelvisHeadings(clip, roles);
  std::vector<double> path = {0.0}, either_way = {0.0};  // turned since the first frame
  for (int i = strides.first; i < strides.first + strides.frames; ++i) {
    const double turn = wrapAngle(walk.states[i + 1].heading - walk.states[i].heading);
    path.push_back(path.back() + turn);
    either_way.push_back(either_way.back() + std::abs(turn));
  }
  double farthest = kEnough, miss = 0.0;
  for (int i = 0; i <= strides.frames; ++i) {
    for (int k = i + 1; k <= strides.frames; ++k) {
      const FrameState &from = walk.states[strides.first + i], &to = walk.states[strides.first + k];
      const double turned = path[k] - path[i];
      if (std::abs(std::remainder(to.phase - from.phase, 1.0)) > same_phase ||
          std::abs(to.blended_turn_rate - from.blended_turn_rate) > kSameRate ||
          std::abs(to.slower - from.slower) > kSameSpeed || std::abs(turned) <= farthest ||
          std::abs(turned) <= std::max(kTurns * (k - i) * walk.frame_time,
                                       kOneWay * (either_way[k] - either_way[i])))
        continue;
      farthest = std::abs(turned);
      miss = std::abs((headings[strides.first + k] - headings[strides.first + i]) / turned - 1.0);
    }
  }
  return miss;
}

}  // namespace

QualityAnchors anchorsOf(const MotionLibrary& library, double scale, double speed) {
  QualityAnchors anchors;
  std::vector<std::pair<double, double>> jerk;  // speed, jerk of the straight walks
  for (const Motion& motion : library.motions) {
    if (motion.kind != MotionKind::kWalk) continue;
    const CaptureQuality& capture = motion.cycle.capture;
    anchors.root_acceleration = std::max(anchors.root_acceleration, capture.root_acceleration);
    if (capture.pops < kFlip) anchors.pops = std::max(anchors.pops, capture.pops);
    if (motion.turning || motion.source.mirrored) continue;
    jerk.emplace_back(motion.cycle.speed * std::sqrt(scale), capture.joint_jerk / std::sqrt(scale));
  }
  std::sort(jerk.begin(), jerk.end());
  if (jerk.empty()) return anchors;
  anchors.joint_jerk = speed <= jerk.front().first ? jerk.front().second : jerk.back().second;
  for (size_t i = 1; i < jerk.size(); ++i) {
    const auto& [v0, j0] = jerk[i - 1];
    const auto& [v1, j1] = jerk[i];
    if (speed < v0 || speed >= v1) continue;
    anchors.joint_jerk = j0 + (speed - v0) / (v1 - v0) * (j1 - j0);
  }
  return anchors;
}

std::vector<QualityLine> judgeWalk(const Clip& clip, const JointRoles& roles,
                                   const AnimationBuffer& walk, const Ground& ground,
                                   const QualityAnchors& anchors) {
  const GaitMeasures gait = measureGait(clip, roles, plantsOfWalk(walk), &ground);
  const PathError path = pathErrorOf(clip, roles, walk);
  const Asked asked = askedOver(walk, gait);
  const double leg =
      0.5 * (roles.legLength(clip.skeleton, kLeft) + roles.legLength(clip.skeleton, kRight));
  const double scale = bodyScale(leg);
  std::vector<QualityLine> lines = {
      {"toe skate", gait.toe_skate, kToeSkate, "m/s"},
      {"drift per plant", gait.largest_drift, kDrift, "m"},
      {"penetration", gait.penetration, kPenetration, "m"},
      {"root acceleration", gait.root_acceleration, kRootAcceleration * anchors.root_acceleration,
       "m/s2"},
      {"joint jerk", gait.joint_jerk, kJointJerk * anchors.joint_jerk, "m/s3"},
      {"pops", gait.pops, std::max(kPops, kPopsOfAnchor * anchors.pops), "1"},
      {"foot turn", fastestFootTurn(clip, roles) / kDegree, kFootTurn / std::sqrt(scale),
       "degrees/s"},
      {"knee backwards", gait.knee_backwards, 0.0, "1"},
      {"bone length change", gait.bone_length_change, 1e-9, "m"},
      {"path error, mean", path.mean, kPathMean * scale, "m"},
      {"path error, largest", path.largest, kPathLargest * scale, "m"},
      {"path error, end", path.end, kPathEnd * scale, "m"},
      {"end heading", path.end_heading / kDegree, kEndHeading, "degrees"},
  };
  if (asked.speed <= 0.0) return lines;  // turned on the spot, or stood
  lines.push_back(
      {"speed, achieved against asked", std::abs(gait.speed / asked.speed - 1.0), kAchieved, "1"});
  if (const Support support = supportAtPace(walk); support.frames > 0) {
    if (std::abs(asked.turn_rate) > kTurns && support.strides > 1) {
      lines.push_back({"turn rate, achieved against asked", turnMiss(clip, roles, walk, support),
                       kAchieved, "1"});
    }
    lines.push_back({"double support, from its norm",
                     std::abs(support.share - doubleSupportNorm(support.speed, leg)),
                     kDoubleSupport, "1"});
  }
  lines.push_back({"flight", gait.flight, 0.0, "1"});
  return lines;
}

std::vector<QualityLine> judgeSteps(const std::vector<JudgedStep>& steps) {
  if (steps.empty()) return {};
  const GaitParameters miss = largestMiss(steps);
  double tilt = 0.0, unsupported = 0.0;
  for (const JudgedStep& step : steps) {
    tilt = std::max(tilt, step.achieved.tilt);
    unsupported = std::max(unsupported, 1.0 - step.achieved.supported);
  }
  return {{"step length, achieved against asked", miss.stride, kStepAchieved, "1"},
          {"lift, achieved against asked", miss.lift, kStepAchieved, "1"},
          {"rise per step, achieved against asked", miss.climb, kStepAchieved, "1"},
          {"sole to ground at mid-stance", tilt / kDegree, kSoleTilt, "degrees"},
          {"unsupported share of a sole", unsupported, kUnsupported, "1"}};
}

}  // namespace amble
