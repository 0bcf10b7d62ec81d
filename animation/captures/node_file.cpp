#include "animation/captures/node_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "animation/captures/node_scene.h"
#include "base/byte_pack.h"
#include "base/error.h"
#include "base/guarded_run.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr const char* kNoAnimation = "holds no animation";
constexpr size_t kToldTakes = 10;

/// A scene as far as it is wanted, or why it is refused.
struct ImportedNodes {
  AnimatedNodes nodes;
  NodeFileNotes notes;
  bool refused = false, still = false;  // still: it has no animation at all
  int line = 0;                         // of the refusal
  std::string problem, expected;
};

std::string namesOf(const std::vector<NodeTake>& takes) {
  std::string names;
  for (size_t i = 0; i < std::min(takes.size(), kToldTakes); ++i) {
    names += (i == 0 ? "'" : ", '") + takes[i].name + "'";
  }
  return takes.size() > kToldTakes ? names + ", ..." : names;
}

const NodeTake& chooseTake(const std::vector<NodeTake>& takes, const std::string& wanted,
                           const std::string& file, NodeFileNotes& notes) {
  if (!wanted.empty()) {
    for (const NodeTake& take : takes) {
      if (take.name == wanted) return take;
    }
    throw InputError(file, 0, "has no animation '" + wanted + "'", "--take " + namesOf(takes));
  }
  const NodeTake* best = &takes[0];
  double most = movementIn(*best);
  for (const NodeTake& take : takes) {
    const double movement = movementIn(take);
    if (movement <= most) continue;
    best = &take;
    most = movement;
  }
  if (takes.size() > 1) {
    notes.warnings.push_back(
        fmt::format("of {} animations '{}' is read, in which most moves; --take chooses of {}",
                    takes.size(), best->name, namesOf(takes)));
  }
  return *best;
}

/// Tracks that a file leaves out of an animated node stay at rest.
void fillTracks(AnimatedNode& node) {
  NodeTracks& tracks = node.tracks;
  if (tracks.empty()) return;
  double time = 0.0;
  for (const std::vector<double>* times :
       {&tracks.translations.times, &tracks.rotations.times, &tracks.scales.times}) {
    if (!times->empty()) time = times->front();
  }
  Eigen::Matrix3d R, S;
  node.X_PN.computeRotationScaling(&R, &S);
  const auto fill = [time](auto& track, const auto& rest) {
    if (track.times.empty()) track = {{time}, {rest}};
  };
  fill(tracks.translations, Eigen::Vector3d(node.X_PN.translation()));
  fill(tracks.rotations, Eigen::Quaterniond(R));
  fill(tracks.scales, Eigen::Vector3d(S.diagonal()));
}

/// What the caller asks for holds instead of the file's axes and unit.
void settleAxes(const NodeFileOptions& options, const NodeScene& scene, ImportedNodes& imported) {
  NodeFileNotes& notes = imported.notes;
  Eigen::Affine3d& X = imported.nodes.X_WFile;
  notes.metres_per_unit = scene.metres_per_unit;
  notes.up = scene.up;
  if (options.metres_per_unit) {
    X.linear() *= *options.metres_per_unit / notes.metres_per_unit;
    notes.metres_per_unit = *options.metres_per_unit;
  }
  if (options.up && *options.up != notes.up) {
    X = Eigen::Affine3d(Eigen::Scaling(notes.metres_per_unit));
    if (*options.up == UpAxis::kY) X = Eigen::Affine3d(yUpToWorld()) * X;
    notes.up = *options.up;
  }
}

