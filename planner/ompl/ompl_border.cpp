#include "planner/ompl/ompl_border.h"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/Planner.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateSampler.h>
#include <ompl/base/StateSpace.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/datastructures/NearestNeighborsLinear.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/util/Console.h>

#include <cmath>

#include "base/rotation.h"

namespace amble {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

// How much nearer a stance is that needs no turn: metres that are walked while the body turns by a
// radian, roughly [m/rad].
constexpr double kTurnWeight = 0.3;

class WalkState : public ob::State {
 public:
  Waypoint at;
};

const Waypoint& waypoint(const ob::State* state) {
  return static_cast<const WalkState*>(state)->at;
}
Waypoint& waypoint(ob::State* state) { return static_cast<WalkState*>(state)->at; }

double distanceBetween(const Waypoint& a, const Waypoint& b) {
  return (a.stance.position - b.stance.position).norm();
}

class WalkSampler : public ob::StateSampler {
 public:
  WalkSampler(const ob::StateSpace* space, const Steering& steering,
              const Eigen::AlignedBox2d& bounds, std::uint64_t seed, OmplEffort& effort)
      : StateSampler(space),
        steering_(steering),
        sampler_(steering, bounds),
        scratch_(steering.makeScratch()),
        seed_(seed),
        effort_(effort) {}

  // Where no try is free the state stays as it is, and costs one more refusal.
  void sampleUniform(ob::State* state) override {
    if (const auto sample = sampler_.draw(seed_, effort_.samples++, *scratch_))
      waypoint(state) = {sample->stance};
  }
  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    SampleStream stream(seed_, (1ULL << 50) + effort_.samples++);
    const double angle = stream.uniform(-kPi, kPi), radius = distance * std::sqrt(stream.uniform());
    waypoint(state) = waypoint(near);
    waypoint(state).stance.position +=
        radius * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
    steering_.place(waypoint(state).stance);
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
    sampleUniformNear(state, mean, 2.0 * deviation);
  }

 private:
  const Steering& steering_;
  StanceSampler sampler_;
  SteeringScratchPtr scratch_;
  std::uint64_t seed_;
  OmplEffort& effort_;
};

class WalkSpace : public ob::StateSpace {
 public:
  WalkSpace(const Steering& steering, const Eigen::AlignedBox2d& bounds, std::uint64_t seed)
      : steering_(steering), bounds_(bounds), seed_(seed) {
    setName("Amble stances");
    type_ = ob::STATE_SPACE_UNKNOWN;
  }

  bool isMetricSpace() const override { return false; }
  bool hasSymmetricDistance() const override { return false; }
  bool hasSymmetricInterpolate() const override { return false; }
  unsigned int validSegmentCount(const ob::State*, const ob::State*) const override { return 1; }
  unsigned int getDimension() const override { return 3; }
  double getMaximumExtent() const override { return bounds_.diagonal().norm() + kTurnWeight * kPi; }
  double getMeasure() const override { return bounds_.volume() * 2.0 * kPi; }

  void enforceBounds(ob::State* state) const override {
    Eigen::Vector3d& position = waypoint(state).stance.position;
    position.head<2>() = position.head<2>().cwiseMax(bounds_.min()).cwiseMin(bounds_.max()).eval();
  }
  bool satisfiesBounds(const ob::State* state) const override {
    return bounds_.contains(waypoint(state).stance.position.head<2>());
  }
  void copyState(ob::State* to, const ob::State* from) const override {
    waypoint(to) = waypoint(from);
  }
  bool equalStates(const ob::State* a, const ob::State* b) const override {
    return distance(a, b) == 0.0;
  }

  double distance(const ob::State* from, const ob::State* to) const override {
    const Waypoint &a = waypoint(from), &b = waypoint(to);
    const bool free = a.any_heading || b.any_heading;
    return distanceBetween(a, b) +
           (free ? 0.0 : kTurnWeight * std::abs(wrapAngle(b.stance.heading - a.stance.heading)));
  }

