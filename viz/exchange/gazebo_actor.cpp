#include "viz/exchange/gazebo_actor.h"

#include <Eigen/Geometry>
#include <charconv>
#include <map>
#include <string_view>
#include <vector>

#include "base/rotation.h"
#include "base/xml.h"

namespace amble {
namespace {

using Eigen::Matrix3f;
using Eigen::Matrix4d;
using Eigen::Matrix4f;
using Eigen::Vector3f;

// A frame as a matrix: points of the frame into World.
Matrix4d matrixOf(const JointFrame& frame) {
  Matrix4d matrix = Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = frame.q_WJ.toRotationMatrix();
  matrix.topRightCorner<3, 1>() = frame.p_WJ;
  return matrix;
}

// X_WJ of every joint in the rest pose.
std::vector<JointFrame> restFrames(const Skeleton& skeleton) {
  Pose rest;
  rest.rotations.assign(skeleton.size(), Eigen::Quaterniond::Identity());
  rest.rotations[0] = yUpToWorld();
  std::vector<JointFrame> frames(skeleton.size());
  forwardKinematics(skeleton, rest, frames);
  return frames;
}

// A list of numbers or words, as COLLADA has them: with blanks between.
class List {
 public:
  void put(std::string_view word) {
    if (!text_.empty()) text_ += ' ';
    text_ += word;
  }
  void put(double number) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, static_cast<float>(number) + 0.0f);
    put(std::string_view(text, end.ptr));
  }
  void put(size_t number) { put(std::string_view(std::to_string(number))); }
  void put(const Vector3f& p) {
    for (int i = 0; i < 3; ++i) put(static_cast<double>(p[i]));
  }
  // Row by row.
  void put(const Matrix4d& matrix) {
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) put(matrix(row, column));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

// Names that an XML document may give: of letters, digits and `_`, not beginning with a digit.
std::vector<std::string> identifiers(std::span<const std::string> joint_names) {
  std::vector<std::string> names;
  for (const std::string& name : joint_names)
    names.push_back(name.empty() || (name[0] >= '0' && name[0] <= '9') ? "_" + name : name);
  return names;
}

// Of a source of COLLADA: what it holds, in how many numbers each thing.
struct Kind {
  const char* array;  // the element that lists them
  const char* type;
  std::vector<const char*> parameters;
  size_t stride;
};
const Kind kPoints = {"float_array", "float", {"X", "Y", "Z"}, 3};
const Kind kNames = {"Name_array", "name", {"JOINT"}, 1};
const Kind kMatrices = {"float_array", "float4x4", {"TRANSFORM"}, 16};
const Kind kWeights = {"float_array", "float", {"WEIGHT"}, 1};

class ColladaSkin {
 public:
  ColladaSkin(std::ostream& out, const Skeleton& skeleton, const Figure& figure,
              std::span<const std::string> joint_names)
      : xml_(out),
        skeleton_(skeleton),
        figure_(figure),
        names_(identifiers(joint_names)),
        frames_(restFrames(skeleton)) {
    for (size_t i = 0; i < figure.triangles.size(); ++i)
      by_color_[figure.colors[figure.triangles[i][0]]].push_back(i);
  }

  void write() {
    xml_.declare();
    const auto collada = xml_.open(
        "COLLADA",
        {{"xmlns", "http://www.collada.org/2005/11/COLLADASchema"}, {"version", "1.4.1"}});
    writeAsset();
    writeColors();
    writeMesh();
    writeSkin();
    writeScene();
  }

 private:
  static std::string colorName(size_t i) { return "color" + std::to_string(i); }

  // The dates are asked for, and say nothing: the same walk gives the same bytes.
  void writeAsset() {
    const auto asset = xml_.open("asset");
    xml_.text("created", {}, "1980-01-01T00:00:00Z");
    xml_.text("modified", {}, "1980-01-01T00:00:00Z");
    xml_.empty("unit", {{"name", "meter"}, {"meter", "1"}});
    xml_.text("up_axis", {}, "Z_UP");
  }

  void writeColors() {
    {
      const auto effects = xml_.open("library_effects");
      size_t i = 0;
      for (const auto& [color, triangles] : by_color_) {
        const auto effect = xml_.open("effect", {{"id", colorName(i++) + "-effect"}});
        const auto profile = xml_.open("profile_COMMON");
        const auto technique = xml_.open("technique", {{"sid", "common"}});
        const auto shader = xml_.open("lambert");
        const auto diffuse = xml_.open("diffuse");
        List rgba;
        for (const std::uint8_t channel : color) rgba.put(channel / 255.0);
        rgba.put(1.0);
        xml_.text("color", {}, rgba.text());
      }
    }
    const auto materials = xml_.open("library_materials");
    for (size_t i = 0; i < by_color_.size(); ++i) {
      const auto material = xml_.open("material", {{"id", colorName(i)}, {"name", colorName(i)}});
      xml_.empty("instance_effect", {{"url", "#" + colorName(i) + "-effect"}});
    }
  }

