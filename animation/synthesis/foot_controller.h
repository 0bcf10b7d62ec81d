/// The foot controller: planted feet stay where they are, swinging feet go from print to print;
/// legs follow by two-link inverse kinematics in their own plane.
///
/// A planted foot rolls about its heel and then about its ball (FootShape), by the captured pitch.
/// So the point that touches the ground does not move at all, where a captured one slides by a
/// centimetre.
#pragma once

#include <array>
#include <vector>

#include "animation/body/foot_shape.h"
#include "animation/steps/foot_target.h"
#include "animation/synthesis/gait_blend.h"
#include "animation/synthesis/leg_lanes.h"
#include "animation/synthesis/sub_controller.h"

namespace amble {

class FootController : public SubController {
 public:
  /// @param knee_axes  about which knees bend, in the thighs' joint frames, by Side: kneeAxes
  FootController(const Skeleton& skeleton, const JointRoles& roles,
                 const std::array<FootShape, 2>& shapes, const GaitBlend& blend,
                 const std::array<Eigen::Vector3d, 2>& knee_axes);

  /// Lowers the root where a leg would be longer than it may (LegReach), at stances by what is
  /// missing there and between them by the least smooth curve over what is missing, then turns the
  /// legs. False where hips would have to be lowered too far, or a leg does not reach.
  bool apply(AnimationBuffer& buffer) const override;

 private:
  using Four = std::array<int, 4>;  // frames that are made side by side

  static Four fourFrom(int first, int last);
  LaneLeg laneLeg(Side side, const Eigen::Vector3d& knee_axis) const;
  LaneLegs view() const;
  // Legs under hips that are where they were.
  struct Trial {
    std::vector<Eigen::Quaterniond> captured;  // [frame][chain_], as they were
    std::vector<double> height;                // of the root, as it was [m]
    std::vector<double> missing;               // by so much has it to be lower at each frame [m]
    std::vector<char> reached;                 // whether both reach their targets
    std::vector<std::array<Sole, 2>> soles;    // by Side
  };
  // Which captured cycle a foot follows, from frame to frame.
  struct Follows {
    const FootState* state = nullptr;  // that the cycle is of
    FootBlend cycle;
    FootCycle blended;  // where it is several
  };
  struct Scratch {
    explicit Scratch(size_t chain) : joints(kLaneJoint * chain), legs{joints.data(), {}} {}
    std::vector<double> joints;
    LaneLegFrames legs;
    std::array<Follows, 2> follows;  // by Side
  };
  void addSoles(const FrameState& state, Scratch& scratch, Trial& trial) const;
  void aim(const AnimationBuffer& buffer, const Four& frames, const Trial& trial,
           LaneLegFrames& legs) const;
  double risenPitch(const Sole& sole, Side side, int lane, const LaneLegFrames& legs) const;
  void turn(const Four& frames, const LaneLegFrames& legs, AnimationBuffer& buffer,
            bool reached[4]) const;
  bool tryLegs(AnimationBuffer& buffer, Scratch& scratch, Trial& trial) const;

  JointRoles roles_;
  std::array<FootShape, 2> shapes_;
  std::array<double, 2> leg_lengths_;  // by Side [m]
  const GaitBlend& blend_;
  std::vector<int> chain_;        // both legs, with what they hang on (chainOf)
  std::vector<int> parents_;      // of these, in the chain; of the first -1
  std::vector<double> offsets_;   // of these, three each [m]
  std::array<LaneLeg, 2> lanes_;  // by Side
};

}  // namespace amble
