#include "animation/synthesis/action.h"

#include <stdexcept>

#include "animation/synthesis/movement_controller.h"
#include "animation/synthesis/posture_controller.h"

namespace amble {
namespace {

bool isAction(const Motion& motion) {
  return (motion.kind == MotionKind::kMovement || motion.kind == MotionKind::kPosture) &&
         motion.valid.when == Validity::When::kAlways;
}

}  // namespace

const Motion* findAction(const MotionLibrary& library, const std::string& name) {
  const Motion* motion = library.find(name);
  return motion != nullptr && isAction(*motion) ? motion : nullptr;
}

std::string listActions(const MotionLibrary& library) {
  std::string names;
  for (const Motion& motion : library.motions) {
    if (isAction(motion)) names += " " + motion.name;
  }
  return names.empty() ? " none" : names;
}

std::unique_ptr<const SubController> makeAction(const MotionLibrary& library,
                                                const std::string& name) {
  const Motion* motion = findAction(library, name);
  if (motion == nullptr) {
    throw std::invalid_argument("the library has no movement or posture " + name +
                                " that is always valid");
  }
  if (motion->kind == MotionKind::kMovement)
    return std::make_unique<MovementController>(library, *motion);
  return std::make_unique<PostureController>(library, *motion);
}

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

}  // namespace amble