  void writeSource(const std::string& id, const Kind& kind, const List& list, size_t count) {
    const auto source = xml_.open("source", {{"id", id}});
    xml_.text(kind.array, {{"id", id + "-array"}, {"count", count * kind.stride}}, list.text());
    const auto technique = xml_.open("technique_common");
    const auto accessor = xml_.open(
        "accessor", {{"source", "#" + id + "-array"}, {"count", count}, {"stride", kind.stride}});
    for (const char* parameter : kind.parameters)
      xml_.empty("param", {{"name", parameter}, {"type", kind.type}});
  }

  void writeMesh() {
    const auto library = xml_.open("library_geometries");
    const auto geometry = xml_.open("geometry", {{"id", "figure-mesh"}, {"name", "figure"}});
    const auto mesh = xml_.open("mesh");
    List positions, normals;
    for (const Vector3f& p : figure_.vertices) positions.put(p);
    for (const Vector3f& n : figure_.normals) normals.put(n);
    writeSource("figure-positions", kPoints, positions, figure_.vertices.size());
    writeSource("figure-normals", kPoints, normals, figure_.normals.size());
    {
      const auto vertices = xml_.open("vertices", {{"id", "figure-vertices"}});
      xml_.empty("input", {{"semantic", "POSITION"}, {"source", "#figure-positions"}});
    }
    size_t i = 0;
    for (const auto& [color, triangles] : by_color_) {
      const auto group =
          xml_.open("triangles", {{"material", colorName(i++)}, {"count", triangles.size()}});
      xml_.empty("input", {{"semantic", "VERTEX"}, {"source", "#figure-vertices"}, {"offset", 0}});
      xml_.empty("input", {{"semantic", "NORMAL"}, {"source", "#figure-normals"}, {"offset", 1}});
      List corners;
      for (const size_t triangle : triangles) {
        for (const std::uint32_t corner : figure_.triangles[triangle]) {
          corners.put(size_t{corner});
          corners.put(size_t{corner});
        }
      }
      xml_.text("p", {}, corners.text());
    }
  }

  void writeSkin() {
    const auto library = xml_.open("library_controllers");
    const auto controller = xml_.open("controller", {{"id", "figure-skin"}});
    const auto skin = xml_.open("skin", {{"source", "#figure-mesh"}});
    List identity;
    identity.put(Matrix4d(Matrix4d::Identity()));
    xml_.text("bind_shape_matrix", {}, identity.text());
    List names, matrices;
    for (const std::string& name : names_) names.put(std::string_view(name));
    for (const JointFrame& frame : frames_) matrices.put(Matrix4d(matrixOf(frame).inverse()));
    writeSource("figure-joints", kNames, names, names_.size());
    writeSource("figure-binds", kMatrices, matrices, names_.size());
    List weights, counts, pairs;
    size_t count = 0;
    for (size_t v = 0; v < figure_.vertices.size(); ++v) {
      const size_t before = count;
      for (size_t k = 0; k < figure_.weights[v].size(); ++k) {
        if (figure_.weights[v][k] <= 0.0f) continue;
        weights.put(static_cast<double>(figure_.weights[v][k]));
        pairs.put(size_t{figure_.joints[v][k]});
        pairs.put(count++);
      }
      counts.put(count - before);
    }
    writeSource("figure-weights", kWeights, weights, count);
    {
      const auto joints = xml_.open("joints");
      xml_.empty("input", {{"semantic", "JOINT"}, {"source", "#figure-joints"}});
      xml_.empty("input", {{"semantic", "INV_BIND_MATRIX"}, {"source", "#figure-binds"}});
    }
    const auto vertex_weights = xml_.open("vertex_weights", {{"count", figure_.vertices.size()}});
    xml_.empty("input", {{"semantic", "JOINT"}, {"source", "#figure-joints"}, {"offset", 0}});
    xml_.empty("input", {{"semantic", "WEIGHT"}, {"source", "#figure-weights"}, {"offset", 1}});
    xml_.text("vcount", {}, counts.text());
    xml_.text("v", {}, pairs.text());
  }

