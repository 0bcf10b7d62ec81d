// FBX and Collada through Assimp 5.2.5. What it does to axes and units, by format:
//   Collada: the root's transform takes them to y up and metres;
//   FBX: neither, but the file's axes and unit are in the scene's metadata.
// An FBX node's pivots and pre-rotations become nodes of their own above it, named
// `Name_$AssimpFbx$_...`. Where pivots are among them each part has tracks of its own; else one
// track has the node's whole place, in which Assimp forgets to invert the post-rotation.
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <map>
#include <set>

#include "animation/captures/node_scene.h"
#include "base/assimp_scene.h"
#include "base/error.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr const char* kHelperMark = "_$AssimpFbx$_";
constexpr const char* kPostRotation = "_$AssimpFbx$_PostRotation";

// Assimp's own, where a file does not say its ticks [1/s].
constexpr double kUsualTicks = 25.0;

// Rates of frames that an FBX may mean [1/s].
constexpr double kMinFbxRate = 1.0, kMaxFbxRate = 1000.0;

/// The number behind the first "line" of a message of Assimp's; 0: none.
int lineIn(const std::string& problem) {
  const size_t at = problem.find("line ");
  int line = 0;
  for (size_t i = at == problem.npos ? problem.size() : at + 5;
       i < problem.size() && std::isdigit(static_cast<unsigned char>(problem[i])) &&
       line < 100'000'000;
       ++i) {
    line = 10 * line + (problem[i] - '0');
  }
  return line;
}

/// Calls Assimp by `import` and takes what it throws or leaves for an error.
template <typename Import>
const aiScene& importScene(Assimp::Importer& importer, const std::string& file, Import import) {
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_TEXTURES, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_MATERIALS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
  const aiScene* scene = nullptr;
  std::string problem;
  try {
    scene = import();
    if (scene == nullptr) problem = importer.GetErrorString();
  } catch (const std::exception& thrown) {
    problem = thrown.what();
  }
  if (scene == nullptr || scene->mRootNode == nullptr) {
    throw InputError(file, lineIn(problem), "cannot be read: " + oneLine(problem), kNodeFile);
  }
  return *scene;
}

Eigen::Vector3d valueOf(const aiVectorKey& key) {
  return {key.mValue.x, key.mValue.y, key.mValue.z};
}

Eigen::Quaterniond valueOf(const aiQuatKey& key) {
  return Eigen::Quaterniond(key.mValue.w, key.mValue.x, key.mValue.y, key.mValue.z).normalized();
}

template <typename Key, typename T>
void copyTrack(const Key* keys, unsigned count, double ticks, KeyTrack<T>& track) {
  for (unsigned i = 0; i < count; ++i) {
    track.times.push_back(keys[i].mTime / ticks);
    track.values.push_back(valueOf(keys[i]));
  }
}

NodeTracks tracksOf(const aiNodeAnim& channel, double ticks) {
  NodeTracks tracks;
  copyTrack(channel.mPositionKeys, channel.mNumPositionKeys, ticks, tracks.translations);
  copyTrack(channel.mRotationKeys, channel.mNumRotationKeys, ticks, tracks.rotations);
  copyTrack(channel.mScalingKeys, channel.mNumScalingKeys, ticks, tracks.scales);
  return tracks;
}

/// Names of the nodes that a skin, a camera or a light goes by.
struct NamedNodes {
  std::set<std::string> bones, things;

  explicit NamedNodes(const aiScene& scene) {
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
      for (unsigned b = 0; b < scene.mMeshes[m]->mNumBones; ++b) {
        bones.insert(scene.mMeshes[m]->mBones[b]->mName.C_Str());
      }
    }
    for (unsigned i = 0; i < scene.mNumCameras; ++i) {
      things.insert(scene.mCameras[i]->mName.C_Str());
    }
    for (unsigned i = 0; i < scene.mNumLights; ++i) things.insert(scene.mLights[i]->mName.C_Str());
  }
};

/// Parents first, children in the file's order; by a stack, for a file may nest as deep as it
/// likes.
std::vector<AnimatedNode> nodesOf(const aiScene& scene, const std::string& file) {
  const NamedNodes named(scene);
  std::vector<AnimatedNode> nodes;
  std::vector<std::pair<const aiNode*, int>> open = {{scene.mRootNode, -1}};
  while (!open.empty()) {
    const auto [from, parent] = open.back();
    open.pop_back();
    if (nodes.size() >= kMaxNodes) throw InputError(file, 0, "too many nodes", "at most 100,000");
    AnimatedNode node;
    node.name = from->mName.C_Str();
    node.parent = parent;
    node.X_PN = nodeTransform(*from);
    node.helper = node.name.find(kHelperMark) != std::string::npos;
    node.bone = named.bones.contains(node.name);
    node.thing = from->mNumMeshes > 0 || named.things.contains(node.name);
    nodes.push_back(std::move(node));
    for (unsigned c = from->mNumChildren; c-- > 0;) {
      open.push_back({from->mChildren[c], static_cast<int>(nodes.size()) - 1});
    }
  }
  return nodes;
}

