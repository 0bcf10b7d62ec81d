#include "planner/legs/plan_run.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/parallel.h"
#include "base/rotation.h"
#include "base/stopwatch.h"
#include "planner/refine_walk.h"
#include "planner/steering/ground_reach.h"
#include "planner/steering/reached_region.h"
#include "planner/why/ground_profile.h"
#include "planner/why/obstruction.h"

namespace amble {
namespace {

constexpr int kHeadings = 16;  // tried where a place may be stood on by any heading

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

double headingFromTo(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return std::atan2(to.y() - from.y(), to.x() - from.x());
}

// The way of small steps.
RootPath straightLine(const WalkEdge& edge) {
  const double heading = headingFromTo(edge.from.position, edge.to.position);
  return RootPath({makeBezier(edge.from.position.head<2>(), heading, edge.to.position.head<2>(),
                              heading, 1.0 / 3.0)});
}

class Plan {
 public:
  Plan(const PlanRequest& request, const WalkSteering& steering, const LegPlannerMaker& make)
      : request_(widened(request)),
        steering_(steering),
        make_(make),
        scratch_(steering_.makeScratch()) {}

  PlanOutcome run();

 private:
  static PlanRequest widened(PlanRequest request);
  std::optional<SteeringFailure> settle(const PlanEnd& end, double likely_heading, Waypoint& at);
  bool isCovered(const Stance& end) const;
  bool settleEnds();
  std::optional<std::vector<WalkEdge>> walkLeg(LegPlanner& planner, const Waypoint& from,
                                               const Waypoint& to);
  std::optional<EdgePath> walkAllLegs();
  void finish(EdgePath path);
  void refuse(PlanStatus status, Obstruction why);
  bool groundLeads();
  std::optional<Obstruction> whyNot(const LegPlanner& planner) const;
  void tellReached();
  void addPath(const WalkEdge& edge, AnimationBuffer part);

