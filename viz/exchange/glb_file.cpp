#include "viz/exchange/glb_file.h"

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "base/text.h"
#include "base/version.h"

namespace amble {
namespace {

using tinygltf::Value;

Value valueOf(const nlohmann::json& json) {
  if (json.is_object()) {
    Value::Object object;
    for (const auto& [key, item] : json.items()) object[key] = valueOf(item);
    return Value(object);
  }
  if (json.is_array()) {
    Value::Array array;
    for (const auto& item : json) array.push_back(valueOf(item));
    return Value(array);
  }
  if (json.is_boolean()) return Value(json.get<bool>());
  if (json.is_number_integer() && std::abs(json.get<double>()) < 2e9) return Value(json.get<int>());
  if (json.is_number()) return Value(json.get<double>());
  return Value(json.is_string() ? json.get<std::string>() : std::string());
}

Value extrasOf(const std::string& text) {
  return text.empty() ? Value() : valueOf(nlohmann::json::parse(text));
}

class GlbWriter {
 public:
  explicit GlbWriter(const GlbFile& file) : file_(file) { model_.buffers.emplace_back(); }

  void write(std::ostream& out) {
    model_.asset.version = "2.0";
    model_.asset.generator = "Amble " + version();
    addMaterials();
    for (const GlbMesh& mesh : file_.meshes) addMesh(mesh);
    addNodes();
    addSkin();
    addAnimation();
    tinygltf::TinyGLTF writer;
    // Who opened the stream says why it takes no more.
    if (!writer.WriteGltfSceneToStream(&model_, out, false, true) && out)
      throw std::runtime_error("glTF could not be written");
  }

