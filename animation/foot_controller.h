/// The foot controller: planted feet stay where they are, swinging feet go from print to print; legs follow by two-link
/// inverse kinematics in their own plane.
///
/// A planted foot rolls about its heel and then about its ball (FootShape), by the captured pitch. So the point that touches the ground does not
/// move at all, where a captured one slides by a centimetre.
#pragma once

#include <array>

#include "animation/foot_cycle_fit.h"
#include "animation/foot_shape.h"
#include "animation/gait_blend.h"
#include "animation/sub_controller.h"

namespace amble {

/// Where a foot is to be: the ankle, the foot's rotation and how far the toes bend up.
struct FootTarget {
  Eigen::Vector3d ankle;     ///< [m, World]
  Eigen::Quaterniond q_WF;   ///< foot joint in World
  double toe_bend = 0.0;     ///< [rad, >= 0]
};

FootTarget footTarget(const FootState& state, const FootCycle& cycle, const FootShape& shape);

class FootController : public SubController {
 public:
  /// A leg stretched farther than this share of thigh and shank is refused: the knee would snap.
  static constexpr double kLongestReach = 0.9995;

  FootController(const Skeleton& skeleton, const JointRoles& roles,
                 const std::array<FootShape, 2>& shapes, const GaitBlend& blend);

  bool apply(AnimationBuffer& buffer) const override;

  /// How far each leg would have to reach in a frame, as a share of its length; also beyond 1. `joints` is scratch.
  double reach(const AnimationBuffer& buffer, int frame, std::vector<JointFrame>& joints) const;
  /// How much lower the root has to be for no leg to reach farther than `share`, in a frame [m, >= 0].
  double missingHeight(const AnimationBuffer& buffer, int frame, double share,
                       std::vector<JointFrame>& joints) const;

 private:
  bool placeLeg(Side side, const FootTarget& target, std::span<const JointFrame> joints,
                std::span<Eigen::Quaterniond> rotations) const;

  const Skeleton& skeleton_;
  JointRoles roles_;
  std::array<FootShape, 2> shapes_;
  const GaitBlend& blend_;
  Eigen::Vector3d left_R_;  // a walker's left, in the root's frame
};

}  // namespace amble