  // A stance on the straight line, headed along it: the way one walks from `from` to `to`, not
  // back.
  void interpolate(const ob::State* from, const ob::State* to, double t,
                   ob::State* state) const override {
    const Waypoint a = waypoint(from), b = waypoint(to);
    Waypoint& out = waypoint(state);
    out = t < 0.5 ? a : b;
    if (t <= 0.0 || t >= 1.0) return;
    const Eigen::Vector3d way = b.stance.position - a.stance.position;
    out = Waypoint{};
    out.stance.position = a.stance.position + t * way;
    out.stance.heading = std::atan2(way.y(), way.x());
    steering_.place(out.stance);
  }

  ob::StateSamplerPtr allocDefaultStateSampler() const override {
    return std::make_shared<WalkSampler>(this, steering_, bounds_, seed_, effort_);
  }
  ob::State* allocState() const override { return new WalkState; }
  void freeState(ob::State* state) const override { delete static_cast<WalkState*>(state); }

  const Steering& steering() const { return steering_; }
  OmplEffort& effort() const { return effort_; }

 private:
  const Steering& steering_;
  Eigen::AlignedBox2d bounds_;
  std::uint64_t seed_;
  mutable OmplEffort effort_;  // OMPL asks const objects; a planner of ours asks from one thread
};

const WalkSpace& walkSpace(const ob::SpaceInformation& space) {
  return static_cast<const WalkSpace&>(*space.getStateSpace());
}

class StandChecker : public ob::StateValidityChecker {
 public:
  explicit StandChecker(ob::SpaceInformation* space)
      : StateValidityChecker(space), scratch_(walkSpace(*space).steering().makeScratch()) {}
  bool isValid(const ob::State* state) const override {
    Stance stance = waypoint(state).stance;
    return !walkSpace(*si_).steering().stand(stance, *scratch_);
  }

 private:
  SteeringScratchPtr scratch_;
};

class WalkValidator : public ob::MotionValidator {
 public:
  explicit WalkValidator(ob::SpaceInformation* space)
      : MotionValidator(space), scratch_(walkSpace(*space).steering().makeScratch()) {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    const SteerResult result =
        walkSpace(*si_).steering().steer(waypoint(from), waypoint(to), *scratch_);
    OmplEffort& effort = walkSpace(*si_).effort();
    effort.steering.add(result);
    if (!result.edge) effort.refused.push_back(result.failure);
    result.edge ? ++valid_ : ++invalid_;
    return result.edge.has_value();
  }
  // An edge is valid whole or not at all: of a refused one the last valid state is its begin.
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last) const override {
    if (checkMotion(from, to)) return true;
    if (last.first) si_->copyState(last.first, from);
    last.second = 0.0;
    return false;
  }

 private:
  SteeringScratchPtr scratch_;
};

class RoadmapPlanner : public ob::Planner {
 public:
  RoadmapPlanner(const OmplSpacePtr& space, SampledRoadmap& roadmap, const SearchLimits& limits)
      : Planner(space, "Amble roadmap"), roadmap_(roadmap), limits_(limits) {
    specs_.directed = true;
    specs_.multithreaded = true;
    specs_.recognizedGoal = ob::GOAL_STATE;
  }

  ob::PlannerStatus solve(const ob::PlannerTerminationCondition& ptc) override;
  void clear() override {
    Planner::clear();
    roadmap_.clear();
  }
  void getPlannerData(ob::PlannerData& data) const override;

 private:
  int insert(const ob::State* state, bool start) {
    const Waypoint& at = waypoint(state);
    const bool both_ways = at.stance.standing && !at.any_heading;
    return roadmap_.insert(at, both_ways || !start, both_ways || start);
  }

  SampledRoadmap& roadmap_;
  const SearchLimits& limits_;
};

ob::PlannerStatus RoadmapPlanner::solve(const ob::PlannerTerminationCondition& ptc) {
  checkValidity();
  const ob::State* start = pis_.nextStart();
  const ob::State* goal = pis_.nextGoal();
  if (!start) return ob::PlannerStatus::INVALID_START;
  if (!goal) return ob::PlannerStatus::INVALID_GOAL;
  const int from = insert(start, true), to = insert(goal, false);
  if (!ptc && !roadmap_.connect(from, to, limits_)) return ob::PlannerStatus::TIMEOUT;
  const auto edges = roadmap_.roadmap().shortestPath(from, to);
  if (!edges) return ob::PlannerStatus::TIMEOUT;
  const auto path = std::make_shared<og::PathGeometric>(si_);
  const auto append = [&](int node) {
    WalkState state;
    state.at = roadmap_.roadmap().nodes()[node].at;
    path->append(&state);
  };
  append(from);
  for (const int edge : *edges) append(roadmap_.roadmap().edges()[edge].to);
  pdef_->addSolutionPath(path, false, 0.0, getName());
  return ob::PlannerStatus::EXACT_SOLUTION;
}

