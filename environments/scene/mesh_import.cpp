// Reading meshes through Assimp 5.2.5. What it does to axes and units, by format:
//   Collada: root transform to y up and metres; IFC the same, by its root's transform;
//   FBX: neither, but the file's axes and unit are in the scene's metadata;
//   glTF: is y up and in metres; PLY, STL: say nothing.

#include "environments/scene/mesh_import.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <set>
#include <string_view>

#include "base/assimp_scene.h"
#include "base/error.h"
#include "base/file_axes.h"
#include "base/text.h"

namespace amble {
namespace {

// A node's name as the file gave it: Assimp's own helper nodes have none.
std::string fileName(const aiNode& node) {
  const std::string name = node.mName.C_Str();
  if (!name.empty() && name.front() == '$') return "";
  return name.substr(0, name.find("_$AssimpFbx$_"));
}

class PartCollector {
 public:
  PartCollector(const aiScene& scene, std::string file) : scene_(scene), file_(std::move(file)) {}

  void collect(const aiNode& node, const Eigen::Affine3d& X_parent,
               const std::vector<std::string>& above, std::vector<MeshPart>& parts) {
    const std::string name = fileName(node);
    // Rooms and the holes of doors and windows are no things.
    if (name.starts_with("IfcSpace") || name.starts_with("IfcOpening")) return;
    const Eigen::Affine3d X = X_parent * nodeTransform(node);
    MeshPart part;
    if (!name.empty() && !isFileRoot(node)) part.names.push_back(name);
    for (unsigned i = 0; i < node.mNumMeshes; ++i)
      addMesh(*scene_.mMeshes[node.mMeshes[i]], X, part);
    std::vector<std::string> names = above;
    if (!part.names.empty()) names.insert(names.begin(), part.names.front());
    part.names.insert(part.names.end(), above.begin(), above.end());
    part.mesh = cleanMesh(part.mesh);
    if (!part.mesh.triangles.empty()) parts.push_back(std::move(part));
    for (unsigned i = 0; i < node.mNumChildren; ++i) collect(*node.mChildren[i], X, names, parts);
  }

 private:
  // Assimp names a root that the file does not have after the file or the format.
  bool isFileRoot(const aiNode& node) const {
    const std::string name = node.mName.C_Str();
    return node.mParent == nullptr && (name == std::filesystem::path(file_).filename().string() ||
                                       name == "RootNode" || name == "ROOT" || name.front() == '<');
  }

  void addMesh(const aiMesh& mesh, const Eigen::Affine3d& X, MeshPart& part) {
    const std::string name = mesh.mName.C_Str();
    if (!name.empty() && std::find(part.names.begin(), part.names.end(), name) == part.names.end())
      part.names.push_back(name);
    const int base = static_cast<int>(part.mesh.vertices.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D& p = mesh.mVertices[v];
      part.mesh.vertices.push_back(X * Eigen::Vector3d(p.x, p.y, p.z));
      if (!part.mesh.vertices.back().allFinite())
        throw InputError(file_, 0, "a vertex of '" + name + "' is not finite", "finite numbers");
    }
    const bool mirrored = X.linear().determinant() < 0.0;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue;
      std::array<int, 3> t;
      for (int k = 0; k < 3; ++k) {
        if (face.mIndices[k] >= mesh.mNumVertices)
          throw InputError(file_, 0,
                           "a triangle of '" + name + "' names a vertex that is not there",
                           "indices below " + std::to_string(mesh.mNumVertices));
        t[k] = base + static_cast<int>(face.mIndices[k]);
      }
      if (mirrored) std::swap(t[1], t[2]);
      part.mesh.triangles.push_back(t);
    }
  }

  const aiScene& scene_;
  std::string file_;
};

// The files that Assimp opens: the one that is read, and of those that it names the regular ones
// in its folder, wherever links lead.
class FolderFiles : public Assimp::DefaultIOSystem {
 public:
  explicit FolderFiles(const std::filesystem::path& file)
      : beside_(file.parent_path()),
        percents_(meshEnding(file) == ".gltf"),
        file_(placeOf(file)),
        folder_(placeOf(std::filesystem::absolute(file).parent_path())) {}

  bool Exists(const char* path) const override { return isAllowed(meant(path)); }
  Assimp::IOStream* Open(const char* path, const char* mode) override {
    const std::filesystem::path file = meant(path);
    if (isAllowed(file)) {
      if (placeOf(file) != file_) others_.insert(file);
      return Assimp::DefaultIOSystem::Open(file.c_str(), mode);
    }
    if (refused_.empty()) refused_ = path;
    return nullptr;
  }
  /// The first that was asked for and not opened, as it was named; or empty.
  const std::string& refused() const { return refused_; }
  /// What was opened beside the file itself.
  const std::set<std::filesystem::path>& others() const { return others_; }

