#include "viz/pictures/walk_shot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "base/rotation.h"
#include "viz/pictures/floor_marks.h"
#include "viz/pictures/room.h"

namespace amble {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kWholeRoom = 14.0;  // a scene no longer than this is shown whole [m]
constexpr double kAroundWalk = 2.0;  // of a larger one so much is shown around the walk [m]
// What must fit into the picture above the floor, where it is there [m].
constexpr double kHeadroom = 2.5;
constexpr float kMargin = 28;          // about the room [pixels]
constexpr double kElevation = 0.72;    // of the eye above the horizon [rad]
constexpr double kLowElevation = 0.2;  // of the eye beside the walk [rad]
constexpr double kEyeHeight = 0.93;    // of a walker, of the stature
constexpr double kLookDown = 0.22;     // of who walks and looks where to [rad]
constexpr double kWideView = 1.35;     // across the picture, by the walker's eyes [rad]

// What of a body must be seen, over the ground under it; the first is taken for its feet [m].
constexpr std::array<double, 4> kWatchedHeights = {RoomSight::kFeet, 0.6, 1.1, 1.6};

// What the picture is about: bodies where there are any, else start and goal.
std::vector<Vector3d> watchedPoints(const WalkView& view, const std::vector<int>& frames) {
  std::vector<Vector3d> places;  // on the ground
  for (const int frame : frames) {
    const Vector3d& p_WR = view.animation->poses.p_WR(frame);
    places.emplace_back(p_WR.x(), p_WR.y(), view.animation->states[frame].position.z());
  }
  if (places.empty()) {
    for (const auto& place : {view.start, view.goal})
      if (place) places.emplace_back(place->position.x(), place->position.y(), place->height);
    if (view.obstruction != nullptr) places.push_back(view.obstruction->body);
  }
  std::vector<Vector3d> points;
  for (const Vector3d& p : places)
    for (const double height : kWatchedHeights) points.push_back(p + height * Vector3d::UnitZ());
  return points;
}

// The box of the picture: what is around the watched points and belongs to the scene.
AlignedBox3d focusBox(const WalkView& view, const std::vector<Vector3d>& watched) {
  const AlignedBox3d scene = view.scene->bounds();
  AlignedBox3d box = scene;
  if (!watched.empty() && scene.sizes().head<2>().maxCoeff() > kWholeRoom) {
    AlignedBox3d around;
    for (const Vector3d& p : watched) around.extend(p);
    around.min().array() -= kAroundWalk;
    around.max().array() += kAroundWalk;
    const AlignedBox3d common = around.intersection(scene);
    if (!common.isEmpty()) box = common;
  }
  box.min().z() = view.floor;
  box.max().z() = view.floor + std::clamp(scene.max().z() - view.floor, 1.8, kHeadroom);
  for (const Vector3d& p : watched) box.max().z() = std::max(box.max().z(), p.z());
  return box;
}

std::vector<Vector3f> corners(const AlignedBox3d& box) {
  std::vector<Vector3f> points;
  for (int i = 0; i < 8; ++i)
    points.push_back(box.corner(static_cast<AlignedBox3d::CornerType>(i)).cast<float>());
  return points;
}

// How many watched points nothing hides, in a small picture.
int visibleCount(const std::vector<DrawTriangle>& triangles, const Camera& camera, int width,
                 int height, const std::vector<Vector3d>& watched, int threads) {
  constexpr float kSlack = 0.25f;  // half a body's thickness [m]
  const DepthMap map = rasterizeDepth(triangles, camera, width, height, kSeeThrough, threads);
  int count = 0;
  for (const Vector3d& p : watched) {
    const Vector3f view = camera.toView(p.cast<float>());
    const Eigen::Vector2f at = camera.toPixel(view);
    const int x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
    if (x < 0 || y < 0 || x >= width || y >= height) continue;
    const float depth = map.at(x, y);
    count += depth == 0 || depth > view.z() - kSlack;
  }
  return count;
}

// How far apart the walk's places lie in the picture, one after another: bodies hide one another
// where it is seen along its way [pixels, >= 1].
double spreadOf(const Camera& camera, const std::vector<Vector3d>& watched) {
  constexpr size_t kPlace = kWatchedHeights.size();  // points of one place
  double spread = 1.0;
  for (size_t i = kPlace; i < watched.size(); i += kPlace) {
    const auto at = [&](size_t k) {
      return camera.toPixel(camera.toView(watched[k].cast<float>()));
    };
    spread += static_cast<double>((at(i) - at(i - kPlace)).norm());
  }
  return spread;
}

// The surfaces of the room and their triangles, from wherever it is seen.
struct RoomModel {
  std::vector<RoomSurface> surfaces;
  DrawnSurfaces drawn;
};

// What stood in the way is seen by its colour.
RoomModel modelRoom(const WalkView& view, int threads) {
  RoomModel room{sortRoom(*view.scene, view.floor), {}};
  if (view.obstruction != nullptr) {
    for (RoomSurface& surface : room.surfaces) {
      const std::string name = objectName(view.scene->objects[surface.object]);
      if (name == view.obstruction->object || name == view.obstruction->other)
        surface.color = mix(surface.color, kStopColor, 0.45f);
    }
  }
  room.drawn = drawSurfaces(room.surfaces, threads);
  return room;
}

// What a picture is about, and is to show.
struct Subject {
  std::vector<Vector3d> watched;
  AlignedBox3d focus;
};

struct Shot {
  Camera camera;
  std::vector<DrawTriangle> triangles;  // of the room
};

// Of the views from these directions the one in which the most of the walk is seen, and widest; the
// first of equals.
Shot chooseShot(const WalkView& view, const Subject& subject, const RoomModel& room,
                const std::vector<ViewDirection>& directions, const ShotSettings& settings) {
  constexpr int kSmall = 4;  // the trial pictures are so many times smaller
  const std::vector<Vector3f> points = corners(subject.focus);
  const int count = static_cast<int>(directions.size());
  std::vector<Shot> shots(directions.size());
  std::vector<double> worth(directions.size());
  parallelFor(count, settings.threads, [&](int i, int) {
    Shot& shot = shots[i];
    shot.camera = frameView(points, directions[i], settings.width, settings.height, kMargin);
    addRoom(room.surfaces, room.drawn,
            {shot.camera.eye.cast<double>(), subject.watched, view.floor}, shot.triangles);
    const double seen =
        visibleCount(shot.triangles, shot.camera.enlarged(1.0f / kSmall), settings.width / kSmall,
                     settings.height / kSmall, subject.watched, 1);
    worth[i] =
        seen * seen * spreadOf(shot.camera, subject.watched);  // hidden counts more: by trial
  });
  return std::move(shots[std::max_element(worth.begin(), worth.end()) - worth.begin()]);
}

// The four corners.
std::vector<ViewDirection> cornerDirections(const AlignedBox3d& focus) {
  const bool wide = focus.sizes().x() >= focus.sizes().y();
  const double turn = wide ? 62 * kPi / 180 : 28 * kPi / 180;
  std::vector<ViewDirection> directions;
  for (const double azimuth : {-turn, turn - kPi, turn, kPi - turn})
    directions.push_back({azimuth, kElevation});
  return directions;
}

// Both sides of the way from the first place to the last, in plan; of the room's long side where
// they are one.
std::vector<ViewDirection> sideDirections(const Subject& subject) {
  const Vector3d size = subject.focus.sizes();
  Eigen::Vector2d way(size.x() >= size.y() ? 1.0 : 0.0, size.x() >= size.y() ? 0.0 : 1.0);
  if (!subject.watched.empty()) {
    const Vector3d between = subject.watched.back() - subject.watched.front();
    if (between.head<2>().norm() > 0.5) way = between.head<2>();
  }
  const double along = std::atan2(way.y(), way.x());
  return {{along - kPi / 2, kLowElevation}, {along + kPi / 2, kLowElevation}};
}

Shot shootFromAbove(const WalkView& view, const Subject& subject, const RoomModel& room,
                    const ShotSettings& settings) {
  constexpr float kAboveAll = 100.0f;  // above all that is shown [m]
  Shot shot;
  const Vector3f size = subject.focus.sizes().cast<float>();
  shot.camera.parallel = true;
  shot.camera.axes << 1, 0, 0, 0, -1, 0, 0, 0, -1;  // right, down, forward
  shot.camera.eye = subject.focus.center().cast<float>() + kAboveAll * Vector3f::UnitZ();
  shot.camera.centre =
      Eigen::Vector2f(static_cast<float>(settings.width), static_cast<float>(settings.height)) / 2;
  shot.camera.scale = std::min((static_cast<float>(settings.width) - 2 * kMargin) / size.x(),
                               (static_cast<float>(settings.height) - 2 * kMargin) / size.y());
  addRoom(room.surfaces, room.drawn, {shot.camera.eye.cast<double>(), subject.watched, view.floor},
          shot.triangles);
  return shot;
}

// Whose eyes these are stands at the start where there is no walk.
Shot shootAsWalker(const WalkView& view, const Subject& subject, const RoomModel& room,
                   const ShotSettings& settings) {
  constexpr double kStature = 1.75;  // of whom nothing is known [m]
  Vector3d ground = subject.focus.center();
  double heading = 0.0, stature = kStature;
  if (view.hasBody()) {
    const FrameState& state = view.animation->states[middleFrame(view)];
    const Vector3d& p_WR = view.animation->poses.p_WR(middleFrame(view));
    ground = Vector3d(p_WR.x(), p_WR.y(), state.position.z());
    heading = state.heading;
    const PlacedBody placed = placeBodyAt(view, 0);
    stature = 0.0;
    for (size_t i = 0; i < placed.to.size(); ++i)
      stature = std::max(stature, std::max(placed.from[i].z(), placed.to[i].z()) +
                                      view.body->parts[i].radius -
                                      view.animation->states[0].position.z());
  } else if (view.start) {
    ground = Vector3d(view.start->position.x(), view.start->position.y(), view.start->height);
    heading = view.start->heading.value_or(0.0);
  }
  Shot shot;
  shot.camera.eye = (ground + kEyeHeight * stature * Vector3d::UnitZ()).cast<float>();
  shot.camera.axes =
      viewAxes(Vector3d(std::cos(heading), std::sin(heading), -std::tan(kLookDown)).cast<float>());
  shot.camera.centre =
      Eigen::Vector2f(static_cast<float>(settings.width), static_cast<float>(settings.height)) / 2;
  shot.camera.scale =
      0.5f * static_cast<float>(settings.width) / static_cast<float>(std::tan(kWideView / 2));
  RoomSight sight{shot.camera.eye.cast<double>(), {}, view.floor};
  sight.inside = true;
  addRoom(room.surfaces, room.drawn, sight, shot.triangles);
  return shot;
}

Shot shoot(const WalkView& view, const Subject& subject, const RoomModel& room,
           const ShotSettings& settings) {
  switch (settings.from) {
    case PointOfView::kTop:
      return shootFromAbove(view, subject, room, settings);
    case PointOfView::kSide:
      return chooseShot(view, subject, room, sideDirections(subject), settings);
    case PointOfView::kCorner: {
      std::vector<ViewDirection> corners = cornerDirections(subject.focus);
      if (settings.corner) corners = {corners[*settings.corner]};
      return chooseShot(view, subject, room, corners, settings);
    }
    case PointOfView::kFirst:
      return shootAsWalker(view, subject, room, settings);
  }
  return {};
}

// High, and from between the two walls that are not drawn: both walls that are get light.
Vector3f sunDirection(const Camera& camera) {
  const Vector3f back = -camera.axes.row(2).transpose();
  return {back.x() > 0 ? 0.65f : -0.65f, back.y() > 0 ? 0.48f : -0.48f, 1.0f};
}

}  // namespace

int middleFrame(const WalkView& view) { return view.hasBody() ? view.animation->size() / 2 : 0; }

WalkShot takeShot(const WalkView& view, const ShotSettings& settings) {
  Subject subject;
  subject.watched = watchedPoints(view, settings.frames);
  subject.focus = focusBox(view, subject.watched);
  Shot shot = shoot(view, subject, modelRoom(view, settings.threads), settings);
  addFloorMarks(view, shot.triangles);
  LightSettings light;
  light.threads = settings.threads;
  light.to_sun = sunDirection(shot.camera);
  light.shadowed =
      Eigen::AlignedBox3f(subject.focus.min().cast<float>(), subject.focus.max().cast<float>());
  return {shot.camera, std::move(shot.triangles), light};
}

}  // namespace amble
