#include "viz/pictures/outline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace amble {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kSliceStep = 0.10;  // between two cuts through closed meshes [m]
constexpr int kMostCells = 4000000;  // the grid gets coarser where it would be larger than this
constexpr double kSmallest = 6.0;    // pieces and holes below this are noise [cells]
// How far a traced corner may lie off the line that replaces it [cells]
constexpr double kStraight = 0.8;

// Cells that are covered, with a border of one empty cell all round.
class Grid {
 public:
  Grid(const Eigen::AlignedBox2d& box, double cell) : cell_(cell) {
    const Vector2d size = box.sizes();
    cell_ = std::max(cell_, std::sqrt(size.x() * size.y() / kMostCells));
    origin_ = box.min() - Vector2d::Constant(1.5 * cell_);
    width_ = static_cast<int>(size.x() / cell_) + 4;
    height_ = static_cast<int>(size.y() / cell_) + 4;
    covered_.resize(static_cast<size_t>(width_) * height_);
  }

  int width() const { return width_; }
  int height() const { return height_; }
  double cell() const { return cell_; }
  bool at(int x, int y) const {
    return x >= 0 && y >= 0 && x < width_ && y < height_ && covered_[index(x, y)];
  }
  Vector2d corner(int x, int y) const { return origin_ + cell_ * Vector2d(x, y); }
  double rowMiddle(int y) const { return origin_.y() + (y + 0.5) * cell_; }

  // Covers the cells of row y whose middles lie between x0 and x1 [m], and at least the one in
  // between.
  void coverSpan(int y, double x0, double x1) {
    if (y < 1 || y >= height_ - 1) return;
    int first = static_cast<int>(std::ceil((x0 - origin_.x()) / cell_ - 0.5));
    int last = static_cast<int>(std::floor((x1 - origin_.x()) / cell_ - 0.5));
    if (last < first)
      first = last = static_cast<int>(std::floor(((x0 + x1) / 2 - origin_.x()) / cell_));
    first = std::max(first, 1);
    last = std::min(last, width_ - 2);
    for (int x = first; x <= last; ++x) covered_[index(x, y)] = 1;
  }

  // Covers a convex polygon, thin ones too: every row that it reaches gets a cell at least.
  void coverPolygon(const std::vector<Vector2d>& polygon) {
    double low = polygon[0].y(), high = polygon[0].y();
    for (const Vector2d& p : polygon) {
      low = std::min(low, p.y());
      high = std::max(high, p.y());
    }
    const int first = std::max(1, static_cast<int>(std::floor((low - origin_.y()) / cell_)));
    const int last =
        std::min(height_ - 2, static_cast<int>(std::floor((high - origin_.y()) / cell_)));
    for (int y = first; y <= last; ++y) {
      const double line = std::clamp(rowMiddle(y), low, high);
      double x0 = 1e30, x1 = -1e30;
      for (size_t i = 0; i < polygon.size(); ++i) {
        const Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if ((a.y() > line && b.y() > line) || (a.y() < line && b.y() < line)) continue;
        const double t = a.y() == b.y() ? 0 : (line - a.y()) / (b.y() - a.y());
        const double x = a.x() + t * (b.x() - a.x());
        x0 = std::min({x0, x, a.y() == b.y() ? b.x() : x});
        x1 = std::max({x1, x, a.y() == b.y() ? b.x() : x});
      }
      if (x0 <= x1) coverSpan(y, x0, x1);
    }
  }

 private:
  size_t index(int x, int y) const { return static_cast<size_t>(y) * width_ + x; }

  double cell_;
  Vector2d origin_;
  int width_ = 0, height_ = 0;
  std::vector<uint8_t> covered_;
};

// The part of a triangle between two heights, from above.
std::vector<Vector2d> clipLevels(const std::array<Vector3d, 3>& triangle, double low, double high) {
  std::vector<Vector3d> polygon(triangle.begin(), triangle.end());
  for (const auto& [sign, level] : {std::pair(1.0, low), std::pair(-1.0, high)}) {
    std::vector<Vector3d> kept;
    for (size_t i = 0; i < polygon.size(); ++i) {
      const Vector3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const double da = sign * (a.z() - level), db = sign * (b.z() - level);
      if (da >= 0) kept.push_back(a);
      if ((da > 0 && db < 0) || (da < 0 && db > 0)) kept.push_back(a + da / (da - db) * (b - a));
    }
    polygon = std::move(kept);
  }
  std::vector<Vector2d> flat;
  for (const Vector3d& p : polygon) flat.push_back(p.head<2>());
  return flat;
}

