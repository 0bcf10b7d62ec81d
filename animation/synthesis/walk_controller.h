/// The walk controller (Pettré §4.2): cycles warped to the step length, blended to the turn rate,
/// played by distance walked and projected on the root path.
#pragma once

#include <vector>

#include "animation/synthesis/gait_blend.h"
#include "animation/synthesis/sub_controller.h"

namespace amble {

/// Root and joints of four frames of `poses` from channels[4 * channel + i] (WalkCycle::series), on
/// their states' positions and headings, leant as these say.
void projectChannels(std::span<const double> channels,
                     const std::vector<Eigen::Quaterniond>& reference,
                     const std::array<const FrameState*, 4>& states,
                     const std::array<int, 4>& frames, PoseArray& poses);

class WalkController : public SubController {
 public:
  /// How the root walks apart from the captured cycle.
  struct Carriage {
    double lead = 0.0;  ///< so much farther forward over the path's point [m]
    /// So much lower, by step length: evenly from 0 to `longest` [m, >= 0].
    std::vector<double> lowering;
    double longest = 1.0;  ///< step length of the last lowering [m, > 0]
  };

  WalkController(const GaitBlend& blend, const std::vector<Eigen::Quaterniond>& reference,
                 const Eigen::VectorXd& stand_channels, Carriage carriage);

  /// Overwrites every pose. The share of the standing posture (FrameState::standing) is mixed in
  /// here, channel by channel, since the mean of two rotations is that of their rotation vectors
  /// against a reference that lies near both.
  bool apply(AnimationBuffer& buffer) const override;
  double lowering(double step_length) const;  ///< in the middle of the double support [m]
  /// Of the root on the level, walking straight in steps so long, at a phase [m].
  double height(double phase, double step_length) const;
  /// Share of the lowering at a phase: whole in the double support, where the legs are spread,
  /// kLeastLowering over the standing leg [0, 1].
  static double loweringShare(double phase);

  /// By trial: less and the hips bob, more and the standing knee bends [0 to 1].
  static constexpr double kLeastLowering = 0.5;

 private:
  void carry(const FrameState& state, int frame, std::span<double> channels) const;

  const GaitBlend& blend_;
  const std::vector<Eigen::Quaterniond>& reference_;
  Eigen::VectorXd stand_;
  Carriage carriage_;
};

}  // namespace amble
