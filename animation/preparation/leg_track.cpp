#include "animation/preparation/leg_track.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "animation/preparation/bone_pitch.h"
#include "animation/steps/foot_target.h"
#include "animation/steps/leg_reach.h"
#include "animation/steps/stride_law.h"
#include "base/ease.h"
#include "base/rotation.h"

namespace amble {
namespace {

// A ball that is lifted higher than this over a tip that stands is a foot that has left [rad].
constexpr double kMostRolled = 45.0 * kDegree;

// Of walks at the captured speed and rate.
DoubleSupports supportsOf(const WalkCycle& cycle, double leg_length) {
  StrideLaw law(cycle.speed, cycle.stepLength());
  law.setSupports({{cycle.speed, cycle.doubleSupports()}}, leg_length);
  return law.supports(cycle.speed, 0.0);
}

}  // namespace

double swayBasis(int k, double phase) {
  const double angle = 2.0 * std::numbers::pi * swayWaves(k) * phase;
  return k % 2 == 0 ? std::cos(angle) : std::sin(angle);
}

Eigen::Vector3d swayAt(const PelvisSway& sway, double phase) {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  for (int k = 0; k < kSwayNumbers; ++k) at[swayAxis(k)] += sway[k] * swayBasis(k, phase);
  return at;
}

LegTrack::LegTrack(const Skeleton& skeleton, const JointRoles& roles, const FootShape& shape,
                   const std::vector<Eigen::Quaterniond>& reference, const WalkCycle& cycle,
                   Side side)
    : skeleton_(skeleton),
      joints_(roles.legs[side]),
      shape_(shape),
      reference_(reference),
      cycle_(cycle),
      path_{Eigen::Vector2d::Zero(), 0.0, 2.0 * cycle.stepLength(), cycle.turn_rate * cycle.period},
      toe_out_(cycle.toe_out[side]),
      thigh_(skeleton.joint(joints_.leg).offset.norm()),
      shank_(skeleton.joint(joints_.foot).offset.norm()),
      joints_at_(skeleton.size()),
      foot_(cycle.feet[side]) {
  const double node = side == kLeft ? 0.0 : 0.5, sign = side == kLeft ? 1.0 : -1.0;
  const DoubleSupports steps = supportsOf(cycle, roles.legLength(skeleton, kLeft));
  const double before = 0.5 * steps(side, 0), after = 0.5 * steps(other(side), 1);  // [cycles]
  strike_ = node - before;
  stance_ = before + 0.5 + after;
  beside_ = node + 0.25;
  forward_ = cycle.foot_forward[side];
  left_ = cycle.prints_left + 0.5 * sign * cycle.step_width;
  for (int i = 0; i < kSamples; ++i) captured_.push_back(legAt(timeOf(i)));
}

double LegTrack::timeOf(int sample) {
  return sample < FootCycle::kStanceSamples
             ? static_cast<double>(sample) / FootCycle::kStanceSamples
             : 1.0 + static_cast<double>(sample - FootCycle::kStanceSamples) /
                         FootCycle::kSwingSamples;
}

double LegTrack::phaseAt(double at) const {
  return strike_ + (at <= 1.0 ? at * stance_ : stance_ + (at - 1.0) * (1.0 - stance_));
}

Eigen::Quaterniond LegTrack::pathAt(double at) const {
  return aboutZ(path_.headingAt(phaseAt(at)));
}

// At a time of the foot, FootState::at.
LegTrack::Leg LegTrack::legAt(double at) const {
  const double phase = phaseAt(at);
  const Eigen::VectorXd c = fourierAt(cycle_.series, phase);
  const Eigen::Quaterniond along = pathAt(at);
  Pose pose;
  pose.p_WR = along * c.head<3>();
  pose.p_WR.head<2>() += path_.at(phase);
  for (size_t j = 0; j < reference_.size(); ++j) {
    const Eigen::Vector3d v = c.segment<3>(3 + 3 * static_cast<Eigen::Index>(j));
    pose.rotations.push_back(reference_[j] * expRotation(v));
  }
  pose.rotations[0] = along * pose.rotations[0];
  forwardKinematics(skeleton_, pose, joints_at_);
  return {joints_at_[joints_.up_leg].p_WJ, joints_at_[joints_.foot].p_WJ,
          joints_at_[joints_.toe].p_WJ};
}

double LegTrack::capturedPitch(int sample) const {
  const double at = timeOf(sample), tau = at - 1.0;
  const Leg& leg = captured_[sample];
  const double down = seenDown(leg.ball - leg.ankle, headingAt(at) + toe_out_);
  if (tau >= 0.0) {
    return pitchOfBone(down, swingPolynomial(foot_.yaw, tau), swingPolynomial(foot_.roll, tau),
                       shape_);
  }
  const double pitch = down - flatDrop(shape_);
  return at < FootCycle::kFlat ? std::min(pitch, 0.0) : std::max(pitch, 0.0);
}

double LegTrack::capturedToes(int sample) const {
  constexpr int kFlat = static_cast<int>(FootCycle::kFlat * FootCycle::kStanceSamples);
  const double rise =
      captured_[std::min(sample, FootCycle::kStanceSamples)].ball.z() - captured_[kFlat].ball.z();
  const double rolled =
      std::asin(std::clamp(rise / (shape_.tip_x - shape_.ball_x), 0.0, std::sin(kMostRolled)));
  constexpr double kOver = 0.25;  // of the swing: by then toes lie as they lay
  return rolled * (1.0 - smoothstep((timeOf(sample) - 1.0) / kOver));
}

void LegTrack::make(const FootCycle& foot, double forward, const PelvisSway& sway) {
  foot_ = foot;
  moved_ = forward;
  sway_ = sway;
}

Eigen::Vector3d LegTrack::printAt(double u) const {
  Eigen::Vector3d print =
      aboutZ(path_.headingAt(u)) * Eigen::Vector3d(forward_ + moved_, left_, 0.0);
  print.head<2>() += path_.at(u);
  return print;
}

// Of the path beside the foot, which turns with it as it swings.
double LegTrack::headingAt(double at) const {
  return path_.headingAt(beside_) + smoothstep(at - 1.0) * path_.turn;
}

// The pitch to which FootController raises the heel.
double LegTrack::raised(const Eigen::Vector3d& sole, int sample, double pitch,
                        const Eigen::Vector3d& hip) const {
  Sole on;
  on.place.position = sole;
  on.place.heading = headingAt(timeOf(sample)) + toe_out_;
  on.pitch = pitch;
  const double longest = std::clamp(capturedLength(sample), LegReach::kStraight * length(),
                                    LegReach::kLongest * length());
  const Eigen::Vector3d ankle = sole + aboutZ(on.place.heading) * rolledAnkle(shape_, pitch);
  return raisedPitch(on, shape_, hip, (ankle - hip).norm(), longest);
}

LegTrack::Made LegTrack::made(int sample, const LegMoves& moved) const {
  const double at = timeOf(sample), heading = headingAt(at);
  const Eigen::Quaterniond q_WS = aboutZ(heading + toe_out_), along = pathAt(at);
  Eigen::Vector3d sole = print() + aboutZ(heading) * Eigen::Vector3d(moved[kByPrint], 0.0, 0.0);
  if (sample >= FootCycle::kStanceSamples) {
    const Eigen::Vector3d way = stride();
    const Eigen::Vector3d ahead = way / way.norm(), left(-ahead.y(), ahead.x(), 0.0);
    sole += swingProgress(foot_, at - 1.0) * way + moved[kByWay] * ahead +
            swingPolynomial(foot_.sideways, at - 1.0) * left;
    sole.z() += swingPolynomial(foot_.height, at - 1.0) + moved[kByHeight];
  }
  sole += q_WS * rolledBall(shape_, std::max(0.0, toeRoll(foot_, at) + moved[kByToes]));
  Eigen::Vector3d sway = swayAt(sway_, phaseOf(sample));
  sway.x() += moved[kByHip];
  sway.z() += moved[kByHipUp];
  const Eigen::Vector3d hip = captured_[sample].hip + along * sway;
  const double pitch = raised(sole, sample, foot_.pitch[sample] + moved[kByPitch], hip);
  return {sole + q_WS * rolledAnkle(shape_, pitch) - hip, pitch};
}

LegBend LegTrack::bendOf(int sample, const Made& leg) const {
  const Eigen::Vector3d line = pathAt(timeOf(sample)).conjugate() * leg.line;
  const double l = std::min(line.norm(), LegReach::kLongest * length());
  const double cosine = (l * l - thigh_ * thigh_ - shank_ * shank_) / (2.0 * thigh_ * shank_);
  const double knee = std::acos(std::clamp(cosine, -1.0, 1.0));
  const double forward = std::atan2(line.x(), -line.z());
  return {knee, forward, knee - forward - leg.pitch};
}

Eigen::Vector2d LegTrack::soleUnderAnkle(double tau) const {
  const double at = 1.0 + tau;
  const Eigen::Quaterniond q_WS = aboutZ(headingAt(at) + toe_out_);
  const Eigen::Vector3d sole =
      legAt(at).ankle + pathAt(at) * swayAt(sway_, phaseAt(at)) -
      q_WS * (rolledAnkle(shape_, footPitch(foot_, at)) + rolledBall(shape_, toeRoll(foot_, at))) -
      print();
  const Eigen::Vector3d way = stride();
  return {sole.dot(way) / way.squaredNorm(), sole.z()};
}

}  // namespace amble
