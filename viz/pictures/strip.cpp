// The film strip: renderStrip of viz/pictures/render.h.
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "base/text.h"
#include "viz/pictures/draw_mesh.h"
#include "viz/pictures/lighting.h"
#include "viz/pictures/render.h"
#include "viz/pictures/section.h"
#include "viz/pictures/tiny_text.h"

namespace amble {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kBelow = 0.076;     // how much is shown below the floor [window]
constexpr double kTick = 0.1;        // between the marks of the floor [m]
constexpr double kLevelView = 0.02;  // an eye lower than this sees the floor as a line [rad]
constexpr float kSinkTint = 0.75f;   // how red a body is drawn below the floor

const Color kTrunk = rgb(176, 178, 184);
const Color kEarth = rgb(222, 214, 200);
const Color kLineColor = rgb(60, 62, 70);

std::vector<Color> limbColors(const Body& body) {
  std::vector<Color> colors;
  for (const BodyPart& part : body.parts) {
    const bool left = part.name.find("left") != std::string::npos;
    const bool right = part.name.find("right") != std::string::npos;
    const bool leg = part.sole >= 0 || part.name.find("arm") == std::string::npos;
    const Color side = sideColor(left ? kLeft : kRight);
    colors.push_back(!left && !right ? kTrunk : leg ? side : mix(side, kTrunk, 0.45f));
  }
  return colors;
}

// Of the ground under the walker; the view's floor where frames do not say [m].
double groundUnder(const WalkView& view, int frame) {
  const std::vector<FrameState>& states = view.animation->states;
  return states.empty() ? view.floor : states[static_cast<size_t>(frame)].position.z();
}

// A parallel view of the walker at a frame; the picture's middle column is the root's.
Camera tileCamera(const WalkView& view, int frame, const StripSettings& settings) {
  const Vector3d root = view.animation->poses.p_WR(frame);
  const double azimuth = view.animation->states[frame].heading + settings.side;
  const double level = std::cos(settings.lift);
  const Vector3d back(level * std::cos(azimuth), level * std::sin(azimuth),
                      std::sin(settings.lift));
  const Vector3d middle(root.x(), root.y(),
                        groundUnder(view, frame) + (0.5 - kBelow) * settings.window);
  Camera camera;
  camera.parallel = true;
  camera.axes = viewAxes((-back).cast<float>());
  camera.eye = (middle + 4 * back).cast<float>();
  camera.centre = Eigen::Vector2f(static_cast<float>(settings.tile_width),
                                  static_cast<float>(settings.tile_height)) /
                  2;
  camera.scale = static_cast<float>(settings.tile_height / settings.window);
  return camera;
}

// What each foot stands on in a frame, stood on last and comes to next.
std::vector<Footprint> printsAround(const WalkView& view, int frame) {
  std::vector<Footprint> around;
  for (const Side side : {kLeft, kRight}) {
    const Footprint *here = nullptr, *next = nullptr;
    for (const Footprint& print : view.animation->footprints) {
      if (print.side != side) continue;
      if (print.first_frame <= frame) here = &print;
      if (print.first_frame > frame && next == nullptr) next = &print;
    }
    if (here != nullptr) around.push_back(*here);
    if (next != nullptr) around.push_back(*next);
  }
  return around;
}

// What the camera has to its right, level.
Vector3d rightOf(const Camera& camera) { return camera.axes.row(0).transpose().cast<double>(); }

// The ground's row in each column of a tile, in the walker's plane: -1 where there is none.
std::vector<int> groundRows(const WalkView& view, int frame, const Camera& camera, int width) {
  constexpr double kReach = 1.0;  // from where the walker stands to what is ground beside him [m]
  const Vector3d root = view.animation->poses.p_WR(frame), right = rightOf(camera);
  const double level = groundUnder(view, frame);
  std::vector<int> rows(width, -1);
  for (int x = 0; x < width; ++x) {
    const Vector3d at = root + (x + 0.5 - 0.5 * width) / camera.scale * right;
    const auto height = view.ground->height(at.x(), at.y(), level, kReach);
    if (!height) continue;
    const Vector3f on(static_cast<float>(at.x()), static_cast<float>(at.y()),
                      static_cast<float>(*height));
    rows[x] = static_cast<int>(std::lround(camera.toPixel(camera.toView(on)).y()));
  }
  return rows;
}

// The same where the ground is not known: a print's under its sole, the lower of two that lie
// behind one another; elsewhere that of the lowest print.
std::vector<int> printRows(const WalkView& view, int frame, const Camera& camera, int width) {
  const auto pixel = [&](const Vector3d& p) {
    return camera.toPixel(camera.toView(p.cast<float>()));
  };
  const Vector3d root = view.animation->poses.p_WR(frame);
  const std::vector<Footprint> prints = printsAround(view, frame);
  double lowest = prints.empty() ? groundUnder(view, frame) : prints[0].position.z();
  for (const Footprint& print : prints) lowest = std::min(lowest, print.position.z());
  const auto rowOf = [&](double z) {
    return static_cast<int>(std::lround(pixel({root.x(), root.y(), z}).y()));
  };
  std::vector<int> under(width, -1);
  for (const Footprint& print : prints) {
    const Vector3d half =
        soleLength(view) / 2 * Vector3d(std::cos(print.heading), std::sin(print.heading), 0);
    const float a = pixel(print.position - half).x(), b = pixel(print.position + half).x();
    const int first = std::max(0, static_cast<int>(std::floor(std::min(a, b))));
    const int last = std::min(width - 1, static_cast<int>(std::ceil(std::max(a, b))));
    for (int x = first; x <= last; ++x) under[x] = std::max(under[x], rowOf(print.position.z()));
  }
  for (int& row : under) {
    if (row < 0) row = rowOf(lowest);
  }
  return under;
}

// Pixels of a tile.
struct TileWindow {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

// Where anything of these is seen, with what darkens there.
TileWindow windowOf(const std::vector<DrawTriangle>& triangles, const Camera& camera, int width,
                    int height) {
  constexpr float kMargin = 4;  // of rounding, and of what smooths corners [pixels]
  constexpr int kGrid = 4;      // what the noise of corners repeats after [pixels]
  Eigen::Vector2f low = Eigen::Vector2f::Constant(1e9f), high = -low;
  for (const DrawTriangle& triangle : triangles) {
    for (const Vector3f& p : triangle.p) {
      const Eigen::Vector2f pixel = camera.toPixel(camera.toView(p));
      low = low.cwiseMin(pixel);
      high = high.cwiseMax(pixel);
    }
  }
  const auto within = [](float at, int most) {
    return static_cast<int>(std::clamp(at, 0.0f, static_cast<float>(most)));
  };
  TileWindow window = {within(low.x() - kMargin, width) / kGrid * kGrid,
                       within(low.y() - kMargin, height) / kGrid * kGrid,
                       within(std::ceil(high.x()) + kMargin, width),
                       within(std::ceil(high.y()) + kMargin, height)};
  if (window.x1 <= window.x0 || window.y1 <= window.y0) window = {0, 0, kGrid, kGrid};
  return window;
}

// A tile, and the samples of what of it there is anything in.
struct LitTile {
  Image image;
  TileWindow window;
  SampleBuffer samples;

