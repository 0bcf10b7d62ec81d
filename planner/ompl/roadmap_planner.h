/// Our roadmaps as planners of OMPL.
#pragma once

#include <memory>

#include "planner/ompl/ompl_query.h"
#include "planner/roadmap/sampled_roadmap.h"

namespace amble {

/// A planner that owns its graph and the graph's edges. Several queries may be solved one after
/// another, the roadmap is kept between them; `clear` empties it. It draws the space's samples and
/// asks the space's steering, on limits.threads threads and by the space's seed; a solution's edges
/// are those of the graph, which the space's motion validator is told of.
OmplPlannerPtr makeRoadmapPlanner(const OmplSpacePtr& space,
                                  std::unique_ptr<SampledRoadmap> roadmap,
                                  const SearchLimits& limits);

/// The roadmap of such a planner, or null.
const SampledRoadmap* roadmapOf(const ompl::base::Planner& planner);

}  // namespace amble
