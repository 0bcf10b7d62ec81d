/// A pose that some chains of joints hold during the walk (Pettré §4.2).
#pragma once

#include <vector>

#include "animation/library/motion_library.h"
#include "animation/synthesis/sub_controller.h"

namespace amble {

class PostureController : public SubController {
 public:
  /// @pre motion is a posture of the library, which outlives the controller
  PostureController(const MotionLibrary& library, const Motion& motion);

  /// Overwrites the rotations of its joints in every frame; standing or walking, the pose is the
  /// same. Never refuses.
  bool apply(AnimationBuffer& buffer) const override;

 private:
  const Posture& posture_;
  std::vector<int> joints_;
};

}  // namespace amble
