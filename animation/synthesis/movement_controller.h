/// A captured movement of some chains of joints, laid over the walk (Pettré §4.2): what its joints
/// do replaces what the walk's do, in step with it.
#pragma once

#include <vector>

#include "animation/library/motion_library.h"
#include "animation/synthesis/sub_controller.h"

namespace amble {

class MovementController : public SubController {
 public:
  /// @pre motion is a movement of the library, which outlives the controller
  MovementController(const MotionLibrary& library, const Motion& motion);

  bool apply(AnimationBuffer& buffer) const override;

 private:
  const std::vector<Eigen::Quaterniond>& reference_;
  const FourierSeries& series_;
  std::vector<int> joints_;
};

/// The joints that a motion of these chains moves: without chains those of trunk, head and arms,
/// since the walk has the legs. @pre the motion is of the library
std::vector<int> movedJoints(const MotionLibrary& library, const Motion& motion);

}  // namespace amble
