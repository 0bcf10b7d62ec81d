#include "animation/graph/graph_file.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <set>

#include "base/byte_pack.h"
#include "base/error.h"
#include "base/files.h"
#include "base/output_file.h"
#include "base/sha256.h"
#include "base/text.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "files are little-endian");

constexpr FileKind kGraphKind = {"a cluster graph (amble graph build)", kMaxGraphFile};
constexpr std::string_view kTitle = "amble graph 1\n";
constexpr std::string_view kAnyTitle = "amble graph ";
constexpr size_t kDigest = 64;          // of SHA-256, in hexadecimal [bytes]
constexpr double kLongestFrame = 10.0;  // [s]
constexpr double kMostSteps = 1e5;      // frames of a file for one of the graph's
constexpr double kMostFileFrames = 1e9;
constexpr float kLargestFeature = 1e6f;   // [m]
constexpr int kMostFrames = 100'000'000;  // so that sums of two stay whole numbers

// Reading and packing go through the same list of values.
template <typename Pack>
void passReading(Pack& pack, double& unit, int& up, bool& faces, double& facing, double& frame_time,
                 std::string& take, std::string& asf, std::string& roles) {
  pack(unit);
  pack(up);
  pack(faces);
  pack(facing);
  pack(frame_time);
  pack(take);
  pack(asf);
  pack(roles);
}

void packReading(const MotionReadOptions& reading, Packer& pack) {
  double unit = reading.metres_per_unit.value_or(0.0);
  int up = reading.up ? static_cast<int>(*reading.up) : -1;
  bool faces = reading.facing.has_value();
  double facing = reading.facing.value_or(0.0), frame_time = reading.frame_time.value_or(0.0);
  std::string take = reading.take, asf = reading.asf.string(), roles = reading.roles.string();
  passReading(pack, unit, up, faces, facing, frame_time, take, asf, roles);
}

MotionReadOptions unpackReading(Unpacker& unpack) {
  double unit = 0.0, facing = 0.0, frame_time = 0.0;
  int up = 0;
  bool faces = false;
  std::string take, asf, roles;
  passReading(unpack, unit, up, faces, facing, frame_time, take, asf, roles);
  MotionReadOptions reading;
  if (unit != 0.0) reading.metres_per_unit = unit;
  if (up >= 0) reading.up = static_cast<UpAxis>(up);
  if (faces) reading.facing = facing;
  if (frame_time != 0.0) reading.frame_time = frame_time;
  reading.take = take;
  reading.asf = asf;
  reading.roles = roles;
  return reading;
}

const char* faultOf(const MotionReadOptions& reading) {
  if (reading.metres_per_unit &&
      !(*reading.metres_per_unit > 0.0 && *reading.metres_per_unit < 1e9))
    return "a unit that is none";
  if (reading.up && *reading.up != UpAxis::kY && *reading.up != UpAxis::kZ)
    return "an axis that is none";
  if (reading.facing && !std::isfinite(*reading.facing)) return "a heading that is none";
  if (reading.frame_time && !(*reading.frame_time > 0.0 && *reading.frame_time <= kLongestFrame))
    return "a frame time that is none";
  return nullptr;
}

const char* faultOf(const std::vector<GraphClip>& clips, int frames) {
  int first = 0;
  for (const GraphClip& clip : clips) {
    if (clip.first != first || clip.frames < 1 || clip.frames > frames - first ||
        clip.first_frame < 0 || clip.first_frame > kMostFrames ||
        !(clip.step > 0.0 && clip.step <= kMostSteps) ||
        clip.first_frame + clip.step * clip.frames > kMostFileFrames)
      return "a clip of no frames";
    first += clip.frames;
  }
  return first == frames ? nullptr : "frames of no clip";
}

// Each node is merged once, after it was made, with one of its own state.
const char* faultOf(const std::vector<Merge>& merges, const std::vector<SupportState>& states) {
  const int frames = static_cast<int>(states.size());
  std::vector<bool> merged(frames + merges.size(), false);
  std::vector<SupportState> state = states;
  for (size_t k = 0; k < merges.size(); ++k) {
    const Merge& merge = merges[k];
    const int made = frames + static_cast<int>(k);
    for (const int node : {merge.a, merge.b}) {
      if (node < 0 || node >= made || merged[node]) return "a tree that is none";
      merged[node] = true;
    }
    if (state[merge.a] != state[merge.b]) return "a cluster of two states";
    if (!(merge.error >= 0.0f) || !std::isfinite(merge.error)) return "an error that is none";
    state.push_back(state[merge.a]);
  }
  const std::set<SupportState> there(states.begin(), states.end());
  return merges.size() + there.size() == states.size() ? nullptr : "trees that are not whole";
}

// What its numbers must be; a text is what they are not.
const char* faultOf(const KeptGraph& kept) {
  const ClusterGraph& graph = kept.graph;
  if (!(graph.frame_time > 0.0 && graph.frame_time <= kLongestFrame))
    return "a frame time that is none";
  if (graph.states.empty() || graph.states.size() > static_cast<size_t>(kMostFrames))
    return "no frames";
  for (const SupportState state : graph.states)
    if (static_cast<int>(state) >= kSupportStates) return "a state that is none";
  if (!(graph.features.cwiseAbs().maxCoeff() <= kLargestFeature) || !graph.features.allFinite())
    return "a frame that is nowhere";
  for (const std::vector<GraphInput>& inputs : kept.inputs)
    if (inputs.empty()) return "a clip of no file";
  if (const char* fault = faultOf(kept.reading)) return fault;
  if (const char* fault = faultOf(graph.clips, graph.frames())) return fault;
  return faultOf(graph.merges, graph.states);
}

