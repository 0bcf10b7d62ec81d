/// A scene as a body meets it: obstacles, and the ground apart from them (DESIGN.md, section 3).
#pragma once

#include "environments/clearance_field.h"
#include "environments/ground_layer.h"
#include "environments/obstacle_set.h"
#include "environments/scene.h"
#include "environments/scene_ground.h"

namespace amble {

class SceneLayers {
 public:
  /// @pre ground outlives the layers.
  SceneLayers(const Scene& scene, const SceneGround& ground);

  /// An object that the capsule touches or lies in, the ground left out; -1 for none.
  int touchedObstacle(const Capsule& capsule, ObstacleSet::Scratch& scratch) const {
    return field_.isFree(capsule) ? -1 : obstacles_.touched(capsule, scratch);
  }
  /// The obstacle nearer than `limit`, if there is one [m].
  ObstacleSet::Nearest nearestObstacle(const Capsule& capsule, double limit,
                                       ObstacleSet::Scratch& scratch) const {
    if (field_.isFree(capsule.inflated(limit))) return {limit, -1};
    return obstacles_.nearest(capsule, limit, scratch);
  }
  const GroundLayer& ground() const { return ground_; }

 private:
  struct Split;
  SceneLayers(Split split, const SceneGround& ground);

  ObstacleSet obstacles_;
  GroundLayer ground_;
  ClearanceField field_;
};

}  // namespace amble
