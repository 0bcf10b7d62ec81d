/// The scene: objects with their shapes, placed in World, and what each is to a walker (DESIGN.md,
/// section 5).
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/guard_limits.h"
#include "base/stop_request.h"
#include "environments/scene/mesh.h"

namespace amble {

class KeptMeshes;  // kept_meshes.h

enum class Role { kAuto, kGround, kObstacle, kIgnore };

struct Box {
  Eigen::Vector3d size;
};  ///< whole lengths [m, > 0]
struct Cylinder {
  double radius, height;
};  ///< upright, [m, > 0]
struct Sphere {
  double radius;
};  ///< [m, > 0]
struct CapsuleShape {
  double radius, height;
};  ///< upright, whole height tip to tip [m, > 2 radius]
using Shape = std::variant<Box, Cylinder, Sphere, CapsuleShape, TriangleMesh>;

/// One rigid thing. An object whose mesh file has several parts becomes one SceneObject a part,
/// each with its role; `name` is then the same for all of them.
struct SceneObject {
  std::string name;  ///< of the object in the scene file
  std::string part;  ///< name inside the mesh file, where it was one part; else empty
  Shape shape;
  /// Scale is applied to the shape already.
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();
  Role role = Role::kAuto;
};

struct Scene {
  std::string name;
  std::filesystem::path file;
  std::vector<SceneObject> objects;           ///< `ignore` ones are kept: pictures show them
  std::vector<std::filesystem::path> inputs;  ///< every file that was read, its meshes' own too
  std::vector<std::string> warnings;          ///< what is likely not meant, a line each

  Eigen::AlignedBox3d bounds() const;  ///< of all objects but the ignored [m]
  int triangleCount() const;           ///< of meshes; primitives count 0
};

/// What bounds the loading of a scene, beside what its files say.
struct LoadLimits {
  size_t memory = GuardLimits{}.memory;  ///< that reading a mesh file may fill [bytes, > 0]
  StopRequest stop = {};                 ///< ends the loading, with Stopped
  KeptMeshes* meshes = nullptr;  ///< of scenes that were read before; null: each reads its own
};

/// @throws InputError as DESIGN.md, section 5 asks (unknown and doubled keys, ranges, doubled
/// names, `up` missing or not wanted, a scene under 0.5 m or over 1 km with the `scale` it would
/// need); Stopped.
Scene readScene(const std::filesystem::path& file, const LoadLimits& limits = {});

/// The same in two steps, between which other work is done: its meshes are read meanwhile.
class SceneReading {
 public:
  /// Reads the scene's own file. @throws as readScene
  explicit SceneReading(const std::filesystem::path& file, const LoadLimits& limits = {});
  ~SceneReading();
  /// Waits for the meshes. @throws as readScene. @pre asked once
  Scene finish();

 private:
  class Reader;
  std::unique_ptr<Reader> reader_;
};

/// An object as messages and reports name it: its name in the scene, with that of its part of a
/// mesh file where it is one.
std::string objectName(const SceneObject& object);

/// Pattern of `parts: match:`: `*` stands for any characters, `?` for one; upper and lower case are
/// the same (ASCII).
bool matchesPattern(std::string_view pattern, std::string_view name);

/// The object's surface in World; primitives become meshes, round ones of chords.
TriangleMesh worldMesh(const SceneObject& object);

/// A shape's bounds where it stands; exact for primitives [m].
Eigen::AlignedBox3d worldBounds(const Shape& shape, const Eigen::Isometry3d& X_WO);

}  // namespace amble
