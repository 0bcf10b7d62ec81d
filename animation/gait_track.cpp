#include "animation/gait_track.h"

#include <algorithm>
#include <cmath>

#include "animation/rotation.h"

namespace amble {
namespace {

// A heel has landed when its ankle is slower than this share of the walk's speed, a toe has left
// when it is faster. By trial on lab walks; only the shape of the swing is cut there, the timing of
// steps is set by speed.
constexpr double kStrikeShare = 0.8;
constexpr double kLiftShare = 0.6;
constexpr double kShortestPlant = 0.2;  // [s]

// Times at which `speed` crosses `level`, downwards or upwards, in fractions of frames.
std::vector<double> crossings(const std::vector<double>& speed, double level, bool down) {
  std::vector<double> times;
  for (size_t i = 0; i + 1 < speed.size(); ++i) {
    const bool before = speed[i] > level, after = speed[i + 1] > level;
    if (before == after || before != down) continue;
    times.push_back(static_cast<double>(i) + (speed[i] - level) / (speed[i] - speed[i + 1]));
  }
  return times;
}

std::vector<double> speeds(const std::vector<Eigen::Vector3d>& points, double frame_time) {
  std::vector<double> speed(points.size(), 0.0);
  for (size_t i = 1; i + 1 < points.size(); ++i) {
    speed[i] = (points[i + 1] - points[i - 1]).norm() / (2.0 * frame_time);
  }
  if (points.size() > 2) speed.front() = speed[1], speed.back() = speed[points.size() - 2];
  return speed;
}

// Speed of walking: the median of the root's over frames in which it moves.
double walkingSpeed(const Clip& clip) {
  std::vector<Eigen::Vector3d> root;
  for (int i = 0; i < clip.frames(); ++i) root.push_back(clip.poses.p_WR(i));
  std::vector<double> moving;
  for (const double v : speeds(root, clip.frame_time)) {
    if (v > 0.3) moving.push_back(v);
  }
  if (moving.empty()) return 0.0;
  std::nth_element(moving.begin(), moving.begin() + moving.size() / 2, moving.end());
  return moving[moving.size() / 2];
}

}  // namespace

GaitTrack::GaitTrack(const Clip& level, const JointRoles& roles,
                     const std::array<FootShape, 2>& feet)
    : clip_(level),
      roles_(roles),
      feet_(feet),
      root_to_heading_(restToHeading(level.skeleton, roles).conjugate()),
      joints_(level.skeleton.size()) {
  pose_.rotations.resize(level.skeleton.size());
  findPlants(kLeft);
  findPlants(kRight);
}

void GaitTrack::poseAt(double frame, Pose& pose) const {
  const int i = std::clamp(static_cast<int>(frame), 0, std::max(0, clip_.frames() - 2));
  const int j = std::min(i + 1, clip_.frames() - 1);
  interpolatePose(clip_.poses[i], clip_.poses[j], std::clamp(frame - i, 0.0, 1.0), pose);
}

const std::vector<JointFrame>& GaitTrack::jointsAt(double frame) const {
  poseAt(frame, pose_);
  forwardKinematics(clip_.skeleton, pose_, joints_);
  return joints_;
}

double GaitTrack::headingAt(double frame) const {
  poseAt(frame, pose_);
  const Eigen::Vector3d forward =
      pose_.rotations[0] * (root_to_heading_ * Eigen::Vector3d::UnitX());
  return std::atan2(forward.y(), forward.x());
}

Eigen::Quaterniond GaitTrack::sole(Side side, double frame,
                                   const Eigen::Quaterniond& correction) const {
  const Eigen::Quaterniond& q_WF = jointsAt(frame)[roles_.legs[side].foot].q_WJ;
  return q_WF * feet_[side].q_SF.conjugate() * correction;
}

Eigen::Vector3d GaitTrack::ankle(Side side, double frame) const {
  return jointsAt(frame)[roles_.legs[side].foot].p_WJ;
}

GaitTrack::FlatFoot GaitTrack::flatFoot(Side side, const Plant& plant) const {
  const double middle = plant.strike + 0.45 * (plant.lift_off - plant.strike);
  const Eigen::Quaterniond q_WS = sole(side, middle, Eigen::Quaterniond::Identity());
  const Eigen::Vector3d forward = q_WS * Eigen::Vector3d::UnitX();
  FlatFoot flat;
  flat.heading = std::atan2(forward.y(), forward.x());
  flat.correction = q_WS.conjugate() * aboutZ(flat.heading);
  flat.print = ankle(side, middle) - aboutZ(flat.heading) * rolledAnkle(feet_[side], 0.0);
  return flat;
}

void GaitTrack::findPlants(Side side) {
  std::vector<Eigen::Vector3d> ankle, toe;
  for (int i = 0; i < clip_.frames(); ++i) {
    const std::vector<JointFrame>& joints = jointsAt(i);
    ankle.push_back(joints[roles_.legs[side].foot].p_WJ);
    toe.push_back(joints[roles_.legs[side].toe].p_WJ);
  }
  const double speed = walkingSpeed(clip_);
  if (!(speed > 0.0)) return;  // nobody walks: what crosses zero is noise
  const auto strikes = crossings(speeds(ankle, clip_.frame_time), kStrikeShare * speed, true);
  const auto lifts = crossings(speeds(toe, clip_.frame_time), kLiftShare * speed, false);
  for (const double strike : strikes) {
    const auto lift = std::upper_bound(lifts.begin(), lifts.end(), strike);
    if (lift == lifts.end() || (*lift - strike) * clip_.frame_time < kShortestPlant) continue;
    if (!plants_[side].empty() && plants_[side].back().lift_off == *lift) continue;
    plants_[side].push_back({strike, *lift});
  }
}

}  // namespace amble