// Covers the inside of a level cut through a closed mesh: rows between crossings with a winding
// other than 0.
void coverSlice(const TriangleMesh& mesh, double z, Grid& grid) {
  std::vector<std::vector<std::pair<double, int>>> rows(grid.height());
  for (const auto& t : mesh.triangles) {
    std::array<Vector2d, 2> ends;
    int count = 0;
    for (int k = 0; k < 3; ++k) {
      const Vector3d &a = mesh.vertices[t[k]], &b = mesh.vertices[t[(k + 1) % 3]];
      if ((a.z() > z) == (b.z() > z)) continue;
      const double share = (z - a.z()) / (b.z() - a.z());
      ends[a.z() > z ? 0 : 1] =
          (a + share * (b - a)).head<2>();  // from where the edge goes down to where up
      ++count;
    }
    if (count != 2) continue;
    const bool up = ends[1].y() > ends[0].y();
    const Vector2d &low = ends[up ? 0 : 1], &high = ends[up ? 1 : 0];
    const double first = std::ceil((low.y() - grid.rowMiddle(0)) / grid.cell());
    for (int y = std::max(0, static_cast<int>(first)); y < grid.height(); ++y) {
      const double line = grid.rowMiddle(y);
      if (line >= high.y()) break;
      if (line < low.y()) continue;
      const double share = (line - low.y()) / (high.y() - low.y());
      rows[y].emplace_back(low.x() + share * (high.x() - low.x()), up ? 1 : -1);
    }
  }
  for (int y = 0; y < grid.height(); ++y) {
    std::sort(rows[y].begin(), rows[y].end());
    int winding = 0;
    for (size_t i = 0; i + 1 < rows[y].size(); ++i) {
      winding += rows[y][i].second;
      if (winding != 0) grid.coverSpan(y, rows[y][i].first, rows[y][i + 1].first);
    }
  }
}

