#include "planner/walk_steering.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "animation/rotation.h"

namespace amble {
namespace {

constexpr std::array<double, 3> kHandles = {
    0.3, 0.45, 0.6};  // of makeBezier, by trial: bends of every kind have one that suits
constexpr double kSamePlace = 1e-6;    // nearer stances have no direction between them [m]
constexpr double kSameHeading = 1e-9;  // a smaller turn is none [rad]
// A curve that begins or ends further from the straight line's direction is a loop; turning on the
// spot is shorter [rad].
constexpr double kWidestCurve = 100 * kDegree;
// Stride and cadence give way a little so that steps and frames are whole.
constexpr double kSpeedMargin = 1.15;

class WalkScratch : public SteeringScratch {
 public:
  CollisionScratchPtr collision;
  AnimationBuffer buffer;
};

WalkScratch& walkScratch(SteeringScratch& scratch) { return static_cast<WalkScratch&>(scratch); }

SteeringFailure failure(WalkRule rule) {
  const bool limits = rule == WalkRule::kStepLength || rule == WalkRule::kTurnRate;
  return {limits ? SteeringStage::kLimits : SteeringStage::kAnimation, walkRuleName(rule)};
}

SteeringFailure failure(const Contact& contact) {
  return {SteeringStage::kValidation, "contact", contact.part, contact.object, contact.gap};
}

double turn(double from, double to) {
  const double angle = wrapAngle(to - from);
  return std::abs(angle) < kSameHeading ? 0.0 : angle;
}

// One way to walk from one stance to the other: the headings of the root path's two ends, and its
// handles.
struct Way {
  double leave = 0.0;
  double arrive = 0.0;
  double handle = 1.0 / 3.0;
  double curvature = 0.0;  // largest [1/m]
};

WalkEdge makeEdge(const Waypoint& from, const Waypoint& to, const Way& way) {
  WalkEdge edge;
  edge.from = from.stance;
  edge.to = to.stance;
  edge.any_leading = to.any_leading;
  if (from.any_heading) edge.from.heading = way.leave;
  if (to.any_heading) edge.to.heading = way.arrive;
  edge.turn_first = turn(edge.from.heading, way.leave);
  edge.turn_last = turn(way.arrive, edge.to.heading);
  edge.path = RootPath({makeBezier(edge.from.position.head<2>(), way.leave,
                                   edge.to.position.head<2>(), way.arrive, way.handle)});
  edge.length = edge.path.length();
  return edge;
}

// Curves of all handle lengths, the gentlest first.
void addCurves(const Waypoint& from, const Waypoint& to, double leave, double arrive, int count,
               std::vector<WalkEdge>& edges) {
  std::vector<std::pair<double, WalkEdge>> curves;
  for (const double handle : kHandles) {
    WalkEdge edge = makeEdge(from, to, {leave, arrive, handle});
    const double curvature = edge.path.maxCurvature();
    curves.emplace_back(curvature, std::move(edge));
  }
  std::stable_sort(curves.begin(), curves.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (int i = 0; i < count; ++i) edges.push_back(std::move(curves[i].second));
}

Stance withHeading(Stance stance, double heading) {
  stance.heading = heading;
  return stance;
}

}  // namespace

WalkSteering::WalkSteering(const WalkSynthesizer& synthesizer, const CollisionWorld& world,
                           const Ground& ground, double floor, double reach)
    : synthesizer_(synthesizer), world_(world), ground_(ground), floor_(floor), reach_(reach) {}

SteeringScratchPtr WalkSteering::makeScratch() const {
  auto scratch = std::make_unique<WalkScratch>();
  scratch->collision = world_.makeScratch();
  return scratch;
}

double WalkSteering::topSpeed() const { return kSpeedMargin * synthesizer_.settings().speed; }

bool WalkSteering::place(Stance& stance) const {
  const auto height = ground_.height(stance.position.x(), stance.position.y(), floor_, reach_);
  if (height) stance.position.z() = *height;
  return height.has_value();
}

std::optional<SteeringFailure> WalkSteering::stand(Stance& stance, SteeringScratch& scratch) const {
  if (!place(stance)) return failure(WalkRule::kNoGround);
  WalkScratch& own = walkScratch(scratch);
  const WalkResult result = synthesizer_.stand(stance, own.buffer);
  if (result.refused != WalkRule::kNone) return failure(result.refused);
  if (const auto contact = world_.checkPose(own.buffer.poses[0], *own.collision))
    return failure(*contact);
  return std::nullopt;
}

std::optional<SteeringFailure> WalkSteering::contact(const AnimationBuffer& buffer,
                                                     SteeringScratch& scratch) const {
  const auto found =
      world_.check(buffer.poses, buffer.states, false, *walkScratch(scratch).collision);
  if (found) return failure(*found);
  return std::nullopt;
}

// Stage 1: root paths, the ones that are likeliest to be wanted first.
std::vector<WalkEdge> WalkSteering::proposals(const Waypoint& from, const Waypoint& to) const {
  const Eigen::Vector2d way = (to.stance.position - from.stance.position).head<2>();
  const double ahead = std::atan2(way.y(), way.x());
  const double leave = from.any_heading ? ahead : from.stance.heading;
  const double arrive = to.any_heading ? ahead : to.stance.heading;
  const bool may_turn_first = from.stance.standing || from.any_heading;
  const bool may_turn_last = to.stance.standing || to.any_heading;
  const double off_first = std::abs(turn(ahead, leave)), off_last = std::abs(turn(ahead, arrive));
  std::vector<WalkEdge> edges;
  if (off_first > 0.0 || off_last > 0.0) {
    const int curves = may_turn_first && may_turn_last ? 1 : static_cast<int>(kHandles.size());
    if (off_first < kWidestCurve && off_last < kWidestCurve)
      addCurves(from, to, leave, arrive, curves, edges);
  }
  if ((may_turn_first || off_first == 0.0) && (may_turn_last || off_last == 0.0)) {
    edges.push_back(makeEdge(from, to, {ahead, ahead}));
  } else if (may_turn_first && off_last < kWidestCurve) {  // bend into the arriving walk
    addCurves(from, to, ahead, arrive, 1, edges);
    addCurves(from, to, 2 * ahead - arrive, arrive, 1, edges);  // an arc, nearly
  } else if (may_turn_last && off_first < kWidestCurve) {
    addCurves(from, to, leave, ahead, 1, edges);
    addCurves(from, to, leave, 2 * ahead - leave, 1, edges);
  }
  return edges;
}

// Stages 2 to 4, of the walk first, since it is refused more often than the turns.
SteerResult WalkSteering::judge(WalkEdge edge, SteeringScratch& scratch) const {
  WalkScratch& own = walkScratch(scratch);
  SteerResult result;
  int frames = 0;
  const auto passes = [&](const WalkResult& made) {
    if (made.refused != WalkRule::kNone) {
      result.failure = failure(made.refused);
      return false;
    }
    result.poses += own.buffer.size();
    frames += own.buffer.size() - 1;
    const auto touched = world_.check(own.buffer.poses, own.buffer.states, true, *own.collision);
    if (touched) result.failure = failure(*touched);
    return !touched;
  };
  const double leave = edge.from.heading + edge.turn_first;
  const double arrive = edge.to.heading - edge.turn_last;
  if (!edge.path.empty()) {
    const WalkResult walk =
        synthesizer_.walk(withHeading(edge.from, leave), withHeading(edge.to, arrive), edge.path,
                          edge.any_leading, own.buffer);
    if (!passes(walk)) return result;
    edge.steps = walk.steps;
    if (!edge.to.standing) edge.to.leading = walk.leading;
  }
  if (edge.turn_first != 0.0 &&
      !passes(synthesizer_.turnOnSpot(edge.from, edge.turn_first, own.buffer)))
    return result;
  if (edge.turn_last != 0.0 &&
      !passes(synthesizer_.turnOnSpot(withHeading(edge.to, arrive), edge.turn_last, own.buffer))) {
    return result;
  }
  edge.duration = frames * synthesizer_.settings().frame_time;
  result.edge = std::move(edge);
  return result;
}

SteerResult WalkSteering::steer(const Waypoint& from, const Waypoint& to,
                                SteeringScratch& scratch) const {
  std::vector<WalkEdge> edges;
  if ((to.stance.position - from.stance.position).head<2>().norm() >= kSamePlace) {
    edges = proposals(from, to);
  } else if (from.stance.standing && to.stance.standing) {
    WalkEdge edge;
    edge.from = from.stance;
    edge.to = to.stance;
    if (from.any_heading) edge.from.heading = edge.to.heading;
    if (to.any_heading) edge.to.heading = edge.from.heading;
    edge.turn_first = turn(edge.from.heading, edge.to.heading);
    edges.push_back(std::move(edge));
  }
  SteerResult all;
  all.failure.rule = "same_place";
  for (WalkEdge& edge : edges) {
    SteerResult one = judge(std::move(edge), scratch);
    all.poses += one.poses;
    if (one.edge || one.failure.stage >= all.failure.stage) all.failure = one.failure;
    if (one.edge) {
      all.edge = std::move(one.edge);
      break;
    }
  }
  return all;
}

void WalkSteering::animate(const WalkEdge& edge, AnimationBuffer& out) const {
  AnimationBuffer part;
  bool first = true;
  const auto add = [&] {
    if (first)
      out = part;
    else
      out.append(part);
    first = false;
  };
  const double leave = edge.from.heading + edge.turn_first;
  const double arrive = edge.to.heading - edge.turn_last;
  if (edge.turn_first != 0.0) {
    synthesizer_.turnOnSpot(edge.from, edge.turn_first, part);
    add();
  }
  if (!edge.path.empty()) {
    synthesizer_.walk(withHeading(edge.from, leave), withHeading(edge.to, arrive), edge.path,
                      edge.any_leading, part);
    add();
  }
  if (edge.turn_last != 0.0) {
    synthesizer_.turnOnSpot(withHeading(edge.to, arrive), edge.turn_last, part);
    add();
  }
  if (first) synthesizer_.stand(edge.from, out);
}

}  // namespace amble
