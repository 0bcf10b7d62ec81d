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
  /// A leg stretched farther than this share of thigh and shank is refused: the knee would snap.
  static constexpr double kLongestReach = 0.9995;
  /// A leg behind does not stretch farther than this, its heel rises instead; and by `kPreSwing`
  /// less before and after it lifts off: the knee flexes before the toe leaves.
  static constexpr double kHeelReach = 0.998;
  static constexpr double kPreSwing = 0.03;
  /// Where a leg would stretch farther than this, the hips dip, over kDipTime before and after;
  /// deeper than kDeepestDip is refused.
  static constexpr double kDipReach = 0.999;
  static constexpr double kDipTime = 0.3;        // [s]
  static constexpr double kShortestFade = 0.03;  // of a dip towards a stance [s]
  static constexpr double kDipSpeed = 0.03;      // by trial [m/s]
  static constexpr double kDeepestDip = 0.04;    // [m]; by trial, deeper looks like a stumble
  /// On uneven ground: legs stretch to kUnevenReach before the hips dip, at most to kUnevenDip, and
  /// a dip is spread over kSpread; by trial.
  static constexpr double kUnevenReach = 0.992;
  static constexpr double kUnevenDip = 0.15;  // [m]
  /// So much of a heel's further rise is used there: a foot that stands behind for longer than on
  /// the level would go up on its toes' tips.
  static constexpr double kUnevenHeel = 0.4;
  static constexpr double kSpread = 0.16;     // [s]
  static constexpr double kSinkSpeed = 0.25;  // from a stance on [m/s]

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
};

}  // namespace amble
