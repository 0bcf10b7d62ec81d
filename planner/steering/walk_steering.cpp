#include "planner/steering/walk_steering.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "animation/steps/step_placer.h"
#include "animation/steps/stride_law.h"
#include "base/rotation.h"
#include "environments/ground/ground_cells.h"
#include "planner/steering/free_look.h"
#include "planner/steering/passages.h"
#include "planner/steering/walk_effort.h"
#include "planner/steering/way_finder.h"
#include "planner/steering/ways_between.h"

namespace amble {
namespace {

constexpr double kSamePlace = 1e-6;  // nearer stances have no direction between them [m]
// How far a stance that is put on the ground may be from it: a flight of stairs is higher, what the
// ground rises by between the places of a proposal is not [m].
constexpr double kPlaceReach = 1.5;

class WalkScratch : public SteeringScratch {
 public:
  CollisionScratchPtr collision;
  AnimationBuffer buffer;
  std::vector<JointFrame> joints;
  std::vector<Eigen::Vector3d> from, to;  // axes of the body's parts
};

WalkScratch& walkScratch(SteeringScratch& scratch) { return static_cast<WalkScratch&>(scratch); }

std::vector<CollisionScratch*> collisionScratches(std::span<const SteeringScratchPtr> scratches) {
  std::vector<CollisionScratch*> own;
  for (const SteeringScratchPtr& scratch : scratches)
    own.push_back(walkScratch(*scratch).collision.get());
  return own;
}

SteeringFailure failure(WalkRule rule, const Stance& from, const Stance& to) {
  const Eigen::Vector3d way = to.position - from.position;
  return {rule, -1, -1, 0.0, from.position, to.position, std::atan2(way.y(), way.x())};
}

// Parts of an edge in time, and the one first that is refused most often.
constexpr PartOrder kInTime = {EdgePart::kTurnFirst, EdgePart::kWalk, EdgePart::kTurnLast};
constexpr PartOrder kLikeliestRefused = {EdgePart::kWalk, EdgePart::kTurnFirst,
                                         EdgePart::kTurnLast};

// Small steps to a place beside the first.
bool shifts(const WalkEdge& edge) {
  return edge.path.empty() && edge.from.position != edge.to.position;
}

bool hasPart(const WalkEdge& edge, EdgePart part) {
  if (part == EdgePart::kWalk) return !edge.path.empty();
  if (part == EdgePart::kTurnFirst && shifts(edge)) return true;
  return (part == EdgePart::kTurnFirst ? edge.turn_first : edge.turn_last) != 0.0;
}

Stance withHeading(Stance stance, double heading) {
  stance.heading = heading;
  return stance;
}

// Between the turns at its ends.
std::pair<Stance, Stance> endsOfWalk(const WalkEdge& edge) {
  return {withHeading(edge.from, edge.from.heading + edge.turn_first),
          withHeading(edge.to, edge.to.heading - edge.turn_last)};
}

// How far the walking body reaches to its sides, feet, legs, arms and head.
ClearanceMap::Breadth breadthByHeight(const StraightWalk& walk, const WalkSynthesizer& synthesizer,
                                      const Body& body, const SceneGround& ground) {
  // Of stature: hands hang to the one, and shoulders end at the other.
  constexpr double kHands = 0.4, kShoulders = 0.85;
  const double step = ground.settings().limits.highestStep();
  const double stature = synthesizer.stature();
  const auto reach = [&](double low, double high) {
    const Eigen::AlignedBox1d breadth =
        walkingBreadth(walk, synthesizer.skeleton(), body, Eigen::AlignedBox1d(low, high));
    return breadth.isEmpty() ? 0.0 : std::max(-breadth.min()[0], breadth.max()[0]);
  };
  const std::array<double, 4> heights = {step, std::max(step, kHands * stature),
                                         std::max(step, kShoulders * stature),
                                         std::max(body.upright, stature)};
  ClearanceMap::Breadth all{{}, reach(-step, step)};
  for (size_t i = 0; i + 1 < heights.size(); ++i) {
    if (heights[i] < heights[i + 1])
      all.bands.push_back({heights[i], heights[i + 1], reach(heights[i], heights[i + 1])});
  }
  return all;
}

}  // namespace

WalkSteering::WalkSteering(const WalkSynthesizer& synthesizer, const CollisionWorld& world,
                           const SceneGround& ground, const WalkWishes& wishes)
    : WalkSteering(synthesizer, world, ground, wishes, straightWalk(synthesizer)) {}

WalkSteering::WalkSteering(const WalkSynthesizer& synthesizer, const CollisionWorld& world,
                           const SceneGround& ground, const WalkWishes& wishes,
                           const StraightWalk& walk)
    : synthesizer_(synthesizer),
      world_(world),
      ground_(ground),
      wishes_(wishes),
      core_(walk, synthesizer.skeleton(), synthesizer.roles(), world.body(), synthesizer.stature()),
      reach_(
          walk, synthesizer.skeleton(), synthesizer.roles(), world.body(), synthesizer.stature(),
          {ground.settings().limits.highestStep(),
           StrideLaw::kLongestStep * synthesizer.capturedStep(),
           StepPlacer::kHighestLift * synthesizer.scale(), synthesizer.tooHighToSwingOver(),
           std::min(synthesizer.feet()[kLeft].half_width, synthesizer.feet()[kRight].half_width)}) {
  const Eigen::AlignedBox1d breadth = walkingBreadth(walk, synthesizer.skeleton(), world.body());
  if (breadth.isEmpty()) return;
  half_breadth_ = std::max(-breadth.min()[0], breadth.max()[0]);
  breadth_ = breadthByHeight(walk, synthesizer, world.body(), ground);
}

SteeringScratchPtr WalkSteering::makeScratch() const {
  auto scratch = std::make_unique<WalkScratch>();
  scratch->collision = world_.makeScratch();
  return scratch;
}

double WalkSteering::topSpeed() const {
  return StepPlacer::kFastest * synthesizer_.settings().speed;
}

int WalkSteering::layers() const {
  return ground_.isLevel() ? 0 : std::max(1, ground_.cells().layers());
}

std::vector<StancePair> WalkSteering::passages() const {
  std::vector<StancePair> pairs;
  for (const Passage& passage : findPassages(ground_)) {
    StancePair pair;
    pair.first.position = passage.low;
    pair.second.position = passage.high;
    pair.first.heading = pair.second.heading = passage.heading;
    pairs.push_back(pair);
  }
  return pairs;
}

std::unique_ptr<WayGuide> WalkSteering::guide(const Eigen::Vector3d& from,
                                              const Eigen::Vector3d& to,
                                              const Eigen::AlignedBox2d& bounds,
                                              const std::function<bool()>& stopped,
                                              int threads) const {
  auto room = map(bounds, stopped, threads);
  if (!room) return nullptr;
  return std::make_unique<WayFinder>(std::move(room), from, to, synthesizer_.shortestWalk(),
                                     stopped);
}

std::shared_ptr<const ClearanceMap> WalkSteering::map(const Eigen::AlignedBox2d& bounds,
                                                      const std::function<bool()>& stopped,
                                                      int threads) const {
  if (breadth_.bands.empty()) return nullptr;
  return std::make_shared<const ClearanceMap>(ground_, bounds, breadth_, stopped, threads);
}

namespace {

SteeringFailure disconnected(const BodyReach::Barrier& barrier) {
  const Eigen::Vector3d way = barrier.far - barrier.near;
  return {WalkRule::kDisconnected,
          barrier.part,
          barrier.object,
          0.0,
          barrier.at,
          0.5 * (barrier.near + barrier.far),
          std::atan2(way.y(), way.x())};
}

}  // namespace

std::optional<SteeringFailure> WalkSteering::shutOff(
    const Eigen::Vector3d& from, const Eigen::Vector3d& to, const std::function<bool()>& stopped,
    std::span<const SteeringScratchPtr> scratches) const {
  const auto barrier =
      reach_.barrier(from, to, world_, ground_, collisionScratches(scratches), stopped);
  if (!barrier) return std::nullopt;
  return disconnected(*barrier);
}

std::optional<SteeringFailure> WalkSteering::shutOffOnGround(
    const Eigen::Vector3d& from, const Eigen::Vector3d& to, const std::function<bool()>& stopped,
    std::span<const SteeringScratchPtr> scratches) const {
  const auto barrier =
      reach_.barrier(from, to, world_, ground_, collisionScratches(scratches), stopped, 0.0);
  if (!barrier || barrier->object < 0) return std::nullopt;
  return disconnected(*barrier);
}

bool WalkSteering::place(Stance& stance) const {
  const auto under =
      ground_.stand(stance.position.x(), stance.position.y(), stance.position.z(), kPlaceReach);
  if (under) stance.position.z() = under->height;
  return under.has_value();
}

std::optional<SteeringFailure> WalkSteering::stand(Stance& stance, SteeringScratch& scratch) const {
  if (!place(stance)) return failure(WalkRule::kNoGround, stance, stance);
  return standHere(stance, scratch);
}

std::optional<SteeringFailure> WalkSteering::standHere(const Stance& stance,
                                                       SteeringScratch& scratch) const {
  WalkScratch& own = walkScratch(scratch);
  const WalkResult result = synthesizer_.stand(stance, own.buffer);
  if (result.refused != WalkRule::kNone) return failure(result.refused, stance, stance);
  if (const auto contact = world_.checkPose(own.buffer.poses[0], *own.collision))
    return touched(*contact, own.buffer, own);
  return std::nullopt;
}

std::optional<SteeringFailure> WalkSteering::contact(const AnimationBuffer& buffer,
                                                     SteeringScratch& scratch) const {
  const auto found =
      world_.check(buffer.poses, buffer.soles, false, *walkScratch(scratch).collision);
  if (found) return touched(*found, buffer, scratch);
  return std::nullopt;
}

// A contact by where its part is.
SteeringFailure WalkSteering::touched(const Contact& contact, const AnimationBuffer& buffer,
                                      SteeringScratch& scratch) const {
  WalkScratch& own = walkScratch(scratch);
  const Body& body = world_.body();
  own.joints.resize(synthesizer_.skeleton().size());
  own.from.resize(body.parts.size());
  own.to.resize(body.parts.size());
  forwardKinematics(synthesizer_.skeleton(), buffer.poses[contact.frame], own.joints);
  placeBody(body, own.joints, own.from, own.to);
  const FrameState& state = buffer.states[contact.frame];
  return {WalkRule::kContact,
          contact.part,
          contact.object,
          contact.gap,
          0.5 * (own.from[contact.part] + own.to[contact.part]),
          state.position,
          state.heading};
}

// Of a planned walk alone, in time and effort [s].
double WalkSteering::leastCost(int intervals, std::span<const GaitParameters> gait) const {
  const CharacterSettings& settings = synthesizer_.settings();
  return intervals * settings.frame_time +
         effortOf(gait, synthesizer_.capturedLift(), settings.speed);
}

WalkFilter WalkSteering::costsAtMost(double most) const {
  if (most == HUGE_VAL) return {};
  return [this, most](int intervals, Side, std::span<const GaitParameters> gait) {
    return leastCost(intervals, gait) <= most;
  };
}

// Of the walk of an edge whether it does not cost too much, and one could go on from it; that alone
// in `leads_on`, which is asked about once for the same walk.
WalkFilter WalkSteering::isOfUse(const WalkEdge& edge, const Use& use, bool& leads_on) const {
  if (use.leads_on == nullptr) return costsAtMost(use.most);
  return [this, &use, &leads_on, planned = edge](int intervals, Side leading,
                                                 std::span<const GaitParameters> gait) mutable {
    const double cost = leastCost(intervals, gait);
    if (cost > use.most) return false;
    if (leads_on && planned.duration == cost && planned.to.leading == leading) return true;
    if (!planned.to.standing) planned.to.leading = leading;
    planned.duration = cost;
    return leads_on = (*use.leads_on)(planned);
  };
}

// The one place that knows what an edge is made of: its parts, each begun where the one before it
// in time ends.
WalkResult WalkSteering::make(const WalkEdge& edge, EdgePart part, AnimationBuffer& out,
                              const WalkFilter& is_wanted) const {
  const auto [leave, arrive] = endsOfWalk(edge);
  switch (part) {
    case EdgePart::kTurnFirst:
      return synthesizer_.smallSteps(
          edge.from, shifts(edge) ? edge.to.position : edge.from.position, edge.turn_first, out);
    case EdgePart::kWalk:
      return synthesizer_.walk(leave, arrive, edge.path, edge.any_leading, out, {}, is_wanted);
    case EdgePart::kTurnLast:
      return synthesizer_.turnOnSpot(arrive, edge.turn_last, out);
  }
  return {};
}

// Makes the parts that the edge has, one after another in that order, and shows each until one is
// refused by visit(part, result). @return whether all were taken
template <typename Visit>
bool WalkSteering::visitParts(const WalkEdge& edge, const PartOrder& order, AnimationBuffer& buffer,
                              Visit visit, const WalkFilter& is_wanted) const {
  return std::all_of(order.begin(), order.end(), [&](EdgePart part) {
    return !hasPart(edge, part) || visit(part, make(edge, part, buffer, is_wanted));
  });
}

// What the body would touch for sure, without animating it.
bool WalkSteering::coreTouches(const WalkEdge& edge, SteeringScratch& scratch,
                               SteeringFailure& failure) const {
  if (edge.path.empty()) return false;
  const auto touch = core_.touch(
      {edge.path, edge.from.position.z(), edge.from.standing, edge.to.standing, ground_}, world_,
      *walkScratch(scratch).collision);
  if (!touch) return false;
  failure = {WalkRule::kContact, touch->part, touch->object, 0.0,
             touch->at,          touch->body, touch->heading};
  return true;
}

// Whether the bounds hold the edge, and stages 2 to 4, of the walk first, since it is refused more
// often than the turns.
SteerResult WalkSteering::judge(WalkEdge edge, SteeringScratch& scratch, const Use& use) const {
  WalkScratch& own = walkScratch(scratch);
  SteerResult result;
  bool leads_on = true;
  if (!staysWithin(edge, wishes_.within)) {
    result.failure = failure(WalkRule::kBounds, edge.from, edge.to);
    return result;
  }
  if (coreTouches(edge, scratch, result.failure)) return result;
  int frames = 0;
  double near = 0.0;
  const auto passes = [&](EdgePart part, const WalkResult& made) {
    if (made.refused != WalkRule::kNone) {
      result.failure = failure(made.refused, edge.from, edge.to);
      return false;
    }
    if (made.unwanted) {
      (leads_on ? result.too_dear : result.leads_nowhere) = true;
      return false;
    }
    result.poses += own.buffer.size();
    frames += own.buffer.size() - 1;
    if (const auto contact =
            world_.check(own.buffer.poses, own.buffer.soles, true, *own.collision)) {
      result.failure = touched(*contact, own.buffer, scratch);
      return false;
    }
    if (wishes_.comfort > 0.0)
      near += world_.nearness(own.buffer.poses, wishes_.comfort, *own.collision);
    if (part != EdgePart::kWalk) return true;
    edge.steps = made.steps;
    edge.effort = effortOf(own.buffer, synthesizer_.capturedLift(), synthesizer_.settings().speed);
    if (!edge.to.standing) edge.to.leading = made.leading;
    return true;
  };
  if (!visitParts(edge, kLikeliestRefused, own.buffer, passes, isOfUse(edge, use, leads_on)))
    return result;
  edge.duration = frames * synthesizer_.settings().frame_time;
  edge.unease = kNearnessCost * near * synthesizer_.settings().frame_time;
  result.edge = std::move(edge);
  return result;
}

SteerResult WalkSteering::steer(const Waypoint& from, const Waypoint& to,
                                SteeringScratch& scratch) const {
  return steer(from, to, scratch, {}, nullptr);
}

SteerResult WalkSteering::steerWithin(const Waypoint& from, const Waypoint& to, double most,
                                      SteeringScratch& scratch) const {
  return steer(from, to, scratch, {most}, nullptr);
}

SteerResult WalkSteering::steerOn(const Waypoint& from, const Waypoint& to, double most,
                                  const LeadsOn& leads_on, SteeringScratch& scratch) const {
  return steer(from, to, scratch, {most, &leads_on}, nullptr);
}

bool WalkSteering::mayLead(const Waypoint& from, const Waypoint& to, double most,
                           SteeringScratch& scratch) const {
  const Eigen::Vector3d line = to.stance.position - from.stance.position;
  if (line.head<2>().norm() < kSamePlace) return true;
  SteeringFailure failure;
  for (const Way& way : waysBetween(from, to)) {
    const WalkEdge edge = makeEdge(from, to, way);
    if (edge.path.empty()) return true;
    if (!staysWithin(edge, wishes_.within) || coreTouches(edge, scratch, failure)) continue;
    const auto [leave, arrive] = endsOfWalk(edge);
    const WalkResult walk =
        synthesizer_.outlook(leave, arrive, edge.path, edge.any_leading, costsAtMost(most));
    if (walk.refused == WalkRule::kNone) return !walk.unwanted;
  }
  return false;
}

WalkSteering::Attempt WalkSteering::attempt(const Waypoint& from, const Waypoint& to,
                                            SteeringScratch& scratch) const {
  Attempt attempt;
  attempt.result = steer(from, to, scratch, {}, &attempt.refused);
  if (attempt.result.edge) attempt.refused.reset();
  return attempt;
}

// The edge is the first proposal that nothing refuses. Where one costs more than `use.most`,
// whether that is so is not asked: those after it bend more and are hardly shorter. Nor is it of
// those from which one could not go on, unless there is another behind them.
SteerResult WalkSteering::steer(const Waypoint& from, const Waypoint& to, SteeringScratch& scratch,
                                const Use& use, std::optional<WalkEdge>* refused) const {
  SteerResult all;
  all.failure = failure(WalkRule::kNoCurve, from.stance, to.stance);
  std::vector<WalkEdge> put_off;
  const auto passes = [&](WalkEdge edge, const Use& its_use) {
    std::optional<WalkEdge> proposal;
    if (refused || its_use.leads_on) proposal = edge;
    SteerResult one = judge(std::move(edge), scratch, its_use);
    all.poses += one.poses;
    all.too_dear = one.too_dear;
    all.edge = std::move(one.edge);
    if (one.leads_nowhere) {
      put_off.push_back(std::move(*proposal));
      return false;
    }
    if (!all.edge && !all.too_dear && stageOf(one.failure.rule) >= stageOf(all.failure.rule)) {
      all.failure = one.failure;
      if (refused) *refused = std::move(proposal);
    }
    return all.edge || all.too_dear;
  };
  const Eigen::Vector3d line = to.stance.position - from.stance.position;
  if (line.head<2>().norm() < kSamePlace) {
    if (onOneFloor(from, to) || isThere(from, to)) passes(makeTurn(from, to), {use.most});
    return all;
  }
  for (const Way& way : waysBetween(from, to)) {
    if (passes(makeEdge(from, to, way), use)) break;
  }
  if (!all.edge) {
    all.leads_nowhere = !all.too_dear && !put_off.empty();
    return all;
  }
  std::optional<WalkEdge> last = std::move(all.edge);
  for (WalkEdge& edge : std::exchange(put_off, {}))
    if (passes(std::move(edge), {use.most})) return all;
  all.edge = std::move(last);
  return all;
}

// One of the ways that steer() would try does.
bool WalkSteering::looksFree(const Waypoint& from, const Waypoint& to,
                             SteeringScratch& scratch) const {
  if (!onOneFloor(from, to) || half_breadth_ <= 0.0) return false;
  const Eigen::Vector2d line = (to.stance.position - from.stance.position).head<2>();
  if (line.norm() < synthesizer_.shortestWalk()) return false;
  const FreeLook look(synthesizer_, world_, ground_, half_breadth_);
  return std::ranges::any_of(waysBetween(from, to), [&](const Way& way) {
    const WalkEdge edge = makeEdge(from, to, way);
    return staysWithin(edge, wishes_.within) && look.isFree(edge, *walkScratch(scratch).collision);
  });
}

SteerResult WalkSteering::smallSteps(const Waypoint& from, const Waypoint& to,
                                     SteeringScratch& scratch) const {
  const Eigen::Vector3d line = to.stance.position - from.stance.position;
  if (line.head<2>().norm() > WalkSynthesizer::kSmallSteps || !onOneFloor(from, to)) {
    SteerResult none;
    none.failure = failure(WalkRule::kNoCurve, from.stance, to.stance);
    return none;
  }
  return judge(makeTurn(from, to), scratch, {});
}

WalkRule WalkSteering::animateRefused(const WalkEdge& edge, AnimationBuffer& out) const {
  AnimationBuffer part;
  bool first = true;
  WalkRule refused = WalkRule::kNone;
  visitParts(edge, kInTime, part, [&](EdgePart, const WalkResult& result) {
    refused = result.refused;
    if (refused != WalkRule::kNone) return false;
    if (std::exchange(first, false))
      out = part;
    else
      out.append(part);
    return true;
  });
  if (first) synthesizer_.stand(edge.from, out);
  return refused;
}

void WalkSteering::animate(const WalkEdge& edge, AnimationBuffer& out) const {
  const WalkRule refused = animateRefused(edge, out);
  // What was judged is made again the same: it cannot be refused.
  assert(refused == WalkRule::kNone);
  (void)refused;
}

}  // namespace amble