  const PlanRequest request_;
  const WalkSteering& steering_;
  const LegPlannerMaker& make_;
  SteeringScratchPtr scratch_;
  std::vector<Waypoint> stops_;  // start, via points, goal
  size_t leg_ = 0;               // that is looked at: from that stop to the next
  PlanOutcome outcome_;
};

PlanRequest Plan::widened(PlanRequest request) {
  request.bounds.extend(request.start.position.head<2>().eval());
  request.bounds.extend(request.goal.position.head<2>().eval());
  for (const Eigen::Vector3d& via : request.via) request.bounds.extend(via.head<2>().eval());
  return request;
}

// The waypoint of an end, as it is asked for: standing or walking. Where its heading is free, one
// by which the body has room there, the likely one if it may.
std::optional<SteeringFailure> Plan::settle(const PlanEnd& end, double likely_heading,
                                            Waypoint& at) {
  at = {};
  at.stance.position = end.position;
  at.stance.standing = end.standing;
  at.any_heading = !end.heading;
  std::optional<SteeringFailure> first;
  for (int i = 0; i < (end.heading ? 1 : kHeadings); ++i) {
    at.stance.heading =
        end.heading ? *end.heading : wrapAngle(likely_heading + 2.0 * kPi * i / kHeadings);
    const auto failure = isCovered(at.stance) ? steering_.standHere(at.stance, *scratch_)
                                              : steering_.stand(at.stance, *scratch_);
    if (!failure) return std::nullopt;
    if (!first) first = failure;
  }
  return first;
}

// Whether the ground that the end is on lies in something on which there is other ground, as a
// large bed: it stays there, and is blocked by that.
bool Plan::isCovered(const Stance& end) const {
  Stance placed = end;
  return steering_.place(placed) &&
         placed.position.z() > end.position.z() + request_.ground->settings().limits.highestStep();
}

void Plan::refuse(PlanStatus status, Obstruction why) {
  outcome_.status = status;
  ++outcome_.refusals[why.rule];
  outcome_.why = std::move(why);
}

// Whether ground leads from stop to stop; said at once where it does not.
bool Plan::groundLeads() {
  const double step = longestStep(*request_.synthesizer);
  for (size_t i = 0; i + 1 < stops_.size(); ++i) {
    const auto gap =
        findGap(*request_.ground, stops_[i].stance.position, stops_[i + 1].stance.position, step);
    if (!gap) continue;
    leg_ = i;
    refuse(PlanStatus::kNoWalk, whatTheGroundLacks(*gap, request_));
    outcome_.proved = true;
    return false;
  }
  return true;
}

bool Plan::settleEnds() {
  std::vector<Eigen::Vector3d> places = {request_.start.position};
  places.insert(places.end(), request_.via.begin(), request_.via.end());
  places.push_back(request_.goal.position);
  const size_t last = places.size() - 1;
  stops_.resize(places.size());
  for (size_t i = 0; i <= last; ++i) {
    const double likely = headingFromTo(places[i == 0 ? 0 : i - 1], places[std::min(i + 1, last)]);
    const PlanEnd end = i == 0      ? request_.start
                        : i == last ? request_.goal
                                    : PlanEnd{places[i], {}, true};
    if (const auto failure = settle(end, likely, stops_[i])) {
      refuse(i == 0      ? PlanStatus::kStartBlocked
             : i == last ? PlanStatus::kGoalBlocked
                         : PlanStatus::kNoWalk,
             whatBlocks(*failure, stops_[i], request_, steering_));
      leg_ = i == 0 ? 0 : i - 1;
      if (i > 0 && i < last) outcome_.why->via = static_cast<int>(i) - 1;
      outcome_.proved = true;
      return false;
    }
    if (i > 0 && i < last)
      stops_[i].any_heading = false;  // legs must join: refinement walks on there if it can
  }
  return true;
}

// Places that are too near for a walk are joined by small steps.
std::optional<std::vector<WalkEdge>> Plan::walkLeg(LegPlanner& planner, const Waypoint& from,
                                                   const Waypoint& to) {
  if (from.stance.position != to.stance.position) {
    SteerResult beside = steering_.smallSteps(from, to, *scratch_);
    if (beside.edge) return std::vector<WalkEdge>{std::move(*beside.edge)};
  }
  return planner.solve(from, to);
}

std::optional<EdgePath> Plan::walkAllLegs() {
  const auto planner = make_(request_, steering_);
  EdgePath path;
  path.start = stops_.front();
  path.goal = stops_.back();
  path.pinned = {true};
  bool solved = true;
  for (size_t i = 0; solved && i + 1 < stops_.size(); ++i) {
    const auto leg = walkLeg(*planner, stops_[i], stops_[i + 1]);
    solved = leg.has_value();
    leg_ = i;
    if (!solved) break;
    path.edges.insert(path.edges.end(), leg->begin(), leg->end());
    path.pinned.resize(path.edges.size(), false);
    path.pinned.push_back(true);
  }
  planner->describe(outcome_);
  outcome_.time_limit_hit = !solved && request_.limits.timeIsUp();
  outcome_.stopped = !solved && request_.limits.stopped() && !outcome_.time_limit_hit;
  if (!solved) outcome_.why = whyNot(*planner);
  std::optional<Eigen::Vector3d> stopped_at;
  if (outcome_.why) {
    stopped_at = outcome_.why->at;
    addLeastOverlap(planner->refused(), steering_, request_.limits.threads, *outcome_.why);
  }
  describeRefused(planner->refused(), stopped_at, outcome_);
  if (!solved) return std::nullopt;
  return path;
}

// What cuts the ground in two says more than what refused most on the nearer side of it.
std::optional<Obstruction> Plan::whyNot(const LegPlanner& planner) const {
  if (!outcome_.proved && !request_.limits.stopped()) {
    std::vector<SteeringScratchPtr> scratches;
    for (int i = 0; i < request_.limits.threads; ++i) scratches.push_back(steering_.makeScratch());
    const auto shut = steering_.shutOffOnGround(
        stops_[leg_].stance.position, stops_[leg_ + 1].stance.position,
        [this] { return request_.limits.stopped(); }, scratches);
    if (shut) return whatShutsOff(*shut, request_);
  }
  return planner.why();
}

// How far one gets on the leg that is not walked.
void Plan::tellReached() {
  if (outcome_.status == PlanStatus::kStartBlocked || !outcome_.why) return;
  const auto room = steering_.map(
      request_.bounds, [&] { return request_.limits.stopped(); }, request_.limits.threads);
  if (!room) return;
  outcome_.reached = reachedRegion(*room, stops_[leg_].stance.position,
                                   stops_[leg_ + 1].stance.position, outcome_.why->at);
}

void Plan::addPath(const WalkEdge& edge, AnimationBuffer part) {
  if (outcome_.walk.buffer.size() == 0)
    outcome_.walk.buffer = std::move(part);
  else
    outcome_.walk.buffer.append(part);
  if (!edge.path.empty()) outcome_.walk.path.append(edge.path);
  if (edge.path.empty() && edge.length > 0.0) outcome_.walk.path.append(straightLine(edge));
  outcome_.walk.stances.push_back(edge.to);
}

// What is refined is animated as a whole and checked as a whole: these frames are what is exported.
void Plan::finish(EdgePath path) {
  const Stopwatch watch;
  SteeringCount count;
  const RefineSettings settings{request_.planner != "cylinder" && request_.refine.walk_on,
                                request_.refine.tries};
  path = refineWalk(steering_, std::move(path), settings, request_.limits, count);
  outcome_.time_limit_hit = request_.limits.timeIsUp();
  outcome_.stopped = request_.limits.stopped() && !outcome_.time_limit_hit;
  outcome_.walk.stances = {path.edges.front().from};
  std::vector<AnimationBuffer> parts(path.edges.size());
  parallelFor(static_cast<int>(parts.size()), request_.limits.threads,
              [&](int i, int) { steering_.animate(path.edges[i], parts[i]); });
  for (size_t i = 0; i < parts.size(); ++i) addPath(path.edges[i], std::move(parts[i]));
  for (const auto& [rule, times] : count.refusals) outcome_.refusals[rule] += times;
  outcome_.poses_checked += count.poses + outcome_.walk.buffer.size();
  const auto failure = steering_.contact(outcome_.walk.buffer, *scratch_);
  if (failure) {
    outcome_.walk = {};
    refuse(PlanStatus::kNoWalk, *whatStoodInTheWay({*failure}, request_));
  } else {
    outcome_.status = PlanStatus::kSolved;
  }
  outcome_.times.refine = watch.seconds();
}

PlanOutcome Plan::run() {
  const Stopwatch watch;
  const bool may_be = settleEnds() && groundLeads();
  outcome_.times.search = watch.seconds();
  std::optional<EdgePath> path;
  if (may_be) path = walkAllLegs();
  if (path)
    finish(std::move(*path));
  else
    tellReached();
  return std::move(outcome_);
}

}  // namespace

void checkRequest(const PlanRequest& request) {
  require(request.synthesizer && request.world && request.ground,
          "synthesizer, world and ground are needed");
  require(!request.bounds.isEmpty() && request.bounds.sizes().allFinite(),
          "bounds must hold something");
  require(request.limits.max_failures >= 1, "max_failures must be 1 or more");
  require(request.limits.threads >= 1 && request.limits.threads <= 64, "threads must be 1 to 64");
  require(request.comfort >= 0.0, "comfort must be 0 or more");
  require(request.refine.tries >= 0, "tries must be 0 or more");
}

PlanOutcome runPlan(const PlanRequest& request, const WalkSteering& steering,
                    const LegPlannerMaker& make) {
  return Plan(request, steering, make).run();
}

}  // namespace amble
