#include "planner/legs/planners.h"

#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/geometric/planners/sst/SST.h>

#include <algorithm>
#include <stdexcept>

#include "base/sample_stream.h"
#include "planner/legs/cylinder_legs.h"
#include "planner/legs/ompl_legs.h"
#include "planner/ompl/quiet_ompl.h"
#include "planner/ompl/roadmap_planner.h"
#include "planner/roadmap/nearest_roadmap.h"
#include "planner/roadmap/visibility_roadmap.h"

namespace amble {
namespace {

namespace og = ompl::geometric;

template <typename RoadmapKind>
OmplPlannerPtr roadmap(const OmplSpacePtr& space, const SearchLimits& limits) {
  return makeRoadmapPlanner(space, std::make_unique<RoadmapKind>(samplerOf(*space)), limits);
}

// With a generator of its own, which OMPL seeds from one that all share.
template <typename Tree>
class Seeded : public Tree {
 public:
  Seeded(const OmplSpacePtr& space, std::uint64_t seed) : Tree(space) {
    this->rng_.setLocalSeed(static_cast<std::uint_fast32_t>(SampleStream(seed, 0).bits() >> 33));
  }
};

using Parameters = std::map<std::string, std::string>;  // OMPL's names; lengths in metres

// One of OMPL's planners whose tree grows forward from the start. Checked by their sources (1.5):
// each motion is checked from the tree to the new state, and RRT*, with its collision checks
// delayed as they are unless told otherwise, rewires by the motion from the new state. (Not delayed
// it takes the way back for granted where the way there is free.)
template <typename Tree>
auto tree(Parameters parameters) {
  return [parameters](const OmplSpacePtr& space, const SearchLimits& limits) -> OmplPlannerPtr {
    const QuietOmpl quiet;
    const auto planner = std::make_shared<Seeded<Tree>>(space, limits.seed);
    planner->params().setParams(parameters);
    return planner;
  };
}

}  // namespace

const std::vector<PlannerEntry>& planners() {
  static const std::vector<PlannerEntry> all = {
      {"visibility",
       "visibility roadmap of directed edges (Simeon, Laumond, Nissoux 2000); every edge animated "
       "and checked",
       roadmap<VisibilityRoadmap>},
      {"prm", "directed k-nearest roadmap on the same steering; max_failures counts its samples",
       roadmap<NearestRoadmap>},
      {"rrt", "OMPL's RRT on the same steering, grown forward; draws up to 4 max_failures samples",
       tree<og::RRT>({{"range", "2.5"}})},
      {"est", "OMPL's EST: the same, grown from where its tree is thin",
       tree<og::EST>({{"range", "2.5"}})},
      {"sst", "OMPL's SST: a sparse tree of short ways, which uses all of its samples",
       tree<og::SST>({{"range", "2.5"}, {"selection_radius", "0.8"}, {"pruning_radius", "0.2"}})},
      {"rrtstar", "OMPL's RRT*: the same by rewiring, which uses all of its samples",
       tree<og::RRTstar>({{"range", "2.5"}})},
      {"cylinder",
       "plans for the body's bounding cylinder, then animates the path; a contact has it tried "
       "again",
       nullptr},
  };
  return all;
}

const PlannerEntry& findPlanner(const std::string& name) {
  const auto found = std::find_if(planners().begin(), planners().end(),
                                  [&](const PlannerEntry& entry) { return entry.name == name; });
  if (found == planners().end()) throw std::invalid_argument("unknown planner: " + name);
  return *found;
}

LegPlannerPtr makeLegPlanner(const PlanRequest& request, const WalkSteering& steering,
                             const SearchLimits& limits) {
  const PlannerEntry& entry = findPlanner(request.planner);
  if (!entry.make) return makeCylinderLegs(request, steering, limits);
  const OmplSpacePtr space = makeWalkSpace(steering, request.bounds, limits.seed);
  return makeOmplLegs(request, limits, space, entry.make(space, limits));
}

}  // namespace amble