  void writeScene() {
    {
      const auto library = xml_.open("library_visual_scenes");
      const auto scene = xml_.open("visual_scene", {{"id", "scene"}, {"name", "scene"}});
      writeJoint(0);
      const auto node = xml_.open("node", {{"id", "figure"}, {"name", "figure"}, {"type", "NODE"}});
      const auto instance = xml_.open("instance_controller", {{"url", "#figure-skin"}});
      xml_.text("skeleton", {}, "#" + names_[0]);
      const auto bind = xml_.open("bind_material");
      const auto technique = xml_.open("technique_common");
      for (size_t i = 0; i < by_color_.size(); ++i)
        xml_.empty("instance_material", {{"symbol", colorName(i)}, {"target", "#" + colorName(i)}});
    }
    const auto scene = xml_.open("scene");
    xml_.empty("instance_visual_scene", {{"url", "#scene"}});
  }

  // With all that hangs below it. Rigs are nested less deep than the stack: a BVH's joints 1,000 at
  // most.
  void writeJoint(int joint) {
    const std::string& name = names_[joint];
    const auto node =
        xml_.open("node", {{"id", name}, {"sid", name}, {"name", name}, {"type", "JOINT"}});
    const int parent = skeleton_.joint(joint).parent;
    const Matrix4d own = matrixOf(frames_[joint]);
    List matrix;
    matrix.put(parent < 0 ? own : Matrix4d(matrixOf(frames_[parent]).inverse() * own));
    xml_.text("matrix", {{"sid", "transform"}}, matrix.text());
    for (int child = joint + 1; child < skeleton_.size(); ++child)
      if (skeleton_.joint(child).parent == joint) writeJoint(child);
  }

  XmlWriter xml_;
  const Skeleton& skeleton_;
  const Figure& figure_;
  const std::vector<std::string> names_;
  const std::vector<JointFrame> frames_;
  std::map<std::array<std::uint8_t, 3>, std::vector<size_t>> by_color_;  // triangles
};

}  // namespace

Figure restedFigure(const Skeleton& skeleton, const Figure& figure) {
  const std::vector<JointFrame> rest = restFrames(skeleton);
  std::vector<Matrix4f> back;  // from the rest pose into the bind pose, by joint
  for (int joint = 0; joint < skeleton.size(); ++joint)
    back.push_back((matrixOf(figure.bind[joint]) * matrixOf(rest[joint]).inverse()).cast<float>());
  Figure rested = figure;
  rested.bind = rest;
  for (size_t v = 0; v < figure.vertices.size(); ++v) {
    Matrix4f skinned = Matrix4f::Zero();
    for (size_t k = 0; k < figure.weights[v].size(); ++k)
      skinned += figure.weights[v][k] * back[figure.joints[v][k]];
    const Matrix3f turned = skinned.topLeftCorner<3, 3>();
    rested.vertices[v] =
        turned.inverse() * (figure.vertices[v] - Vector3f(skinned.topRightCorner<3, 1>()));
    rested.normals[v] = (turned.transpose() * figure.normals[v]).normalized();
  }
  return rested;
}

void writeSkinCollada(std::ostream& out, const Skeleton& skeleton, const Figure& figure,
                      std::span<const std::string> joint_names) {
  ColladaSkin(out, skeleton, restedFigure(skeleton, figure), joint_names).write();
}

void writeActorSdf(std::ostream& out, double bvh_unit) {
  List unit;
  unit.put(bvh_unit);
  XmlWriter xml(out);
  xml.declare();
  const auto sdf = xml.open("sdf", {{"version", "1.9"}});
  const auto world = xml.open("world", {{"name", "walk"}});
  {
    const auto sun = xml.open("light", {{"type", "directional"}, {"name", "sun"}});
    xml.text("pose", {}, "0 0 10 0 0 0");
    xml.text("direction", {}, "-0.5 0.3 -0.9");
  }
  const auto actor = xml.open("actor", {{"name", "walker"}});
  {
    const auto skin = xml.open("skin");
    xml.text("filename", {}, "walk.dae");
    xml.text("scale", {}, "1");
  }
  {
    const auto animation = xml.open("animation", {{"name", "walk"}});
    xml.text("filename", {}, "walk.bvh");
    xml.text("scale", {}, unit.text());
    xml.text("interpolate_x", {}, "false");
  }
  const auto script = xml.open("script");
  xml.text("loop", {}, "true");
  xml.text("delay_start", {}, "0");
  xml.text("auto_start", {}, "true");
}

}  // namespace amble
