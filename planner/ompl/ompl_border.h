/// OMPL's side of the planner: our state space of stances, our roadmaps as `ompl::base::Planner`,
/// and OMPL's own RRT.
///
/// The space says that it is neither a metric nor symmetric, in distance and in interpolation, and
/// that a motion is one segment: only steering knows what lies between two stances, and it walks
/// one way. So planners of OMPL that connect states both ways by one check (PRM, SPARS, RRTConnect,
/// ...) must not be used in it; those that grow one tree forward from the start may. OMPL's types
/// are only named here: whoever calls their members includes OMPL.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

#include "planner/roadmap/sampled_roadmap.h"

namespace ompl::base {
class Planner;
class SpaceInformation;
}  // namespace ompl::base

namespace amble {

using OmplPlannerPtr = std::shared_ptr<ompl::base::Planner>;
using OmplSpacePtr = std::shared_ptr<ompl::base::SpaceInformation>;

/// Space, validity of states (`stand`), validity of motions (`steer`), sampler (StanceSampler, by
/// index from 0).
/// @pre steering outlives it.
OmplSpacePtr makeWalkSpace(const Steering& steering, const Eigen::AlignedBox2d& bounds,
                           std::uint64_t seed);

/// A roadmap as a planner: several queries may be solved one after another, the roadmap is kept
/// between them.
/// @pre roadmap and limits outlive it.
OmplPlannerPtr makeRoadmapPlanner(const OmplSpacePtr& space, SampledRoadmap& roadmap,
                                  const SearchLimits& limits);

/// `ompl::geometric::RRT`, its generator seeded. It grows forward from the start, as walks do.
/// @param range  longest edge [m, > 0]
OmplPlannerPtr makeRrtPlanner(const OmplSpacePtr& space, std::uint64_t seed, double range = 2.5);

/// What a tree-growing planner asked its space, so far.
struct OmplEffort {
  long long samples = 0;
  SteeringCount steering;
  std::vector<SteeringFailure> refused;
};
OmplEffort effortOf(const OmplSpacePtr& space);

/// Waypoints of the walk that the planner finds, ends included, or none. Stops at limits.stopped(),
/// or after `max_samples` of the space's sampler [> 0]. The planner is asked anew: what a former
/// query left in it is cleared, a roadmap is kept.
std::optional<std::vector<Waypoint>> solveWith(ompl::base::Planner& planner, const Waypoint& from,
                                               const Waypoint& to, const SearchLimits& limits,
                                               long long max_samples);

}  // namespace amble
