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
#include "animation/synthesis/walk_synthesizer.h"
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
// Sources that are noisy raise no bar: a joint that flips over, or either of these (QUALITY.md).
constexpr double kFlip = 10.0;               // pops
constexpr double kNoisyJerk = 130.0;         // [m/s^3]
constexpr double kNoisyAcceleration = 12.0;  // of the root [m/s^2]
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

PathError pathErrorOf(const Clip& clip, const JointRoles& roles, const AnimationBuffer& walk,
                      const StancePelvis& end) {
  std::vector<PlannedPoint> planned;
  for (const FrameState& state : walk.states) {
    planned.push_back({state.position.head<2>(), state.heading});
  }
  PlannedPoint& last = planned.back();
  last.position += Eigen::Rotation2Dd(last.heading) * Eigen::Vector2d(end.ahead, end.left);
  last.heading += end.turned;
  return pathError(clip, roles, planned);
}

// Of the path over the span that the gait was measured in [rad/s].
double askedTurnRate(const AnimationBuffer& walk, const GaitMeasures& gait) {
  const int last_frame = walk.size() - 1;
  const int first = std::clamp(static_cast<int>(std::lround(gait.begin)), 0, last_frame);
  const int last = std::clamp(static_cast<int>(std::lround(gait.end)), first, last_frame);
  if (last == first) return 0.0;
  double turned = 0.0;
  for (int i = first; i < last; ++i) {
    turned += wrapAngle(walk.states[i + 1].heading - walk.states[i].heading);
  }
  return turned / ((last - first) * walk.frame_time);
}

// Whole strides while the walk goes at its pace: starts, stops and turns on the spot have more
// double support, as they should, and in them the pelvis is up to 10 cm before or behind its plan,
// as captured, which over a step or two is no speed. Over whole strides, since a share over part of
// one depends on where it is cut, and a pelvis sways to and fro in each.
struct Strides {
  double begin = 0.0, end = 0.0;  // strikes of one foot [frames]
  int count = 0;                  // 0 where there is no whole stride at pace

  double frames() const { return end - begin; }
};

// What of the time between a frame and the next a foot is down, of that time.
struct Down {
  double from = 0.0, to = 0.0;  // [0, 1]; none where they are the same
};

// A phase of the foot goes on evenly between two frames.
Down downBetween(const FootState& foot, const FootState& next) {
  const double gone = next.at - foot.at + (next.at < foot.at ? 2.0 : 0.0);
  if (foot.planted()) return {0.0, next.planted() ? 1.0 : (1.0 - foot.at) / gone};
  return next.planted() ? Down{(2.0 - foot.at) / gone, 1.0} : Down{};
}

Strides stridesAtPace(const AnimationBuffer& walk) {
  double top = 0.0;
  for (const FrameState& state : walk.states) top = std::max(top, state.speed);
  const auto at_pace = [&](const FrameState& state) {
    return state.speed >= kPace * top && !state.start.there && !state.stop.there;
  };
  Strides longest;
  if (top <= 0.0) return longest;
  std::array<double, 2> strike = {-1.0, -1.0};  // the first of this stretch, by Side [frames]
  std::array<int, 2> strides = {0, 0};          // since
  for (int i = 1; i < walk.size(); ++i) {
    if (!at_pace(walk.states[i])) strike = {-1.0, -1.0};
    for (int side = 0; side < 2; ++side) {
      const FootState &before = walk.states[i - 1].feet[side], &foot = walk.states[i].feet[side];
      if (before.planted() || !foot.planted() || !at_pace(walk.states[i])) continue;
      const double at = i - 1 + downBetween(before, foot).from;
      strides[side] = strike[side] < 0.0 ? 0 : strides[side] + 1;
      if (strike[side] < 0.0) strike[side] = at;
      if (at - strike[side] > longest.frames()) longest = {strike[side], at, strides[side]};
    }
  }
  return longest;
}

// Of whole strides, their double support and mean speed. A share of frames would be off by half of
// a frame at each strike and lift-off: by up to 0.03 over the 60 of one stride.
struct Support {
  double share = 0.0;  // [0, 1]
  double speed = 0.0;  // [m/s]
};

Support supportOver(const AnimationBuffer& walk, const Strides& strides) {
  Support support;
  for (int i = static_cast<int>(strides.begin); i < strides.end; ++i) {
    const FrameState &state = walk.states[i], &next = walk.states[i + 1];
    const double from = std::max(0.0, strides.begin - i), to = std::min(1.0, strides.end - i);
    const Down left = downBetween(state.feet[kLeft], next.feet[kLeft]);
    const Down right = downBetween(state.feet[kRight], next.feet[kRight]);
    const double both = std::min({left.to, right.to, to}) - std::max({left.from, right.from, from});
    support.share += std::max(0.0, both) / strides.frames();
    support.speed += (to - from) * state.speed / strides.frames();
  }
  return support;
}

// What the pelvis misses of the speed that was asked, over whole strides: both are smoothed alike.
double speedMiss(const Clip& clip, const JointRoles& roles, const AnimationBuffer& walk,
                 const Strides& strides) {
  std::vector<Eigen::Vector3d> asked;
  for (const FrameState& state : walk.states) asked.push_back(state.position);
  const auto speed = [&](const std::vector<Eigen::Vector3d>& way) {
    return smoothedSpeed(way, clip.frame_time, strides.begin, strides.end);
  };
  return std::abs(speed(pelvisPath(clip, roles)) / speed(asked) - 1.0);
}

