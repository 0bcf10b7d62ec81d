/// Triangle meshes.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace amble {

struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;  ///< [m]
  std::vector<std::array<int, 3>>
      triangles;  ///< indices of vertices, counter-clockwise from outside
};

/// Primitives as closed meshes, centred on the origin, z up [m]. `segments` round the axis [>= 8].
TriangleMesh makeBox(const Eigen::Vector3d& size);
TriangleMesh makeCylinder(double radius, double height, int segments = 48);
TriangleMesh makeSphere(double radius, int segments = 48);
TriangleMesh makeCapsule(double radius, double height, int segments = 48);

/// Triangles flatter than this are dropped: the squared sine of an angle between two edges [1].
/// Rounding leaves collinear corners of a float file at about 1e-14.
inline constexpr double kZeroArea = 1e-20;

/// The mesh with vertices of exactly the same place joined, triangles without area dropped and
/// vertices that none uses left out.
TriangleMesh cleanMesh(const TriangleMesh& mesh);

/// An edge-connected piece of a mesh, after joining equal vertices. It is closed where every edge
/// belongs to an even number of its triangles (to two, or to four where solids meet in an edge):
/// it has an inside then, by parity.
struct MeshComponent {
  TriangleMesh mesh;
  bool closed = false;
};
std::vector<MeshComponent> splitComponents(const TriangleMesh& mesh);

}  // namespace amble
