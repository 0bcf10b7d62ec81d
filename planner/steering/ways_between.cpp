#include "planner/steering/ways_between.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/rotation.h"
#include "environments/ground/scene_ground.h"

namespace amble {
namespace {

constexpr std::array<double, 3> kHandles = {
    0.3, 0.45, 0.6};  // of makeBezier, by trial: bends of every kind have one that suits
constexpr double kNoTurn = 1e-9;  // a smaller turn is none [rad]
// A curve that begins or ends further from the straight line's direction is a loop; turning on the
// spot is shorter [rad].
constexpr double kWidestCurve = 100 * kDegree;

double turn(double from, double to) {
  const double angle = wrapAngle(to - from);
  return std::abs(angle) < kNoTurn ? 0.0 : angle;
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

// Where one may turn, or step aside, from the one to the other.
bool isLevel(const Waypoint& from, const Waypoint& to) {
  const double rise = to.stance.position.z() - from.stance.position.z();
  return std::abs(rise) < SceneGround::kLevel;
}

}  // namespace

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

bool staysWithin(const WalkEdge& edge, const std::optional<Eigen::AlignedBox2d>& bounds) {
  constexpr double kRounding = 1e-9;  // of who walks along their border [m]
  if (!bounds || edge.path.empty()) return true;
  const Eigen::AlignedBox2d way = edge.path.extent();
  return (way.min().array() >= bounds->min().array() - kRounding).all() &&
         (way.max().array() <= bounds->max().array() + kRounding).all();
}

bool onOneFloor(const Waypoint& from, const Waypoint& to) {
  return isLevel(from, to) && from.stance.standing && to.stance.standing;
}

WalkEdge makeTurn(const Waypoint& from, const Waypoint& to) {
  WalkEdge edge;
  edge.from = from.stance;
  edge.to = to.stance;
  if (from.any_heading) edge.from.heading = edge.to.heading;
  if (to.any_heading) edge.to.heading = edge.from.heading;
  edge.turn_first = turn(edge.from.heading, edge.to.heading);
  if (!edge.to.standing && to.any_leading) edge.to.leading = edge.from.leading;
  edge.length = (edge.to.position - edge.from.position).head<2>().norm();
  return edge;
}

bool isThere(const Waypoint& from, const Waypoint& to) {
  const WalkEdge edge = makeTurn(from, to);
  return isLevel(from, to) && !from.stance.standing && !to.stance.standing &&
         std::abs(edge.turn_first) <= kNoTurn &&
         (to.any_leading || to.stance.leading == from.stance.leading);
}

}  // namespace amble
