#include "environments/ground/scene_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.h"
#include "environments/ground/ground_cells.h"
#include "environments/ground/ground_patches.h"
#include "environments/ground/plan_strip.h"
#include "environments/ground/plan_triangle.h"

namespace amble {
namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();
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

// Unit, upwards.
std::vector<Eigen::Vector3d> upwardNormals(const std::vector<Triangle3>& triangles) {
  std::vector<Eigen::Vector3d> normals;
  normals.reserve(triangles.size());
  for (const Triangle3& t : triangles) {
    const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    normals.push_back(normal.z() < 0.0 ? Eigen::Vector3d(-normal) : normal);
  }
  return normals;
}

HeightRange heightsOf(const Triangle3& t) {
  const auto [low, high] = std::minmax({t[0].z(), t[1].z(), t[2].z()});
  return {low, high};
}

// Whether a triangle may have its highest point over some strip between two heights.
bool mayEndBetween(const Triangle3& t, const HeightRange& own, double low, double high) {
  if (own.high < low || own.low > high) return false;  // which most are
  // The half of a wall's side that its diagonal bounds does not end there.
  return own.high <= high || std::abs(upwardness(t)) >= GroundPatches::kUpright;
}

// A triangle along a line.
struct Thing {
  double top, begin, end;  // along the line
  StripPlane plane;
  int triangle;
  // Pieces that reach beyond both have some of it in them; empty where that is not known.
  double sure_begin, sure_end;

  // The highest first, of those the ones that are level: they are quick.
  bool operator<(const Thing& other) const {
    if (top != other.top) return top > other.top;
    const bool is_level = sure_begin < sure_end, others = other.sure_begin < other.sure_end;
    return is_level != others ? is_level : triangle < other.triangle;
  }
};

// The highest of the levels, lowest first, that is within reach.
std::optional<SurfacePoint> highestWithin(std::span<const double> levels, double z, double reach) {
  for (size_t k = levels.size(); k-- > 0;)
    if (!(std::abs(levels[k] - z) > reach)) return SurfacePoint{levels[k]};
  return std::nullopt;
}

GroundSettings atLevel(double level) {
  GroundSettings settings;
  settings.level = level;
  return settings;
}

}  // namespace

struct SceneGround::Parts {
  std::shared_ptr<const ScenePieces> pieces;
  TriangleGrid surfaces = {};
  std::vector<Eigen::Vector3d> normals = {};  // of the surfaces
  std::vector<HeightRange> heights = {};      // of all triangles
  std::optional<GroundCells> cells = {};
  std::unique_ptr<const GroundPatches> patches = {};

  // Of each triangle whether it is ground; each thread has its own bytes.
  std::vector<uint8_t> groundOf(const Scene& scene, const std::vector<bool>& up) const {
    constexpr size_t kAtATime = 256;
    std::vector<uint8_t> is_ground(up.size(), 0);
    const size_t shares = (up.size() + kAtATime - 1) / kAtATime;
    parallelFor(static_cast<int>(shares), usualThreads(), [&](int share, int) {
      const size_t begin = share * kAtATime, end = std::min(up.size(), begin + kAtATime);
      for (size_t t = begin; t < end; ++t) {
        const int object = pieces->pieceOf(static_cast<int>(t)).object;
        is_ground[t] = up[t] && (scene.objects[object].role == Role::kGround ||
                                 cells->isGround(pieces->triangles()[t]));
      }
    });
    return is_ground;
  }
};

SceneGround::SceneGround(const Scene& scene, double level) : SceneGround(scene, atLevel(level)) {}

SceneGround::SceneGround(const Scene& scene, const GroundSettings& settings,
                         const StopRequest& stop)
    : SceneGround(scene, std::make_shared<const ScenePieces>(splitScene(scene, stop)), settings,
                  stop) {}

SceneGround::SceneGround(const Scene& scene, std::shared_ptr<const ScenePieces> pieces,
                         const GroundSettings& settings, const StopRequest& stop)
    : settings_(settings),
      parts_(std::make_unique<Parts>(Parts{std::move(pieces)})),
      up_(facingUp(scene, *parts_->pieces, settings.limits.max_slope)),
      ground_triangles_(up_.size(), false),
      ground_objects_(scene.objects.size(), false) {
  const ScenePieces& of_scene = *parts_->pieces;
  parts_->cells.emplace(scene, of_scene, up_, settings, stop);
  const std::vector<uint8_t> is_ground = parts_->groundOf(scene, up_);
  std::vector<Triangle3> ground;
  for (size_t t = 0; t < up_.size(); ++t) {
    if (!is_ground[t]) continue;
    const int object = of_scene.pieceOf(static_cast<int>(t)).object;
    ground_triangles_[t] = true;
    ground_objects_[object] = true;
    ground.push_back(of_scene.triangles()[t]);
    for (const Eigen::Vector3d& corner : ground.back())
      heights_.extend(Eigen::AlignedBox1d::VectorType(corner.z()));
  }
  parts_->normals = upwardNormals(ground);
  parts_->heights.reserve(up_.size());
  for (const Triangle3& t : of_scene.triangles()) parts_->heights.push_back(heightsOf(t));
  parts_->surfaces = TriangleGrid(std::move(ground));
  parts_->patches = std::make_unique<const GroundPatches>(parts_->surfaces, of_scene.grid);
  all_level_ = std::ranges::all_of(parts_->surfaces.triangles(), amble::isLevel);
  is_level_ = heights_.isEmpty() || heights_.sizes()[0] <= kLevel;
}

