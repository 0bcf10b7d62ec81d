#include "animation/synthesis/movement_controller.h"

#include <array>

#include "base/rotation.h"

namespace amble {
namespace {

constexpr int kMostHarmonics = 12;  // of a library's cycles

}  // namespace

std::vector<int> movedJoints(const MotionLibrary& library, const Motion& motion) {
  std::vector<std::string> chains = motion.chains;
  if (chains.empty()) chains = {"trunk", "head", "left_arm", "right_arm"};
  std::vector<int> joints;
  for (const std::string& chain : chains) {
    const std::vector<int> some = chainJoints(library.skeleton, library.roles, chain);
    joints.insert(joints.end(), some.begin(), some.end());
  }
  return joints;
}

MovementController::MovementController(const MotionLibrary& library, const Motion& motion)
    : reference_(library.stand().rotations),
      series_(motion.cycle.series),
      joints_(movedJoints(library, motion)) {}

bool MovementController::apply(AnimationBuffer& buffer) const {
  std::array<double, 2 * kMostHarmonics + 2> basis;
  for (int i = 0; i < buffer.size(); ++i) {
    fourierBasis(buffer.states[i].phase, series_.harmonics(), basis.data());
    for (const int j : joints_) {
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