// What the pelvis misses of the path's turn while a walk at pace turns one way: between two moments
// of one phase at which it turns as fast and goes as fast, whole strides apart and as far around as
// there are such. In between it swings by up to 20 degrees to either side, the more the faster the
// walk turns; moments that are nearly alike leave a degree of it, which of less than kEnough would
// be more than kAchieved. 0 where there are none.
double turnMiss(const Clip& clip, const JointRoles& roles, const AnimationBuffer& walk,
                const Strides& strides) {
  constexpr double kOneWay = 0.9;              // share of turning that is left [1]
  constexpr double kSameRate = 2.0 * kDegree;  // [rad/s]
  constexpr double kSameSpeed = 0.005;         // in what is blended [m/s]
  constexpr double kEnough = 20.0 * kDegree;
  const int first = static_cast<int>(std::ceil(strides.begin));
  const int frames = static_cast<int>(std::ceil(strides.end)) - first;
  const double same_phase = 0.55 * strides.count / strides.frames();  // half of a frame [cycles]
  const std::vector<double> headings = pelvisHeadings(clip, roles);
  std::vector<double> path = {0.0}, either_way = {0.0};  // turned since the first frame
  for (int i = first; i < first + frames; ++i) {
    const double turn = wrapAngle(walk.states[i + 1].heading - walk.states[i].heading);
    path.push_back(path.back() + turn);
    either_way.push_back(either_way.back() + std::abs(turn));
  }
  double farthest = kEnough, miss = 0.0;
  for (int i = 0; i <= frames; ++i) {
    for (int k = i + 1; k <= frames; ++k) {
      const FrameState &from = walk.states[first + i], &to = walk.states[first + k];
      const double turned = path[k] - path[i];
      if (std::abs(std::remainder(to.phase - from.phase, 1.0)) > same_phase ||
          std::abs(to.blended_turn_rate - from.blended_turn_rate) > kSameRate ||
          std::abs(to.slower - from.slower) > kSameSpeed || std::abs(turned) <= farthest ||
          std::abs(turned) <= std::max(kTurns * (k - i) * walk.frame_time,
                                       kOneWay * (either_way[k] - either_way[i])))
        continue;
      farthest = std::abs(turned);
      miss = std::abs((headings[first + k] - headings[first + i]) / turned - 1.0);
    }
  }
  return miss;
}

bool isNoisy(const CaptureQuality& capture) {
  return capture.joint_jerk > kNoisyJerk || capture.root_acceleration > kNoisyAcceleration ||
         capture.pops >= kFlip;
}

}  // namespace

StancePelvis pelvisOf(const WalkSynthesizer& walker, const Stance& stance) {
  AnimationBuffer pose;
  if (stance.standing || walker.stand(stance, pose).refused != WalkRule::kNone) return {};
  const Clip clip = {"stance", walker.skeleton(), pose.frame_time, pose.poses, {}};
  const Eigen::Vector2d beside =
      Eigen::Rotation2Dd(-stance.heading) * (clip.poses.p_WR(0) - stance.position).head<2>();
  return {beside.x(), beside.y(),
          wrapAngle(pelvisHeadings(clip, walker.roles()).front() - stance.heading)};
}

QualityAnchors anchorsOf(const MotionLibrary& library, double scale, double speed) {
  QualityAnchors anchors;
  double noisy = 0.0;                           // root acceleration of noisy ones [m/s^2]
  std::vector<std::pair<double, double>> jerk;  // speed, jerk of the straight walks
  for (const Motion& motion : library.motions) {
    if (motion.kind != MotionKind::kWalk) continue;
    const CaptureQuality& capture = motion.cycle.capture;
    if (isNoisy(capture)) {
      noisy = std::max(noisy, std::min(capture.root_acceleration, kNoisyAcceleration));
    } else {
      anchors.root_acceleration = std::max(anchors.root_acceleration, capture.root_acceleration);
      anchors.pops = std::max(anchors.pops, capture.pops);
    }
    if (motion.turning || motion.source.mirrored) continue;
    jerk.emplace_back(motion.cycle.speed * std::sqrt(scale),
                      std::min(capture.joint_jerk, kNoisyJerk) / std::sqrt(scale));
  }
  if (anchors.root_acceleration == 0.0) anchors.root_acceleration = noisy;
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
  const PathError path = pathErrorOf(clip, roles, walk, anchors.end);
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
  if (walk.states.back().arc <= walk.states.front().arc) return lines;  // on the spot, or stood
  if (const Strides strides = stridesAtPace(walk); strides.count > 0) {
    lines.push_back(
        {"speed, achieved against asked", speedMiss(clip, roles, walk, strides), kAchieved, "1"});
    if (std::abs(askedTurnRate(walk, gait)) > kTurns && strides.count > 1) {
      lines.push_back({"turn rate, achieved against asked", turnMiss(clip, roles, walk, strides),
                       kAchieved, "1"});
    }
    const Support support = supportOver(walk, strides);
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
