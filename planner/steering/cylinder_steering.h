/// Steering for the planner `cylinder`, which is there to compare with: what plans for a body's
/// bounding cylinder instead of the body (Kuffner, "Goal-directed navigation for animated
/// characters using real-time path planning and control", CAPTECH 1998).
///
/// Edges are straight lines on level ground, any heading will do; slopes and steps stop it. The
/// cylinder holds the body in every frame of a straight walk: its axis goes through the root path's
/// point, its radius is the farthest that any capsule reaches from there, its height the stature. A
/// capsule inside the cylinder, of the same radius and height, stands for it: what stops the
/// capsule stops the cylinder.
#pragma once

#include "environments/collision/collision_world.h"
#include "planner/steering/steering.h"
#include "planner/steering/straight_walk.h"

namespace amble {

/// Farthest horizontal distance of the body from the root path's point, over a walk; 0 for one
/// without frames [m].
double boundingRadius(const StraightWalk& walk, const Skeleton& skeleton, const Body& body);

class CylinderSteering : public Steering {
 public:
  struct Settings {
    double radius = 0.4;  ///< [m, > 0]
    double height = 1.7;  ///< [m, > 2 radius + 0.05]
    double speed = 1.2;   ///< [m/s, > 0]
  };

  /// @pre scene and ground outlive the steering.
  CylinderSteering(const Scene& scene, const SceneGround& ground, const Settings& settings);

  SteeringScratchPtr makeScratch() const override;
  std::optional<SteeringFailure> stand(Stance& stance, SteeringScratch& scratch) const override;
  bool place(Stance& stance) const override;
  SteerResult steer(const Waypoint& from, const Waypoint& to,
                    SteeringScratch& scratch) const override;
  double topSpeed() const override { return settings_.speed; }

 private:
  const SceneGround& ground_;
  Settings settings_;
  CollisionWorld world_;
};

}  // namespace amble
