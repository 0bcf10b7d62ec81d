/// Actions: movements and postures of the library that are laid over a whole walk (Pettré §4.2).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "animation/library/motion_library.h"
#include "animation/synthesis/sub_controller.h"

namespace amble {

/// The movement or posture of that name; null where the library has none that is always valid:
/// actions are held for the whole walk.
const Motion* findAction(const MotionLibrary& library, const std::string& name);
/// The names that findAction knows, in the library's order, each after a blank; " none" of none.
std::string listActions(const MotionLibrary& library);

/// What lays it over a walk. @pre the library outlives it. @throws std::invalid_argument where
/// findAction finds none
std::unique_ptr<const SubController> makeAction(const MotionLibrary& library,
                                                const std::string& name);

/// The joints that a motion of these chains moves: without chains those of trunk, head and arms,
/// since the walk has the legs. @pre the motion is of the library
std::vector<int> movedJoints(const MotionLibrary& library, const Motion& motion);

}  // namespace amble
