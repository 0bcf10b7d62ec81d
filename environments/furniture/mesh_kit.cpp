#include "environments/furniture/mesh_kit.h"

#include <cmath>
#include <cstdio>
#include <map>

namespace amble {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;
constexpr double kWeld = 1e-7;  // vertices of one surface nearer than this are the same [m]

// Gives equal points one index.
class Welder {
 public:
  explicit Welder(Surface& surface) : surface_(surface) {}

  int index(const Vector3d& p) {
    const std::array<long, 3> key = {std::lround(p.x() / kWeld), std::lround(p.y() / kWeld),
                                     std::lround(p.z() / kWeld)};
    const auto [it, added] = index_.try_emplace(key, static_cast<int>(surface_.vertices.size()));
    if (added) surface_.vertices.push_back(p);
    return it->second;
  }

 private:
  Surface& surface_;
  std::map<std::array<long, 3>, int> index_;
};

void addQuad(Surface& surface, int a, int b, int c, int d) {
  surface.triangles.push_back({a, b, c});
  surface.triangles.push_back({a, c, d});
}

// A line across a rounded box: the inner box's coordinate, and the slope of the normal towards this
// axis.
struct Station {
  double inner;
  double slope;
};

std::vector<Station> boxStations(double half, double radius, int arc, int inner) {
  std::vector<Station> stations;
  const double flat = arc > 0 ? half - radius : half;
  for (int k = arc; k > 0; --k) stations.push_back({-flat, -std::tan(k * kPi / (4 * arc))});
  for (int k = 0; k <= inner; ++k) stations.push_back({flat * (2.0 * k / inner - 1), 0});
  for (int k = 1; k <= arc; ++k) stations.push_back({flat, std::tan(k * kPi / (4 * arc))});
  return stations;
}

// One side of a rounded box, normal to `axis`, as a grid over the two other axes.
void addBoxSide(const RoundedBox& box, int axis, int sign, Surface& surface, Welder& welder) {
  const double radius = box.arc > 0 ? box.radius : 0.0;
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const auto us = boxStations(box.size[u] / 2, box.radius, box.arc, box.inner[u]);
  const auto vs = boxStations(box.size[v] / 2, box.radius, box.arc, box.inner[v]);
  std::vector<std::vector<int>> grid(us.size(), std::vector<int>(vs.size()));
  for (size_t i = 0; i < us.size(); ++i) {
    for (size_t j = 0; j < vs.size(); ++j) {
      Vector3d inner, normal;
      inner[axis] = sign * (box.size[axis] / 2 - radius);
      inner[u] = us[i].inner;
      inner[v] = vs[j].inner;
      normal[axis] = sign;
      normal[u] = us[i].slope;
      normal[v] = vs[j].slope;
      grid[i][j] = welder.index(inner + radius * normal.normalized());
    }
  }
  for (size_t i = 0; i + 1 < us.size(); ++i) {
    for (size_t j = 0; j + 1 < vs.size(); ++j) {
      const int a = grid[i][j], b = grid[i + 1][j], c = grid[i + 1][j + 1], d = grid[i][j + 1];
      if (sign > 0) {
        addQuad(surface, a, b, c, d);
      } else {
        addQuad(surface, a, d, c, b);
      }
    }
  }
}

// Joins rings of equally many points, each counter-clockwise from its end, with the first and last
// closed by fans.
Surface joinRings(const std::vector<std::vector<Vector3d>>& rings, const Vector3d& first_centre,
                  const Vector3d& last_centre) {
  Surface surface;
  const int n = static_cast<int>(rings.front().size());
  for (const auto& ring : rings)
    surface.vertices.insert(surface.vertices.end(), ring.begin(), ring.end());
  const int first = static_cast<int>(surface.vertices.size());
  const int base = static_cast<int>(rings.size() - 1) * n;
  surface.vertices.push_back(first_centre);
  surface.vertices.push_back(last_centre);
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    surface.triangles.push_back({first, next, i});
    for (int r = 0; r < base; r += n) addQuad(surface, r + i, r + next, r + n + next, r + n + i);
    surface.triangles.push_back({first + 1, base + i, base + next});
  }
  return surface;
}