  bool shows(int x, int y) const {
    return x >= window.x0 && x < window.x1 && y >= window.y0 && y < window.y1 &&
           samples.depth[samples.index((x - window.x0) * kSupersampling,
                                       (y - window.y0) * kSupersampling)] > 0;
  }
};

LitTile lightTile(const std::vector<DrawTriangle>& triangles, const Camera& camera,
                  const TileWindow& window, const LightSettings& light,
                  const StripSettings& settings) {
  Camera part = camera.enlarged(kSupersampling);
  part.centre -= kSupersampling *
                 Eigen::Vector2f(static_cast<float>(window.x0), static_cast<float>(window.y0));
  const int width = window.x1 - window.x0, height = window.y1 - window.y0;
  LitTile tile{Image(settings.tile_width, settings.tile_height), window,
               rasterize(triangles, part, width * kSupersampling, height * kSupersampling)};
  fillRect(tile.image, 0, 0, settings.tile_width, settings.tile_height, light.background);
  const Image lit = lightSamples(tile.samples, part, triangles, light);
  for (int y = 0; y < height; ++y)
    std::copy_n(lit.pixel(0, y), static_cast<size_t>(width) * 3,
                tile.image.pixel(window.x0, window.y0 + y));
  return tile;
}

// The floor from the side: a line with a mark every 10 cm of World, so that a sliding foot shows;
// what of the body is below it is drawn red.
void drawFloorLine(const std::vector<int>& rows, double floor, const Camera& camera, LitTile& lit) {
  Image& tile = lit.image;
  for (int x = 0; x < tile.width; ++x) {
    if (rows[x] < 0) continue;
    for (int y = rows[x]; y < tile.height; ++y) {
      const uint8_t* old = tile.pixel(x, y);
      const Color sunk = mix(rgb(old[0], old[1], old[2]), rgb(220, 20, 20), kSinkTint);
      fillRect(tile, x, y, 1, 1, lit.shows(x, y) ? sunk : kEarth);
    }
    fillRect(tile, x, rows[x], 1, 1, kLineColor);
  }
  const Vector3d on_floor(camera.eye.x(), camera.eye.y(), floor);
  const Vector3d right = rightOf(camera);
  const double middle = right.dot(on_floor);
  const double half = tile.width / (2.0 * camera.scale);
  for (int i = static_cast<int>(std::ceil((middle - half) / kTick)); i * kTick <= middle + half;
       ++i) {
    const Vector3d mark = on_floor + (i * kTick - middle) * right;
    const int x =
        static_cast<int>(std::lround(camera.toPixel(camera.toView(mark.cast<float>())).x()));
    if (x >= 0 && x < tile.width && rows[x] >= 0)
      fillRect(tile, x, rows[x], 1, i % 5 == 0 ? 12 : 5, kLineColor);
  }
}

// What the walker's plane cuts of the scene, as lines.
void drawSection(const WalkView& view, int frame, const SceneSection& section, const Camera& camera,
                 Image& tile) {
  const Vector3d root = view.animation->poses.p_WR(frame), right = rightOf(camera);
  const auto pixel = [&](const Vector2d& p) -> Eigen::Vector2f {
    const Vector3d at(root.x() + p.x() * right.x(), root.y() + p.x() * right.y(), p.y());
    return camera.toPixel(camera.toView(at.cast<float>()));
  };
  const double reach = tile.width / (2.0 * camera.scale);
  for (const SectionLine& line : section.cut(root, right, reach)) {
    const Eigen::Vector2f a = pixel(line.from), b = pixel(line.to);
    const int steps = std::clamp(static_cast<int>((b - a).cwiseAbs().maxCoeff()) + 1, 1, 4096);
    for (int i = 0; i <= steps; ++i) {
      const Eigen::Vector2f at = a + static_cast<float>(i) / static_cast<float>(steps) * (b - a);
      fillRect(tile, static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y())),
               1, 1, kLineColor);
    }
  }
}

