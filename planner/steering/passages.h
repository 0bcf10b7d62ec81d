/// Where ground leads up: stairs, ramps and kerbs, as straight lines from level to level.
///
/// Narrow passages of a roadmap: a flight is crossed straight, from a place before it to one beyond
/// it, and hardly two random stances lie so. They are found from the ground itself. From places
/// where it is not level the way is followed uphill, against the faces of the risers or along the
/// slope, step by step as far as steps lead, and then downhill, until it is level again for some
/// way: there a person can stand, on a landing in its middle. Of lines side by side, of which a
/// flight has many and a kerb more, three are kept. Stairs that wind have no such line: what leads
/// up them is left to the samples.
#pragma once

#include <vector>

#include "environments/ground/scene_ground.h"

namespace amble {

struct Passage {
  Eigen::Vector3d low, high;  ///< on level ground before and beyond [m, World]
  double heading = 0.0;       ///< from low to high [rad]
};

/// The same for the same ground, lowest first.
std::vector<Passage> findPassages(const SceneGround& ground);

}  // namespace amble
