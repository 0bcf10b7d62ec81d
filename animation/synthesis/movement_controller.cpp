#include "animation/synthesis/movement_controller.h"

#include "animation/synthesis/action.h"
#include "base/rotation.h"

namespace amble {

MovementController::MovementController(const MotionLibrary& library, const Motion& motion)
    : reference_(library.stand().rotations),
      series_(motion.cycle.series),
      joints_(movedJoints(library, motion)) {}

bool MovementController::apply(AnimationBuffer& buffer) const {
  std::vector<double> basis(2 * series_.harmonics() + 2);
  for (int i = 0; i < buffer.size(); ++i) {
    const FrameState& state = buffer.states[i];
    fourierBasis(state.phase, series_.harmonics(), basis.data());
    for (size_t k = 2; k < basis.size(); ++k) basis[k] *= 1.0 - state.standing;
    for (const int j : joints_) {
      // Pettré eq. 2.
      Eigen::Vector3d v = Eigen::Vector3d::Zero();
      for (int k = 0; k <= series_.harmonics(); ++k) {
        v += basis[2 * k] * series_.alpha.block<3, 1>(3 + 3 * j, k) +
             basis[2 * k + 1] * series_.beta.block<3, 1>(3 + 3 * j, k);
      }
      buffer.poses.rotations(i)[j] = reference_[j] * expRotation(v);
    }
  }
  return true;
}

}  // namespace amble
