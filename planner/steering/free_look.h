/// Whether there is so much room along a way that a walk by it is there, nearly for sure, without
/// the walk being made (Steering::looksFree).
///
/// The way bends gently, posts along it that are somewhat thicker than the walking body touch
/// nothing, and the ground goes on level as far to its sides as feet are. Steps, edges and what is
/// over or under the ground there are for steering to say. Cost: some microseconds a metre.
#pragma once

#include "animation/synthesis/walk_synthesizer.h"
#include "environments/collision/collision_world.h"
#include "planner/steering/steering.h"

namespace amble {

class FreeLook {
 public:
  /// @param half_breadth  of the walking body, from its path [m, > 0] @pre all outlive it
  FreeLook(const WalkSynthesizer& synthesizer, const CollisionWorld& world,
           const SceneGround& ground, double half_breadth)
      : synthesizer_(synthesizer), world_(world), ground_(ground), half_breadth_(half_breadth) {}

  /// Of the root path of an edge. @pre it has one
  bool isFree(const WalkEdge& edge, CollisionScratch& scratch) const;

 private:
  bool isLevelAround(const Eigen::Vector3d& p) const;

  const WalkSynthesizer& synthesizer_;
  const CollisionWorld& world_;
  const SceneGround& ground_;
  double half_breadth_;
};

}  // namespace amble