 private:
  // A glTF names files by addresses, `my%20walk.bin`, which Assimp takes for names.
  std::filesystem::path meant(const std::filesystem::path& path) const {
    if (!percents_) return path;
    const std::filesystem::path plain =
        beside_ / withoutPercents(path.lexically_relative(beside_).string());
    return isAllowed(plain) ? plain : path;
  }
  static std::filesystem::path placeOf(const std::filesystem::path& file) {
    std::error_code error;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(file), error);
  }
  bool isAllowed(const std::filesystem::path& path) const {
    std::error_code error;
    const std::filesystem::path place = placeOf(path);
    if (!std::filesystem::is_regular_file(place, error)) return false;
    const auto [end, ignored] =
        std::mismatch(folder_.begin(), folder_.end(), place.begin(), place.end());
    return place == file_ || end == folder_.end();
  }

  std::filesystem::path beside_;  // the folder as the file's name has it
  bool percents_;
  std::filesystem::path file_, folder_;
  std::string refused_;
  std::set<std::filesystem::path> others_;
};

// What Assimp drops of a file with no more than a warning: of a glTF those triangles whose corners
// are no vertices of it. One at a time: Assimp has one log.
class DroppedFaces {
 public:
  DroppedFaces() { Assimp::DefaultLogger::set(new Log(there_)); }  // which takes it over
  ~DroppedFaces() { Assimp::DefaultLogger::set(nullptr); }
  DroppedFaces(const DroppedFaces&) = delete;
  DroppedFaces& operator=(const DroppedFaces&) = delete;

  bool there() const { return there_; }

 private:
  class Log : public Assimp::Logger {
   public:
    explicit Log(bool& there) : there_(there) {}
    bool attachStream(Assimp::LogStream*, unsigned) override { return false; }
    bool detachStream(Assimp::LogStream*, unsigned) override { return false; }

   private:
    void OnDebug(const char*) override {}
    void OnVerboseDebug(const char*) override {}
    void OnInfo(const char*) override {}
    void OnWarn(const char* message) override {
      there_ |= std::string_view(message).find("out-of-range indices") != std::string_view::npos;
    }
    void OnError(const char*) override {}

    bool& there_;
  };

  bool there_ = false;
};

bool isYUp(const std::string& ending) {
  return ending == ".dae" || ending == ".gltf" || ending == ".glb" || ending == ".ifc" ||
         ending == ".ifczip";
}

[[noreturn]] void failReading(const std::string& name, const std::string& problem,
                              const std::string& refused) {
  // What Assimp says where all that there is has been left out.
  if (problem.find("No meshes remaining") != std::string::npos)
    throw InputError(name, 0, "holds only points or lines, no faces", "a mesh of faces");
  if (!refused.empty())
    throw InputError(name, 0, "cannot be read: it refers to '" + oneLine(refused) + "'",
                     "a regular file in its own folder");
  throw InputError(name, 0, "cannot be read: " + oneLine(problem),
                   std::string("a mesh as ") + kMeshFormats);
}

void checkCorners(const aiScene& scene, const std::string& name) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[m];
    for (unsigned f = 0; f < mesh.mNumFaces; ++f)
      if (mesh.mFaces[f].mNumIndices > unsigned{kMostCorners})
        throw InputError(name, 0,
                         "a face of '" + oneLine(mesh.mName.C_Str()) + "' has " +
                             std::to_string(mesh.mFaces[f].mNumIndices) + " corners",
                         "at most " + std::to_string(kMostCorners) + " in a face");
  }
}

// Read, then cut into triangles: null, or an exception of Assimp's, where one of the two fails.
const aiScene* readTriangles(Assimp::Importer& importer, const std::string& name) {
  const aiScene* const scene = importer.ReadFile(name, 0);
  if (!scene) return nullptr;
  checkCorners(*scene, name);
  return importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_SortByPType);
}

void configure(Assimp::Importer& importer) {
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_ANIMATIONS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_TEXTURES, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
}

}  // namespace

std::string meshEnding(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

bool isMeshEnding(const std::string& ending) {
  if (ending.empty()) return false;
  if (ending == ".obj") return true;  // most are, and an importer is not made for nothing
  static const Assimp::Importer importer;
  return importer.IsExtensionSupported(ending);
}

MeshFile importMesh(const std::filesystem::path& file) {
  const std::string name = file.string();
  Assimp::Importer importer;
  configure(importer);
  FolderFiles* const files = new FolderFiles(file);
  importer.SetIOHandler(files);  // which takes it over
  const aiScene* scene = nullptr;
  std::string problem;
  const DroppedFaces dropped;
  try {
    scene = readTriangles(importer, name);
    if (!scene) problem = importer.GetErrorString();
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& e) {
    problem = e.what();
  }
  if (dropped.there())
    throw InputError(name, 0, "a triangle names a vertex that is not there",
                     "indices below the number of its mesh's vertices");
  if (!scene || !scene->mRootNode) failReading(name, problem, files->refused());

  MeshFile result;
  const std::string ending = meshEnding(file);
  Eigen::Affine3d X = Eigen::Affine3d::Identity();
  if (isYUp(ending)) X.linear() = yUpMatrix();
  if (ending == ".fbx") X = fbxToWorld(*scene, name);
  result.has_axes = isYUp(ending) || ending == ".fbx";
  for (const std::filesystem::path& other : files->others())
    result.others.push_back(other.string());
  PartCollector(*scene, name).collect(*scene->mRootNode, X, {}, result.parts);
  if (result.parts.empty())
    throw InputError(name, 0, "holds no triangles", "at least one with an area");
  return result;
}

}  // namespace amble