std::string packBody(const KeptGraph& kept) {
  Packer pack;
  packReading(kept.reading, pack);
  pack(kept.graph.frame_time);
  pack(kept.graph.clips.size());
  for (size_t i = 0; i < kept.graph.clips.size(); ++i) {
    const GraphClip& clip = kept.graph.clips[i];
    pack(clip.name);
    pack(clip.first);
    pack(clip.frames);
    pack(clip.first_frame);
    pack(clip.step);
    pack(kept.inputs[i].size());
    for (const GraphInput& input : kept.inputs[i]) {
      pack(input.path);
      pack(input.sha256);
    }
  }
  pack(kept.graph.states);
  for (Eigen::Index i = 0; i < kept.graph.features.size(); ++i) pack(kept.graph.features.data()[i]);
  pack(kept.graph.merges.size());
  for (const Merge& merge : kept.graph.merges) {
    pack(merge.a);
    pack(merge.b);
    pack(merge.error);
  }
  return pack.bytes();
}

// @throws std::runtime_error where the bytes end
KeptGraph unpackBody(std::string_view bytes) {
  Unpacker unpack(bytes);
  KeptGraph kept;
  kept.reading = unpackReading(unpack);
  unpack(kept.graph.frame_time);
  for (size_t left = unpack.takeCount(); left > 0; --left) {
    GraphClip clip;
    unpack(clip.name);
    unpack(clip.first);
    unpack(clip.frames);
    unpack(clip.first_frame);
    unpack(clip.step);
    kept.graph.clips.push_back(clip);
    std::vector<GraphInput>& inputs = kept.inputs.emplace_back();
    for (size_t more = unpack.takeCount(); more > 0; --more) {
      GraphInput input;
      unpack(input.path);
      unpack(input.sha256);
      inputs.push_back(input);
    }
  }
  unpack(kept.graph.states);
  const size_t values = kept.graph.states.size() * kFeatureRows;
  if (values * sizeof(float) > bytes.size()) throw std::runtime_error("bytes end too soon");
  kept.graph.features.resize(kFeatureRows, static_cast<Eigen::Index>(kept.graph.states.size()));
  for (size_t i = 0; i < values; ++i) unpack(kept.graph.features.data()[i]);
  for (size_t left = unpack.takeCount(); left > 0; --left) {
    Merge merge;
    unpack(merge.a);
    unpack(merge.b);
    unpack(merge.error);
    kept.graph.merges.push_back(merge);
  }
  return kept;
}

}  // namespace

std::string packGraph(const KeptGraph& kept) {
  std::string bytes = std::string(kTitle) + packBody(kept);
  return bytes + sha256(bytes);
}

KeptGraph unpackGraph(std::string_view bytes, const std::string& name) {
  const auto fail = [&](const std::string& problem) {
    throw InputError(name, 0, problem, "one that `amble graph build` has written");
  };
  if (!bytes.starts_with(kAnyTitle)) fail("is no cluster graph");
  if (!bytes.starts_with(kTitle)) fail("is a cluster graph of another format, or cut off");
  const size_t signed_size = bytes.size() - std::min(bytes.size(), kDigest);
  if (signed_size < kTitle.size() ||
      sha256(bytes.substr(0, signed_size)) != bytes.substr(signed_size))
    fail("is a damaged cluster graph: its bytes are not those that were written");
  KeptGraph kept;
  try {
    kept = unpackBody(bytes.substr(kTitle.size(), signed_size - kTitle.size()));
  } catch (const std::runtime_error&) {
    fail("is a damaged cluster graph: it ends too soon");
  }
  if (const char* fault = faultOf(kept))
    fail(std::string("is a damaged cluster graph: it has ") + fault);
  if (packGraph(kept) != bytes) fail("is a damaged cluster graph: it goes on after its end");
  return kept;
}

void writeGraph(const KeptGraph& kept, const fs::path& file) {
  writeFile(file, [&](std::ostream& out) { out << packGraph(kept); });
}

KeptGraph readGraph(const fs::path& file) {
  return unpackGraph(readWholeFile(file, kGraphKind), file.string());
}

bool looksLikeGraph(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return false;
  std::string begin(kAnyTitle.size(), '\0');
  std::ifstream in(file, std::ios::binary);
  return in.read(begin.data(), static_cast<std::streamsize>(begin.size())) && begin == kAnyTitle;
}

fs::path inputFile(const fs::path& graph_file, const GraphInput& input) {
  const fs::path path = input.path;
  return path.is_absolute() || graph_file == "-" ? path : graph_file.parent_path() / path;
}

GraphInput graphInput(const fs::path& graph_file, const fs::path& file) {
  const fs::path folder = graph_file == "-" ? fs::path(".") : graph_file;
  const fs::path base =
      graph_file == "-" ? fs::absolute(folder) : fs::absolute(folder).parent_path();
  const fs::path relative =
      fs::absolute(file).lexically_normal().lexically_relative(base.lexically_normal());
  return {relative.empty() ? fs::absolute(file).string() : relative.string(), sha256OfFile(file)};
}

std::string whatChanged(const KeptGraph& kept, const fs::path& graph_file) {
  std::vector<std::string> changed;
  std::set<std::string> seen;
  for (const std::vector<GraphInput>& inputs : kept.inputs) {
    for (const GraphInput& input : inputs) {
      if (!seen.insert(input.path).second) continue;
      const fs::path file = inputFile(graph_file, input);
      std::error_code error;
      if (!fs::is_regular_file(file, error))
        changed.push_back(input.path + " (missing)");
      else if (sha256OfFile(file) != input.sha256)
        changed.push_back(input.path);
    }
  }
  return joined(changed);
}

}  // namespace amble
