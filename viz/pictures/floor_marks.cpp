#include "viz/pictures/floor_marks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/rotation.h"
#include "viz/pictures/draw_mesh.h"

namespace amble {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kReachLift = 0.002;  // of the ground that is reached, above the ground [m]
constexpr double kPlaceLift = 0.003;  // of the marks of start and goal above the floor [m]
constexpr double kPathLift = 0.006;   // of the path's ribbon above the floor [m]
constexpr double kPrintLift = 0.009;  // of footprints: over the path [m]

// A disc, and a wedge before it where the heading is given.
void addPlace(const PlaceView& place, double height, const Color& color,
              std::vector<DrawTriangle>& triangles) {
  constexpr double kRadius = 0.13, kReach = 0.32;  // [m]
  std::vector<Vector2d> disc;
  for (int i = 0; i < 32; ++i)
    disc.push_back(place.position +
                   kRadius * Vector2d(std::cos(i * kPi / 16), std::sin(i * kPi / 16)));
  addPolygon(disc, height, color, triangles);
  if (!place.heading) return;
  const auto at = [&](double turn, double reach) -> Vector2d {
    return place.position +
           reach * Vector2d(std::cos(*place.heading + turn), std::sin(*place.heading + turn));
  };
  addPolygon(
      std::vector<Vector2d>{at(-0.9, kRadius * 1.15), at(0, kReach), at(0.9, kRadius * 1.15)},
      height, color, triangles);
}

// The root path as a ribbon; where a walk climbs, on the ground under its frames.
void addPath(const WalkView& view, std::vector<DrawTriangle>& triangles) {
  constexpr double kWidth = 0.022;  // [m]
  const auto climbs = [&](const FrameState& state) { return state.position.z() != view.floor; };
  if (view.animation == nullptr ||
      std::none_of(view.animation->states.begin(), view.animation->states.end(), climbs)) {
    addRibbon(pathLine(view), kWidth, view.floor + kPathLift, kPathColor, triangles);
    return;
  }
  const std::vector<FrameState>& states = view.animation->states;
  for (size_t i = 1; i < states.size(); ++i) {
    const Vector3d &a = states[i - 1].position, &b = states[i].position;
    const std::array<Vector2d, 2> line = {a.head<2>(), b.head<2>()};
    if ((line[1] - line[0]).norm() < 1e-6) continue;
    addRibbon(line, kWidth, std::max(a.z(), b.z()) + kPathLift, kPathColor, triangles);
  }
}

// The ground that is reached, strip by strip, as a veil.
void addReached(const WalkView& view, std::vector<DrawTriangle>& triangles) {
  if (view.reached == nullptr) return;
  const double half = view.reached->breadth / 2;
  const Vector3d along(half, 0, kReachLift), across(0, half, 0), lift(0, 0, 2 * kReachLift);
  for (const ReachedRegion::Strip& strip : view.reached->strips) {
    const Vector3d from = strip.from - along + lift, to = strip.to + along;
    DrawTriangle low, high;
    low.p = {(from - across).cast<float>(), (to - across).cast<float>(),
             (to + across).cast<float>()};
    high.p = {low.p[0], low.p[2], (from + across).cast<float>()};
    for (DrawTriangle* t : {&low, &high}) {
      t->normal.fill(Eigen::Vector3f::UnitZ());
      t->color = kReachedColor;
      t->flags = kDecal | kNoShadow | kTwoSided | kSeeThrough;
      triangles.push_back(*t);
    }
  }
}

// Where one gets no farther.
void addStop(const WalkView& view, std::vector<DrawTriangle>& triangles) {
  // A head that shows on both sides of a thin wall in which it is.
  constexpr double kWidth = 0.04, kHead = 0.11, kNeedle = 0.02;  // [m]
  if (view.reached != nullptr) {
    const std::array<Vector2d, 2> line = {view.reached->near.head<2>(),
                                          view.reached->far.head<2>()};
    if ((line[1] - line[0]).norm() > kWidth)
      addRibbon(line, kWidth, view.reached->near.z() + kPathLift, kStopColor, triangles);
  }
  if (view.obstruction == nullptr) return;
  const Vector3d at = view.obstruction->at;
  const double ground = std::min(view.obstruction->body.z(), at.z());
  addCapsule({at.x(), at.y(), ground}, at, kNeedle, kStopColor, triangles);
  addCapsule(at, at, kHead, kStopColor, triangles);
}

}  // namespace

void addFloorMarks(const WalkView& view, std::vector<DrawTriangle>& triangles) {
  for (const PlaceView& place : view.via)
    addPlace(place, view.floor + kPlaceLift, rgb(109, 91, 176), triangles);
  addReached(view, triangles);
  addStop(view, triangles);
  const bool walks = view.animation != nullptr && !view.animation->states.empty();
  const double from = walks ? view.animation->states.front().position.z() : view.floor;
  const double to = walks ? view.animation->states.back().position.z() : view.floor;
  if (view.start) addPlace(*view.start, from + kPlaceLift, kStartColor, triangles);
  if (view.goal) addPlace(*view.goal, to + kPlaceLift, kGoalColor, triangles);
  addPath(view, triangles);
  if (view.animation == nullptr) return;
  const double length = soleLength(view);
  for (const Footprint& print : view.animation->footprints)
    addPolygon(placedShoe(print, length), print.position.z() + kPrintLift, sideColor(print.side),
               triangles);
}

}  // namespace amble