// A bar below the floor's line under each foot that is planted in this frame.
void drawPlants(const WalkView& view, int frame, const Camera& camera, Image& tile) {
  const double length = soleLength(view);
  for (const Footprint& print : view.animation->footprints) {
    if (frame < print.first_frame || frame > print.last_frame) continue;
    const Vector3d along(std::cos(print.heading), std::sin(print.heading), 0);
    const Vector3d heel = print.position - along * (length / 2),
                   toe = print.position + along * (length / 2);
    const auto a = camera.toPixel(camera.toView(heel.cast<float>()));
    const auto b = camera.toPixel(camera.toView(toe.cast<float>()));
    const int x = static_cast<int>(std::lround(std::min(a.x(), b.x())));
    const int width = std::max(2, static_cast<int>(std::lround(std::abs(a.x() - b.x()))));
    fillRect(tile, x, static_cast<int>(std::lround(a.y())) + 14 + (print.side == kRight ? 5 : 0),
             width, 4, sideColor(print.side));
  }
}

void addFloorAround(const WalkView& view, int frame, std::vector<DrawTriangle>& triangles) {
  constexpr double kHalf = 2.0;  // [m]
  const Vector3d root = view.animation->poses.p_WR(frame);
  const auto snap = [](double v) { return std::round(v / kTick) * kTick; };
  const Vector2d middle(snap(root.x()), snap(root.y()));
  TriangleMesh floor = makeBox({2 * kHalf, 2 * kHalf, 0.02});
  const double level = groundUnder(view, frame);
  for (Vector3d& p : floor.vertices) p += Vector3d(middle.x(), middle.y(), level - 0.01);
  addMesh(floor, kEarth, kNoShadow, triangles);
  for (double d = -kHalf; d <= kHalf + 1e-9; d += kTick) {
    const std::vector<Vector2d> across = {middle + Vector2d(d, -kHalf),
                                          middle + Vector2d(d, kHalf)};
    const std::vector<Vector2d> along = {middle + Vector2d(-kHalf, d), middle + Vector2d(kHalf, d)};
    addRibbon(across, 0.004, level, mix(kEarth, kLineColor, 0.25f), triangles);
    addRibbon(along, 0.004, level, mix(kEarth, kLineColor, 0.25f), triangles);
  }
  for (const Footprint& print : view.animation->footprints)
    if (frame >= print.first_frame && frame <= print.last_frame)
      addPolygon(placedShoe(print, soleLength(view)), print.position.z(),
                 mix(sideColor(print.side), kEarth, 0.35f), triangles);
}

