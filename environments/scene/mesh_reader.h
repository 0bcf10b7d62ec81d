/// Reading meshes, OBJ through tinyobjloader and all others through Assimp, in a process of its
/// own: Assimp's parsers recurse as deep as a file nests, and files may claim more memory than
/// there is.
///
/// What a file says of itself is read first (the schema of an IFC, the extensions that a glTF
/// requires, the lengths of a GLB). Only regular files are read, and of those that a mesh file
/// names only such as lie in its folder or below it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/guarded_run.h"
#include "environments/scene/mesh.h"

namespace amble {

/// An object inside a mesh file.
struct MeshPart {
  std::vector<std::string>
      names;          ///< its own name first, then those of what it hangs under in the file
  TriangleMesh mesh;  ///< file's node transforms applied, in the file's axes and unit
};

/// What is read, as parts by name; node transforms applied, degenerate triangles dropped,
/// equal vertices joined. FBX, Collada, glTF and IFC say their axes and unit, and are turned to z
/// up, metres; others are left as they are.
struct MeshFile {
  std::vector<MeshPart> parts;
  bool has_axes = false;  ///< the file says its axes and unit itself: `up:` may not be given
  std::vector<std::string> others;    ///< files beside it that were read too, such as buffers
  std::vector<std::string> warnings;  ///< of what was passed over, with file and line
};

/// Assimp needs about thirty times a text's size.
inline constexpr FileKind kMeshFile = {"a mesh", size_t{512} << 20};

/// @param memory  that reading may fill, beside that of this program [bytes, > 0]
/// @param stopped  asked ten times a second, where given; true ends the reading
/// @throws InputError if the file is missing, no regular file, too large, broken, empty of
/// triangles, or holds a number that is not finite; or if reading it takes more than `memory`, or
/// more time than its size explains.
MeshFile readMesh(const std::filesystem::path& file, size_t memory = GuardLimits{}.memory,
                  const std::function<bool()>& stopped = {});

/// Files up to this size are read together [bytes].
inline constexpr size_t kSmallMesh = size_t{1} << 20;

/// Reads those that are small meanwhile, in a process for each processor and not for each of them:
/// to start one costs more than to read it.
class SmallMeshes {
 public:
  /// Begins. @param memory, stopped  as for readMesh, of all together
  explicit SmallMeshes(const std::vector<std::filesystem::path>& files,
                       size_t memory = GuardLimits{}.memory,
                       const std::function<bool()>& stopped = {});
  /// Waits for what readMesh gives of each. What cannot be read is left out, and so are all of a
  /// process that one breaks or brings beyond its limits: readMesh says what is wrong with it.
  std::map<std::filesystem::path, MeshFile> take();

 private:
  struct Share {
    std::vector<std::filesystem::path> files;
    GuardedWork reading;
  };
  std::vector<Share> shares_;
};

}  // namespace amble
