/// Triangle meshes, and reading them through Assimp.
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace amble {

struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;        ///< [m]
  std::vector<std::array<int, 3>> triangles;    ///< indices of vertices, counter-clockwise from outside
};

/// An object inside a mesh file.
struct MeshPart {
  std::vector<std::string> names;  ///< its own name first, then those of what it hangs under in the file
  TriangleMesh mesh;               ///< file's node transforms applied, in the file's axes and unit
};

/// What Assimp reads, as parts by name; node transforms applied, degenerate triangles dropped, equal vertices joined.
/// FBX, Collada, glTF and IFC say their axes and unit, and are turned to z up, metres; others are left as they are.
struct MeshFile {
  std::vector<MeshPart> parts;
  bool has_axes = false;  ///< the file says its axes and unit itself: `up:` may not be given
};

/// @throws InputError if the file is missing, broken, empty of triangles, or holds a number that is not finite.
MeshFile readMesh(const std::filesystem::path& file);

/// Primitives as closed meshes, centred on the origin, z up [m]. `segments` round the axis [>= 8].
TriangleMesh makeBox(const Eigen::Vector3d& size);
TriangleMesh makeCylinder(double radius, double height, int segments = 48);
TriangleMesh makeSphere(double radius, int segments = 48);
TriangleMesh makeCapsule(double radius, double height, int segments = 48);

/// Edge-connected pieces of a mesh; `closed` where every edge belongs to two triangles (after joining equal vertices).
struct MeshComponent {
  TriangleMesh mesh;
  bool closed = false;
};
std::vector<MeshComponent> splitComponents(const TriangleMesh& mesh);

}  // namespace amble
