// Reading meshes through Assimp 5.2.5. What it does to axes and units, by format:
//   Collada: root transform to y up and metres; IFC the same, by its root's transform;
//   FBX: neither, but the file's axes and unit are in the scene's metadata;
//   glTF: is y up and in metres; OBJ, PLY, STL: say nothing.

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>

#include "base/assimp_scene.h"
#include "base/error.h"
#include "environments/scene/mesh.h"

namespace amble {
namespace {

constexpr const char* kFormats = "OBJ, glTF or GLB, PLY, STL, DAE, FBX or IFC";

std::string lowerCase(std::string s) {
  std::transform(s.begin(), s.end(), s.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return s;
}

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

}  // namespace

MeshFile readMesh(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    throw InputError(name, 0, "no such file", std::string("a mesh as ") + kFormats);
  Assimp::Importer importer;
  const std::string extension = lowerCase(file.extension().string());
  if (extension.empty() || !importer.IsExtensionSupported(extension))
    throw InputError(name, 0, "not a format for meshes", kFormats);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_ANIMATIONS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_TEXTURES, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
  const aiScene* scene = nullptr;
  std::string problem;
  try {
    scene = importer.ReadFile(name, aiProcess_Triangulate | aiProcess_SortByPType);
    if (!scene) problem = importer.GetErrorString();
  } catch (const std::exception& e) {
    problem = e.what();
  }
  if (!scene || !scene->mRootNode)
    throw InputError(name, 0, "cannot be read: " + oneLine(problem),
                     std::string("a mesh as ") + kFormats);

  MeshFile result;
  const bool y_up = extension == ".dae" || extension == ".gltf" || extension == ".glb" ||
                    extension == ".ifc" || extension == ".ifczip";
  Eigen::Affine3d X = Eigen::Affine3d::Identity();
  if (y_up) X.linear() = yUpMatrix();
  if (extension == ".fbx") X = fbxToWorld(*scene, name);
  result.has_axes = y_up || extension == ".fbx";
  PartCollector(*scene, name).collect(*scene->mRootNode, X, {}, result.parts);
  if (result.parts.empty())
    throw InputError(name, 0, "holds no triangles", "at least one with an area");
  return result;
}

}  // namespace amble
