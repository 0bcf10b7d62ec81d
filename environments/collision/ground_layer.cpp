#include "environments/collision/ground_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "base/parallel.h"
#include "environments/scene/parity_column.h"

namespace amble {
namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();

const TriangleMesh& meshOf(const Obstacle& surface) {
  return std::get<TriangleMesh>(surface.shape);
}

std::vector<Obstacle> withoutSolids(std::vector<Obstacle> surfaces) {
  for (Obstacle& surface : surfaces) surface.solid = {};
  return surfaces;
}

Triangle3 cornersOf(const TriangleMesh& mesh, const std::array<int, 3>& t) {
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

// Of all triangles, seen from above [m^2].
double planArea(const std::vector<Obstacle>& surfaces) {
  double twice = 0.0;
  for (const Obstacle& surface : surfaces) {
    for (const TriangleMesh* mesh : {&meshOf(surface), &surface.solid.mesh}) {
      for (const std::array<int, 3>& t : mesh->triangles) {
        const Eigen::Vector3d& a = mesh->vertices[t[0]];
        twice += std::abs((mesh->vertices[t[1]] - a).cross(mesh->vertices[t[2]] - a).z());
      }
    }
  }
  return 0.5 * twice;
}

// The point of a triangle that is nearest to p (Ericson 2005, section 5.1.5).
Eigen::Vector3d nearestPoint(const Triangle3& t, const Eigen::Vector3d& p) {
  const Eigen::Vector3d ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0], bp = p - t[1],
                        cp = p - t[2];
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp),
               d6 = ac.dot(cp);
  if (d1 <= 0.0 && d2 <= 0.0) return t[0];
  if (d3 >= 0.0 && d4 <= d3) return t[1];
  if (d6 >= 0.0 && d5 <= d6) return t[2];
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return t[0] + d1 / (d1 - d3) * ab;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return t[0] + d2 / (d2 - d6) * ac;
  if (va <= 0.0 && d4 >= d3 && d5 >= d6)
    return t[1] + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (t[2] - t[1]);
  return t[0] + (vb * ab + vc * ac) / (va + vb + vc);
}

}  // namespace

GroundLayer::Slab::Slab(const Triangle3& t)
    : min(t[0].cwiseMin(t[1]).cwiseMin(t[2])),
      max(t[0].cwiseMax(t[1]).cwiseMax(t[2])),
      normal((t[1] - t[0]).cross(t[2] - t[0]).normalized()) {
  std::tie(low, high) = std::minmax({normal.dot(t[0]), normal.dot(t[1]), normal.dot(t[2])});
}

// What a capsule sweeps between two places: points no farther than `radius` from the hull of four.
struct GroundLayer::Sweep {
  std::array<Eigen::Vector3d, 4> points;
  double radius;
  Eigen::AlignedBox3d box;

  Sweep(const std::array<Eigen::Vector3d, 4>& corners, double around)
      : points(corners), radius(around) {
    for (const Eigen::Vector3d& p : points) box.extend(p);
    box = {box.min().array() - radius, box.max().array() + radius};
  }

  // Whether a plane across `axis`, a unit vector, parts it from what lies between these along it.
  bool isApart(const Eigen::Vector3d& axis, double least, double most) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Eigen::Vector3d& p : points) {
      const double d = axis.dot(p);
      low = std::min(low, d);
      high = std::max(high, d);
    }
    return low - radius >= most || high + radius <= least;
  }

  // Planes across the axes.
  bool isBeside(const Slab& slab) const {
    return (box.min().array() >= slab.max.array()).any() ||
           (box.max().array() <= slab.min.array()).any();
  }

  // Those of the triangle, and across the line from the triangle to the middle.
  bool isClearOf(const Triangle3& t, const Slab& slab) const {
    if (isApart(slab.normal, slab.low, slab.high)) return true;
    const Eigen::Vector3d middle = 0.25 * (points[0] + points[1] + points[2] + points[3]);
    const Eigen::Vector3d way = middle - nearestPoint(t, middle);
    const double far = way.norm();
    if (!(far > 0.0)) return false;
    const Eigen::Vector3d axis = way / far;
    const auto [least, most] = std::minmax({axis.dot(t[0]), axis.dot(t[1]), axis.dot(t[2])});
    return isApart(axis, least, most);
  }
};

