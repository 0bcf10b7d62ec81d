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
  // How hips give way where legs are too short: see HipDip.
  struct Manner {
    double reach;       // of a leg, as a share of its length, beyond which they do
    double deepest;     // [m]
    double heel_share;  // of footTarget
    // How far the root is lowered at each frame, by how much is missing there [m].
    std::vector<double> (*lowering)(const std::vector<double>& missing, double frame_time);
  };
  using Targets = std::array<FootTarget, 2>;  // by Side

  Targets targetsOf(const AnimationBuffer& buffer, int frame, double heel_share,
                    std::vector<JointFrame>& joints) const;
  double missingHeight(const Targets& targets, std::span<const JointFrame> joints,
                       double share) const;
  static double heelReach(double at);
  static std::vector<double> dips(const std::vector<double>& missing, double frame_time);
  static std::vector<double> sinks(const std::vector<double>& missing, double frame_time);
  bool place(AnimationBuffer& buffer, const Manner& manner) const;
  bool placeLegs(const Targets& targets, std::span<const JointFrame> joints,
                 std::span<Eigen::Quaterniond> rotations) const;
  bool placeLeg(Side side, const FootTarget& target, std::span<const JointFrame> joints,
                std::span<Eigen::Quaterniond> rotations) const;

  const Skeleton& skeleton_;
  JointRoles roles_;
  std::array<FootShape, 2> shapes_;
  std::array<double, 2> leg_lengths_;  // by Side [m]
  const GaitBlend& blend_;
  std::array<Eigen::Vector3d, 2> knee_axes_;
  std::vector<int> legs_;  // both, with what they hang on (chainOf)
};

}  // namespace amble
