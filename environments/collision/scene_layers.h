/// A scene as a body meets it: obstacles, and the ground apart from them (DESIGN.md, section 3).
///
/// Three sets. Obstacles: everything without ground. The ground layer: ground, and what lies below
/// its surface with it, such as risers. Banks: the rest of the pieces that ground is part of, such
/// as the side of a stair or the wall of a house that is one mesh with its floor; where they meet
/// the ground soles may be as deep in their edges as in the ground's.
#pragma once

#include <optional>

#include "environments/collision/clearance_field.h"
#include "environments/collision/ground_layer.h"
#include "environments/collision/obstacle_set.h"
#include "environments/ground/scene_ground.h"
#include "environments/scene/scene.h"

namespace amble {

class SceneLayers {
 public:
  /// @throws Stopped if that is asked for.
  SceneLayers(const Scene& scene, const SceneGround& ground, const StopRequest& stop = {},
              Checker checker = Checker::kFast);

  /// An object that the capsule touches or lies in, the ground left out; -1 for none.
  /// @param depth  by which it may sink into banks from above: that of the ground [m, >= 0]
  /// @param after  objects of no larger number are left out
  int touchedObstacle(const Capsule& capsule, double depth, ObstacleSet::Scratch& scratch,
                      int after = -1) const;
  /// The obstacle or bank nearer than `limit`, if there is one [m]. Banks are left out for soles,
  /// which stand on what they are part of.
  ObstacleSet::Nearest nearestObstacle(const Capsule& capsule, double limit, bool is_sole,
                                       ObstacleSet::Scratch& scratch) const;
  /// True only if the capsule touches no obstacle, nor would it higher by up to `depth` [m, >= 0];
  /// false says nothing. Cost: some nanoseconds.
  bool isFree(const Capsule& capsule, double depth) const {
    return empty_ || field_->isFree(capsule.inflated(depth));
  }
  const GroundLayer& ground() const { return *ground_; }

 private:
  struct Split;

  // Each is there once it is made; some are made at the same time.
  std::optional<ObstacleSet> obstacles_, banks_;
  bool empty_ = false;  // of obstacles and banks
  std::optional<GroundLayer> ground_;
  std::optional<ClearanceField> field_;
};

}  // namespace amble
