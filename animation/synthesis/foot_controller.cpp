#include "animation/synthesis/foot_controller.h"

#include <algorithm>
#include <cmath>

#include "animation/body/two_link.h"
#include "animation/synthesis/leg_reach.h"
#include "base/ease.h"
#include "base/rotation.h"

namespace amble {
namespace {

// Replaces every value by the mean of those within `half` of it.
void smoothed(std::vector<double>& values, int half) {
  const int n = static_cast<int>(values.size());
  std::vector<double> sums(n + 1, 0.0);
  for (int i = 0; i < n; ++i) sums[i + 1] = sums[i] + values[i];
  for (int i = 0; i < n; ++i) {
    const int first = std::max(0, i - half), last = std::min(n - 1, i + half);
    values[i] = (sums[last + 1] - sums[first]) / (last + 1 - first);
  }
}

}  // namespace

FootController::FootController(const Skeleton& skeleton, const JointRoles& roles,
                               const std::array<FootShape, 2>& shapes, const GaitBlend& blend,
                               const std::array<Eigen::Vector3d, 2>& knee_axes)
    : skeleton_(skeleton),
      roles_(roles),
      shapes_(shapes),
      blend_(blend),
      knee_axes_(knee_axes),
      legs_(chainOf(skeleton, std::array{roles.legs[kLeft].foot, roles.legs[kRight].foot})) {}

bool FootController::apply(AnimationBuffer& buffer) const {
  return dipHips(buffer) && placeLegs(buffer, 1.0);
}

bool FootController::applyUneven(AnimationBuffer& buffer) const {
  return sinkHips(buffer) && placeLegs(buffer, HipDip::kUnevenHeel);
}

bool FootController::placeLegs(AnimationBuffer& buffer, double heel_share) const {
  std::vector<JointFrame> joints(skeleton_.size());
  for (int i = 0; i < buffer.size(); ++i) {
    forwardKinematics(skeleton_, buffer.poses[i], legs_, joints);
    for (const Side side : {kLeft, kRight}) {
      const FootTarget target = targetFor(side, buffer.states[i], joints, heel_share);
      if (!placeLeg(side, target, joints, buffer.poses.rotations(i))) return false;
    }
  }
  return true;
}

// Share of its length to which a leg behind stretches: less around lift-off.
double FootController::heelReach(double at) {
  constexpr double kFrom = LegReach::kPreSwingFrom, kTo = LegReach::kPreSwingTo;
  const double rise = smoothstep((at - kFrom) / (1.0 - kFrom));
  const double fall = smoothstep((kTo - at) / (kTo - 1.0));
  return LegReach::kHeel - LegReach::kPreSwing * rise * fall;
}

FootTarget FootController::targetFor(Side side, const FrameState& state,
                                     std::span<const JointFrame> joints, double heel_share) const {
  return footTarget(state.feet[side], blend_.foot(side), shapes_[side],
                    joints[roles_.legs[side].up_leg].p_WJ,
                    heelReach(state.feet[side].at) * roles_.legLength(skeleton_, side), heel_share);
}

// Lowers the root around frames in which a leg would be too short, never at the first and last
// frame: those are stances.
bool FootController::dipHips(AnimationBuffer& buffer) const {
  const int n = buffer.size();
  std::vector<JointFrame> joints(skeleton_.size());
  std::vector<double> dip(n, 0.0);
  const int reach = std::max(1, static_cast<int>(std::lround(HipDip::kTime / buffer.frame_time)));
  bool any = false;
  for (int i = 1; i + 1 < n; ++i) {
    const double missing = missingHeight(buffer, i, LegReach::kDip, joints);
    if (missing <= 0.0) continue;
    if (missing > HipDip::kDeepest) return false;
    any = true;
    for (int j = std::max(1, i - reach); j <= std::min(n - 2, i + reach); ++j) {
      const double away = std::abs(j - i) / static_cast<double>(reach);
      dip[j] = std::max(dip[j], missing * 0.5 * (1.0 + std::cos(kPi * away)));
    }
  }
  if (!any) return true;
  for (int i = 1; i + 1 < n; ++i) {
    // Near a stance a dip of a millimetre or two may come at once, a deep one needs its time.
    const double from_end = std::min(i, n - 1 - i) * buffer.frame_time;
    const double fade = std::max(HipDip::kShortestFade, dip[i] / HipDip::kSpeed);
    buffer.poses.p_WR(i).z() -= dip[i] * smoothstep(from_end / fade);
  }
  return true;
}

// Lowers the root by the least smooth curve over what is missing: the largest of what is missing
// within HipDip::kUnevenTime, averaged over as long. The first and last frame stay: they are
// stances.
bool FootController::sinkHips(AnimationBuffer& buffer) const {
  const int n = buffer.size();
  std::vector<JointFrame> joints(skeleton_.size());
  std::vector<double> missing(n, 0.0), sunk(n, 0.0);
  for (int i = 1; i + 1 < n; ++i) {
    missing[i] = missingHeight(buffer, i, LegReach::kUneven, joints, HipDip::kUnevenHeel);
    if (missing[i] > HipDip::kUnevenDeepest) return false;
  }
  const int reach =
      std::max(1, static_cast<int>(std::lround(HipDip::kUnevenTime / buffer.frame_time)));
  for (int i = 0; i < n; ++i) {
    const auto from = missing.begin() + std::max(0, i - reach);
    const auto to = missing.begin() + std::min(n, i + reach + 1);
    sunk[i] = *std::max_element(from, to);
  }
  for (int pass = 0; pass < 2; ++pass) smoothed(sunk, reach / 2);
  for (int i = 1; i + 1 < n; ++i) {
    const double from_end = std::min(i, n - 1 - i) * buffer.frame_time;
    const double fade = std::max(HipDip::kShortestFade, sunk[i] / HipDip::kUnevenSpeed);
    buffer.poses.p_WR(i).z() -= sunk[i] * smoothstep(from_end / fade);
  }
  return true;
}

bool FootController::placeLeg(Side side, const FootTarget& target,
                              std::span<const JointFrame> joints,
                              std::span<Eigen::Quaterniond> rotations) const {
  const LegJoints& leg = roles_.legs[side];
  const TwoLink links{joints[leg.up_leg].p_WJ, joints[leg.leg].p_WJ, joints[leg.foot].p_WJ,
                      joints[leg.up_leg].q_WJ * knee_axes_[side]};
  const double length = (links.knee - links.hip).norm() + (links.ankle - links.knee).norm();
  if ((target.ankle - links.hip).norm() > LegReach::kLongest * length) return false;
  const auto solved = solveTwoLink(links, target.ankle);
  if (!solved) return false;
  // Joints between (twist joints of some rigs) turn with the link above them.
  const auto parentRotation = [&](int joint, const Eigen::Quaterniond& turned) {
    return turned * joints[skeleton_.joint(joint).parent].q_WJ;
  };
  const Eigen::Quaterniond q_WThigh = solved->thigh * joints[leg.up_leg].q_WJ;
  const Eigen::Quaterniond q_WShank = solved->shank * joints[leg.leg].q_WJ;
  const Eigen::Quaterniond& q_WParent = joints[skeleton_.joint(leg.up_leg).parent].q_WJ;
  rotations[leg.up_leg] = (q_WParent.conjugate() * q_WThigh).normalized();
  rotations[leg.leg] = (parentRotation(leg.leg, solved->thigh).conjugate() * q_WShank).normalized();
  rotations[leg.foot] =
      (parentRotation(leg.foot, solved->shank).conjugate() * target.q_WF).normalized();
  rotations[leg.toe] = shapes_[side].q_FT * Eigen::Quaterniond(Eigen::AngleAxisd(
                                                -target.toe_bend, shapes_[side].lateral_T));
  return true;
}

double FootController::missingHeight(const AnimationBuffer& buffer, int frame, double share,
                                     std::vector<JointFrame>& joints, double heel_share) const {
  forwardKinematics(skeleton_, buffer.poses[frame], legs_, joints);
  double missing = 0.0;
  for (const Side side : {kLeft, kRight}) {
    const FootTarget target = targetFor(side, buffer.states[frame], joints, heel_share);
    const Eigen::Vector3d d = joints[roles_.legs[side].up_leg].p_WJ - target.ankle;
    const double longest = share * roles_.legLength(skeleton_, side);
    const double room = longest * longest - d.head<2>().squaredNorm();
    missing = std::max(missing, d.z() - std::sqrt(std::max(room, 0.0)));
  }
  return missing;
}

}  // namespace amble