GroundLayer::GroundLayer(std::vector<Obstacle> surfaces, const StopRequest& stop, Checker checker)
    : surfaces_(withoutSolids(surfaces), stop, checker) {
  std::vector<Triangle3> triangles;
  for (const Obstacle& surface : surfaces) {
    const TriangleMesh& mesh = meshOf(surface);
    for (const std::array<int, 3>& t : mesh.triangles) {
      triangles.push_back(cornersOf(mesh, t));
      slabs_.emplace_back(triangles.back());
      objects_.push_back(surface.object);
    }
    solids_.push_back({surface.object, Parity(surface.solid)});
  }
  grid_ = TriangleGrid(std::move(triangles));
  for (const Obstacle& surface : surfaces)
    for (const TriangleMesh* mesh : {&meshOf(surface), &surface.solid.mesh})
      for (const Eigen::Vector3d& v : mesh->vertices) extent_.extend(Eigen::Vector2d(v.head<2>()));
  if (extent_.isEmpty()) return;
  cell_ = std::max({kCell, extent_.sizes().maxCoeff() / kMostCells,
                    std::sqrt(planArea(surfaces) / kMostEntries)});
  for (int k = 0; k < 2; ++k) count_[k] = 1 + static_cast<int>(extent_.sizes()[k] / cell_);
  fillSpans(surfaces, stop);
}

Eigen::Vector2i GroundLayer::cellOf(const Eigen::Vector2d& p) const {
  Eigen::Vector2i cell;
  for (int k = 0; k < 2; ++k) {
    const double steps = std::clamp((p[k] - extent_.min()[k]) / cell_, 0.0, count_[k] - 1.0);
    cell[k] = static_cast<int>(steps);
  }
  return cell;
}

// The columns of a row that a triangle lies over, first and last, or a few more.
std::pair<int, int> GroundLayer::columnsOf(const Triangle3& t, int row, int low, int high) const {
  constexpr int kFew = 4;  // for which it is not worth it
  if (high - low < kFew) return {low, high};
  const double y = extent_.min().y() + cell_ * row;
  const auto part = boundsWithin(
      t, {Eigen::Vector2d(-HUGE_VAL, y - kSeam), Eigen::Vector2d(HUGE_VAL, y + cell_ + kSeam)});
  if (!part) return {0, -1};
  const double margin = 2.0 * kSeam;
  return {cellOf({part->min().x() - margin, y}).x(), cellOf({part->max().x() + margin, y}).x()};
}

// The heights that a triangle has over each cell of the rows.
void GroundLayer::collect(const Triangle3& t, int solid, int first_row, int last_row,
                          std::vector<Entry>& entries) const {
  constexpr double kRounding = 1e-9;  // [m]
  Eigen::AlignedBox2d plan;
  for (const Eigen::Vector3d& corner : t) plan.extend(Eigen::Vector2d(corner.head<2>()));
  const Eigen::Vector2i low = cellOf(plan.min().array() - kSeam),
                        high = cellOf(plan.max().array() + kSeam);
  for (int j = std::max(low.y(), first_row); j <= std::min(high.y(), last_row); ++j) {
    const auto [first, last] = columnsOf(t, j, low.x(), high.x());
    for (int i = first; i <= last; ++i) {
      const Eigen::Vector2d corner = extent_.min() + cell_ * Eigen::Vector2d(i, j);
      const auto heights =
          heightsWithin(t, {corner.array() - kSeam, (corner.array() + (cell_ + kSeam)).matrix()});
      if (heights)
        entries.push_back(
            {j * count_.x() + i, solid, {heights->low - kRounding, heights->high + kRounding}});
    }
  }
}

// The triangles of surfaces and solids that lie over each strip of rows. What of a solid is in the
// surface too, in the same order, is taken once.
std::vector<std::vector<GroundLayer::Face>> GroundLayer::facesByStrip(
    const std::vector<Obstacle>& surfaces, int strips) const {
  std::vector<std::vector<Face>> by_strip(strips);
  const auto add = [&](const Triangle3& t, int solid) {
    const auto [low, high] = std::minmax({t[0].y(), t[1].y(), t[2].y()});
    const int first = cellOf({extent_.min().x(), low - kSeam}).y() / kStripRows;
    const int last = cellOf({extent_.min().x(), high + kSeam}).y() / kStripRows;
    for (int strip = first; strip <= last; ++strip) by_strip[strip].push_back({t, solid});
  };
  for (size_t k = 0; k < surfaces.size(); ++k) {
    const TriangleMesh &mesh = meshOf(surfaces[k]), &solid = surfaces[k].solid.mesh;
    for (const std::array<int, 3>& t : mesh.triangles) add(cornersOf(mesh, t), static_cast<int>(k));
    size_t next = 0;
    for (const std::array<int, 3>& t : solid.triangles) {
      const Triangle3 corners = cornersOf(solid, t);
      const bool known =
          next < mesh.triangles.size() && corners == cornersOf(mesh, mesh.triangles[next]);
      if (known)
        ++next;
      else
        add(corners, static_cast<int>(k));
    }
  }
  return by_strip;
}

