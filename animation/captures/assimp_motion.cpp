// Skeletal animation through Assimp 5.2.5. What it does to axes and units, by format:
//   Collada: the root's transform takes them to y up and metres;
//   FBX: neither, but the file's axes and unit are in the scene's metadata;
//   glTF: is y up and in metres.
// An FBX node's pivots and pre-rotations become nodes of their own above it, named
// `Name_$AssimpFbx$_...`, with tracks of their own.
#include "animation/captures/assimp_motion.h"

#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <map>
#include <set>

#include "animation/captures/node_animation.h"
#include "base/assimp_scene.h"
#include "base/byte_pack.h"
#include "base/error.h"
#include "base/guarded_run.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr const char* kHelperMark = "_$AssimpFbx$_";
constexpr const char* kNoAnimation = "holds no animation";
constexpr const char* kExpected = "animation of a skeleton as FBX, glTF, GLB or DAE";

// Far more than a person's; a scene around one has some thousands.
constexpr size_t kMaxNodes = 100'000;

// Assimp's own, where a file does not say its ticks [1/s].
constexpr double kUsualTicks = 25.0;

// Rates of frames that an FBX may mean [1/s].
constexpr double kMinRate = 1.0, kMaxRate = 1000.0;

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
    throw InputError(file, lineIn(problem), "cannot be read: " + oneLine(problem), kExpected);
  }
  return *scene;
}

const aiScene& importFile(Assimp::Importer& importer, const std::string& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    throw InputError(file, 0, "no such file", kExpected);
  }
  return importScene(importer, file, [&] { return importer.ReadFile(file, 0); });
}

size_t keyCount(const aiAnimation& animation) {
  size_t keys = 0;
  for (unsigned i = 0; i < animation.mNumChannels; ++i) {
    const aiNodeAnim& channel = *animation.mChannels[i];
    keys += static_cast<size_t>(channel.mNumPositionKeys) + channel.mNumRotationKeys +
            channel.mNumScalingKeys;
  }
  return keys;
}

