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

// A dip near a stance, which stays as it is: one of a millimetre or two may come at once, a deep
// one needs its time.
void fadeToStances(std::vector<double>& dip, double speed, double frame_time) {
  const int n = static_cast<int>(dip.size());
  for (int i = 0; i < n; ++i) {
    const double from_end = std::min(i, n - 1 - i) * frame_time;
    const double fade = std::max(HipDip::kShortestFade, dip[i] / speed);
    dip[i] *= smoothstep(from_end / fade);
  }
}

}  // namespace

FootController::FootController(const Skeleton& skeleton, const JointRoles& roles,
                               const std::array<FootShape, 2>& shapes, const GaitBlend& blend,
                               const std::array<Eigen::Vector3d, 2>& knee_axes)
    : skeleton_(skeleton),
      roles_(roles),
      shapes_(shapes),
      leg_lengths_{roles.legLength(skeleton, kLeft), roles.legLength(skeleton, kRight)},
      blend_(blend),
      knee_axes_(knee_axes),
      legs_(chainOf(skeleton, std::array{roles.legs[kLeft].foot, roles.legs[kRight].foot})) {}

bool FootController::apply(AnimationBuffer& buffer) const {
  return place(buffer, {LegReach::kDip, HipDip::kDeepest, 1.0, dips});
}

bool FootController::applyUneven(AnimationBuffer& buffer) const {
  return place(buffer, {LegReach::kUneven, HipDip::kUnevenDeepest, HipDip::kUnevenHeel, sinks});
}

// Legs are placed where the hips are; only where those are lowered then, from anew. Never at the
// first and last frame: those are stances.
bool FootController::place(AnimationBuffer& buffer, const Manner& manner) const {
  const int n = buffer.size();
  std::vector<JointFrame> joints(skeleton_.size());
  std::vector<Eigen::Quaterniond> captured;  // [frame][legs_]
  captured.reserve(n * legs_.size());
  std::vector<double> missing(n, 0.0);
  std::vector<char> placed(n);
  for (int i = 0; i < n; ++i) {
    const Targets targets = targetsOf(buffer, i, manner.heel_share, joints);
    if (i > 0 && i + 1 < n) missing[i] = missingHeight(targets, joints, manner.reach);
    if (missing[i] > manner.deepest) return false;
    for (const int j : legs_) captured.push_back(buffer.poses.rotations(i)[j]);
    placed[i] = placeLegs(targets, joints, buffer.poses.rotations(i));
  }
  const std::vector<double> lowered = manner.lowering(missing, buffer.frame_time);
  for (int i = 0; i < n; ++i) {
    if (lowered[i] == 0.0 && !placed[i]) return false;
    if (lowered[i] == 0.0) continue;
    for (size_t k = 0; k < legs_.size(); ++k)
      buffer.poses.rotations(i)[legs_[k]] = captured[i * legs_.size() + k];
    buffer.poses.p_WR(i).z() -= lowered[i];
    const Targets targets = targetsOf(buffer, i, manner.heel_share, joints);
    if (!placeLegs(targets, joints, buffer.poses.rotations(i))) return false;
  }
  return true;
}

bool FootController::placeLegs(const Targets& targets, std::span<const JointFrame> joints,
                               std::span<Eigen::Quaterniond> rotations) const {
  return placeLeg(kLeft, targets[kLeft], joints, rotations) &&
         placeLeg(kRight, targets[kRight], joints, rotations);
}

// Share of its length to which a leg behind stretches: less around lift-off.
double FootController::heelReach(double at) {
  constexpr double kFrom = LegReach::kPreSwingFrom, kTo = LegReach::kPreSwingTo;
  const double rise = smoothstep((at - kFrom) / (1.0 - kFrom));
  const double fall = smoothstep((kTo - at) / (kTo - 1.0));
  return LegReach::kHeel - LegReach::kPreSwing * rise * fall;
}

// Leaves in `joints` where those of the legs are.
FootController::Targets FootController::targetsOf(const AnimationBuffer& buffer, int frame,
                                                  double heel_share,
                                                  std::vector<JointFrame>& joints) const {
  forwardKinematics(skeleton_, buffer.poses[frame], legs_, joints);
  const auto target = [&](Side side) {
    const FootState& foot = buffer.states[frame].feet[side];
    return footTarget(foot, blend_.foot(side), shapes_[side], joints[roles_.legs[side].up_leg].p_WJ,
                      heelReach(foot.at) * leg_lengths_[side], heel_share);
  };
  return {target(kLeft), target(kRight)};
}

// Around frames in which a leg would be too short.
std::vector<double> FootController::dips(const std::vector<double>& missing, double frame_time) {
  const int n = static_cast<int>(missing.size());
  std::vector<double> dip(n, 0.0);
  const int reach = std::max(1, static_cast<int>(std::lround(HipDip::kTime / frame_time)));
  for (int i = 1; i + 1 < n; ++i) {
    if (missing[i] <= 0.0) continue;
    for (int j = std::max(1, i - reach); j <= std::min(n - 2, i + reach); ++j) {
      const double away = std::abs(j - i) / static_cast<double>(reach);
      dip[j] = std::max(dip[j], missing[i] * 0.5 * (1.0 + std::cos(kPi * away)));
    }
  }
  fadeToStances(dip, HipDip::kSpeed, frame_time);
  return dip;
}

// The least smooth curve over what is missing: the largest of what is missing within
// HipDip::kUnevenTime, averaged over as long.
std::vector<double> FootController::sinks(const std::vector<double>& missing, double frame_time) {
  const int n = static_cast<int>(missing.size());
  std::vector<double> sunk(n, 0.0);
  const int reach = std::max(1, static_cast<int>(std::lround(HipDip::kUnevenTime / frame_time)));
  for (int i = 0; i < n; ++i) {
    const auto from = missing.begin() + std::max(0, i - reach);
    const auto to = missing.begin() + std::min(n, i + reach + 1);
    sunk[i] = *std::max_element(from, to);
  }
  for (int pass = 0; pass < 2; ++pass) smoothed(sunk, reach / 2);
  fadeToStances(sunk, HipDip::kUnevenSpeed, frame_time);
  return sunk;
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
  return missingHeight(targetsOf(buffer, frame, heel_share, joints), joints, share);
}

double FootController::missingHeight(const Targets& targets, std::span<const JointFrame> joints,
                                     double share) const {
  double missing = 0.0;
  for (const Side side : {kLeft, kRight}) {
    const Eigen::Vector3d d = joints[roles_.legs[side].up_leg].p_WJ - targets[side].ankle;
    const double longest = share * leg_lengths_[side];
    const double room = longest * longest - d.head<2>().squaredNorm();
    missing = std::max(missing, d.z() - std::sqrt(std::max(room, 0.0)));
  }
  return missing;
}

}  // namespace amble
