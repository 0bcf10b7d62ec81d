/// A captured movement of some chains of joints, laid over the walk (Pettré §4.2): what its joints
/// do replaces what the walk's do, in step with it.
#pragma once

#include <vector>

#include "animation/library/motion_library.h"
#include "animation/synthesis/sub_controller.h"

namespace amble {

/// Its swing fades with FrameState::standing, as the walk's does, to the movement's mean pose: who
/// stands takes no steps that it could go with, and a standing stance's phase says nothing.
class MovementController : public SubController {
 public:
  /// @pre motion is a movement of the library, which outlives the controller
  MovementController(const MotionLibrary& library, const Motion& motion);

  /// Overwrites the rotations of its joints in every frame. Never refuses.
  bool apply(AnimationBuffer& buffer) const override;

 private:
  const std::vector<Eigen::Quaterniond>& reference_;
  const FourierSeries& series_;
  std::vector<int> joints_;
};

}  // namespace amble