const aiAnimation& chooseAnimation(const aiScene& scene, const std::string& file,
                                   AssimpMotionNotes& notes) {
  const aiAnimation* best = nullptr;
  for (unsigned i = 0; i < scene.mNumAnimations; ++i) {
    const aiAnimation* const animation = scene.mAnimations[i];
    if (best == nullptr || keyCount(*animation) > keyCount(*best)) best = animation;
  }
  if (best == nullptr || best->mNumChannels == 0) {
    throw InputError(file, 0, kNoAnimation, kExpected);
  }
  if (scene.mNumAnimations > 1) {
    notes.warnings.push_back(file + ": of " + std::to_string(scene.mNumAnimations) +
                             " animations '" + oneLine(best->mName.C_Str()) + "' is read");
  }
  return *best;
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

/// A track that a file leaves out stays at rest.
template <typename T>
void fillTrack(KeyTrack<T>& track, double time, const T& rest) {
  if (track.times.empty()) track = {{time}, {rest}};
}

NodeTracks tracksOf(const aiNodeAnim& channel, double ticks, const Eigen::Affine3d& X_PN) {
  NodeTracks tracks;
  copyTrack(channel.mPositionKeys, channel.mNumPositionKeys, ticks, tracks.translations);
  copyTrack(channel.mRotationKeys, channel.mNumRotationKeys, ticks, tracks.rotations);
  copyTrack(channel.mScalingKeys, channel.mNumScalingKeys, ticks, tracks.scales);
  if (tracks.empty()) return tracks;
  Eigen::Matrix3d R, S;
  X_PN.computeRotationScaling(&R, &S);
  double time = 0.0;
  for (const std::vector<double>* times :
       {&tracks.translations.times, &tracks.rotations.times, &tracks.scales.times}) {
    if (!times->empty()) time = times->front();
  }
  fillTrack<Eigen::Vector3d>(tracks.translations, time, X_PN.translation());
  fillTrack<Eigen::Quaterniond>(tracks.rotations, time, Eigen::Quaterniond(R));
  fillTrack<Eigen::Vector3d>(tracks.scales, time, S.diagonal());
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
std::vector<AnimatedNode> nodesOf(const aiScene& scene, const std::string& file,
                                  const aiAnimation& animation) {
  const NamedNodes named(scene);
  const double ticks = animation.mTicksPerSecond > 0.0 ? animation.mTicksPerSecond : kUsualTicks;
  std::map<std::string, const aiNodeAnim*> channels;
  for (unsigned i = 0; i < animation.mNumChannels; ++i) {
    channels.emplace(animation.mChannels[i]->mNodeName.C_Str(), animation.mChannels[i]);
  }
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
    const auto channel = channels.find(node.name);
    if (channel != channels.end()) node.tracks = tracksOf(*channel->second, ticks, node.X_PN);
    nodes.push_back(std::move(node));
    for (unsigned c = from->mNumChildren; c-- > 0;) {
      open.push_back({from->mChildren[c], static_cast<int>(nodes.size()) - 1});
    }
  }
  return nodes;
}

/// The file's axes and unit; what the caller asks for holds instead.
void settleAxes(const aiScene& scene, const std::string& file, const std::string& ending,
                const AssimpMotionOptions& options, AnimatedNodes& nodes,
                AssimpMotionNotes& notes) {
  notes = {1.0, UpAxis::kY, std::move(notes.warnings)};
  Eigen::Affine3d X = Eigen::Affine3d(yUpToWorld());
  if (ending == ".fbx") {
    X = fbxToWorld(scene, file);
    notes.metres_per_unit = fbxUnit(scene);
    notes.up = X.linear().col(1).z() != 0.0 ? UpAxis::kY : UpAxis::kZ;
  } else if (ending == ".dae") {
    // Assimp's root takes the file to y up and metres.
    Eigen::Affine3d& root = nodes.nodes[0].X_PN;
    const double scale = std::cbrt(std::abs(root.linear().determinant()));
    if (!(scale > 0.0)) throw InputError(file, 0, "a unit of no length", "more than 0");
    X = X * root;
    root = Eigen::Affine3d::Identity();
    notes.metres_per_unit = scale;
    notes.up = std::abs(X.linear().col(1).z()) > 0.5 * scale ? UpAxis::kY : UpAxis::kZ;
  }
  if (options.metres_per_unit) {
    X.linear() *= *options.metres_per_unit / notes.metres_per_unit;
    notes.metres_per_unit = *options.metres_per_unit;
  }
  if (options.up && *options.up != notes.up) {
    X = Eigen::Affine3d(Eigen::Scaling(notes.metres_per_unit));
    if (*options.up == UpAxis::kY) X = Eigen::Affine3d(yUpToWorld()) * X;
    notes.up = *options.up;
  }
  nodes.X_WFile = X;
}

/// A scene as far as it is wanted, or why it is refused.
struct ImportedNodes {
  AnimatedNodes nodes;
  AssimpMotionNotes notes;
  bool refused = false;
  int line = 0;  // of the refusal
  std::string problem, expected;
};

ImportedNodes nodesOfScene(const aiScene& scene, const std::string& name,
                           const AssimpMotionOptions& options) {
  ImportedNodes imported;
  const std::string ending = lowerEnding(name);
  const aiAnimation& animation = chooseAnimation(scene, name, imported.notes);
  imported.nodes.nodes = nodesOf(scene, name, animation);
  settleAxes(scene, name, ending, options, imported.nodes, imported.notes);
  const double rate = animation.mTicksPerSecond;
  if (ending == ".fbx" && rate >= kMinRate && rate <= kMaxRate) {
    imported.nodes.frame_time = 1.0 / rate;
  }
  return imported;
}

/// Everything that a node has, in one order for both ways.
template <typename Each, typename Node>
void visit(Each& each, Node& node) {
  each(node.name);
  each(node.parent);
  each(node.X_PN.matrix());
  each(node.tracks.translations.times);
  each(node.tracks.translations.values);
  each(node.tracks.rotations.times);
  each(node.tracks.rotations.values);
  each(node.tracks.scales.times);
  each(node.tracks.scales.values);
  each(node.helper);
  each(node.bone);
  each(node.thing);
}

template <typename Each, typename Imported>
void visitImported(Each& each, Imported& imported) {
  each(imported.refused);
  each(imported.line);
  each(imported.problem);
  each(imported.expected);
  each(imported.notes.metres_per_unit);
  each(imported.notes.up);
  each(imported.notes.warnings);
  each(imported.nodes.X_WFile.matrix());
  each(imported.nodes.frame_time);
}

std::string packed(const ImportedNodes& imported) {
  Packer pack;
  visitImported(pack, imported);
  pack(imported.nodes.nodes.size());
  for (const AnimatedNode& node : imported.nodes.nodes) visit(pack, node);
  return pack.bytes();
}

ImportedNodes unpacked(const std::string& bytes) {
  Unpacker unpack(bytes);
  ImportedNodes imported;
  visitImported(unpack, imported);
  for (size_t count = unpack.takeCount(); count > 0; --count) {
    visit(unpack, imported.nodes.nodes.emplace_back());
  }
  return imported;
}

/// Assimp recurses as deep as a file nests, and for ever where nodes are below themselves: it works
/// in a process of its own. `import` returns the scene.
template <typename Import>
ImportedNodes importGuarded(const std::string& name, const AssimpMotionOptions& options,
                            Import import) {
  const GuardLimits limits;
  const auto work = [&]() -> std::string {
    Assimp::Importer importer;
    try {
      return packed(nodesOfScene(import(importer), name, options));
    } catch (const InputError& error) {
      ImportedNodes refusal;
      refusal.refused = true;
      refusal.line = error.line();
      refusal.problem = error.problem();
      refusal.expected = error.expected();
      return packed(refusal);
    }
  };
  const GuardedAnswer answer = runGuarded(work, limits);
  if (!answer.done()) throw InputError(name, 0, "cannot be read: " + answer.why(limits), kExpected);
  ImportedNodes imported = unpacked(answer.bytes);
  if (imported.refused) {
    throw InputError(name, imported.line, imported.problem, imported.expected);
  }
  return imported;
}

Clip clipOf(ImportedNodes imported, const std::string& name, const AssimpMotionOptions& options,
            AssimpMotionNotes* notes) {
  if (notes != nullptr) *notes = std::move(imported.notes);
  return clipOfNodes(imported.nodes, name, options.frame_time);
}

}  // namespace

Clip readAssimpMotion(const std::filesystem::path& file, const AssimpMotionOptions& options,
                      AssimpMotionNotes* notes) {
  const std::string name = file.string();
  const auto import = [&name](Assimp::Importer& importer) -> const aiScene& {
    return importFile(importer, name);
  };
  return clipOf(importGuarded(name, options, import), name, options, notes);
}

Clip parseAssimpMotion(std::string_view bytes, const std::string& name,
                       const AssimpMotionOptions& options, AssimpMotionNotes* notes) {
  const std::string ending = lowerEnding(name);
  const auto import = [&](Assimp::Importer& importer) -> const aiScene& {
    return importScene(importer, name, [&] {
      return importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0,
                                         ending.empty() ? "" : ending.c_str() + 1);
    });
  };
  return clipOf(importGuarded(name, options, import), name, options, notes);
}

bool holdsAnimation(const std::filesystem::path& file) {
  const std::string name = file.string();
  try {
    importGuarded(name, {}, [&name](Assimp::Importer& importer) -> const aiScene& {
      return importFile(importer, name);
    });
  } catch (const InputError& error) {
    if (error.problem() == kNoAnimation) return false;
    throw;
  }
  return true;
}

}  // namespace amble