// Walks along the border of the covered cells, these on the left, from grid corner to grid corner.
std::vector<std::vector<Eigen::Vector2i>> traceBorders(const Grid& grid) {
  // Steps by direction: 0 east, 1 north, 2 west, 3 south. The border leaves corner (x, y) in
  // direction d where the cell to the left of the step is covered and the one to the right is not.
  static constexpr int kStep[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  static constexpr int kLeft[4][2] = {{0, 0}, {-1, 0}, {-1, -1}, {0, -1}};
  static constexpr int kRight[4][2] = {{0, -1}, {0, 0}, {-1, 0}, {-1, -1}};
  const auto leaves = [&](int x, int y, int d) {
    return grid.at(x + kLeft[d][0], y + kLeft[d][1]) &&
           !grid.at(x + kRight[d][0], y + kRight[d][1]);
  };
  std::vector<uint8_t> done(static_cast<size_t>(grid.width() + 1) * (grid.height() + 1));
  std::vector<std::vector<Eigen::Vector2i>> borders;
  for (int y = 0; y <= grid.height(); ++y) {
    for (int x = 0; x <= grid.width(); ++x) {
      if (!leaves(x, y, 0) || (done[static_cast<size_t>(y) * (grid.width() + 1) + x] & 1)) continue;
      auto& border = borders.emplace_back();
      int cx = x, cy = y, d = 0;
      do {
        done[static_cast<size_t>(cy) * (grid.width() + 1) + cx] |= static_cast<uint8_t>(1 << d);
        border.emplace_back(cx, cy);
        cx += kStep[d][0];
        cy += kStep[d][1];
        for (const int turn :
             {3, 0, 1})  // right, straight on, left: cells that touch in a corner stay apart
          if (leaves(cx, cy, (d + turn) % 4)) {
            d = (d + turn) % 4;
            break;
          }
      } while (cx != x || cy != y || d != 0);
    }
  }
  return borders;
}

double offLine(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d way = b - a;
  const double t =
      way.squaredNorm() > 0 ? std::clamp((p - a).dot(way) / way.squaredNorm(), 0.0, 1.0) : 0.0;
  return (a + t * way - p).norm();
}

// Douglas and Peucker: corners nearer than `tolerance` to the line that replaces them go.
void simplify(const Outline& line, size_t first, size_t last, double tolerance, Outline& kept) {
  size_t far = first;
  double most = tolerance;
  for (size_t i = first + 1; i < last; ++i) {
    const double off = offLine(line[i], line[first], line[last]);
    if (off > most) {
      most = off;
      far = i;
    }
  }
  if (far == first) {
    kept.push_back(line[first]);
    return;
  }
  simplify(line, first, far, tolerance, kept);
  simplify(line, far, last, tolerance, kept);
}

double signedArea(const Outline& outline) {
  double sum = 0;
  for (size_t i = 0; i < outline.size(); ++i) {
    const Vector2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return sum / 2;
}

Outline simplifiedBorder(const Grid& grid, const std::vector<Eigen::Vector2i>& border) {
  Outline line;
  // Middles of the steps, not corners: a slanted edge is then within a quarter of a cell of the
  // truth.
  for (size_t i = 0; i < border.size(); ++i) {
    const auto &a = border[i], &b = border[(i + 1) % border.size()];
    line.push_back((grid.corner(a.x(), a.y()) + grid.corner(b.x(), b.y())) / 2);
  }
  line.push_back(line.front());
  // Two far points split the ring, so that neither half begins and ends in the same place.
  size_t far = 0;
  for (size_t i = 0; i < line.size(); ++i)
    if ((line[i] - line[0]).norm() > (line[far] - line[0]).norm()) far = i;
  Outline kept;
  simplify(line, 0, far, kStraight * grid.cell(), kept);
  simplify(line, far, line.size() - 1, kStraight * grid.cell(), kept);
  return kept;
}

// Andrew's monotone chain: counter-clockwise, without points on the edges.
Outline convexHull(std::vector<Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const Vector2d& a, const Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  Outline hull;
  if (points.empty()) return hull;
  for (const bool upper : {false, true}) {
    const size_t base = hull.size();
    for (const Vector2d& p : points) {
      while (hull.size() >= base + 2) {
        const Vector2d &a = hull[hull.size() - 2], &b = hull.back();
        if ((b - a).x() * (p - a).y() - (b - a).y() * (p - a).x() > 1e-9) break;
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();  // begins the other half
    if (!upper) std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace

std::vector<Outline> traceOutlines(const TriangleMesh& mesh, const OutlineSettings& settings) {
  Eigen::AlignedBox2d box;
  std::vector<std::vector<Vector2d>> polygons;
  for (const auto& t : mesh.triangles) {
    auto polygon = clipLevels({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]},
                              settings.low, settings.high);
    if (polygon.size() < 3) continue;
    for (const Vector2d& p : polygon) box.extend(p);
    polygons.push_back(std::move(polygon));
  }
  if (polygons.empty()) return {};
  Grid grid(box, settings.cell);
  for (const auto& polygon : polygons) grid.coverPolygon(polygon);
  for (const MeshComponent& piece : splitComponents(mesh)) {
    if (!piece.closed) continue;
    const int slices = std::max(1, static_cast<int>((settings.high - settings.low) / kSliceStep));
    for (int i = 0; i <= slices; ++i)  // a little off round heights, where furniture has its edges
      coverSlice(piece.mesh,
                 settings.low + 1e-4 + (settings.high - settings.low - 2e-4) * i / slices, grid);
  }
  std::vector<Outline> outlines;
  for (const auto& border : traceBorders(grid)) {
    Outline outline = simplifiedBorder(grid, border);
    if (outline.size() >= 3 &&
        std::abs(signedArea(outline)) > kSmallest * grid.cell() * grid.cell())
      outlines.push_back(std::move(outline));
  }
  return outlines;
}

std::vector<Outline> traceConvexOutline(const TriangleMesh& mesh, const OutlineSettings& settings) {
  std::vector<Vector2d> points;
  for (const auto& t : mesh.triangles)
    for (const Vector2d& p :
         clipLevels({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}, settings.low,
                    settings.high))
      points.push_back(p);
  Outline outline = convexHull(std::move(points));
  if (outline.size() < 3) return {};
  return {outline};
}

double coveredArea(const std::vector<Outline>& outlines) {
  double area = 0;
  for (const Outline& outline : outlines) area += signedArea(outline);
  return area;
}

}  // namespace amble
