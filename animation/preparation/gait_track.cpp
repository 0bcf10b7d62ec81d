#include "animation/preparation/gait_track.h"

#include <algorithm>
#include <cmath>

#include "animation/analysis/classify_clip.h"
#include "animation/analysis/motion_measures.h"
#include "animation/body/pelvis.h"
#include "animation/library/foot_cycle.h"
#include "base/rotation.h"
#include "base/statistics.h"

namespace amble {
namespace {

constexpr double kMidStance = FootCycle::kFlat;  // of a stance: the sole is flat there
// In a run a foot that is off the ground may be low and slow once more, and its plant goes on until
// then: by half and more, where stances differ by a tenth. What is longer than the usual by this is
// as long as the usual [1].
constexpr double kLongStance = 1.25;

}  // namespace

GaitTrack::GaitTrack(const Clip& level, const JointRoles& roles,
                     const std::array<FootShape, 2>& feet, const FootPlants* plants)
    : clip_(level), roles_(roles), feet_(feet), joints_(level.skeleton.size()) {
  pose_.rotations.resize(level.skeleton.size());
  takePlants(plants != nullptr ? *plants : detectPlants(level, roles));
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

double GaitTrack::headingAt(double frame) const { return pelvisHeading(jointsAt(frame), roles_); }

Eigen::Quaterniond GaitTrack::sole(Side side, double frame,
                                   const Eigen::Quaterniond& correction) const {
  const Eigen::Quaterniond& q_WF = jointsAt(frame)[roles_.legs[side].foot].q_WJ;
  return q_WF * feet_[side].q_SF.conjugate() * correction;
}

Eigen::Vector3d GaitTrack::ankle(Side side, double frame) const {
  return jointsAt(frame)[roles_.legs[side].foot].p_WJ;
}

Eigen::Vector3d GaitTrack::footBone(Side side, double frame) const {
  const std::vector<JointFrame>& joints = jointsAt(frame);
  return joints[roles_.legs[side].toe].p_WJ - joints[roles_.legs[side].foot].p_WJ;
}

double GaitTrack::standingDrop(Side side, const Plant& plant) const {
  constexpr int kSamples = 9;
  double mean = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    const double x = kDownFrom + (kDownUntil - kDownFrom) * i / (kSamples - 1);
    const Eigen::Vector3d bone = footBone(side, plant.strike + x * (plant.lift_off - plant.strike));
    mean += std::atan2(-bone.z(), bone.head<2>().norm()) / kSamples;
  }
  return mean;
}

GaitTrack::FlatFoot GaitTrack::flatFoot(Side side, const Plant& plant) const {
  const double middle = plant.strike + kMidStance * (plant.lift_off - plant.strike);
  const Eigen::Quaterniond q_WS = sole(side, middle, Eigen::Quaterniond::Identity());
  const Eigen::Vector3d forward = q_WS * Eigen::Vector3d::UnitX();
  FlatFoot flat;
  flat.heading = std::atan2(forward.y(), forward.x());
  flat.correction = q_WS.conjugate() * aboutZ(flat.heading);
  flat.print = ankle(side, middle) - aboutZ(flat.heading) * rolledAnkle(feet_[side], 0.0);
  return flat;
}

// A plant that touches the clip's ends began before it or goes on after it: it is taken to last as
// long as the others, where its middle, at which the foot is flat, lies within the clip.
void GaitTrack::takePlants(const FootPlants& found) {
  const int last = clip_.frames() - 1;
  std::vector<double> durations;
  for (const Side side : {kLeft, kRight}) {
    for (const FootPlant& p : found.plants[side]) {
      if (p.first > 0 && p.last < last) durations.push_back(p.lift_off - p.strike);
    }
  }
  if (durations.empty()) return;
  const bool runs = classifyClip(found, clip_.frame_time).largest() == MotionType::kRun;
  const double usual = runs ? quantile(durations, 0.5) : upperMedian(durations);
  for (const Side side : {kLeft, kRight}) {
    for (const FootPlant& p : found.plants[side]) {
      Plant plant{p.strike, p.lift_off};
      if (p.first == 0 && p.last == last) continue;
      if (runs && p.first > 0 && plant.lift_off > plant.strike + kLongStance * usual) {
        plant.lift_off = plant.strike + usual;
      }
      if (p.first == 0) plant.strike = std::min(plant.strike, plant.lift_off - usual);
      if (p.last == last) plant.lift_off = std::max(plant.lift_off, plant.strike + usual);
      const double middle = plant.strike + kMidStance * (plant.lift_off - plant.strike);
      if (middle >= 0.0 && middle <= last) plants_[side].push_back(plant);
    }
  }
}

}  // namespace amble
