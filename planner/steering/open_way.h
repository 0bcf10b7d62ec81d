/// Whether there is room all the way from one place to another for an upright post, for sure: a
/// coarse flood over squares of the plane, the nearest to the goal first, that ends as soon as the
/// goal is reached. It answers yes at once where a proof of no would be looked for in vain.
#pragma once

#include <Eigen/Geometry>
#include <functional>

#include "environments/collision/collision_world.h"
#include "environments/ground/scene_ground.h"
#include "planner/steering/ground_reach.h"
#include "planner/steering/near_ground.h"

namespace amble {

struct UprightPost {
  double low = 0.0, high = 0.0;  ///< over the lowest and over the highest ground around [m]
  double around = 0.0;           ///< so far to each side that is looked for [m, > 0]
  double radius = 0.0;           ///< [m, > 0]
  double aside = 0.0;            ///< from either end it may begin and end so far [m, >= 0]
};

/// Over squares, near the ground, in all of which the post touches nothing. No says nothing. Cost:
/// some hundred nanoseconds a square.
/// @param from, to  [m, World]; @param square  side [m, > 0]
/// @param stopped  asked now and then; where it says so the answer is no
bool isOpenWay(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const UprightPost& post,
               double square, const CollisionWorld& world, const SceneGround& ground,
               const ReachedGround& reached, const NearGround& near, CollisionScratch& scratch,
               const std::function<bool()>& stopped);

}  // namespace amble