void RoadmapPlanner::getPlannerData(ob::PlannerData& data) const {
  Planner::getPlannerData(data);
  std::vector<WalkState> states(roadmap_.roadmap().nodes().size());
  std::vector<unsigned int> vertex;
  for (size_t i = 0; i < states.size(); ++i) {
    states[i].at = roadmap_.roadmap().nodes()[i].at;
    vertex.push_back(data.addVertex(ob::PlannerDataVertex(&states[i])));
  }
  for (const RoadmapEdge& edge : roadmap_.roadmap().edges())
    data.addEdge(vertex[edge.from], vertex[edge.to]);
  data.decoupleFromPlanner();  // it has copies of the states then
}

class SeededRrt : public og::RRT {
 public:
  SeededRrt(const OmplSpacePtr& space, std::uint64_t seed) : RRT(space) {
    rng_.setLocalSeed(static_cast<std::uint_fast32_t>(SampleStream(seed, 0).bits() >> 33));
  }
};

// OMPL logs to the console: its words are not ours.
class QuietOmpl {
 public:
  QuietOmpl() : level_(ompl::msg::getLogLevel()) { ompl::msg::setLogLevel(ompl::msg::LOG_NONE); }
  ~QuietOmpl() { ompl::msg::setLogLevel(level_); }

 private:
  ompl::msg::LogLevel level_;
};

}  // namespace

OmplSpacePtr makeWalkSpace(const Steering& steering, const Eigen::AlignedBox2d& bounds,
                           std::uint64_t seed) {
  const QuietOmpl quiet;
  const auto space =
      std::make_shared<ob::SpaceInformation>(std::make_shared<WalkSpace>(steering, bounds, seed));
  space->setStateValidityChecker(std::make_shared<StandChecker>(space.get()));
  space->setMotionValidator(std::make_shared<WalkValidator>(space.get()));
  space->setup();
  return space;
}

OmplPlannerPtr makeRoadmapPlanner(const OmplSpacePtr& space, SampledRoadmap& roadmap,
                                  const SearchLimits& limits) {
  return std::make_shared<RoadmapPlanner>(space, roadmap, limits);
}

OmplPlannerPtr makeRrtPlanner(const OmplSpacePtr& space, std::uint64_t seed, double range) {
  const QuietOmpl quiet;
  const auto planner = std::make_shared<SeededRrt>(space, seed);
  planner->setRange(range);
  planner->setNearestNeighbors<ompl::NearestNeighborsLinear>();
  return planner;
}

OmplEffort effortOf(const OmplSpacePtr& space) { return walkSpace(*space).effort(); }

std::optional<std::vector<Waypoint>> solveWith(ob::Planner& planner, const Waypoint& from,
                                               const Waypoint& to, const SearchLimits& limits,
                                               long long max_samples) {
  const QuietOmpl quiet;
  const auto space = planner.getSpaceInformation();
  WalkState start, goal;
  start.at = from;
  goal.at = to;
  const auto problem = std::make_shared<ob::ProblemDefinition>(space);
  problem->addStartState(&start);
  const auto goal_state = std::make_shared<ob::GoalState>(space);
  goal_state->setState(&goal);
  problem->setGoal(goal_state);
  dynamic_cast<RoadmapPlanner*>(&planner) ? planner.clearQuery() : planner.clear();
  planner.setProblemDefinition(problem);
  if (!planner.isSetup()) planner.setup();
  const OmplEffort& effort = walkSpace(*space).effort();
  const long long last = effort.samples + max_samples;
  planner.solve(
      ob::PlannerTerminationCondition([&] { return limits.stopped() || effort.samples >= last; }));
  if (!problem->hasExactSolution()) return std::nullopt;
  const auto path = std::static_pointer_cast<og::PathGeometric>(problem->getSolutionPath());
  std::vector<Waypoint> waypoints;
  for (const ob::State* state : path->getStates()) waypoints.push_back(waypoint(state));
  return waypoints;
}

}  // namespace amble
