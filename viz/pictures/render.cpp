#include "viz/pictures/render.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "base/rotation.h"
#include "base/text.h"
#include "viz/pictures/draw_mesh.h"
#include "viz/pictures/lighting.h"
#include "viz/pictures/room.h"
#include "viz/pictures/tiny_text.h"

namespace amble {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kWholeRoom = 14.0;  // a scene no longer than this is shown whole [m]
constexpr double kAround = 2.0;      // of a larger one so much is shown around the walk [m]
// What must fit into the picture above the floor, where it is there [m].
constexpr double kHeadroom = 2.5;
constexpr double kPlaceLift = 0.003;  // of the marks of start and goal above the floor [m]
constexpr double kPathLift = 0.006;   // of the path's ribbon above the floor [m]
constexpr double kPrintLift = 0.009;  // of footprints: over the path [m]
constexpr float kMargin = 28;         // about the room [pixels]
constexpr double kElevation = 0.72;   // of the eye above the horizon [rad]

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
      if (place) places.emplace_back(place->position.x(), place->position.y(), view.floor);
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
    around.min().array() -= kAround;
    around.max().array() += kAround;
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

struct Shot {
  Camera camera;
  std::vector<DrawTriangle> triangles;  // of the room
};

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

// The corner from which the most of the walk is seen, and widest; the first of equals.
Shot chooseShot(const WalkView& view, const AlignedBox3d& focus,
                const std::vector<Vector3d>& watched, const RenderSettings& settings) {
  constexpr int kSmall = 4;  // the trial pictures are so many times smaller
  const std::vector<RoomSurface> room = sortRoom(*view.scene, view.floor);
  const DrawnSurfaces drawn = drawSurfaces(room, settings.threads);
  const std::vector<Vector3f> points = corners(focus);
  const bool wide = focus.sizes().x() >= focus.sizes().y();
  const double turn = wide ? 62 * kPi / 180 : 28 * kPi / 180;
  const std::array<double, 4> azimuths = {-turn, turn - kPi, turn, kPi - turn};
  std::array<Shot, 4> shots;
  std::array<double, 4> worth = {};
  parallelFor(4, settings.threads, [&](int i, int) {
    Shot& shot = shots[i];
    shot.camera =
        frameView(points, {azimuths[i], kElevation}, settings.width, settings.height, kMargin);
    addRoom(room, drawn, {shot.camera.eye.cast<double>(), watched, view.floor}, shot.triangles);
    const double seen = visibleCount(shot.triangles, shot.camera.enlarged(1.0f / kSmall),
                                     settings.width / kSmall, settings.height / kSmall, watched, 1);
    worth[i] = seen * seen * spreadOf(shot.camera, watched);  // hidden counts more: by trial
  });
  return std::move(shots[std::max_element(worth.begin(), worth.end()) - worth.begin()]);
}

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

void addFloorMarks(const WalkView& view, std::vector<DrawTriangle>& triangles) {
  for (const PlaceView& place : view.via)
    addPlace(place, view.floor + kPlaceLift, rgb(109, 91, 176), triangles);
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

// High, and from between the two walls that are not drawn: both walls that are get light.
Vector3f sunDirection(const Camera& camera) {
  const Vector3f back = -camera.axes.row(2).transpose();
  return {back.x() > 0 ? 0.65f : -0.65f, back.y() > 0 ? 0.48f : -0.48f, 1.0f};
}

// "0 s [colours] 9.5 s" in the lower left corner.
void drawTimeBar(Image& image, double duration) {
  constexpr int kBar = 260, kThick = 14, kDot = 2, kIndent = 26;
  const int y = image.height - kIndent - kThick;
  const Color ink = rgb(70, 74, 82);
  const std::string end = fixedNumber(duration, 1) + " s";
  const int plate = textWidth("0 s " + end, kDot) + kBar + 4 * kDot + 20;
  fillRect(image, kIndent - 10, y - 8, plate, kThick + 16, rgb(246, 247, 249));
  drawText(image, kIndent, y, "0 s", kDot, ink);
  const int x = kIndent + textWidth("0 s ", kDot);
  for (int i = 0; i < kBar; ++i) fillRect(image, x + i, y, 1, kThick, timeColor((i + 0.5) / kBar));
  drawText(image, x + kBar + 4 * kDot, y, end, kDot, ink);
}

}  // namespace

std::vector<int> bodyFrames(const WalkView& view, const RenderSettings& settings) {
  if (!view.hasBody()) return {};
  const PoseArray& poses = view.animation->poses;
  const int last = view.animation->size() - 1;
  const int step =
      std::max(1, static_cast<int>(std::lround(settings.every / view.animation->frame_time)));
  const auto merges = [&](int a, int b) {
    return (poses.p_WR(a) - poses.p_WR(b)).norm() < settings.apart;
  };
  std::vector<int> frames = {0};
  for (int frame = step; frame <= last; ++frame) {
    if (frame - frames.back() >= step && !merges(frame, frames.back())) frames.push_back(frame);
  }
  // The last stands for one that it would merge with.
  if (frames.back() == last) return frames;
  const bool near = last - frames.back() <= step / 2 || merges(last, frames.back());
  if (near && frames.size() > 1) frames.pop_back();
  if (!near || !merges(last, 0)) frames.push_back(last);
  return frames;
}

WalkShot takeShot(const WalkView& view, const RenderSettings& settings) {
  const std::vector<Vector3d> watched = watchedPoints(view, bodyFrames(view, settings));
  const AlignedBox3d focus = focusBox(view, watched);
  Shot shot = chooseShot(view, focus, watched, settings);
  addFloorMarks(view, shot.triangles);
  LightSettings light;
  light.threads = settings.threads;
  light.to_sun = sunDirection(shot.camera);
  light.shadowed = Eigen::AlignedBox3f(focus.min().cast<float>(), focus.max().cast<float>());
  return {shot.camera, std::move(shot.triangles), light};
}

Image renderWalk(const WalkView& view, const RenderSettings& settings) {
  WalkShot shot = takeShot(view, settings);
  const std::vector<int> frames = bodyFrames(view, settings);
  for (const int frame : frames) {
    const double share = static_cast<double>(frame) / std::max(1, view.animation->size() - 1);
    const std::vector<Color> colors(view.body->parts.size(), timeColor(share));
    addBody(view, frame, colors, shot.triangles);
  }
  const Camera large = shot.camera.enlarged(kSupersampling);
  const SampleBuffer samples = rasterize(shot.triangles, large, settings.width * kSupersampling,
                                         settings.height * kSupersampling, settings.threads);
  Image image = lightSamples(samples, large, shot.triangles, shot.light);
  if (!frames.empty())
    drawTimeBar(image, (view.animation->size() - 1) * view.animation->frame_time);
  return image;
}

}  // namespace amble
