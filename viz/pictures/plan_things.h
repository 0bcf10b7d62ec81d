/// What a plan view draws of a scene: its things, cut at a few heights and seen from above.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "environments/scene/scene.h"
#include "viz/pictures/outline.h"

namespace amble {

inline constexpr double kFloorDepth = 0.03;  ///< tops this close to the floor are floor or rug [m]

/// Objects of one name are one thing; a file that holds a whole flat is a thing a part.
struct PlanThing {
  std::string name;
  std::vector<Outline> floor;  ///< within kFloorDepth of the floor
  std::vector<Outline> body;   ///< what a body can touch: from 0.05 to 1.8 m over the floor
  std::vector<Outline> hips;   ///< where hips and hands are: from 0.5 to 1.2 m over the floor
  Eigen::AlignedBox2d box;     ///< of `body` [m]
  double top = 0;              ///< highest point over the floor [m, >= 0]
};

/// @param floor  height of the floor [m, World z]
std::vector<PlanThing> cutScene(const Scene& scene, double floor);

}  // namespace amble