Image renderTile(const WalkView& view, int frame, const SceneSection& section,
                 const StripSettings& settings) {
  const bool level = std::abs(settings.lift) < kLevelView;
  std::vector<DrawTriangle> triangles;
  addBody(view, frame, limbColors(*view.body), triangles);
  if (!level) addFloorAround(view, frame, triangles);
  const Camera camera = tileCamera(view, frame, settings);
  LightSettings light;
  light.background = rgb(250, 250, 251);
  const Vector3f back = -camera.axes.row(2).transpose();
  light.to_sun = Vector3f(back.x(), back.y(), 0) * 0.8f + Vector3f(0.1f, 0.2f, 1.0f);
  const Vector3f root = view.animation->poses.p_WR(frame).cast<float>();
  light.shadowed =
      Eigen::AlignedBox3f(root - Vector3f::Constant(1.2f), root + Vector3f::Constant(1.2f));
  light.shadow_size = 512;
  const int width = settings.tile_width, height = settings.tile_height;
  const TileWindow window =
      level ? windowOf(triangles, camera, width, height) : TileWindow{0, 0, width, height};
  LitTile lit = lightTile(triangles, camera, window, light, settings);
  Image& tile = lit.image;
  if (level) {
    const auto rows = view.ground != nullptr ? groundRows : printRows;
    drawFloorLine(rows(view, frame, camera, width), groundUnder(view, frame), camera, lit);
    drawSection(view, frame, section, camera, tile);
    drawPlants(view, frame, camera, tile);
  }
  const double time = frame * view.animation->frame_time;
  drawText(tile, 6, 6, std::to_string(frame) + "  " + fixedNumber(time, 3) + " s", 2, kLineColor);
  fillRect(tile, 0, 0, 1, height, mix(kLineColor, light.background, 0.7f));
  return std::move(lit.image);
}

// The window of a tile is told for an adult.
StripSettings fitted(const WalkView& view, StripSettings settings) {
  constexpr double kAdult = 1.75;  // [m]
  const PlacedBody placed = placeBodyAt(view, 0);
  double crown = 0.0;
  for (size_t i = 0; i < placed.to.size(); ++i)
    crown = std::max(crown, std::max(placed.from[i].z(), placed.to[i].z()) +
                                view.body->parts[i].radius - groundUnder(view, 0));
  settings.window *= crown / kAdult;
  return settings;
}

}  // namespace

StripSettings stripOfWhole(const AnimationBuffer& walk) {
  constexpr double kEvery = 0.1;  // [s]
  constexpr int kMost = 120;      // pictures
  StripSettings settings;
  const int usual = static_cast<int>(std::lround(kEvery / walk.frame_time));
  settings.step = std::max({1, usual, (walk.size() + kMost - 1) / kMost});
  settings.pictures = kMost;
  settings.columns = 12;
  return settings;
}

Image renderStrip(const WalkView& view, const StripSettings& asked) {
  if (!view.hasBody()) return Image(asked.tile_width, asked.tile_height);
  const StripSettings settings = fitted(view, asked);
  const SceneSection section(*view.scene);
  const int left = view.animation->size() - std::max(0, settings.first);
  const int count = std::clamp((left + settings.step - 1) / settings.step, 1, settings.pictures);
  const int columns = std::min(settings.columns, count);
  const int rows = (count + columns - 1) / columns;
  Image strip(columns * settings.tile_width, rows * settings.tile_height);
  std::fill(strip.rgb.begin(), strip.rgb.end(), uint8_t{250});
  parallelFor(count, settings.threads, [&](int i, int) {
    const int frame = std::min(settings.first + i * settings.step, view.animation->size() - 1);
    const Image tile = renderTile(view, frame, section, settings);
    const int x = i % columns * settings.tile_width, y = i / columns * settings.tile_height;
    for (int row = 0; row < tile.height; ++row)
      std::copy_n(tile.pixel(0, row), static_cast<size_t>(tile.width) * 3, strip.pixel(x, y + row));
  });
  return strip;
}

}  // namespace amble
