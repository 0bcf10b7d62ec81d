// glTF 2.0, GLB and VRM animation (VRMC_vrm_animation 1.0): nodes and animations only. Assimp reads
// neither 16-bit turns nor the slopes of splines, nor which bone of a VRM animation is which.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "animation/captures/node_file.h"
#include "animation/captures/node_scene.h"
#include "base/assimp_scene.h"
#include "base/error.h"
#include "base/files.h"
#include "base/rotation.h"
#include "base/text.h"

namespace amble {
namespace {

using Json = nlohmann::json;

constexpr FileKind kGltfFile{kNodeFile, kMaxNodeFile};

// Extensions that change nothing of nodes and their animation: surfaces, lights, avatars.
constexpr std::array kOfOtherThings = {"KHR_materials_",
                                       "KHR_texture_",
                                       "EXT_texture_",
                                       "MSFT_texture_",
                                       "KHR_lights_",
                                       "EXT_lights_",
                                       "KHR_mesh_quantization",
                                       "EXT_mesh_gpu_instancing",
                                       "KHR_draco_mesh_compression",
                                       "KHR_xmp",
                                       "VRM",
                                       "KHR_node_visibility"};
constexpr const char* kMeshopt = "EXT_meshopt_compression";

// Types of numbers (glTF 2.0, 3.6.2.2).
constexpr int kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123,
              kUnsignedInt = 5125, kFloat = 5126;

constexpr size_t kGlbHeader = 12, kChunkHeader = 8;  // [bytes]
constexpr uint32_t kJsonChunk = 0x4E4F534A, kBinChunk = 0x004E4942;

int sizeOf(int type) {
  switch (type) {
    case kByte:
    case kUnsignedByte:
      return 1;
    case kShort:
    case kUnsignedShort:
      return 2;
    case kUnsignedInt:
    case kFloat:
      return 4;
    default:
      return 0;
  }
}

int widthOf(const std::string& type) {
  return type == "SCALAR" ? 1 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 0;
}

/// A number as it lies in a buffer.
double numberAt(const unsigned char* at, int type, bool normalized) {
  const auto value = [at]<typename T>(T) {
    T number;
    std::memcpy(&number, at, sizeof number);
    return number;
  };
  const auto whole = [&](auto number) {
    // glTF 2.0, 3.6.2.2: c / (2^n - 1), signed max(c / (2^(n-1) - 1), -1).
    const double top = std::numeric_limits<decltype(number)>::max();
    return normalized ? std::max(value(number) / top, -1.0) : static_cast<double>(value(number));
  };
  switch (type) {
    case kByte:
      return whole(int8_t{});
    case kUnsignedByte:
      return whole(uint8_t{});
    case kShort:
      return whole(int16_t{});
    case kUnsignedShort:
      return whole(uint16_t{});
    case kUnsignedInt:
      return whole(uint32_t{});
    default:
      return value(float{});
  }
}

Eigen::Vector3d valueFrom(const double* v, Eigen::Vector3d) { return {v[0], v[1], v[2]}; }
Eigen::Quaterniond valueFrom(const double* v, Eigen::Quaterniond) {
  return {v[3], v[0], v[1], v[2]};
}

uint32_t wordAt(std::string_view bytes, size_t at) {
  uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

/// The bytes of a base64 text (RFC 4648); another sign ends it.
std::string fromBase64(std::string_view text) {
  std::string bytes;
  uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const int digit = c >= 'A' && c <= 'Z'   ? c - 'A'
                      : c >= 'a' && c <= 'z' ? c - 'a' + 26
                      : c >= '0' && c <= '9' ? c - '0' + 52
                      : c == '+'             ? 62
                      : c == '/'             ? 63
                                             : -1;
    if (digit < 0) break;
    bits = bits << 6 | static_cast<uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xFFu);
  }
  return bytes;
}

class GltfReader {
 public:
  explicit GltfReader(const std::string& file) : file_(file) {}
  NodeScene read(std::string_view bytes);