// The outline moved inwards along the mean of the normals of the two edges at each point.
std::vector<Vector2d> insetOutline(const std::vector<Vector2d>& outline, double inset) {
  const size_t n = outline.size();
  std::vector<Vector2d> moved(n);
  for (size_t i = 0; i < n; ++i) {
    const Vector2d before = (outline[i] - outline[(i + n - 1) % n]).normalized();
    const Vector2d after = (outline[(i + 1) % n] - outline[i]).normalized();
    const Vector2d along = (before + after).normalized();
    const double corner = std::max(0.5, along.dot(after));  // longer at corners, to keep the width
    moved[i] = outline[i] + inset / corner * Vector2d(-along.y(), along.x());
  }
  return moved;
}

double printed(double value) { return std::abs(value) < 0.5e-5 ? 0.0 : value; }  // no "-0.00000"

}  // namespace

Surface& Surface::append(const Surface& other) {
  const int base = static_cast<int>(vertices.size());
  vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& t : other.triangles)
    triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  return *this;
}

Surface& Surface::move(double x, double y, double z) {
  for (Vector3d& p : vertices) p += Vector3d(x, y, z);
  return *this;
}

Surface& Surface::rotate(int axis, double angle_deg) {
  const Eigen::AngleAxisd turn(angle_deg * kPi / 180, Vector3d::Unit(axis));
  for (Vector3d& p : vertices) p = turn * p;
  return *this;
}

Surface& Surface::deform(const std::function<Vector3d(const Vector3d&)>& map) {
  for (Vector3d& p : vertices) p = map(p);
  return *this;
}

void Furniture::add(const std::string& group, const Surface& surface) {
  for (auto& [name_of_group, whole] : groups) {
    if (name_of_group == group) {
      whole.append(surface);
      return;
    }
  }
  groups.emplace_back(group, surface);
}

int Furniture::triangleCount() const {
  size_t count = 0;
  for (const auto& group : groups) count += group.second.triangles.size();
  return static_cast<int>(count);
}

Surface makeRoundedBox(const RoundedBox& box) {
  Surface surface;
  Welder welder(surface);
  for (int axis = 0; axis < 3; ++axis) {
    addBoxSide(box, axis, 1, surface, welder);
    addBoxSide(box, axis, -1, surface, welder);
  }
  return surface;
}

Surface makeLathe(const std::vector<Vector2d>& profile, int segments, bool ring) {
  std::vector<std::vector<Vector3d>> rings;
  for (const Vector2d& p : profile) {
    if (!ring && p.x() < kWeld) continue;  // on the axis: an end, closed by a fan
    auto& points = rings.emplace_back();
    for (int i = 0; i < segments; ++i) {
      const double angle = 2 * kPi * i / segments;
      points.emplace_back(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y());
    }
  }
  if (!ring) {
    return joinRings(rings, {0, 0, profile.front().y()}, {0, 0, profile.back().y()});
  }
  Surface surface;
  for (const auto& points : rings)
    surface.vertices.insert(surface.vertices.end(), points.begin(), points.end());
  const int count = static_cast<int>(rings.size());
  for (int r = 0; r < count; ++r) {
    const int low = r * segments;
    const int high = (r + 1) % count * segments;
    for (int i = 0; i < segments; ++i) {
      const int next = (i + 1) % segments;
      addQuad(surface, low + i, low + next, high + next, high + i);
    }
  }
  return surface;
}

std::vector<Vector2d> smoothCurve(const std::vector<Vector2d>& points, int steps) {
  std::vector<Vector2d> curve;
  const int last = static_cast<int>(points.size()) - 1;
  for (int i = 0; i < last; ++i) {
    const Vector2d &p1 = points[i], &p2 = points[i + 1];
    const Vector2d& p0 = points[std::max(0, i - 1)];
    const Vector2d& p3 = points[std::min(last, i + 2)];
    for (int k = 0; k < steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      curve.push_back(0.5 * (2 * p1 + t * (p2 - p0) + t * t * (2 * p0 - 5 * p1 + 4 * p2 - p3) +
                             t * t * t * (3 * p1 - p0 - 3 * p2 + p3)));
    }
  }
  curve.push_back(points.back());
  return curve;
}