ImportedNodes import(const NodeSource& source, const NodeFileOptions& options) {
  const std::string ending = lowerEnding(source.name);
  const bool assimp = ending == ".fbx" || ending == ".dae";
  NodeScene scene = assimp ? assimpScene(source) : gltfScene(source);
  ImportedNodes imported;
  imported.still = scene.takes.empty();
  if (imported.still) return imported;
  const NodeTake& take = chooseTake(scene.takes, options.take, source.name, imported.notes);
  imported.nodes = std::move(scene.nodes);
  imported.nodes.frame_time = take.frame_time;
  for (size_t n = 0; n < take.tracks.size(); ++n) imported.nodes.nodes[n].tracks = take.tracks[n];
  if (assimp) foldPivots(imported.nodes);
  for (AnimatedNode& node : imported.nodes.nodes) fillTracks(node);
  settleAxes(options, scene, imported);
  return imported;
}

template <typename Each, typename Track>
void visitTrack(Each& each, Track& track) {
  each(track.times);
  each(track.values);
  each(track.shape);
  each(track.in);
  each(track.out);
}

/// Everything that a node has, in one order for both ways.
template <typename Each, typename Node>
void visit(Each& each, Node& node) {
  each(node.name);
  each(node.parent);
  each(node.X_PN.matrix());
  visitTrack(each, node.tracks.translations);
  visitTrack(each, node.tracks.rotations);
  visitTrack(each, node.tracks.scales);
  each(node.helper);
  each(node.bone);
  each(node.thing);
}

template <typename Each, typename Imported>
void visitImported(Each& each, Imported& imported) {
  each(imported.refused);
  each(imported.still);
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

/// The formats' readers recurse as deep as a file nests, and for ever where nodes are below
/// themselves: they work in a process of their own.
ImportedNodes importGuarded(const NodeSource& source, const NodeFileOptions& options) {
  const GuardLimits limits{.memory = options.memory};
  const auto work = [&]() -> std::string {
    try {
      return packed(import(source, options));
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
  const std::string& name = source.name;
  if (!answer.done())
    throw InputError(name, 0, "cannot be read: " + answer.why(limits),
                     answer.end == GuardEnd::kMemory ? kMoreMemory : kNodeFile);
  ImportedNodes imported = unpacked(answer.bytes);
  if (imported.refused) {
    throw InputError(name, imported.line, imported.problem, imported.expected);
  }
  return imported;
}

std::optional<Clip> clipIfAny(const NodeSource& source, const NodeFileOptions& options,
                              NodeFileNotes* notes) {
  ImportedNodes imported = importGuarded(source, options);
  if (imported.still) return {};
  if (notes != nullptr) *notes = std::move(imported.notes);
  return clipOfNodes(imported.nodes, source.name, options.frame_time);
}

Clip required(std::optional<Clip> clip, const std::string& name) {
  if (!clip) throw InputError(name, 0, kNoAnimation, kNodeFile);
  return std::move(*clip);
}

}  // namespace

bool isNodeFile(const std::filesystem::path& file) {
  constexpr std::array kEndings = {".fbx", ".gltf", ".glb", ".vrma", ".dae"};
  return std::count(kEndings.begin(), kEndings.end(), lowerEnding(file)) > 0;
}

std::optional<Clip> readNodeFileIfAny(const std::filesystem::path& file,
                                      const NodeFileOptions& options, NodeFileNotes* notes) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    throw InputError(file.string(), 0, "no such file", kNodeFile);
  }
  if (std::filesystem::file_size(file, error) > kMaxNodeFile) {
    throw InputError(file.string(), 0, "is larger than " + sizeText(kMaxNodeFile),
                     std::string(kNodeFile) + " of at most that");
  }
  return clipIfAny({file.string()}, options, notes);
}

Clip readNodeFile(const std::filesystem::path& file, const NodeFileOptions& options,
                  NodeFileNotes* notes) {
  return required(readNodeFileIfAny(file, options, notes), file.string());
}

Clip parseNodeFile(std::string_view bytes, const std::string& name, const NodeFileOptions& options,
                   NodeFileNotes* notes) {
  return required(clipIfAny({name, &bytes}, options, notes), name);
}

}  // namespace amble
