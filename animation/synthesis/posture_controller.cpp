#include "animation/synthesis/posture_controller.h"

#include "animation/synthesis/action.h"

namespace amble {

PostureController::PostureController(const MotionLibrary& library, const Motion& motion)
    : posture_(motion.posture), joints_(movedJoints(library, motion)) {}

bool PostureController::apply(AnimationBuffer& buffer) const {
  for (int i = 0; i < buffer.size(); ++i) {
    for (const int j : joints_) buffer.poses.rotations(i)[j] = posture_.rotations[j];
  }
  return true;
}

}  // namespace amble