// Spans are the heights of surfaces, what lies between two of them where it is inside a solid, and
// whatever is below the lowest. Within a cell no surface lies between two spans, so one point tells
// for all, and a solid that is met has surfaces over the cell.
void GroundLayer::fillCell(std::span<const Entry> entries, std::vector<Span>& spans) const {
  const int cell = entries.front().cell;
  std::vector<int> over;
  for (const Entry& entry : entries)
    if (!solids_[entry.solid].test.empty()) over.push_back(entry.solid);
  std::sort(over.begin(), over.end());
  over.erase(std::unique(over.begin(), over.end()), over.end());
  std::vector<const Parity*> solids;
  for (const int k : over) solids.push_back(&solids_[k].test);
  ParityColumn column(
      extent_.min() + cell_ * Eigen::Vector2d(cell % count_.x() + 0.5, cell / count_.x() + 0.5),
      0.5 * cell_, std::move(solids));
  spans.push_back({kNone, entries.front().span.high});
  for (const Entry& entry : entries.subspan(1)) {
    const Span& span = entry.span;
    const double top = spans.back().high;
    if (span.low <= top || column.isInside(0.5 * (top + span.low))) {
      spans.back().high = std::max(top, span.high);
    } else {
      spans.push_back(span);
    }
  }
}

// The cells of some rows, in their order.
GroundLayer::Strip GroundLayer::fillStrip(const std::vector<Face>& faces, int first_row,
                                          int last_row) const {
  std::vector<Entry> entries;
  for (const Face& face : faces) collect(face.corners, face.solid, first_row, last_row, entries);
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.cell, a.span.low, a.span.high) < std::tie(b.cell, b.span.low, b.span.high);
  });
  Strip strip;
  size_t next = 0;
  for (int cell = first_row * count_.x(); cell < (last_row + 1) * count_.x(); ++cell) {
    strip.start.push_back(static_cast<int>(strip.spans.size()));
    const size_t first = next;
    while (next < entries.size() && entries[next].cell == cell) ++next;
    if (next > first) fillCell(std::span(entries).subspan(first, next - first), strip.spans);
  }
  return strip;
}

// By strips of rows, on all threads: each is of its own.
void GroundLayer::fillSpans(const std::vector<Obstacle>& surfaces, const StopRequest& stop) {
  const int strips = (count_.y() + kStripRows - 1) / kStripRows;
  std::vector<std::vector<Face>> faces = facesByStrip(surfaces, strips);
  std::vector<Strip> filled(strips);
  parallelFor(strips, usualThreads(), [&](int k, int) {
    stop.check();
    const int first_row = k * kStripRows;
    filled[k] = fillStrip(faces[k], first_row, std::min(first_row + kStripRows, count_.y()) - 1);
    faces[k] = {};
  });
  for (const Strip& strip : filled) {
    const int before = static_cast<int>(spans_.size());
    for (const int start : strip.start) start_.push_back(before + start);
    spans_.insert(spans_.end(), strip.spans.begin(), strip.spans.end());
  }
  start_.push_back(static_cast<int>(spans_.size()));
  for (const Span& span : spans_) top_ = std::max(top_, span.high);
  fillNearTops();
}

// The largest over a square of cells: along one axis, then along the other.
void GroundLayer::fillNearTops() {
  const int nx = count_.x(), ny = count_.y();
  near_top_.assign(start_.size() - 1, kNone);
  for (size_t cell = 0; cell < near_top_.size(); ++cell)
    if (start_[cell + 1] > start_[cell]) near_top_[cell] = spans_[start_[cell + 1] - 1].high;
  std::vector<double> line;
  const auto widen = [&](double* first, int count, size_t step) {
    line.clear();
    for (int i = 0; i < count; ++i) line.push_back(first[i * step]);
    for (int i = 0; i < count; ++i)
      first[i * step] = *std::max_element(line.begin() + std::max(0, i - kNearCells),
                                          line.begin() + std::min(count, i + kNearCells + 1));
  };
  const size_t row = nx;
  for (int j = 0; j < ny; ++j) widen(&near_top_[j * row], nx, 1);
  for (int i = 0; i < nx; ++i) widen(&near_top_[i], ny, row);
}

