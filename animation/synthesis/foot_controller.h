/// The foot controller: planted feet stay where they are, swinging feet go from print to print;
/// legs follow by two-link inverse kinematics in their own plane.
///
/// A planted foot rolls about its heel and then about its ball (FootShape), by the captured pitch.
/// So the point that touches the ground does not move at all, where a captured one slides by a
/// centimetre.
#pragma once

#include <array>

#include "animation/body/foot_shape.h"
#include "animation/preparation/foot_cycle_fit.h"
#include "animation/synthesis/gait_blend.h"
#include "animation/synthesis/sub_controller.h"

namespace amble {

/// Where a foot is to be: the ankle, the foot's rotation and how far the toes bend up.
struct FootTarget {
  Eigen::Vector3d ankle;    ///< [m, World]
  Eigen::Quaterniond q_WF;  ///< foot joint in World
  double toe_bend = 0.0;    ///< [rad, >= 0]
};

/// Where the foot is to be in a frame. Behind the walker, where the leg from `hip` [World] would be
/// longer than `longest` [m], the heel rises farther than captured, as it does when people take
/// longer steps.
/// @param heel_share  of the rise that there is for a heel beyond the captured one [0, 1]
FootTarget footTarget(const FootState& state, const FootCycle& cycle, const FootShape& shape,
                      const Eigen::Vector3d& hip, double longest, double heel_share = 1.0);

/// The lift of a swing (GaitParameters::lift), from the prints, rolls and shape that a state of it
/// has [m].
double swingLift(FootState state, const FootCycle& cycle, const FootShape& shape);
/// SwingShape::lift that makes the swing's lift what is asked [m]; what is added to clear things
/// stays beside it.
double liftFactor(double lift, FootState state, const FootCycle& cycle, const FootShape& shape);

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