SceneGround::~SceneGround() = default;
SceneGround::SceneGround(SceneGround&&) noexcept = default;

const Eigen::AlignedBox2d& SceneGround::extent() const { return parts_->surfaces.extent(); }
const GroundCells& SceneGround::cells() const { return *parts_->cells; }
const ScenePieces& SceneGround::pieces() const { return *parts_->pieces; }
const TriangleGrid& SceneGround::all() const { return parts_->pieces->grid; }
const TriangleGrid& SceneGround::surfaces() const { return parts_->surfaces; }

SurfacePoint SceneGround::pointOf(int triangle, double height) const {
  return {height, parts_->normals[triangle]};
}

std::optional<SurfacePoint> SceneGround::surface(double x, double y, double z, double reach) const {
  if (const auto levels = parts_->patches->levelsAt(x, y)) return highestWithin(*levels, z, reach);
  return surfaceOfTriangles(x, y, z, reach);
}

std::optional<SurfacePoint> SceneGround::surfaceOfTriangles(double x, double y, double z,
                                                            double reach) const {
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
  return pointOf(found, best);
}

// The triangles near the points are looked for once, in the order in which surface() sees them.
void SceneGround::surfacesOfTriangles(std::span<const Eigen::Vector2d> points, double z,
                                      double reach,
                                      std::span<std::optional<SurfacePoint>> out) const {
  Eigen::AlignedBox2d plan;
  for (const Eigen::Vector2d& p : points) plan.extend(p);
  plan = {plan.min().array() - kSeam, plan.max().array() + kSeam};
  const TriangleGrid& ground = surfaces();
  struct Near {
    int triangle;
    Eigen::AlignedBox3d box;

    bool isBeside(const Eigen::Vector2d& p) const {
      return p.x() < box.min().x() - kSeam || p.x() > box.max().x() + kSeam ||
             p.y() < box.min().y() - kSeam || p.y() > box.max().y() + kSeam;
    }
  };
  std::vector<Near> near;
  ground.visitBox(plan, [&](int t) {
    const auto& [a, b, c] = ground.triangles()[t];
    const Eigen::AlignedBox3d box(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c));
    if (box.max().z() < z - reach - kTouching || box.min().z() > z + reach + kTouching) return;
    if ((box.min().head<2>().array() > plan.max().array()).any() ||
        (box.max().head<2>().array() < plan.min().array()).any())
      return;
    near.push_back({t, box});
  });
  std::sort(near.begin(), near.end(),
            [](const Near& a, const Near& b) { return a.triangle < b.triangle; });
  const auto same = [](const Near& a, const Near& b) { return a.triangle == b.triangle; };
  near.erase(std::unique(near.begin(), near.end(), same), near.end());
  for (size_t i = 0; i < points.size(); ++i) {
    double best = kNone;
    int found = -1;
    for (const Near& one : near) {
      if (one.isBeside(points[i]) || one.box.max().z() <= best) continue;
      const auto height =
          heightOver(ground.triangles()[one.triangle], points[i].x(), points[i].y());
      if (!height || std::abs(*height - z) > reach || *height <= best) continue;
      best = *height;
      found = one.triangle;
    }
    out[i].reset();
    if (found >= 0) out[i] = pointOf(found, best);
  }
}

// Few that are left to the triangles are cheaper one by one.
void SceneGround::surfaces(std::span<const Eigen::Vector2d> points, double z, double reach,
                           std::span<std::optional<SurfacePoint>> out) const {
  constexpr size_t kFew = 8;
  std::vector<int> left;
  for (size_t i = 0; i < points.size(); ++i) {
    const auto levels = parts_->patches->levelsAt(points[i].x(), points[i].y());
    if (levels)
      out[i] = highestWithin(*levels, z, reach);
    else
      left.push_back(static_cast<int>(i));
    if (left.size() > kFew) return surfacesOfTriangles(points, z, reach, out);
  }
  for (const int i : left) out[i] = surfaceOfTriangles(points[i].x(), points[i].y(), z, reach);
}

std::optional<double> SceneGround::levelOver(const Eigen::AlignedBox2d& box, double z,
                                             double reach) const {
  return parts_->patches->levelOver(box, z, reach);
}