 private:
  // Of a component's type and elements of the file; `least` and `most` where they are asked for.
  template <typename Element>
  int addAccessor(const std::vector<Element>& elements, int component, int type, bool bounds,
                  int target = 0) {
    auto& bytes = model_.buffers.front().data;
    while (bytes.size() % 4 != 0) bytes.push_back(0);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = bytes.size();
    view.byteLength = elements.size() * sizeof(Element);
    view.target = target;
    const auto* begin = reinterpret_cast<const unsigned char*>(elements.data());
    bytes.insert(bytes.end(), begin, begin + view.byteLength);
    tinygltf::Accessor accessor;
    accessor.bufferView = static_cast<int>(model_.bufferViews.size());
    accessor.componentType = component;
    accessor.type = type;
    accessor.count = elements.size();
    if (bounds) addBounds(elements, accessor);
    model_.bufferViews.push_back(std::move(view));
    model_.accessors.push_back(std::move(accessor));
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  template <typename Element>
  static void addBounds(const std::vector<Element>& elements, tinygltf::Accessor& accessor) {
    constexpr size_t kNumbers = sizeof(Element) / sizeof(float);
    std::array<float, kNumbers> least, most, one;
    for (size_t i = 0; i < elements.size(); ++i) {
      std::memcpy(one.data(), &elements[i], sizeof(Element));
      for (size_t k = 0; k < kNumbers; ++k) {
        least[k] = i == 0 ? one[k] : std::min(least[k], one[k]);
        most[k] = i == 0 ? one[k] : std::max(most[k], one[k]);
      }
    }
    accessor.minValues.assign(least.begin(), least.end());
    accessor.maxValues.assign(most.begin(), most.end());
  }

  int addFloats(const std::vector<Eigen::Vector3f>& list, bool bounds, int target = 0) {
    return addAccessor(list, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, bounds, target);
  }
  int addShorts(const std::vector<std::array<std::uint16_t, 4>>& list) {
    return addAccessor(list, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_VEC4, false,
                       TINYGLTF_TARGET_ARRAY_BUFFER);
  }

  void addMaterials() {
    for (const GlbMaterial& material : file_.materials) {
      tinygltf::Material out;
      out.name = utf8Text(material.name);
      const Eigen::Vector3f& color = material.color;
      out.pbrMetallicRoughness.baseColorFactor = {color.x(), color.y(), color.z(), 1.0};
      out.pbrMetallicRoughness.metallicFactor = 0.0;
      out.pbrMetallicRoughness.roughnessFactor = 0.9;
      out.doubleSided = material.both_sides;
      model_.materials.push_back(std::move(out));
    }
  }

  int addIndices(const GlbPrimitive& primitive) {
    constexpr size_t kMost = 65535;
    if (primitive.positions.size() > kMost)
      return addAccessor(primitive.indices, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                         TINYGLTF_TYPE_SCALAR, false, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    const std::vector<std::uint16_t> few(primitive.indices.begin(), primitive.indices.end());
    return addAccessor(few, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR, false,
                       TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  }

  void addMesh(const GlbMesh& mesh) {
    tinygltf::Mesh out;
    out.name = utf8Text(mesh.name);
    for (const GlbPrimitive& primitive : mesh.primitives) {
      tinygltf::Primitive part;
      part.material = primitive.material;
      part.mode = primitive.is_line ? TINYGLTF_MODE_LINE_STRIP : TINYGLTF_MODE_TRIANGLES;
      part.attributes["POSITION"] =
          addFloats(primitive.positions, true, TINYGLTF_TARGET_ARRAY_BUFFER);
      if (!primitive.normals.empty())
        part.attributes["NORMAL"] =
            addFloats(primitive.normals, false, TINYGLTF_TARGET_ARRAY_BUFFER);
      if (!primitive.colors.empty()) {
        part.attributes["COLOR_0"] = addShorts(primitive.colors);
        model_.accessors.back().normalized = true;
      }
      if (!primitive.joints.empty()) {
        part.attributes["JOINTS_0"] = addShorts(primitive.joints);
        part.attributes["WEIGHTS_0"] =
            addAccessor(primitive.weights, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC4, false,
                        TINYGLTF_TARGET_ARRAY_BUFFER);
      }
      if (!primitive.indices.empty()) part.indices = addIndices(primitive);
      out.primitives.push_back(std::move(part));
    }
    model_.meshes.push_back(std::move(out));
  }

  // Joints come first: of two of the same name the other gets a number.
  std::string uniqueName(const std::string& name) {
    const std::string good = utf8Text(name);
    std::string unique = good;
    for (int i = 2; unique.empty() || !names_.insert(unique).second; ++i)
      unique = (good.empty() ? "node" : good) + "." + std::to_string(i);
    return unique;
  }

  void addNodes() {
    tinygltf::Scene scene;
    scene.name = utf8Text(file_.name);
    scene.extras = extrasOf(file_.extras);
    for (size_t i = 0; i < file_.nodes.size(); ++i) {
      const GlbNode& node = file_.nodes[i];
      tinygltf::Node out;
      out.name = uniqueName(node.name);
      out.mesh = node.mesh;
      out.skin = node.skinned ? 0 : -1;
      if (!node.translation.isZero(0.0F))
        out.translation = {node.translation.x(), node.translation.y(), node.translation.z()};
      const Eigen::Quaternionf& q = node.rotation;
      if (!q.vec().isZero(0.0F)) out.rotation = {q.x(), q.y(), q.z(), q.w()};
      out.extras = extrasOf(node.extras);
      model_.nodes.push_back(std::move(out));
      auto& siblings = node.parent < 0 ? scene.nodes : model_.nodes[node.parent].children;
      siblings.push_back(static_cast<int>(i));
    }
    model_.scenes.push_back(std::move(scene));
    model_.defaultScene = 0;
  }

  void addSkin() {
    if (file_.joints.empty()) return;
    tinygltf::Skin skin;
    skin.name = utf8Text(file_.name);
    skin.joints = file_.joints;
    skin.skeleton = file_.joints.front();
    skin.inverseBindMatrices =
        addAccessor(file_.inverse_bind, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_MAT4, false);
    model_.skins.push_back(std::move(skin));
  }

  void addChannel(tinygltf::Animation& animation, int node, const char* path, int times,
                  int values) {
    tinygltf::AnimationSampler sampler;
    sampler.input = times;
    sampler.output = values;
    sampler.interpolation = "LINEAR";
    tinygltf::AnimationChannel channel;
    channel.sampler = static_cast<int>(animation.samplers.size());
    channel.target_node = node;
    channel.target_path = path;
    animation.samplers.push_back(std::move(sampler));
    animation.channels.push_back(std::move(channel));
  }

  void addAnimation() {
    if (file_.tracks.empty()) return;
    tinygltf::Animation animation;
    animation.name = utf8Text(file_.name);
    const int times =
        addAccessor(file_.times, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_SCALAR, true);
    for (const GlbTrack& track : file_.tracks) {
      if (!track.translations.empty())
        addChannel(animation, track.node, "translation", times,
                   addFloats(track.translations, false));
      if (track.rotations.empty()) continue;
      std::vector<Eigen::Vector4f> turns;
      for (const Eigen::Quaternionf& q : track.rotations) turns.push_back(q.coeffs());
      addChannel(animation, track.node, "rotation", times,
                 addAccessor(turns, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC4, false));
    }
    model_.animations.push_back(std::move(animation));
  }

  const GlbFile& file_;
  tinygltf::Model model_;
  std::set<std::string> names_;
};

}  // namespace

void writeGlbFile(std::ostream& out, const GlbFile& file) { GlbWriter(file).write(out); }

}  // namespace amble
