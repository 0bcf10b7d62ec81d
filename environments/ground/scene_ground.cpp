#include "environments/ground/scene_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "environments/ground/ground_cells.h"

namespace amble {
namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();
// Of what stands upright, but for rounding, the normal rises by less [1].
constexpr double kUpright = 1e-6;
// Against the rounding of normals: a ramp of exactly the steepest slope is ground.
constexpr double kSlopeRounding = 1e-6;

// Of each triangle whether it could be ground as it lies; `ground` is ground from either side.
std::vector<bool> facingUp(const Scene& scene, const ScenePieces& pieces, double max_slope) {
  const double least = std::cos(max_slope) - kSlopeRounding;
  std::vector<bool> up(pieces.triangles().size(), false);
  for (size_t t = 0; t < up.size(); ++t) {
    const ScenePiece& piece = pieces.pieceOf(static_cast<int>(t));
    const Role role = scene.objects[piece.object].role;
    if (role != Role::kAuto && role != Role::kGround) continue;
    const double nz = upwardness(pieces.triangles()[t]);
    const bool either_side = role == Role::kGround && !piece.closed;
    up[t] = (either_side ? std::abs(nz) : nz) >= least;
  }
  return up;
}

GroundSettings atLevel(double level) {
  GroundSettings settings;
  settings.level = level;
  return settings;
}

}  // namespace

struct SceneGround::Parts {
  ScenePieces pieces;
  TriangleGrid surfaces = {};
  std::optional<GroundCells> cells = {};
};

SceneGround::SceneGround(const Scene& scene, double level) : SceneGround(scene, atLevel(level)) {}

SceneGround::SceneGround(const Scene& scene, const GroundSettings& settings,
                         const StopRequest& stop)
    : settings_(settings),
      parts_(std::make_unique<Parts>(Parts{splitScene(scene, stop)})),
      up_(facingUp(scene, parts_->pieces, settings.limits.max_slope)),
      ground_triangles_(up_.size(), false),
      ground_objects_(scene.objects.size(), false) {
  const ScenePieces& of_scene = parts_->pieces;
  parts_->cells.emplace(scene, of_scene, up_, settings, stop);
  std::vector<Triangle3> ground;
  for (size_t t = 0; t < up_.size(); ++t) {
    const int object = of_scene.pieceOf(static_cast<int>(t)).object;
    if (!up_[t]) continue;
    if (scene.objects[object].role != Role::kGround &&
        !parts_->cells->isGround(of_scene.triangles()[t]))
      continue;
    ground_triangles_[t] = true;
    ground_objects_[object] = true;
    ground.push_back(of_scene.triangles()[t]);
    for (const Eigen::Vector3d& corner : ground.back())
      heights_.extend(Eigen::AlignedBox1d::VectorType(corner.z()));
  }
  parts_->surfaces = TriangleGrid(std::move(ground));
  is_level_ = heights_.isEmpty() || heights_.sizes()[0] <= kLevel;
}

SceneGround::~SceneGround() = default;
SceneGround::SceneGround(SceneGround&&) noexcept = default;

const Eigen::AlignedBox2d& SceneGround::extent() const { return parts_->surfaces.extent(); }
const GroundCells& SceneGround::cells() const { return *parts_->cells; }
const ScenePieces& SceneGround::pieces() const { return parts_->pieces; }
const TriangleGrid& SceneGround::all() const { return parts_->pieces.grid; }
const TriangleGrid& SceneGround::surfaces() const { return parts_->surfaces; }

std::optional<SurfacePoint> SceneGround::surface(double x, double y, double z, double reach) const {
  double best = kNone;
  int found = -1;
  const TriangleGrid& ground = surfaces();
  ground.visitAt(x, y, [&](int t) {
    const auto height = heightOver(ground.triangles()[t], x, y);
    if (!height || std::abs(*height - z) > reach || *height <= best) return;
    best = *height;
    found = t;
  });
  if (found < 0) return std::nullopt;
  const Triangle3& t = ground.triangles()[found];
  const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  return SurfacePoint{best, normal.z() < 0.0 ? Eigen::Vector3d(-normal) : normal};
}

