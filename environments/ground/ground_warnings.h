/// What looks like a floor or a stair and is none.
#pragma once

#include <string>
#include <vector>

#include "environments/ground/scene_ground.h"

namespace amble {

/// A line for each object of role `auto` with an open sheet, as large as a floor is, that faces
/// down and under which there is nothing to stand on: a floor that is wound the wrong way. Ceilings
/// face down, too, and have a floor under them. And a line where steps that the character takes
/// singly follow one another in a flight that walks do not climb, at the highest of them.
std::vector<std::string> groundWarnings(const Scene& scene, const SceneGround& ground);

/// All that a scene is warned of: what was noticed when it was read, and of its ground.
std::vector<std::string> sceneWarnings(const Scene& scene, const SceneGround& ground);

}  // namespace amble
