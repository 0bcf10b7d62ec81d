#include "planner/steering/walk_steering.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/rotation.h"
#include "planner/steering/passages.h"
#include "planner/steering/walk_effort.h"

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
constexpr double kMeasuredWalk =
    3.0;  // that the core is measured on: long enough for full strides [m]

// How far a stance that is put on the ground may be from it: a flight of stairs is higher, what the
// ground rises by between the places of a proposal is not [m].
constexpr double kPlaceReach = 1.5;

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

// Largest |curvature| of a curve, by parameter: near enough to tell curves apart, at a hundredth of
// RootPath's cost [1/m].
double sharpestBend(const Bezier& c) {
  constexpr int kSamples = 16;
  double sharpest = 0.0;
  for (int i = 0; i <= kSamples; ++i) {
    const double u = static_cast<double>(i) / kSamples, v = 1.0 - u;
    const Eigen::Vector2d d = v * v * (c.col(1) - c.col(0)) + 2.0 * u * v * (c.col(2) - c.col(1)) +
                              u * u * (c.col(3) - c.col(2));
    const Eigen::Vector2d dd =
        v * (c.col(2) - 2.0 * c.col(1) + c.col(0)) + u * (c.col(3) - 2.0 * c.col(2) + c.col(1));
    const double speed = d.norm();
    if (!(speed > 0.0)) return HUGE_VAL;
    sharpest = std::max(
        sharpest, 2.0 / 3.0 * std::abs(d.x() * dd.y() - d.y() * dd.x()) / (speed * speed * speed));
  }
  return sharpest;
}

// Ways of all handle lengths, the gentlest first; `count` of them.
void addCurves(const Waypoint& from, const Waypoint& to, double leave, double arrive, int count,
               std::vector<Way>& ways) {
  std::vector<std::pair<double, Way>> curves;
  for (const double handle : kHandles) {
    const Bezier curve = makeBezier(from.stance.position.head<2>(), leave,
                                    to.stance.position.head<2>(), arrive, handle);
    curves.emplace_back(sharpestBend(curve), Way{leave, arrive, handle});
  }
  std::stable_sort(curves.begin(), curves.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (int i = 0; i < count; ++i) ways.push_back(curves[i].second);
}

Stance withHeading(Stance stance, double heading) {
  stance.heading = heading;
  return stance;
}

// Stage 1: root paths, the ones that are likeliest to be wanted first.
std::vector<Way> waysBetween(const Waypoint& from, const Waypoint& to) {
  const Eigen::Vector2d line = (to.stance.position - from.stance.position).head<2>();
  const double ahead = std::atan2(line.y(), line.x());
  const double leave = from.any_heading ? ahead : from.stance.heading;
  const double arrive = to.any_heading ? ahead : to.stance.heading;
  const bool may_turn_first = from.stance.standing || from.any_heading;
  const bool may_turn_last = to.stance.standing || to.any_heading;
  const double off_first = std::abs(turn(ahead, leave)), off_last = std::abs(turn(ahead, arrive));
  std::vector<Way> ways;
  if (off_first > 0.0 || off_last > 0.0) {
    const int curves = may_turn_first && may_turn_last ? 1 : static_cast<int>(kHandles.size());
    if (off_first < kWidestCurve && off_last < kWidestCurve)
      addCurves(from, to, leave, arrive, curves, ways);
  }
  if ((may_turn_first || off_first == 0.0) && (may_turn_last || off_last == 0.0)) {
    ways.push_back({ahead, ahead});
  } else if (may_turn_first && off_last < kWidestCurve) {  // bend into the arriving walk
    addCurves(from, to, ahead, arrive, 1, ways);
    addCurves(from, to, 2 * ahead - arrive, arrive, 1, ways);  // an arc, nearly
  } else if (may_turn_last && off_first < kWidestCurve) {
    addCurves(from, to, leave, ahead, 1, ways);
    addCurves(from, to, leave, 2 * ahead - leave, 1, ways);
  }
  return ways;
}

// Turning on the spot from one heading to the other, where there is no way to walk.
WalkEdge makeTurn(const Waypoint& from, const Waypoint& to) {
  WalkEdge edge;
  edge.from = from.stance;
  edge.to = to.stance;
  if (from.any_heading) edge.from.heading = edge.to.heading;
  if (to.any_heading) edge.to.heading = edge.from.heading;
  edge.turn_first = turn(edge.from.heading, edge.to.heading);
  return edge;
}

}  // namespace

WalkSteering::WalkSteering(const WalkSynthesizer& synthesizer, const CollisionWorld& world,
                           const SceneGround& ground)
    : synthesizer_(synthesizer),
      world_(world),
      ground_(ground),
      core_(straightWalk(synthesizer, ground, kMeasuredWalk), synthesizer.skeleton(),
            synthesizer.roles(), world.body(), synthesizer.stature()) {}

SteeringScratchPtr WalkSteering::makeScratch() const {
  auto scratch = std::make_unique<WalkScratch>();
  scratch->collision = world_.makeScratch();
  return scratch;
}

double WalkSteering::topSpeed() const { return kSpeedMargin * synthesizer_.settings().speed; }

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

bool WalkSteering::place(Stance& stance) const {
  const auto under =
      ground_.stand(stance.position.x(), stance.position.y(), stance.position.z(), kPlaceReach);
  if (under) stance.position.z() = under->height;
  return under.has_value();
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
      world_.check(buffer.poses, buffer.soles, false, *walkScratch(scratch).collision);
  if (found) return failure(*found);
  return std::nullopt;
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
    const auto touched = world_.check(own.buffer.poses, own.buffer.soles, true, *own.collision);
    if (touched) result.failure = failure(*touched);
    return !touched;
  };
  const double leave = edge.from.heading + edge.turn_first;
  const double arrive = edge.to.heading - edge.turn_last;
  if (!edge.path.empty()) {
    const auto touch = core_.touch(
        {edge.path, edge.from.position.z(), edge.from.standing, edge.to.standing, ground_}, world_,
        *own.collision);
    if (touch) {
      result.failure = {SteeringStage::kValidation, "contact", touch->part, touch->object, 0.0};
      return result;
    }
    const WalkResult walk =
        synthesizer_.walk(withHeading(edge.from, leave), withHeading(edge.to, arrive), edge.path,
                          edge.any_leading, own.buffer);
    if (!passes(walk)) return result;
    edge.steps = walk.steps;
    edge.effort = effortOf(own.buffer, synthesizer_.capturedLift(), synthesizer_.settings().speed);
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
  SteerResult all;
  all.failure.rule = "no_curve";
  const auto passes = [&](WalkEdge edge) {
    SteerResult one = judge(std::move(edge), scratch);
    all.poses += one.poses;
    all.edge = std::move(one.edge);
    if (!all.edge && one.failure.stage >= all.failure.stage) all.failure = one.failure;
    return all.edge.has_value();
  };
  const Eigen::Vector3d line = to.stance.position - from.stance.position;
  if (line.head<2>().norm() < kSamePlace) {
    const bool same_floor = std::abs(line.z()) < SceneGround::kLevel;
    if (same_floor && from.stance.standing && to.stance.standing) passes(makeTurn(from, to));
    return all;
  }
  for (const Way& way : waysBetween(from, to)) {
    if (passes(makeEdge(from, to, way))) break;
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
