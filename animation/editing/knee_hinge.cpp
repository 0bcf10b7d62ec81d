#include "animation/editing/knee_hinge.h"

#include <algorithm>
#include <cmath>

#include "animation/body/reference_pose.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr double kSaysPlane = 0.34;  // sine of a flexion, 20 degrees, from which on planes count
// A knee that was captured bent back by kBentBack is bent forward once the leg is shorter by so
// much [m]: over less it would snap, over more the ankle would stay off its place for longer. One
// that was bent back less, over as much less: else it would snap as the capture's knee passes
// straight.
constexpr double kForwardOver = 0.003;
constexpr double kBentBack = 4.0 * kDegree;  // by trial: 2 leave ankles off by 1 mm

/// How the distance of hip and ankle depends on the knee's turn by `angle` about the hinge:
///   thigh . shank = fixed + swing cos(flexion), flexion = captured + angle.
struct KneeCurve {
  double fixed, swing, captured;
};

KneeCurve kneeCurve(const Eigen::Vector3d& thigh, const Eigen::Vector3d& shank,
                    const Eigen::Vector3d& hinge) {
  const double fixed = thigh.dot(hinge) * shank.dot(hinge);
  const double ahead = thigh.dot(shank) - fixed, across = thigh.dot(hinge.cross(shank));
  return {fixed, std::hypot(ahead, across), std::atan2(-across, ahead)};
}

double flexionFor(const KneeCurve& curve, double cosine, double shorter) {
  const double cosine_of_flexion = (cosine - curve.fixed) / std::max(curve.swing, 1e-9);
  const double forward = std::acos(std::clamp(cosine_of_flexion, -1.0, 1.0));
  if (curve.captured >= 0.0) return forward;
  const double over = kForwardOver * std::min(1.0, -curve.captured / kBentBack);
  const double share = shorter < over ? std::max(0.0, shorter / over) : 1.0;
  return (2.0 * share - 1.0) * forward;
}

}  // namespace

KneeHinges kneeHinges(const Clip& clip, const JointRoles& roles) {
  const KneeHinges usual = kneeAxes(roles, referenceOf(clip, roles));
  KneeHinges sums = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  std::vector<JointFrame> joints(clip.skeleton.size());
  for (int i = 0; i < clip.frames(); ++i) {
    forwardKinematics(clip, i, joints);
    for (const Side side : {kLeft, kRight}) {
      const LegJoints& leg = roles.legs[side];
      const Eigen::Vector3d thigh = joints[leg.leg].p_WJ - joints[leg.up_leg].p_WJ;
      const Eigen::Vector3d shank = joints[leg.foot].p_WJ - joints[leg.leg].p_WJ;
      const Eigen::Vector3d normal = thigh.normalized().cross(shank.normalized());
      const Eigen::Vector3d in_thigh = joints[leg.up_leg].q_WJ.conjugate() * normal;
      if (normal.norm() > kSaysPlane && in_thigh.dot(usual[side]) > 0.0) sums[side] += in_thigh;
    }
  }
  for (const Side side : {kLeft, kRight}) {
    if (sums[side].norm() < kSaysPlane) sums[side] = usual[side];
    sums[side].normalize();
  }
  return sums;
}

LegChange changeLeg(const CapturedLeg& leg, const Eigen::Vector3d& hip,
                    const Eigen::Vector3d& ankle) {
  const Eigen::Vector3d thigh_link = leg.knee - leg.hip, shank_link = leg.ankle - leg.knee;
  const double a = thigh_link.norm(), b = shank_link.norm();
  const Eigen::Vector3d way = ankle - hip;
  const double distance = way.norm();
  const double cosine = (distance * distance - a * a - b * b) / (2.0 * a * b);
  const KneeCurve curve = kneeCurve(thigh_link / a, shank_link / b, leg.hinge);
  const double flexion = flexionFor(curve, cosine, leg.reach() - distance);
  const Eigen::Quaterniond bend = expRotation((flexion - curve.captured) * leg.hinge);
  const Eigen::Vector3d bent = thigh_link + bend * shank_link;
  LegChange change;
  change.thigh = turnBetween(bent, way);
  change.shank = change.thigh * bend;
  change.miss = std::abs(bent.norm() - distance);
  return change;
}

}  // namespace amble
