/// Triangle meshes, and reading them through Assimp.
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace amble {

struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;  ///< [m]
  std::vector<std::array<int, 3>>
      triangles;  ///< indices of vertices, counter-clockwise from outside
};

/// An object inside a mesh file.
struct MeshPart {
  std::vector<std::string>
      names;          ///< its own name first, then those of what it hangs under in the file
  TriangleMesh mesh;  ///< file's node transforms applied, in the file's axes and unit
};

/// What Assimp reads, as parts by name; node transforms applied, degenerate triangles dropped,
/// equal vertices joined. FBX, Collada, glTF and IFC say their axes and unit, and are turned to z
/// up, metres; others are left as they are.
struct MeshFile {
  std::vector<MeshPart> parts;
  bool has_axes = false;  ///< the file says its axes and unit itself: `up:` may not be given
};

/// Takes a y-up file's (x, y, z) to World's (x, -z, y), exactly: without the rounding of a
/// quaternion.
inline Eigen::Matrix3d yUpMatrix() {
  return (Eigen::Matrix3d() << 1, 0, 0, 0, 0, -1, 0, 1, 0).finished();
}

/// @throws InputError if the file is missing, broken, empty of triangles, or holds a number that is
/// not finite.
MeshFile readMesh(const std::filesystem::path& file);

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