NodeTake takeOf(const aiAnimation& animation, const std::vector<AnimatedNode>& nodes) {
  const double rate = animation.mTicksPerSecond, ticks = rate > 0.0 ? rate : kUsualTicks;
  std::map<std::string, const aiNodeAnim*> channels;
  for (unsigned i = 0; i < animation.mNumChannels; ++i) {
    channels.emplace(animation.mChannels[i]->mNodeName.C_Str(), animation.mChannels[i]);
  }
  NodeTake take;
  take.name = oneLine(animation.mName.C_Str());
  for (const AnimatedNode& node : nodes) {
    const auto channel = channels.find(node.name);
    take.tracks.push_back(channel == channels.end() ? NodeTracks()
                                                    : tracksOf(*channel->second, ticks));
  }
  return take;
}

/// The file's axes and unit.
void settleAxes(const aiScene& scene, const NodeSource& source, NodeScene& result) {
  Eigen::Affine3d& X = result.nodes.X_WFile;
  if (lowerEnding(source.name) == ".fbx") {
    X = fbxToWorld(scene, source.name);
    result.metres_per_unit = fbxUnit(scene);
    result.up = X.linear().col(1).z() != 0.0 ? UpAxis::kY : UpAxis::kZ;
    return;
  }
  // Assimp's root takes a Collada file to y up and metres.
  Eigen::Affine3d& root = result.nodes.nodes[0].X_PN;
  const double scale = std::cbrt(std::abs(root.linear().determinant()));
  if (!(scale > 0.0)) throw InputError(source.name, 0, "a unit of no length", "more than 0");
  X = Eigen::Affine3d(yUpToWorld()) * root;
  root = Eigen::Affine3d::Identity();
  result.metres_per_unit = scale;
  result.up = std::abs(X.linear().col(1).z()) > 0.5 * scale ? UpAxis::kY : UpAxis::kZ;
}

bool endsWith(const std::string& name, const char* end) { return name.ends_with(end); }

/// By node: the highest of the helpers that are above it without a track; itself where there are
/// none, or where one has a track.
std::vector<int> stillChains(const std::vector<AnimatedNode>& nodes) {
  std::vector<int> tops(nodes.size());
  std::vector<bool> still(nodes.size(), true);
  for (size_t n = 0; n < nodes.size(); ++n) {
    const int parent = nodes[n].parent;
    const bool chained = parent >= 0 && nodes[parent].helper;
    if (chained) still[n] = still[parent];
    if (nodes[n].helper) still[n] = still[n] && nodes[n].tracks.empty();
    tops[n] = chained && still[n] ? tops[parent] : static_cast<int>(n);
  }
  return tops;
}

}  // namespace

void foldPivots(AnimatedNodes& scene) {
  const std::vector<AnimatedNode> all = std::move(scene.nodes);
  const std::vector<int> tops = stillChains(all);
  // Helpers that have something else below them than their node stay.
  std::vector<bool> folded(all.size(), false);
  for (size_t n = 0; n < all.size(); ++n) {
    for (int p = all[n].parent; !all[n].helper && p >= tops[n] && p >= 0; p = all[p].parent) {
      folded[p] = true;
    }
  }
  scene.nodes.clear();
  std::vector<int> index(all.size(), -1);
  for (size_t n = 0; n < all.size(); ++n) {
    if (folded[n]) continue;
    AnimatedNode node = all[n];
    for (int p = node.parent; p >= 0 && folded[p]; p = all[p].parent) {
      node.X_PN = all[p].X_PN * node.X_PN;
      if (endsWith(all[p].name, kPostRotation)) {
        const Eigen::Quaterniond inverse(all[p].X_PN.rotation());
        for (Eigen::Quaterniond& q : node.tracks.rotations.values) q = q * inverse * inverse;
      }
      node.parent = all[p].parent;
    }
    node.parent = node.parent < 0 ? -1 : index[node.parent];
    index[n] = static_cast<int>(scene.nodes.size());
    scene.nodes.push_back(std::move(node));
  }
}

NodeScene assimpScene(const NodeSource& source) {
  Assimp::Importer importer;
  const std::string ending = lowerEnding(source.name);
  const aiScene& scene = importScene(importer, source.name, [&] {
    if (source.bytes == nullptr) return importer.ReadFile(source.name, 0);
    return importer.ReadFileFromMemory(source.bytes->data(), source.bytes->size(), 0,
                                       ending.empty() ? "" : ending.c_str() + 1);
  });
  NodeScene result;
  result.nodes.nodes = nodesOf(scene, source.name);
  settleAxes(scene, source, result);
  for (unsigned i = 0; i < scene.mNumAnimations; ++i) {
    const aiAnimation& animation = *scene.mAnimations[i];
    if (animation.mNumChannels == 0) continue;
    result.takes.push_back(takeOf(animation, result.nodes.nodes));
    const double rate = animation.mTicksPerSecond;
    if (ending == ".fbx" && rate >= kMinFbxRate && rate <= kMaxFbxRate) {
      result.takes.back().frame_time = 1.0 / rate;
    }
  }
  return result;
}

}  // namespace amble
