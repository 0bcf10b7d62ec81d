#include "planner/legs/kept_legs.h"

#include "base/stopwatch.h"
#include "planner/legs/planners.h"

namespace amble {
namespace {

class KeptLegs : public LegPlanner {
 public:
  KeptLegs(const PlanRequest& request, const WalkSteering& steering, const KeptSearch& kept)
      : request_(request), steering_(steering), kept_(kept), scratch_(steering.makeScratch()) {}

  std::optional<std::vector<WalkEdge>> solve(const Waypoint& from, const Waypoint& to) override {
    const Stopwatch watch;
    auto edges = kept_.walk(from, to, request_.limits, *scratch_, count_);
    seconds_ += watch.seconds();
    if (edges) return edges;
    if (!anew_) anew_ = makeLegPlanner(request_, steering_, request_.limits);
    return anew_->solve(from, to);
  }
  std::optional<Obstruction> why() const override { return anew_ ? anew_->why() : std::nullopt; }
  std::vector<const RefusedEdge*> refused() const override {
    return anew_ ? anew_->refused() : std::vector<const RefusedEdge*>{};
  }
  void describe(PlanOutcome& outcome) const override {
    if (anew_) {
      anew_->describe(outcome);
    } else {
      const KeptRoadmap& roadmap = kept_.roadmap();
      outcome.guards = roadmap.count(NodeKind::kGuard);
      outcome.connectors = roadmap.count(NodeKind::kConnector);
      outcome.edges = static_cast<int>(roadmap.edges.size());
      outcome.samples = roadmap.samples;
      outcome.coverage = roadmap.coverage;
    }
    describeCount(count_, outcome);
    outcome.times.search += seconds_;
  }

 private:
  const PlanRequest& request_;
  const WalkSteering& steering_;
  const KeptSearch& kept_;
  const SteeringScratchPtr scratch_;
  LegPlannerPtr anew_;  // for what the roadmap does not know
  SteeringCount count_;
  double seconds_ = 0.0;
};

}  // namespace

LegPlannerPtr makeKeptLegs(const PlanRequest& request, const WalkSteering& steering,
                           const KeptSearch& kept) {
  return std::make_unique<KeptLegs>(request, steering, kept);
}

}  // namespace amble
