#include "planner/legs/ompl_legs.h"

#include <ompl/base/Planner.h>

#include <utility>

#include "base/stopwatch.h"
#include "planner/ompl/roadmap_planner.h"
#include "planner/why/obstruction.h"

namespace amble {
namespace {

// A tree draws many samples for each that a roadmap's failures count: it ends after so many times
// max_failures. A roadmap counts its own.
constexpr int kTreeSamplesPerFailure = 4;

class OmplLegs : public LegPlanner {
 public:
  OmplLegs(const PlanRequest& request, const SearchLimits& limits, OmplSpacePtr space,
           OmplPlannerPtr planner)
      : request_(request),
        limits_(limits),
        space_(std::move(space)),
        planner_(std::move(planner)),
        roadmap_(roadmapOf(*planner_)) {}

  std::optional<std::vector<WalkEdge>> solve(const Waypoint& from, const Waypoint& to) override {
    from_ = from;
    to_ = to;
    const Stopwatch watch;
    beginLeg();
    const long long samples = static_cast<long long>(kTreeSamplesPerFailure) * limits_.max_failures;
    auto edges = solveWith(*planner_, from, to, limits_, samples);
    seconds_ += watch.seconds();
    return edges;
  }
  std::optional<Obstruction> why() const override {
    if (roadmap_ && roadmap_->shutOff()) return whatShutsOff(*roadmap_->shutOff(), request_);
    if (!roadmap_) return whatStoodInTheWay(failuresOf(effortOf(*space_).refused), request_);
    return whatStoodInTheWay(inTheWay(*roadmap_, from_, to_), request_, roadmap_->narrow());
  }
  std::vector<const RefusedEdge*> refused() const override {
    return roadmap_ ? pointersTo(roadmap_->refused()) : pointersTo(effortOf(*space_).refused);
  }
  void describe(PlanOutcome& outcome) const override {
    const SpaceEffort& effort = effortOf(*space_);
    outcome.samples += effort.samples + earlier_samples_;
    describeCount(effort.steering, outcome);
    describeCount(earlier_, outcome);
    if (roadmap_) describeRoadmap(*roadmap_, outcome);
    if (roadmap_) describeCount(roadmap_->steering(), outcome);
    outcome.times.roadmap += seconds_;
  }

 private:
  // A leg's walk does not depend on what the legs before it met: each has a roadmap or tree of its
  // own, and refusals of its own.
  void beginLeg() {
    effortOf(*space_).refused.clear();
    if (!roadmap_) return;
    earlier_.add(roadmap_->steering());
    earlier_samples_ += roadmap_->samples();
    planner_->clear();
  }

  const PlanRequest& request_;
  const SearchLimits& limits_;
  OmplSpacePtr space_;
  OmplPlannerPtr planner_;
  const SampledRoadmap* roadmap_;  // of planner_, where it has one
  Waypoint from_, to_;
  SteeringCount earlier_;  // of roadmaps of legs before
  long long earlier_samples_ = 0;
  double seconds_ = 0.0;
};

}  // namespace

LegPlannerPtr makeOmplLegs(const PlanRequest& request, const SearchLimits& limits,
                           OmplSpacePtr space, OmplPlannerPtr planner) {
  return std::make_unique<OmplLegs>(request, limits, std::move(space), std::move(planner));
}

}  // namespace amble
