/// Stances as a state space of OMPL, with the sampler, the validity of states and the validity of
/// motions that every planner uses.
///
/// The space says that it is neither a metric nor symmetric, in distance and in interpolation, and
/// that a motion is one segment: only steering knows what lies between two stances, and it walks
/// one way. So planners that connect states both ways by one check (PRM, SPARS, RRTConnect, ...)
/// must not be used in it; those that grow one tree forward from the start may (legs/planners.cpp
/// has them). A state carries a waypoint and the number of its place, which copies keep and every
/// new waypoint gets anew: edges that the motion validator found are kept by these numbers, so that
/// each is steered once and the walk along a solution is there. OMPL's types are only named here:
/// whoever calls their members includes OMPL.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <vector>

#include "planner/roadmap/stance_sampler.h"
#include "planner/steering/edge_memory.h"

namespace ompl::base {
class SpaceInformation;
class State;
}  // namespace ompl::base

namespace amble {

using OmplSpacePtr = std::shared_ptr<ompl::base::SpaceInformation>;

/// States are valid by `stand`, motions by `steer`; samples come from StanceSampler, by index from
/// 0. @pre steering outlives it. Not for planners to share that run at the same time.
OmplSpacePtr makeWalkSpace(const Steering& steering, const Eigen::AlignedBox2d& bounds,
                           std::uint64_t seed);

/// What planners asked the space, since it was made or told to forget.
struct SpaceEffort {
  long long samples = 0;
  SteeringCount steering;
  std::vector<RefusedEdge> refused;
};
SpaceEffort& effortOf(const ompl::base::SpaceInformation& space);

/// Forgets effort and edges, and samples by another seed, from index 0.
void restart(const ompl::base::SpaceInformation& space, std::uint64_t seed);

/// Of its samples, and of planners that have no generator of their own.
std::uint64_t seedOf(const ompl::base::SpaceInformation& space);

const StanceSampler& samplerOf(const ompl::base::SpaceInformation& space);

const Waypoint& waypointOf(const ompl::base::State* state);
/// Puts a waypoint into a state, as a new place.
void setWaypoint(const ompl::base::SpaceInformation& space, const Waypoint& at,
                 ompl::base::State* state);

/// The answer for a motion; steering is asked where it is not known yet.
const SteerResult& motionOf(const ompl::base::SpaceInformation& space,
                            const ompl::base::State* from, const ompl::base::State* to);
/// Tells the space of an edge that a planner found by itself.
void learnEdge(const ompl::base::SpaceInformation& space, const ompl::base::State* from,
               const ompl::base::State* to, const WalkEdge& edge);

}  // namespace amble
