#include "viz/pictures/draw_mesh.h"

#include <cmath>

namespace amble {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

constexpr double kCrease = 0.7;       // edges sharper than this stay sharp [rad]
constexpr int kCapsuleSegments = 20;  // round a limb
constexpr double kPi = 3.14159265358979323846;

Vector3d faceNormal(const TriangleMesh& mesh, const std::array<int, 3>& t) {
  const Vector3d& a = mesh.vertices[t[0]];
  return (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);  // length: twice the area
}

// A ring of a capsule: share of the way between its ends, and the direction out of it.
struct CapsuleRing {
  bool at_end;
  double along, out;  // parts of the normal along the axis and away from it
};

std::vector<CapsuleRing> capsuleRings() {
  constexpr int kQuarter = 6;  // rings a cap
  std::vector<CapsuleRing> rings;
  for (int i = 0; i <= kQuarter; ++i) {
    const double angle = -kPi / 2 * (1 - static_cast<double>(i) / kQuarter);
    rings.push_back({false, std::sin(angle), std::cos(angle)});
  }
  for (int i = 0; i <= kQuarter; ++i) {
    const double angle = kPi / 2 * i / kQuarter;
    rings.push_back({true, std::sin(angle), std::cos(angle)});
  }
  return rings;
}

void addCapsule(const Vector3d& from, const Vector3d& to, double radius, const Color& color,
                std::vector<DrawTriangle>& triangles) {
  static const std::vector<CapsuleRing> rings = capsuleRings();
  Vector3d axis = to - from;
  axis = axis.norm() > 1e-9 ? Vector3d(axis.normalized()) : Vector3d::UnitZ();
  const Vector3d side = axis.unitOrthogonal();
  const Vector3d other = axis.cross(side);
  const auto normalAt = [&](const CapsuleRing& ring, int k) {
    const double angle = 2 * kPi * k / kCapsuleSegments;
    return Vector3d(ring.along * axis +
                    ring.out * (std::cos(angle) * side + std::sin(angle) * other));
  };
  const auto corner = [&](size_t r, int k, Vector3f& p, Vector3f& n) {
    const Vector3d normal = normalAt(rings[r], k);
    p = ((rings[r].at_end ? to : from) + radius * normal).cast<float>();
    n = normal.cast<float>();
  };
  for (size_t r = 0; r + 1 < rings.size(); ++r) {
    for (int k = 0; k < kCapsuleSegments; ++k) {
      DrawTriangle low, high;
      low.color = high.color = color;
      corner(r, k, low.p[0], low.normal[0]);
      corner(r, k + 1, low.p[1], low.normal[1]);
      corner(r + 1, k + 1, low.p[2], low.normal[2]);
      high.p = {low.p[0], low.p[2], Vector3f::Zero()};
      high.normal = {low.normal[0], low.normal[2], Vector3f::Zero()};
      corner(r + 1, k, high.p[2], high.normal[2]);
      triangles.push_back(low);
      triangles.push_back(high);
    }
  }
}

DrawTriangle levelTriangle(const Vector2d& a, const Vector2d& b, const Vector2d& c, double height,
                           const Color& color) {
  DrawTriangle t;
  const auto lift = [&](const Vector2d& p) {
    return Vector3f(static_cast<float>(p.x()), static_cast<float>(p.y()),
                    static_cast<float>(height));
  };
  t.p = {lift(a), lift(b), lift(c)};
  t.normal.fill(Vector3f::UnitZ());
  t.color = color;
  t.flags = kDecal | kNoShadow | kTwoSided;
  return t;
}

}  // namespace

std::vector<Vector3f> cornerNormals(const TriangleMesh& mesh, double crease) {
  std::vector<Vector3d> faces;
  std::vector<std::vector<int>> around(mesh.vertices.size());
  for (const auto& t : mesh.triangles) {
    for (const int v : t) around[v].push_back(static_cast<int>(faces.size()));
    faces.push_back(faceNormal(mesh, t));
  }
  const double flat = std::cos(crease);
  std::vector<Vector3f> normals;
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Vector3d own = faces[i].normalized();
    for (const int v : mesh.triangles[i]) {
      Vector3d sum = Vector3d::Zero();
      for (const int f : around[v])
        if (faces[f].dot(own) >= flat * faces[f].norm()) sum += faces[f];
      normals.push_back((sum.norm() > 0 ? Vector3d(sum.normalized()) : own).cast<float>());
    }
  }
  return normals;
}

void addMesh(const TriangleMesh& mesh, const Color& color, uint8_t flags,
             std::vector<DrawTriangle>& triangles) {
  const std::vector<Vector3f> normals = cornerNormals(mesh, kCrease);
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    DrawTriangle t;
    for (int k = 0; k < 3; ++k) {
      t.p[k] = mesh.vertices[mesh.triangles[i][k]].cast<float>();
      t.normal[k] = normals[3 * i + k];
    }
    t.color = color;
    t.flags = flags;
    triangles.push_back(t);
  }
}

void addBody(const WalkView& view, int frame, std::span<const Color> colors,
             std::vector<DrawTriangle>& triangles) {
  const PlacedBody placed = placeBodyAt(view, frame);
  for (size_t i = 0; i < placed.from.size(); ++i)
    addCapsule(placed.from[i], placed.to[i], view.body->parts[i].radius, colors[i], triangles);
}

void addPolygon(std::span<const Vector2d> outline, double height, const Color& color,
                std::vector<DrawTriangle>& triangles) {
  Vector2d middle = Vector2d::Zero();
  for (const Vector2d& p : outline) middle += p / static_cast<double>(outline.size());
  for (size_t i = 0; i < outline.size(); ++i)
    triangles.push_back(
        levelTriangle(middle, outline[i], outline[(i + 1) % outline.size()], height, color));
}

void addRibbon(std::span<const Vector2d> line, double width, double height, const Color& color,
               std::vector<DrawTriangle>& triangles) {
  std::vector<Vector2d> left, right;
  for (size_t i = 0; i < line.size(); ++i) {
    const Vector2d along = line[std::min(i + 1, line.size() - 1)] - line[i > 0 ? i - 1 : 0];
    const Vector2d across = Vector2d(-along.y(), along.x()).normalized() * (width / 2);
    left.push_back(line[i] + across);
    right.push_back(line[i] - across);
  }
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    triangles.push_back(levelTriangle(right[i], right[i + 1], left[i + 1], height, color));
    triangles.push_back(levelTriangle(right[i], left[i + 1], left[i], height, color));
  }
}

}  // namespace amble
