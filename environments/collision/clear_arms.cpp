#include "environments/collision/clear_arms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "animation/body/pelvis.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr double kAngleStep = 0.2 * kDegree;  // to which the least angle is found [rad]

// Ways to make way, by which part of the turn is outwards and which forwards.
constexpr double kWays[3][2] = {{1.0, 0.0}, {0.0, 1.0}, {0.7071, 0.7071}};

Side sideOf(size_t pair) { return armPairs()[pair].first.starts_with("left") ? kLeft : kRight; }

// One arm of a clip, and how it makes way.
struct Arm {
  const Body& body;
  const JointRoles& roles;
  const Eigen::VectorXd& allowed;
  Side side;
  int way;
};

// The arm's joint turned in World, seen from its parent.
Eigen::Quaterniond turnedOut(const Arm& arm, const Clip& clip, int frame, double angle) {
  std::vector<JointFrame> joints(clip.skeleton.size());
  forwardKinematics(clip, frame, joints);
  const Eigen::Quaterniond heading = aboutZ(pelvisHeading(joints, arm.roles));
  // About the way ahead a positive turn takes a hanging arm to the left, about the left backwards.
  const double outwards = (arm.side == kLeft ? 1.0 : -1.0) * kWays[arm.way][0];
  const Eigen::Vector3d axis = heading * Eigen::Vector3d(outwards, -kWays[arm.way][1], 0.0);
  const int joint = arm.roles.arms[arm.side].arm;
  const Eigen::Quaterniond& q_WP = joints[clip.skeleton.joint(joint).parent].q_WJ;
  return q_WP.conjugate() * expRotation(angle * axis) * q_WP * clip.poses.rotations(frame)[joint];
}

// How much deeper than allowed it is at a frame, the most over its pairs [m].
double excessOf(const Arm& arm, const Clip& clip, int frame) {
  const Eigen::MatrixXd depths = armDepths(arm.body, clip, frame, frame);
  double excess = -kNoDepth;
  for (Eigen::Index k = 0; k < depths.cols(); ++k) {
    if (sideOf(static_cast<size_t>(k)) == arm.side)
      excess = std::max(excess, depths(0, k) - arm.allowed[k]);
  }
  return excess;
}

// The least angle that does it at a frame, or twice kMostTurned; the clip's frame stays.
double needed(const Arm& arm, int frame, Clip& clip) {
  if (excessOf(arm, clip, frame) <= kDepthTolerance) return 0.0;
  const int joint = arm.roles.arms[arm.side].arm;
  const Eigen::Quaterniond before = clip.poses.rotations(frame)[joint];
  const auto isClear = [&](double angle) {
    const Eigen::Quaterniond turned = turnedOut(arm, clip, frame, angle);
    clip.poses.rotations(frame)[joint] = turned;
    const bool clear = excessOf(arm, clip, frame) <= 0.0;
    clip.poses.rotations(frame)[joint] = before;
    return clear;
  };
  double low = 0.0, high = kMostTurned;
  if (!isClear(high)) return 2.0 * kMostTurned;
  while (high - low > kAngleStep) {
    const double middle = 0.5 * (low + high);
    (isClear(middle) ? high : low) = middle;
  }
  return high;
}

// By frame from `first` to `last`, by the way that does with the least; which way, in `arm`.
std::vector<double> leastAngles(Arm& arm, int first, int last, Clip& clip) {
  std::vector<double> best;
  double least = std::numeric_limits<double>::infinity();
  int way = 0;
  for (arm.way = 0; arm.way < 3; ++arm.way) {
    std::vector<double> angles;
    double sum = 0.0;
    for (int i = first; i <= last; ++i) {
      angles.push_back(needed(arm, i, clip));
      sum += angles.back();
    }
    if (sum < least) least = sum, best = angles, way = arm.way;
    if (sum == 0.0) break;  // nothing is in the way
  }
  arm.way = way;
  for (double& angle : best) angle = std::min(angle, kMostTurned);
  return best;
}

// At each frame the mean over a window of the largest within the window of each of it: no less than
// the value there, and as smooth as the window is wide. Twice, by half the window each.
std::vector<double> smoothAbove(std::vector<double> values, int half) {
  const int n = static_cast<int>(values.size());
  const auto clamped = [&](int i) { return std::clamp(i, 0, n - 1); };
  std::vector<double> largest(values.size());
  for (int i = 0; i < n; ++i) {
    for (int k = -2 * half; k <= 2 * half; ++k)
      largest[i] = std::max(largest[i], values[clamped(i + k)]);
  }
  for (int pass = 0; pass < 2; ++pass) {
    for (int i = 0; i < n; ++i) {
      double sum = 0.0;
      for (int k = -half; k <= half; ++k) sum += largest[clamped(i + k)];
      values[i] = sum / (2 * half + 1);
    }
    largest = values;
  }
  return values;
}

}  // namespace

ArmClearing clearArms(const Body& body, const JointRoles& roles, const Eigen::VectorXd& allowed,
                      int first, int last, Clip& clip) {
  ArmClearing clearing;
  const int half = std::max(1, static_cast<int>(std::lround(0.25 * kSmoothOver / clip.frame_time)));
  const int begin = std::max(0, first - 4 * half);
  const int end = std::min(clip.frames() - 1, last + 4 * half);
  for (const Side side : {kLeft, kRight}) {
    Arm arm{body, roles, allowed, side, 0};
    std::vector<double> angles = leastAngles(arm, first, last, clip);
    angles.insert(angles.begin(), static_cast<size_t>(first - begin), 0.0);
    angles.resize(static_cast<size_t>(end - begin + 1), 0.0);
    if (*std::max_element(angles.begin(), angles.end()) == 0.0) continue;
    angles = smoothAbove(std::move(angles), half);
    for (int i = begin; i <= end; ++i) {
      const double angle = angles[static_cast<size_t>(i - begin)];
      if (angle <= 0.0) continue;
      const Eigen::Quaterniond turned = turnedOut(arm, clip, i, angle);
      clip.poses.rotations(i)[roles.arms[side].arm] = turned;
      clearing.turned[side] = std::max(clearing.turned[side], angle);
      ++clearing.frames[side];
    }
  }
  return clearing;
}

}  // namespace amble
