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

  bool apply(AnimationBuffer& buffer) const override;
  /// The same where feet stand at different heights and legs are bent and stretched more: the hips
  /// dip deeper, in longer curves.
  bool applyUneven(AnimationBuffer& buffer) const;

  /// How much lower the root has to be in each frame for no leg to reach farther than `share` [m,
  /// >= 0].
  std::vector<double> missingHeights(const AnimationBuffer& buffer, double share,
                                     double heel_share = 1.0) const;

 private:
  // How hips give way where legs are too short: see HipDip.
  struct Manner {
    double reach;       // of a leg, as a share of its length, beyond which they do
    double deepest;     // [m]
    double heel_share;  // of footTarget
    // How far the root is lowered at each frame, by how much is missing there [m].
    std::vector<double> (*lowering)(const std::vector<double>& missing, double frame_time);
  };
  using Four = std::array<int, 4>;  // frames that are made side by side

  static Four fourFrom(int first, int last);
  LaneLeg laneLeg(Side side, const Eigen::Vector3d& knee_axis) const;
  LaneLegs view() const;
  void aim(const AnimationBuffer& buffer, const Four& frames, double heel_share,
           LaneLegFrames& legs) const;
  double risenPitch(const Sole& sole, double at, double heel_share, Side side, int lane,
                    const LaneLegFrames& legs) const;
  void turn(const Four& frames, const LaneLegFrames& legs, AnimationBuffer& buffer,
            bool reached[4]) const;
  static double heelReach(double at);
  static std::vector<double> dips(const std::vector<double>& missing, double frame_time);
  static std::vector<double> sinks(const std::vector<double>& missing, double frame_time);
  // Legs under hips that are where they were.
  struct Trial {
    std::vector<Eigen::Quaterniond> captured;  // [frame][chain_], as they were
    std::vector<double> missing;               // that much too short is a leg at each frame [m]
    std::vector<char> reached;                 // whether both reach their targets
  };
  bool place(AnimationBuffer& buffer, const Manner& manner) const;
  bool tryLegs(AnimationBuffer& buffer, const Manner& manner, LaneLegFrames& legs,
               Trial& trial) const;

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
