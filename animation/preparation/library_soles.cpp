#include "animation/preparation/library_soles.h"

#include <cmath>
#include <optional>
#include <utility>

#include "animation/body/foot_shape.h"
#include "animation/body/pose.h"
#include "animation/body/rest_feet.h"
#include "animation/clips/rest_feet_flat.h"
#include "animation/preparation/gait_track.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr double kSameOffset = 1e-3;  // of joints of one subject in two clips [m]
// How much what turns stood on counts where there are both, by trial: so much, and neither a turn's
// knees nor a walk's ankles are farther from their captures than they may be [1].
constexpr double kOfTurns = 0.6;

void raise(Motion& motion, double rise) {
  switch (motion.kind) {
    case MotionKind::kWalk:
    case MotionKind::kMovement:
      motion.cycle.series.alpha(2, 0) += rise;
      break;
    case MotionKind::kPosture:
    case MotionKind::kBlocking:
      motion.posture.root_height += rise;
      break;
    case MotionKind::kStart:
    case MotionKind::kStop:
      if (!motion.transition.sequence.empty())
        motion.transition.sequence.spline.row(2).array() += rise;
      break;
    case MotionKind::kTurnOnSpot:
      motion.turn.spline.row(2).array() += rise;
      break;
  }
}

// Of what straight walks or turns stood on; none where there is none of them.
std::optional<std::array<double, 2>> meanDrops(const MotionLibrary& library, bool turning) {
  std::array<double, 2> mean = {0.0, 0.0};
  int walks = 0;
  for (const Motion& motion : library.motions) {
    if (motion.kind != MotionKind::kWalk || motion.turning != turning || !motion.cycle.foot_drops)
      continue;
    for (const Side side : {kLeft, kRight}) mean[side] += (*motion.cycle.foot_drops)[side];
    ++walks;
  }
  if (walks == 0) return std::nullopt;
  return std::array{mean[kLeft] / walks, mean[kRight] / walks};
}

}  // namespace

bool isOfRig(const MotionLibrary& library, const Skeleton& skeleton) {
  const Skeleton& own = library.skeleton;
  const JointRoles& roles = library.roles;
  if (skeleton.size() != own.size() || skeleton.joint(0).name != own.joint(0).name) return false;
  for (int i = 1; i < own.size(); ++i) {
    const Joint &one = skeleton.joint(i), &other = own.joint(i);
    const bool of_foot =
        one.parent == roles.legs[kLeft].foot || one.parent == roles.legs[kRight].foot;
    const double off = of_foot ? std::abs(one.offset.norm() - other.offset.norm())
                               : (one.offset - other.offset).norm();
    if (one.name != other.name || one.parent != other.parent || off >= kSameOffset) return false;
  }
  return true;
}

void raise(Clip& clip, double rise) {
  for (int i = 0; i < clip.frames(); ++i) clip.poses.p_WR(i).z() += rise;
}

Clip onSoles(const MotionLibrary& library, const Clip& clip, const std::array<double, 2>& drops) {
  Clip turned = withFeetAtRest(clip, library.roles, drops);
  turned.skeleton = withFootDrops(library.skeleton, library.roles, drops);
  raise(turned, riseBetween(clip.skeleton, turned.skeleton, library.roles));
  return turned;
}

double riseBetween(const Skeleton& from, const Skeleton& to, const JointRoles& roles) {
  const auto ankle = [&](const Skeleton& skeleton) {
    return makeFootShape(skeleton, roles, kLeft, statureOf(skeleton, roles)).ankle_height;
  };
  return ankle(to) - ankle(from);
}

std::array<double, 2> standingDrops(const WalkCycle& cycle, const Skeleton& skeleton,
                                    const JointRoles& roles,
                                    const std::vector<Eigen::Quaterniond>& reference) {
  constexpr double kFrom = GaitTrack::kDownFrom, kUntil = GaitTrack::kDownUntil;
  constexpr int kSamples = 17;
  std::array<double, 2> drops = {0.0, 0.0};
  std::vector<JointFrame> joints(skeleton.size());
  Pose pose;
  pose.rotations.resize(joints.size());
  for (const Side side : {kLeft, kRight}) {
    const LegJoints& leg = roles.legs[side];
    const FootCycle& foot = cycle.feet[side];
    const double stance = foot.lift_off - foot.strike - std::floor(foot.lift_off - foot.strike);
    for (int i = 0; i < kSamples; ++i) {
      const double share = kFrom + (kUntil - kFrom) * i / (kSamples - 1);
      const Eigen::VectorXd channels = fourierAt(cycle.series, foot.strike + share * stance);
      for (size_t j = 0; j < joints.size(); ++j) {
        pose.rotations[j] =
            reference[j] * expRotation(channels.segment<3>(3 + 3 * static_cast<Eigen::Index>(j)));
      }
      forwardKinematics(skeleton, pose, joints);
      const Eigen::Vector3d toe = joints[leg.toe].p_WJ - joints[leg.foot].p_WJ;
      drops[side] += std::atan2(-toe.z(), toe.head<2>().norm()) / kSamples;
    }
  }
  return drops;
}

void standOn(Skeleton soles, MotionLibrary& library) {
  const double rise = riseBetween(library.skeleton, soles, library.roles);
  for (Motion& motion : library.motions) raise(motion, rise);
  library.skeleton = std::move(soles);
}

void settleSoles(MotionLibrary& library) {
  const std::optional<std::array<double, 2>> straight = meanDrops(library, false);
  const std::optional<std::array<double, 2>> turns = meanDrops(library, true);
  if (!straight && !turns) return;
  std::array<double, 2> drops = straight ? *straight : *turns;
  for (const Side side : {kLeft, kRight}) {
    if (turns) drops[side] += kOfTurns * ((*turns)[side] - drops[side]);
  }
  standOn(withFootDrops(library.skeleton, library.roles, drops), library);
}

}  // namespace amble
