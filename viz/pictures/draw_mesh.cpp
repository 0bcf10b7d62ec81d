#include "viz/pictures/draw_mesh.h"

#include <array>
#include <cmath>
#include <numeric>

#include "base/rotation.h"
#include "viz/figure/posed_figure.h"

namespace amble {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

constexpr double kCrease = 0.7;  // edges sharper than this stay sharp [rad]

Vector3d faceNormal(const TriangleMesh& mesh, const std::array<int, 3>& t) {
  const Vector3d& a = mesh.vertices[t[0]];
  return (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);  // length: twice the area
}

// Of a capsule: its rim is never more than 4 % of the radius inside the circle, half a pixel of a
// trunk in the largest pictures.
constexpr int kSegments = 12;               // round a limb
constexpr int kQuarter = 3;                 // rings a cap, beside its pole
constexpr int kRings = 2 * (kQuarter + 1);  // the first half of them around its first end

using Directions = std::array<std::array<Vector3f, kSegments>, kRings>;

// Where a capsule along z has its corners, from its end: ring by ring from pole to pole.
Directions capsuleDirections() {
  Directions directions;
  for (int r = 0; r < kRings; ++r) {
    const int ring = r <= kQuarter ? r - kQuarter : r - kQuarter - 1;
    const double lift = kPi / 2 * ring / kQuarter;
    for (int k = 0; k < kSegments; ++k) {
      const double angle = 2 * kPi * k / kSegments;
      directions[r][k] = Vector3d(std::cos(lift) * std::cos(angle),
                                  std::cos(lift) * std::sin(angle), std::sin(lift))
                             .cast<float>();
    }
  }
  return directions;
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
  std::vector<size_t> first(mesh.vertices.size() + 1);  // in `around`, of each vertex
  for (const auto& t : mesh.triangles) {
    for (const int v : t) ++first[v + 1];
    faces.push_back(faceNormal(mesh, t));
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<int> around(first.back());  // triangles
  std::vector<size_t> end = first;
  for (size_t i = 0; i < mesh.triangles.size(); ++i)
    for (const int v : mesh.triangles[i]) around[end[v]++] = static_cast<int>(i);
  std::vector<double> lengths;
  for (const Vector3d& face : faces) lengths.push_back(face.norm());
  const double flat = std::cos(crease);
  std::vector<Vector3f> normals;
  normals.reserve(3 * faces.size());
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Vector3d own = lengths[i] > 0 ? Vector3d(faces[i] / lengths[i]) : faces[i];
    for (const int v : mesh.triangles[i]) {
      Vector3d sum = Vector3d::Zero();
      for (size_t k = first[v]; k < first[v + 1]; ++k)
        if (faces[around[k]].dot(own) >= flat * lengths[around[k]]) sum += faces[around[k]];
      normals.push_back((sum.norm() > 0 ? Vector3d(sum.normalized()) : own).cast<float>());
    }
  }
  return normals;
}

std::vector<DrawTriangle> drawnMesh(const TriangleMesh& mesh, const Color& color) {
  const std::vector<Vector3f> normals = cornerNormals(mesh, kCrease);
  std::vector<DrawTriangle> triangles(mesh.triangles.size());
  for (size_t i = 0; i < triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      triangles[i].p[k] = mesh.vertices[mesh.triangles[i][k]].cast<float>();
      triangles[i].normal[k] = normals[3 * i + k];
    }
    triangles[i].color = color;
  }
  return triangles;
}

void addMesh(const TriangleMesh& mesh, const Color& color, uint8_t flags,
             std::vector<DrawTriangle>& triangles) {
  for (DrawTriangle& triangle : drawnMesh(mesh, color)) {
    triangle.flags = flags;
    triangles.push_back(triangle);
  }
}

void addCapsule(const Vector3d& from, const Vector3d& to, double radius, const Color& color,
                std::vector<DrawTriangle>& triangles) {
  static const Directions directions = capsuleDirections();
  Vector3d axis = to - from;
  axis = axis.norm() > 1e-9 ? Vector3d(axis.normalized()) : Vector3d::UnitZ();
  Eigen::Matrix3f turned;  // columns: side, other side, axis
  const Vector3d side = axis.unitOrthogonal();
  turned << side.cast<float>(), axis.cross(side).cast<float>(), axis.cast<float>();
  Directions normals, corners;
  for (int r = 0; r < kRings; ++r) {
    const Vector3f end = (r <= kQuarter ? from : to).cast<float>();
    for (int k = 0; k < kSegments; ++k) {
      normals[r][k] = turned * directions[r][k];
      corners[r][k] = end + static_cast<float>(radius) * normals[r][k];
    }
  }
  const auto add = [&](std::array<std::array<int, 2>, 3> at) {
    DrawTriangle t;
    for (int i = 0; i < 3; ++i) {
      t.p[i] = corners[at[i][0]][at[i][1]];
      t.normal[i] = normals[at[i][0]][at[i][1]];
    }
    t.color = color;
    triangles.push_back(t);
  };
  for (int r = 0; r + 1 < kRings; ++r) {
    for (int k = 0; k < kSegments; ++k) {
      const int next = (k + 1) % kSegments;
      if (r + 2 < kRings) add({{{r, k}, {r + 1, next}, {r + 1, k}}});  // none at the last pole
      if (r > 0) add({{{r, k}, {r, next}, {r + 1, next}}});
    }
  }
}

void addBody(const WalkView& view, int frame, std::span<const Color> colors,
             std::vector<DrawTriangle>& triangles) {
  const PlacedBody placed = placeBodyAt(view, frame);
  for (size_t i = 0; i < placed.from.size(); ++i)
    addCapsule(placed.from[i], placed.to[i], view.body->parts[i].radius, colors[i], triangles);
}

void addFigure(const WalkView& view, int frame, const Figure& figure,
               std::vector<DrawTriangle>& triangles) {
  const PosedFigure posed = poseFigure(figure, jointFramesAt(view, frame));
  for (const auto& t : figure.triangles) {
    const auto& color = figure.colors[t[0]];
    DrawTriangle& triangle = triangles.emplace_back();
    triangle.color = rgb(color[0], color[1], color[2]);
    for (int k = 0; k < 3; ++k) {
      triangle.p[k] = posed.vertices[t[k]];
      triangle.normal[k] = posed.normals[t[k]];
    }
  }
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
