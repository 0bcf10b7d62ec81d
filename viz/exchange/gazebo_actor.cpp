#include "viz/exchange/gazebo_actor.h"

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "base/rotation.h"
#include "base/xml.h"
#include "viz/exchange/collada.h"
#include "viz/pictures/room.h"

namespace amble {
namespace {

using Eigen::Matrix3f;
using Eigen::Matrix4d;
using Eigen::Matrix4f;
using Eigen::Vector3d;
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

// Names that an XML document may give: of letters, digits and `_`, not beginning with a digit.
std::vector<std::string> identifiers(std::span<const std::string> joint_names) {
  std::vector<std::string> names;
  for (const std::string& name : joint_names)
    names.push_back(name.empty() || (name[0] >= '0' && name[0] <= '9') ? "_" + name : name);
  return names;
}

const ColladaKind kNames = {"Name_array", "name", {"JOINT"}, 1};
const ColladaKind kMatrices = {"float_array", "float4x4", {"TRANSFORM"}, 16};
const ColladaKind kWeights = {"float_array", "float", {"WEIGHT"}, 1};

ColladaColor bytesOf(const Color& color) {
  ColladaColor bytes{};
  for (int i = 0; i < 3; ++i) bytes[i] = static_cast<std::uint8_t>(std::lround(255.0f * color[i]));
  return bytes;
}

// To the tenth of a millimetre, as what is for looking at is written.
Vector3f rounded(const Vector3d& p) {
  return ((p * 1e4).array().round() / 1e4).matrix().cast<float>();
}

class ColladaSkin {
 public:
  ColladaSkin(std::ostream& out, const Skeleton& skeleton, const Figure& figure,
              std::span<const std::string> joint_names)
      : xml_(out),
        skeleton_(skeleton),
        figure_(figure),
        names_(identifiers(joint_names)),
        frames_(restFrames(skeleton)) {
    for (const auto& t : figure.triangles)
      for (const std::uint32_t v : t) by_color_[figure.colors[t[0]]].push_back({v, v});
  }

  void write() {
    xml_.declare();
    const auto collada = xml_.open("COLLADA", colladaAttributes());
    writeColladaAsset(xml_);
    writeColladaColors(xml_, by_color_);
    writeColladaMesh(xml_, "figure", figure_.vertices, figure_.normals, by_color_);
    writeSkin();
    writeScene();
  }

 private:
  void writeSkin() {
    const auto library = xml_.open("library_controllers");
    const auto controller = xml_.open("controller", {{"id", "figure-skin"}});
    const auto skin = xml_.open("skin", {{"source", "#figure-mesh"}});
    ColladaList identity;
    identity.put(Matrix4d(Matrix4d::Identity()));
    xml_.text("bind_shape_matrix", {}, identity.text());
    ColladaList names, matrices;
    for (const std::string& name : names_) names.put(std::string_view(name));
    for (const JointFrame& frame : frames_) matrices.put(Matrix4d(matrixOf(frame).inverse()));
    writeColladaSource(xml_, "figure-joints", kNames, names, names_.size());
    writeColladaSource(xml_, "figure-binds", kMatrices, matrices, names_.size());
    ColladaList weights, counts, pairs;
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
    writeColladaSource(xml_, "figure-weights", kWeights, weights, count);
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
      bindColladaColors(xml_, by_color_);
    }
    writeColladaEnd(xml_);
  }

  // With all that hangs below it. Rigs are nested less deep than the stack: a BVH's joints 1,000 at
  // most.
  void writeJoint(int joint) {
    const std::string& name = names_[joint];
    const auto node =
        xml_.open("node", {{"id", name}, {"sid", name}, {"name", name}, {"type", "JOINT"}});
    const int parent = skeleton_.joint(joint).parent;
    const Matrix4d own = matrixOf(frames_[joint]);
    ColladaList matrix;
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
  ColladaTriangles by_color_;
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

void writeRoomCollada(std::ostream& out, const Scene& scene, double floor) {
  std::vector<RoomSurface> room = sortRoom(scene, floor);
  thinRoom(room, kMostRoomTriangles);
  std::vector<Vector3f> positions, normals;
  ColladaTriangles by_color;
  for (const RoomSurface& surface : room) {
    std::vector<ColladaCorner>& corners = by_color[bytesOf(surface.color)];
    const std::vector<Vector3d>& at = surface.mesh.vertices;
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (const Vector3d& p : at) positions.push_back(rounded(p));
    for (const auto& t : surface.mesh.triangles) {
      const Vector3d normal = (at[t[1]] - at[t[0]]).cross(at[t[2]] - at[t[0]]).normalized();
      if (normal.isZero()) continue;  // it has no area
      const auto flat = static_cast<std::uint32_t>(normals.size());
      normals.push_back(rounded(normal));
      for (const int v : t) corners.push_back({first + static_cast<std::uint32_t>(v), flat});
    }
  }
  XmlWriter xml(out);
  xml.declare();
  const auto collada = xml.open("COLLADA", colladaAttributes());
  writeColladaAsset(xml);
  writeColladaColors(xml, by_color);
  writeColladaMesh(xml, "room", positions, normals, by_color);
  {
    const auto library = xml.open("library_visual_scenes");
    const auto scenes = xml.open("visual_scene", {{"id", "scene"}, {"name", "scene"}});
    const auto node = xml.open("node", {{"id", "room"}, {"name", "room"}, {"type", "NODE"}});
    const auto instance = xml.open("instance_geometry", {{"url", "#room-mesh"}});
    bindColladaColors(xml, by_color);
  }
  writeColladaEnd(xml);
}

void writeActorSdf(std::ostream& out, double bvh_unit, bool with_room) {
  ColladaList unit;
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
  if (with_room) {
    const auto model = xml.open("model", {{"name", "room"}});
    xml.text("static", {}, "true");
    const auto link = xml.open("link", {{"name", "room"}});
    const auto visual = xml.open("visual", {{"name", "room"}});
    const auto geometry = xml.open("geometry");
    const auto mesh = xml.open("mesh");
    xml.text("uri", {}, "room.dae");
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