 private:
  void load(std::string_view bytes);
  std::string_view chunksOf(std::string_view glb);
  void loadBuffer(const Json& buffer);
  std::string besides(const std::string& uri) const;
  void requireKnownExtensions() const;
  void nameBonesOfVrma();
  void placeNodes();
  void markBones();
  AnimatedNode nodeOf(size_t index, int parent) const;
  NodeTake takeOf(const Json& animation, size_t number) const;
  template <typename T>
  KeyTrack<T> trackOf(const Json& sampler) const;
  std::vector<double> numbersOf(const Json& sampler, const char* key, int width) const;
  const unsigned char* bytesOf(const Json& owner, size_t length) const;
  void overwriteSparse(const Json& accessor, int width, std::vector<double>& to) const;
  const Json& list(const char* name) const;
  const Json& elementOf(const char* name, const Json& owner, const char* key) const;
  size_t countIn(const Json& owner, const char* key) const;
  [[noreturn]] void fail(const std::string& problem, const std::string& expected) const {
    throw InputError(file_, 0, oneLine(problem), expected);
  }

  const std::string& file_;
  Json json_;
  std::string_view binary_;  // of a GLB
  std::vector<std::string> buffers_;
  NodeScene scene_;
  std::vector<int> places_;  // by the file's node: its index in scene_, or -1
};

/// A whole number >= 0; 0 where it is not said.
size_t GltfReader::countIn(const Json& owner, const char* key) const {
  const auto found = owner.find(key);
  if (found == owner.end()) return 0;
  if (!found->is_number_unsigned()) fail(std::string("'") + key + "' is no count", "0 or more");
  return found->get<size_t>();
}

const Json& GltfReader::list(const char* name) const {
  static const Json kNone = Json::array();
  const auto found = json_.find(name);
  if (found == json_.end()) return kNone;
  if (!found->is_array()) fail(std::string("'") + name + "' is no list", "one");
  return *found;
}

/// The element of a list that `owner` names by its index.
const Json& GltfReader::elementOf(const char* name, const Json& owner, const char* key) const {
  const Json& all = list(name);
  if (!owner.contains(key) || countIn(owner, key) >= all.size()) {
    fail(std::string("'") + key + "' is none of the " + name, "an index of one");
  }
  return all[countIn(owner, key)];
}

/// The JSON of a GLB; its other chunk is kept.
std::string_view GltfReader::chunksOf(std::string_view glb) {
  std::string_view text;
  for (size_t at = kGlbHeader; glb.size() - at >= kChunkHeader && at < glb.size();) {
    const size_t length = wordAt(glb, at);
    const uint32_t type = wordAt(glb, at + 4);
    at += kChunkHeader;
    if (length > glb.size() - at) fail("a chunk goes beyond the end", "bytes that are there");
    if (type == kJsonChunk) text = glb.substr(at, length);
    if (type == kBinChunk && binary_.empty()) binary_ = glb.substr(at, length);
    at += length;
  }
  if (text.empty()) fail("a GLB without JSON", kNodeFile);
  return text;
}

/// A file that a glTF refers to is read where it lies in the glTF's folder or below; another, a
/// device, a pipe or a place in the net is none.
std::string GltfReader::besides(const std::string& uri) const {
  std::error_code error;
  const std::filesystem::path own = std::filesystem::path(file_).parent_path();
  const auto folder = std::filesystem::weakly_canonical(own.empty() ? "." : own, error);
  const auto plain = std::filesystem::weakly_canonical(folder / withoutPercents(uri), error);
  const auto real = std::filesystem::exists(plain, error)
                        ? plain
                        : std::filesystem::weakly_canonical(folder / uri, error);
  const auto way = real.lexically_relative(folder);
  if (way.empty() || *way.begin() == ".." || !std::filesystem::is_regular_file(real, error)) {
    fail("cannot be read: '" + uri.substr(0, 100) + "' does not lie beside it",
         "a file in its folder");
  }
  return readWholeFile(real, kGltfFile);
}

void GltfReader::loadBuffer(const Json& buffer) {
  const auto uri = buffer.find("uri");
  if (uri == buffer.end()) {
    buffers_.emplace_back(buffers_.empty() ? binary_ : std::string_view());
    return;
  }
  const std::string& from = uri->get_ref<const std::string&>();
  const size_t comma = from.find(',');
  const bool data = from.starts_with("data:") && comma != from.npos;
  buffers_.push_back(data ? fromBase64(std::string_view(from).substr(comma + 1)) : besides(from));
}

void GltfReader::load(std::string_view bytes) {
  const bool binary = bytes.starts_with("glTF") && bytes.size() >= kGlbHeader;
  json_ = Json::parse(binary ? chunksOf(bytes) : bytes);
  if (!json_.is_object() || !json_.contains("asset")) fail("no glTF: it has no asset", kNodeFile);
  for (const Json& buffer : list("buffers")) loadBuffer(buffer);
}

void GltfReader::requireKnownExtensions() const {
  for (const Json& extension : list("extensionsRequired")) {
    const std::string& name = extension.get_ref<const std::string&>();
    const bool known = std::any_of(kOfOtherThings.begin(), kOfOtherThings.end(),
                                   [&](const char* start) { return name.starts_with(start); });
    if (!known) fail("needs the extension " + name, "glTF without it");
  }
}

/// So many bytes from the place that an accessor, or a part of a sparse one, names.
const unsigned char* GltfReader::bytesOf(const Json& owner, size_t length) const {
  const Json& view = elementOf("bufferViews", owner, "bufferView");
  if (view.contains("extensions") && view["extensions"].contains(kMeshopt)) {
    fail(std::string("needs the extension ") + kMeshopt, "glTF without it");
  }
  if (!view.contains("buffer") || countIn(view, "buffer") >= buffers_.size()) {
    fail("a buffer view of no buffer", "an index of one");
  }
  const std::string& data = buffers_[countIn(view, "buffer")];
  const size_t begin = countIn(view, "byteOffset"), size = countIn(view, "byteLength");
  const size_t offset = countIn(owner, "byteOffset");
  const bool inside = begin <= data.size() && size <= data.size() - begin && offset <= size &&
                      length <= size - offset;
  if (!inside) fail("an accessor goes beyond its buffer", "bytes that are there");
  return reinterpret_cast<const unsigned char*>(data.data()) + begin + offset;
}

/// What a sparse accessor has instead of some of its values.
void GltfReader::overwriteSparse(const Json& accessor, int width, std::vector<double>& to) const {
  const Json& sparse = accessor.at("sparse");
  const Json& places = sparse.at("indices");
  const size_t count = countIn(sparse, "count"), all = to.size() / width;
  const int place_type = places.at("componentType"), type = accessor.at("componentType");
  const int place_size = sizeOf(place_type), size = sizeOf(type);
  if (count > all || place_size == 0) fail("a sparse accessor that is none", "places and values");
  const unsigned char* const place = bytesOf(places, count * place_size);
  const unsigned char* const value = bytesOf(sparse.at("values"), count * width * size);
  const bool normalized = accessor.value("normalized", false);
  for (size_t i = 0; i < count; ++i) {
    const double at = numberAt(place + i * place_size, place_type, false);
    if (!(at >= 0.0 && at < static_cast<double>(all))) {
      fail("a sparse accessor goes beyond its end", "places within it");
    }
    for (int k = 0; k < width; ++k) {
      to[static_cast<size_t>(at) * width + k] =
          numberAt(value + (i * width + k) * size, type, normalized);
    }
  }
}

/// The values of an accessor that a sampler names, one after another, `width` numbers each.
std::vector<double> GltfReader::numbersOf(const Json& sampler, const char* key, int width) const {
  const Json& accessor = elementOf("accessors", sampler, key);
  const int type = accessor.at("componentType"), size = sizeOf(type);
  if (size == 0 || widthOf(accessor.at("type").get<std::string>()) != width) {
    fail("an accessor of a type that an animation has not",
         "as many numbers as a place, a turn or a time has");
  }
  const size_t count = countIn(accessor, "count"), own = static_cast<size_t>(width) * size;
  // No count asks for more memory than some files' length.
  if (count > kMaxNodeFile / own) fail("too many numbers in an accessor", "those of a motion");
  std::vector<double> numbers(count * width, 0.0);
  if (accessor.contains("bufferView") && count > 0) {
    const Json& view = elementOf("bufferViews", accessor, "bufferView");
    const size_t stride = view.contains("byteStride") ? countIn(view, "byteStride") : own;
    if (stride > kMaxNodeFile / count)
      fail("an accessor goes beyond its buffer", "bytes that are there");
    const unsigned char* const data = bytesOf(accessor, (count - 1) * stride + own);
    const bool normalized = accessor.value("normalized", false);
    for (size_t i = 0; i < count * width; ++i) {
      numbers[i] = numberAt(data + i / width * stride + i % width * size, type, normalized);
    }
  }
  if (accessor.contains("sparse")) overwriteSparse(accessor, width, numbers);
  return numbers;
}

template <typename T>
KeyTrack<T> GltfReader::trackOf(const Json& sampler) const {
  constexpr int kWidth = std::is_same_v<T, Eigen::Vector3d> ? 3 : 4;
  const std::string how = sampler.value("interpolation", "LINEAR");
  KeyTrack<T> track;
  track.times = numbersOf(sampler, "input", 1);
  if (how == "STEP") track.shape = KeyShape::kStep;
  if (how == "CUBICSPLINE") track.shape = KeyShape::kCubic;
  const bool cubic = track.shape == KeyShape::kCubic;
  const std::vector<double> numbers = numbersOf(sampler, "output", kWidth);
  const size_t step = cubic ? 3 * kWidth : kWidth;
  if (numbers.size() != step * track.times.size()) {
    fail("an animation has not as many values as times", "one each, of a spline three");
  }
  for (size_t i = 0; i < track.times.size(); ++i) {
    const double* const at = numbers.data() + i * step;
    T value = valueFrom(at + (cubic ? kWidth : 0), T());
    if constexpr (kWidth == 4) {
      if (!cubic) value.normalize();  // 16 bits round its length
    }
    track.values.push_back(value);
    if (!cubic) continue;
    track.in.push_back(valueFrom(at, T()));
    track.out.push_back(valueFrom(at + 2 * kWidth, T()));
  }
  return track;
}

NodeTake GltfReader::takeOf(const Json& animation, size_t number) const {
  NodeTake take;
  take.name = oneLine(animation.value("name", std::to_string(number)));
  take.tracks.resize(scene_.nodes.nodes.size());
  const Json& samplers = animation.at("samplers");
  for (const Json& channel : animation.at("channels")) {
    const Json& target = channel.at("target");
    if (!target.contains("node")) continue;
    const size_t node = countIn(target, "node"), sampler = countIn(channel, "sampler");
    if (node >= places_.size() || sampler >= samplers.size()) {
      fail("an animation of no node or no sampler", "an index of one");
    }
    NodeTracks& tracks = take.tracks[places_[node]];
    const std::string path = target.at("path");
    if (path == "translation") tracks.translations = trackOf<Eigen::Vector3d>(samplers[sampler]);
    if (path == "rotation") tracks.rotations = trackOf<Eigen::Quaterniond>(samplers[sampler]);
    if (path == "scale") tracks.scales = trackOf<Eigen::Vector3d>(samplers[sampler]);
  }
  return take;
}

AnimatedNode GltfReader::nodeOf(size_t index, int parent) const {
  const Json& from = list("nodes")[index];
  const auto numbers = [&](const char* key, size_t count) {
    std::vector<double> values = from.value(key, std::vector<double>());
    if (values.size() != count) values.clear();
    return values;
  };
  AnimatedNode node;
  node.name = from.value("name", "node_" + std::to_string(index));
  node.parent = parent;
  node.thing = from.contains("mesh") || from.contains("camera");
  if (const auto m = numbers("matrix", 16); !m.empty()) {
    node.X_PN.matrix() = Eigen::Map<const Eigen::Matrix4d>(m.data());
    return node;
  }
  if (const auto v = numbers("translation", 3); !v.empty()) {
    node.X_PN.translation() = valueFrom(v.data(), Eigen::Vector3d());
  }
  if (const auto v = numbers("rotation", 4); !v.empty()) {
    const Eigen::Quaterniond q = valueFrom(v.data(), Eigen::Quaterniond());
    node.X_PN.linear() = q.normalized().toRotationMatrix();
  }
  if (const auto v = numbers("scale", 3); !v.empty()) {
    node.X_PN.linear() *= valueFrom(v.data(), Eigen::Vector3d()).asDiagonal();
  }
  return node;
}

/// Parents first, children in the file's order; by a stack, for a file may nest as deep as it
/// likes.
void GltfReader::placeNodes() {
  const Json& nodes = list("nodes");
  if (nodes.size() > kMaxNodes) fail("too many nodes", "at most 100,000");
  std::vector<std::vector<size_t>> children(nodes.size());
  std::vector<bool> hangs(nodes.size(), false);
  for (size_t n = 0; n < nodes.size(); ++n) {
    children[n] = nodes[n].value("children", std::vector<size_t>());
    for (const size_t child : children[n]) {
      if (child >= nodes.size()) fail("a child that is no node", "an index of one");
      if (hangs[child]) fail("a node hangs on two others", "a tree of nodes");
      hangs[child] = true;
    }
  }
  places_.assign(nodes.size(), -1);
  std::vector<std::pair<size_t, int>> open;  // node, place of its parent
  for (size_t n = nodes.size(); n-- > 0;) {
    if (!hangs[n]) open.emplace_back(n, -1);
  }
  while (!open.empty()) {
    const auto [index, parent] = open.back();
    open.pop_back();
    places_[index] = static_cast<int>(scene_.nodes.nodes.size());
    scene_.nodes.nodes.push_back(nodeOf(index, parent));
    for (size_t c = children[index].size(); c-- > 0;) {
      open.emplace_back(children[index][c], places_[index]);
    }
  }
  if (scene_.nodes.nodes.size() < nodes.size()) {
    fail("nodes that hang on themselves", "a tree of nodes");
  }
}

void GltfReader::markBones() {
  for (const Json& skin : list("skins")) {
    for (const size_t joint : skin.value("joints", std::vector<size_t>())) {
      if (joint < places_.size()) scene_.nodes.nodes[places_[joint]].bone = true;
    }
  }
}

/// A VRM animation says which node is which bone of a person: `leftUpperLeg`, whatever its name.
void GltfReader::nameBonesOfVrma() {
  const Json::json_pointer bones("/extensions/VRMC_vrm_animation/humanoid/humanBones");
  if (!json_.contains(bones)) return;
  for (const auto& [bone, is] : json_[bones].items()) {
    if (!is.contains("node") || countIn(is, "node") >= places_.size()) continue;
    scene_.nodes.nodes[places_[countIn(is, "node")]].name = oneLine(bone);
  }
}

NodeScene GltfReader::read(std::string_view bytes) {
  try {
    load(bytes);
    requireKnownExtensions();
    placeNodes();
    markBones();
    nameBonesOfVrma();
    const Json& animations = list("animations");
    for (size_t i = 0; i < animations.size(); ++i) {
      NodeTake take = takeOf(animations[i], i);
      const bool moves = std::any_of(take.tracks.begin(), take.tracks.end(),
                                     [](const NodeTracks& tracks) { return !tracks.empty(); });
      if (moves) scene_.takes.push_back(std::move(take));
    }
  } catch (const Json::exception& problem) {
    fail(std::string("cannot be read: ") + problem.what(), kNodeFile);
  }
  scene_.nodes.X_WFile = Eigen::Affine3d(yUpToWorld());
  return std::move(scene_);
}

}  // namespace

NodeScene gltfScene(const NodeSource& source) {
  if (source.bytes != nullptr) return GltfReader(source.name).read(*source.bytes);
  return GltfReader(source.name).read(readWholeFile(source.name, kGltfFile));
}

}  // namespace amble