double SceneGround::crest(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double half_width,
                          double low, double high) const {
  const double length = (b - a).norm();
  const Eigen::Vector2d along =
      length > 0.0 ? Eigen::Vector2d((b - a) / length) : Eigen::Vector2d(Eigen::Vector2d::UnitX());
  const Eigen::Vector2d aside(-along.y(), along.x());
  const Eigen::AlignedBox2d strip(Eigen::Vector2d(0.0, -half_width),
                                  Eigen::Vector2d(length, half_width));
  Eigen::AlignedBox2d plan;
  for (const Eigen::Vector2d& end : {a, b})
    for (const double side : {half_width, -half_width}) plan.extend(end + side * aside);
  double highest = kNone;
  const TriangleGrid& things = all();
  things.visitBox(plan, [&](int t) {
    Triangle3 local = things.triangles()[t];
    const auto [bottom, top] = std::minmax({local[0].z(), local[1].z(), local[2].z()});
    if (top <= highest || top < low || bottom > high) return;  // which most are
    // The half of a wall's side that its diagonal bounds does not end there.
    if (top > high && std::abs(upwardness(local)) < kUpright) return;
    for (Eigen::Vector3d& corner : local) {
      const Eigen::Vector2d p = corner.head<2>() - a;
      corner.head<2>() << along.dot(p), aside.dot(p);
    }
    const auto heights = heightsWithin(local, strip);
    if (heights && heights->high >= low && heights->high <= high)
      highest = std::max(highest, heights->high);
  });
  return highest;
}

std::optional<SurfacePoint> SceneGround::stand(double x, double y, double z, double reach) const {
  const auto over = [&](double floor) { return surface(x, y, floor, kLevel); };
  if (is_level_) {
    if (heights_.isEmpty() || std::abs(heights_.min()[0] - z) > reach + kLevel) return std::nullopt;
    return over(heights_.min()[0]);
  }
  std::optional<double> nearest;
  for (const double floor : floors(x, y))
    if (!nearest || std::abs(floor - z) < std::abs(*nearest - z)) nearest = floor;
  if (!nearest || std::abs(*nearest - z) > reach) return std::nullopt;
  return over(*nearest);
}

// Heights of all ground there, lowest first; where there is none, of what could be.
std::vector<double> SceneGround::levels(double x, double y) const {
  std::vector<double> ground, any;
  const auto collect = [&](const TriangleGrid& grid, int t, std::vector<double>& out) {
    if (const auto z = heightOver(grid.triangles()[t], x, y)) out.push_back(*z);
  };
  surfaces().visitAt(x, y, [&](int t) { collect(surfaces(), t, ground); });
  if (ground.empty()) {
    all().visitAt(x, y, [&](int t) {
      if (up_[t]) collect(all(), t, any);
    });
  }
  std::vector<double>& heights = ground.empty() ? any : ground;
  std::sort(heights.begin(), heights.end());
  return heights;
}

// Of heights, lowest first, those over which is room, one of each level.
std::vector<double> SceneGround::uncovered(const std::vector<double>& heights) const {
  std::vector<double> floors;
  for (size_t i = 0; i < heights.size(); ++i) {
    // Covered by other ground: what lies under a kerb or a low stair is no floor.
    const bool covered = std::any_of(heights.begin(), heights.end(), [&](double z) {
      return z > heights[i] + kLevel && z < heights[i] + settings_.headroom;
    });
    if (covered || (!floors.empty() && heights[i] - floors.back() <= kLevel)) continue;
    floors.push_back(heights[i]);
  }
  return floors;
}

std::vector<double> SceneGround::floors(double x, double y) const {
  return uncovered(levels(x, y));
}

// What of the cells a floor is part of: of the ground nearest to p in the squares about it; -1 for
// none.
int SceneGround::floorOf(const Eigen::Vector3d& p) const {
  const GroundCells& squares = cells();
  const Eigen::Vector2i at = squares.squareAt(p.head<2>());
  const double most = kLevel + std::tan(settings_.limits.max_slope) * 1.5 * squares.cell();
  int found = -1;
  double nearest = std::numeric_limits<double>::infinity();
  for (int row = at.y() - 1; row <= at.y() + 1; ++row) {
    for (int column = at.x() - 1; column <= at.x() + 1; ++column) {
      for (const GroundCells::Span& span : squares.spans(column, row)) {
        const double off = std::abs(span.height - p.z());
        if (span.floor < 0 || off > most) continue;
        const double apart = off + (squares.middle(column, row) - p.head<2>()).norm();
        if (apart >= nearest) continue;
        nearest = apart;
        found = span.floor;
      }
    }
  }
  return found;
}

std::vector<double> SceneGround::mainFloors(double x, double y) const {
  const std::vector<double> all = levels(x, y);
  std::vector<int> floor_of;
  int largest = -1;
  for (const double height : all) {
    floor_of.push_back(floorOf({x, y, height}));
    if (cells().area(floor_of.back()) > cells().area(largest)) largest = floor_of.back();
  }
  if (largest < 0) return uncovered(all);
  std::vector<double> main;
  for (size_t i = 0; i < all.size(); ++i)
    if (floor_of[i] == largest) main.push_back(all[i]);
  return uncovered(main);
}

}  // namespace amble