bool GroundLayer::isAbove(const Capsule& capsule, double depth) const {
  const double lowest = capsule.lowest() + depth;
  if (lowest >= top_) return true;
  // Of cells so near to its middle, a little less against rounding. Cells at the border answer for
  // what is beyond it: no ground is nearer to that than to them.
  const double room = (kNearCells - 1e-6) * cell_ - capsule.radius;
  if (!(room > 0.0) || 4.0 * room * room < (capsule.to - capsule.from).head<2>().squaredNorm())
    return false;
  const Eigen::Vector2i cell = cellOf(0.5 * (capsule.from + capsule.to).head<2>());
  return lowest >= near_top_[cell.x() + static_cast<size_t>(cell.y()) * count_.x()];
}

bool GroundLayer::isFree(const Capsule& capsule, double depth) const {
  if (isAbove(capsule, depth)) return true;
  Eigen::AlignedBox3d box = capsule.bounds();
  box.translate(Eigen::Vector3d(0.0, 0.0, depth));
  return !meetsSpan(box);
}

bool GroundLayer::meetsSpan(const Eigen::AlignedBox3d& box) const {
  if (box.min().z() >= top_) return false;  // which most are on level ground
  const Eigen::AlignedBox2d plan(Eigen::Vector2d(box.min().head<2>()),
                                 Eigen::Vector2d(box.max().head<2>()));
  if (extent_.isEmpty() || !extent_.intersects(plan)) return false;
  const Eigen::Vector2i low = cellOf(plan.min()), high = cellOf(plan.max());
  for (int j = low.y(); j <= high.y(); ++j) {
    // A row's cells follow one another in memory, and so do their spans.
    const size_t row = static_cast<size_t>(j) * count_.x();
    for (int k = start_[row + low.x()]; k < start_[row + high.x() + 1]; ++k)
      if (box.min().z() < spans_[k].high && box.max().z() > spans_[k].low) return true;
  }
  return false;
}

// Whether nothing over the point's cell is higher.
bool GroundLayer::isAboveCell(const Eigen::Vector3d& p) const {
  if (extent_.isEmpty()) return true;
  const Eigen::Vector2i at = cellOf(p.head<2>());
  const size_t cell = at.x() + static_cast<size_t>(at.y()) * count_.x();
  return start_[cell] == start_[cell + 1] || p.z() >= spans_[start_[cell + 1] - 1].high;
}

// The object inside which, or under whose ground without any other below it, a point lies; -1 for
// none.
int GroundLayer::aboveOf(const Eigen::Vector3d& p) const {
  if (isAboveCell(p)) return -1;
  for (const Solid& solid : solids_)
    if (solid.test.inside(p)) return solid.object;
  int above = -1;
  bool below = false;
  grid_.visitAt(p.x(), p.y(), [&](int t) {
    const auto height = heightOver(grid_.triangles()[t], p.x(), p.y());
    if (!height) return;
    if (*height <= p.z()) below = true;
    if (*height > p.z() && (above < 0 || objects_[t] < above)) above = objects_[t];
  });
  return below ? -1 : above;
}

bool GroundLayer::isClearBetween(const Capsule& a, const Capsule& b, double depth,
                                 double bend) const {
  const Eigen::Vector3d lift(0.0, 0.0, depth);
  const Sweep sweep({a.from + lift, a.to + lift, b.from + lift, b.to + lift}, a.radius + bend);
  if (!meetsSpan(sweep.box)) return true;
  const Eigen::AlignedBox2d plan(Eigen::Vector2d(sweep.box.min().head<2>()),
                                 Eigen::Vector2d(sweep.box.max().head<2>()));
  std::array<int, 16> asked;  // of the triangles that lie over several squares the first ones
  size_t count = 0;
  bool clear = true;
  grid_.visitBox(plan, [&](int t) {
    if (!clear || sweep.isBeside(slabs_[t])) return;
    const auto end = asked.begin() + count;
    if (std::find(asked.begin(), end, t) != end) return;
    if (count < asked.size()) asked[count++] = t;
    clear = sweep.isClearOf(grid_.triangles()[t], slabs_[t]);
  });
  return clear;
}

int GroundLayer::touched(const Capsule& capsule, double depth,
                         ObstacleSet::Scratch& scratch) const {
  Capsule lifted = capsule;
  lifted.from.z() += depth;
  lifted.to.z() += depth;
  if (!meetsSpan(lifted.bounds())) return -1;
  if (!isClearBetween(lifted, lifted, 0.0, 0.0)) {
    const int object = surfaces_.touched(lifted, scratch);
    if (object >= 0) return object;
  }
  // It touches no surface: it is inside or under as a whole or not at all.
  return aboveOf(lifted.from);
}

}  // namespace amble