// Calls visit_one(triangle) for all that may have a highest point over a part of the strip between
// the two heights, and for others.
template <typename Visit>
void SceneGround::visitEnding(const PlanStrip& strip, double low, double high,
                              Visit visit_one) const {
  const auto ending = parts_->patches->endingOver(strip, low, high);
  if (ending)
    for (const int t : *ending) visit_one(t);
  else
    all().visitBox(strip.plan(), visit_one);
}

// Of one triangle, where it is `needed` or more [m, >= low]; else it may be -infinity.
double SceneGround::crestOf(int triangle, const PlanStrip& strip, double needed, double low,
                            double high) const {
  const Triangle3& thing = all().triangles()[triangle];
  const HeightRange& own = parts_->heights[triangle];
  if (own.high < needed || !mayEndBetween(thing, own, low, high)) return kNone;
  const Triangle3 in_strip = strip.local(thing);
  if (StripPlane(in_strip).highestOver(strip.box) < needed) return kNone;
  return crestWithin(in_strip, strip.box, low, high);
}

namespace {

// Around a strip, against rounding.
Eigen::AlignedBox2d boxAround(const PlanStrip& strip) {
  constexpr double kRounding = 1e-6;  // [m]
  const Eigen::AlignedBox2d plan = strip.plan();
  return {plan.min().array() - kRounding, plan.max().array() + kRounding};
}

}  // namespace

double SceneGround::crest(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double half_width,
                          double low, double high) const {
  const PlanStrip strip({a, b}, half_width);
  const Eigen::AlignedBox2d around = boxAround(strip);
  double highest = kNone;
  visitEnding(strip, low, high, [&](int t) {
    if (!isBeside(all().triangles()[t], around))
      highest = std::max(highest, crestOf(t, strip, std::max(highest, low), low, high));
  });
  return highest;
}

bool SceneGround::risesAbove(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double half_width,
                             double low, double high) const {
  const PlanStrip strip({a, b}, half_width);
  const Eigen::AlignedBox2d around = boxAround(strip);
  const auto rises = [&](int t) {
    const HeightRange& own = parts_->heights[t];
    return own.high >= low && own.low <= high && !isBeside(all().triangles()[t], around) &&
           crestOf(t, strip, low, low, high) > low;
  };
  if (const auto any = parts_->patches->anyEnding(strip, low, high, rises)) return *any;
  bool found = false;
  all().visitBox(strip.plan(), [&](int t) { found = found || rises(t); });
  return found;
}

// What lies over all pieces is looked for once; of that each piece, in their order along the line,
// is shown the highest first.
std::vector<double> SceneGround::crests(std::span<const PlanSegment> pieces, double half_width,
                                        double low, double high) const {
  constexpr double kRounding = 1e-6;  // [m]
  std::vector<double> crests(pieces.size(), kNone);
  if (pieces.empty()) return crests;
  const PlanStrip whole({pieces.front().from, pieces.back().to}, half_width + kRounding);
  std::vector<int> near;
  visitEnding(whole, low, high, [&](int t) {
    if (mayEndBetween(all().triangles()[t], parts_->heights[t], low, high)) near.push_back(t);
  });
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  std::vector<Thing> things;
  for (const int t : near) {
    const Triangle3& thing = all().triangles()[t];
    const Triangle3 own = whole.local(thing);
    Eigen::AlignedBox2d at;
    for (const Eigen::Vector3d& corner : own) at.extend(Eigen::Vector2d(corner.head<2>()));
    if (!at.intersects(whole.box)) continue;
    const auto [sure_begin, sure_end] = surelyMet(own, half_width);
    things.push_back({parts_->heights[t].high, at.min().x() - kRounding, at.max().x() + kRounding,
                      StripPlane(own), t, sure_begin, sure_end});
  }
  std::sort(things.begin(), things.end());
  struct Piece {
    PlanStrip strip;
    Eigen::AlignedBox2d box;  // in the whole
  };
  std::vector<Piece> along;
  along.reserve(pieces.size());
  for (const PlanSegment& piece : pieces) {
    const double begin = whole.along.dot(piece.from - whole.origin),
                 end = whole.along.dot(piece.to - whole.origin);
    along.push_back({PlanStrip(piece, half_width),
                     {Eigen::Vector2d(begin, -half_width), Eigen::Vector2d(end, half_width)}});
  }
  for (const Thing& thing : things) {
    const Triangle3& triangle = all().triangles()[thing.triangle];
    const auto first = std::partition_point(along.begin(), along.end(), [&](const Piece& piece) {
      return piece.box.max().x() < thing.begin;
    });
    for (auto piece = first; piece != along.end() && piece->box.min().x() <= thing.end; ++piece) {
      double& crest = crests[piece - along.begin()];
      if (thing.top <= crest) continue;
      if (piece->box.max().x() > thing.sure_begin && piece->box.min().x() < thing.sure_end) {
        crest = thing.top;  // it is level
        continue;
      }
      if (thing.plane.highestOver(piece->box) < std::max(crest, low)) continue;
      crest =
          std::max(crest, crestWithin(piece->strip.local(triangle), piece->strip.box, low, high));
    }
  }
  return crests;
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
