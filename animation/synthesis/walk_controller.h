/// The walk controller (Pettré §4.2): cycles warped to the step length, blended to the turn rate,
/// played by distance walked and projected on the root path.
#pragma once

#include <vector>

#include "animation/synthesis/captured_turns.h"
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
  /// @param stand_channels  WalkCycle::series' channels of standing
  /// @param lead  so much farther forward than captured over the path's point the root walks [m]
  WalkController(const GaitBlend& blend, const CapturedTurns& turns,
                 const std::vector<Eigen::Quaterniond>& reference,
                 const Eigen::VectorXd& stand_channels, double lead);

  /// Overwrites every pose. The share of the standing posture (FrameState::standing) is mixed in
  /// here, channel by channel, since the mean of two rotations is that of their rotation vectors
  /// against a reference that lies near both.
  bool apply(AnimationBuffer& buffer) const override;

 private:
  void carry(const FrameState& state, int frame, std::span<double> scratch,
             std::span<double> channels) const;

  const GaitBlend& blend_;
  const CapturedTurns& turns_;
  const std::vector<Eigen::Quaterniond>& reference_;
  Eigen::VectorXd stand_;
  double lead_;
};

}  // namespace amble
