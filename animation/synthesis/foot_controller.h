/// The foot controller: planted feet stay where they are, swinging feet go from print to print;
/// legs follow by two-link inverse kinematics in their own plane.
///
/// A planted foot rolls about its heel and then about its ball (FootShape), by the captured pitch.
/// So the point that touches the ground does not move at all, where a captured one slides by a
/// centimetre.
#pragma once

#include <array>

#include "animation/body/foot_shape.h"
#include "animation/steps/foot_target.h"
#include "animation/synthesis/gait_blend.h"
#include "animation/synthesis/sub_controller.h"

namespace amble {

class FootController : public SubController {
 public:
  /// @param knee_axes  about which knees bend, in the thighs' joint frames, by Side: kneeAxes
  FootController(const Skeleton& skeleton, const JointRoles& roles,
                 const std::array<FootShape, 2>& shapes, const GaitBlend& blend,
                 const std::array<Eigen::Vector3d, 2>& knee_axes);

  bool apply(AnimationBuffer& buffer) const override;
  /// The same where feet stand at different heights and legs are bent and stretched more: the hips
  /// dip deeper, in longer curves.
  bool applyUneven(AnimationBuffer& buffer) const;

  /// How much lower the root has to be for no leg to reach farther than `share`, in a frame [m, >=
  /// 0]. `joints` is scratch.
  double missingHeight(const AnimationBuffer& buffer, int frame, double share,
                       std::vector<JointFrame>& joints, double heel_share = 1.0) const;

 private:
  FootTarget targetFor(Side side, const FrameState& state, std::span<const JointFrame> joints,
                       double heel_share = 1.0) const;
  static double heelReach(double at);
  bool dipHips(AnimationBuffer& buffer) const;
  bool sinkHips(AnimationBuffer& buffer) const;
  bool placeLegs(AnimationBuffer& buffer, double heel_share) const;
  bool placeLeg(Side side, const FootTarget& target, std::span<const JointFrame> joints,
                std::span<Eigen::Quaterniond> rotations) const;

  const Skeleton& skeleton_;
  JointRoles roles_;
  std::array<FootShape, 2> shapes_;
  const GaitBlend& blend_;
  std::array<Eigen::Vector3d, 2> knee_axes_;
  std::vector<int> legs_;  // both, with what they hang on (chainOf)
};

}  // namespace amble