Surface makeTube(const std::vector<Vector3d>& path, const std::vector<double>& radius,
                 int segments) {
  std::vector<std::vector<Vector3d>> rings;
  Vector3d side = Vector3d::Zero();
  for (size_t i = 0; i < path.size(); ++i) {
    const Vector3d along =
        (path[std::min(i + 1, path.size() - 1)] - path[i > 0 ? i - 1 : 0]).normalized();
    if (i == 0) side = std::abs(along.x()) < 0.9 ? Vector3d::UnitX() : Vector3d::UnitY();
    side =
        (side - side.dot(along) * along).normalized();  // carried along, so that it does not twist
    const Vector3d other = along.cross(side);
    auto& points = rings.emplace_back();
    for (int k = 0; k < segments; ++k) {
      const double angle = 2 * kPi * k / segments;
      points.push_back(path[i] + radius[i] * (std::cos(angle) * side + std::sin(angle) * other));
    }
  }
  return joinRings(rings, path.front(), path.back());
}

Surface makeLeg(const Leg& leg) {
  const double bevel = leg.foot_radius * 0.25;
  const Vector3d foot(leg.foot.x(), leg.foot.y(), 0);
  const Vector3d top(leg.top.x(), leg.top.y(), leg.height);
  // Rings stay level, so that a splayed leg stands flat.
  const auto ringAt = [&](double height, double radius) {
    const Vector3d middle = foot + (top - foot) * (height / leg.height);
    std::vector<Vector3d> points;
    for (int k = 0; k < leg.segments; ++k) {
      const double angle = 2 * kPi * k / leg.segments;
      points.push_back(middle + radius * Vector3d(std::cos(angle), std::sin(angle), 0));
    }
    return points;
  };
  const double middle_radius = 0.45 * leg.foot_radius + 0.55 * leg.top_radius;
  return joinRings({ringAt(0, leg.foot_radius - bevel), ringAt(bevel, leg.foot_radius),
                    ringAt(leg.height / 2, middle_radius), ringAt(leg.height, leg.top_radius)},
                   foot, top);
}

Surface makeLoft(const std::vector<Vector2d>& outline, const Vector2d& centre,
                 const std::vector<LoftRing>& rings) {
  std::vector<std::vector<Vector3d>> points;
  for (const LoftRing& ring : rings) {
    auto& level = points.emplace_back();
    for (const Vector2d& p : insetOutline(outline, ring.inset))
      level.emplace_back(p.x(), p.y(), ring.height);
  }
  return joinRings(points, {centre.x(), centre.y(), rings.front().height},
                   {centre.x(), centre.y(), rings.back().height});
}

std::vector<LoftRing> plateRings(double low, double high, double bevel) {
  const double half = bevel * (1 - std::sqrt(0.5));
  return {{bevel, low},      {half, low + half},  {0, low + bevel},
          {0, high - bevel}, {half, high - half}, {bevel, high}};
}

void writeObj(std::ostream& out, const Furniture& furniture) {
  out << "# " << furniture.name << ": y up, metres; made by make_furniture\n";
  char line[96];
  int base = 1;
  for (const auto& [name, surface] : furniture.groups) {
    out << "o " << name << '\n';
    for (const Vector3d& p : surface.vertices) {
      std::snprintf(line, sizeof line, "v %.5f %.5f %.5f\n", printed(p.x()), printed(p.z()),
                    printed(-p.y()));
      out << line;
    }
    for (const auto& t : surface.triangles)
      out << "f " << t[0] + base << ' ' << t[1] + base << ' ' << t[2] + base << '\n';
    base += static_cast<int>(surface.vertices.size());
  }
}

}  // namespace amble
