#include "viz/exchange/glb.h"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "animation/body/foot_shape.h"
#include "animation/body/joint_names.h"
#include "base/rotation.h"
#include "viz/exchange/glb_file.h"
#include "viz/pictures/room.h"

namespace amble {

using Eigen::Quaterniond;
using Eigen::Quaternionf;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

constexpr float kOverGround = 0.004F;  // of path and prints, so that they do not flicker [m]

Vector3f toFile(const Vector3d& p) { return Vector3d(p.x(), p.z(), -p.y()).cast<float>(); }
Quaterniond toFile(const Quaterniond& q_W) { return yUpToWorld().conjugate() * q_W; }

// glTF's colours are linear (IEC 61966-2-1).
float linear(float s) { return s <= 0.04045F ? s / 12.92F : std::pow((s + 0.055F) / 1.055F, 2.4F); }
Vector3f linear(const Color& color) {
  return {linear(color.x()), linear(color.y()), linear(color.z())};
}

// A motion as both a clip and an animation buffer have it.
struct Motion {
  const Skeleton& skeleton;
  const PoseArray& poses;
  double frame_time;
  const std::vector<Vector3d>* joint_positions;  // null or empty: none but the root's
};

class GlbMaker {
 public:
  explicit GlbMaker(std::string name) { file_.name = std::move(name); }

  GlbFile take() { return std::move(file_); }

  void addReport(const std::string& report) {
    if (report.empty()) return;
    nlohmann::json json = nlohmann::json::parse(report);
    json.erase("times");
    file_.extras = nlohmann::json{{"report", std::move(json)}}.dump();
  }

  void addMotion(const Motion& motion) {
    for (int j = 0; j < motion.skeleton.size(); ++j) {
      GlbTrack track = trackOf(motion, j);
      GlbNode node;
      node.name = motion.skeleton.joint(j).name;
      node.parent = motion.skeleton.joint(j).parent;
      node.rotation = track.rotations.front();
      node.translation = track.translations.empty() ? motion.skeleton.joint(j).offset.cast<float>()
                                                    : track.translations.front();
      file_.joints.push_back(static_cast<int>(file_.nodes.size()));
      file_.nodes.push_back(std::move(node));
      keepWhatMoves(track, j == 0);
    }
    for (int i = 0; i < motion.poses.size(); ++i)
      file_.times.push_back(static_cast<float>(i * motion.frame_time));
  }

  void addFigure(const Figure& figure) {
    for (const JointFrame& frame : figure.bind) {
      Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
      X.linear() = toFile(frame.q_WJ).toRotationMatrix();
      X.translation() = toFile(frame.p_WJ).cast<double>();
      file_.inverse_bind.push_back(X.inverse().matrix().cast<float>());
    }
    if (figure.triangles.empty()) return;
    GlbPrimitive skin;
    skin.material = addMaterial("figure", Color::Ones(), false);
    for (const Vector3f& p : figure.vertices) skin.positions.push_back(toFile(p.cast<double>()));
    for (const Vector3f& n : figure.normals) skin.normals.push_back(toFile(n.cast<double>()));
    for (const auto& color : figure.colors) {
      std::array<std::uint16_t, 4> out = {0, 0, 0, 65535};
      for (int k = 0; k < 3; ++k)
        out[k] = static_cast<std::uint16_t>(
            std::lround(65535.0F * linear(static_cast<float>(color[k]) / 255.0F)));
      skin.colors.push_back(out);
    }
    skin.joints = figure.joints;
    skin.weights = figure.weights;
    for (const auto& t : figure.triangles)
      skin.indices.insert(skin.indices.end(), t.begin(), t.end());
    addNode("figure", -1, addMesh("figure", {std::move(skin)})).skinned = true;
  }

  void addPath(const WalkView& view) {
    GlbPrimitive line;
    line.is_line = true;
    for (const FrameState& state : view.animation->states)
      line.positions.push_back(toFile(state.position) + kOverGround * Vector3f::UnitY());
    if (line.positions.size() < 2) return;
    line.material = addMaterial("root path", kPathColor, true);
    addNode("root path", -1, addMesh("root path", {std::move(line)}));
  }

  void addFootprints(const WalkView& view) {
    if (view.animation->footprints.empty()) return;
    const int parent = static_cast<int>(file_.nodes.size());
    addNode("footprints", -1, -1);
    std::array<int, 2> meshes{};
    for (const Side side : {kLeft, kRight}) meshes[side] = addSole(side, soleLength(view));
    int number = 0;
    for (const Footprint& print : view.animation->footprints) {
      Vector3d normal = Vector3d::UnitZ();
      if (view.ground != nullptr) {
        const auto there =
            view.ground->surface(print.position.x(), print.position.y(), print.position.z(), 0.1);
        if (there) normal = there->normal;
      }
      GlbNode& node = addNode(
          "footprint " + std::to_string(++number) + (print.side == kLeft ? " left" : " right"),
          parent, meshes[print.side]);
      node.translation = toFile(print.position + kOverGround * normal);
      // The mesh is in the file's axes: World's turn between them.
      node.rotation =
          (toFile(soleFrame(print.heading, normal)) * yUpToWorld()).normalized().cast<float>();
    }
  }

  void addScene(const Scene& scene, double floor) {
    const int parent = static_cast<int>(file_.nodes.size());
    addNode("scene", -1, -1);
    std::vector<RoomSurface> room = sortRoom(scene, floor);
    if (const std::string said = thinRoom(room, kMostGlbTriangles); !said.empty())
      file_.nodes[parent].extras = nlohmann::json{{"thinned", said}}.dump();
    std::map<int, std::vector<const RoomSurface*>> by_object;
    for (const RoomSurface& surface : room)
      if (!surface.mesh.triangles.empty()) by_object[surface.object].push_back(&surface);
    for (const auto& [object, surfaces] : by_object) {
      const std::string name = objectName(scene.objects[object]);
      std::vector<GlbPrimitive> primitives = primitivesOf(surfaces);
      addNode(name, parent, primitives.empty() ? -1 : addMesh(name, std::move(primitives)));
    }
  }

 private:
  GlbNode& addNode(const std::string& name, int parent, int mesh) {
    GlbNode node;
    node.name = name;
    node.parent = parent;
    node.mesh = mesh;
    file_.nodes.push_back(std::move(node));
    return file_.nodes.back();
  }

  int addMesh(const std::string& name, std::vector<GlbPrimitive> primitives) {
    file_.meshes.push_back({name, std::move(primitives)});
    return static_cast<int>(file_.meshes.size()) - 1;
  }

  // One for each colour, whoever has it.
  int addMaterial(const std::string& name, const Color& color, bool both_sides) {
    const auto [known, is_new] = materials_.try_emplace({hexColor(color), both_sides},
                                                        static_cast<int>(file_.materials.size()));
    if (is_new) file_.materials.push_back({name, linear(color), both_sides});
    return known->second;
  }

  static GlbTrack trackOf(const Motion& motion, int joint) {
    GlbTrack track;
    track.node = joint;
    const bool moving = motion.joint_positions != nullptr && !motion.joint_positions->empty();
    for (int i = 0; i < motion.poses.size(); ++i) {
      const PoseView pose = motion.poses[i];
      const Quaterniond q = joint == 0 ? toFile(pose.rotations[0]) : pose.rotations[joint];
      Quaternionf turn = q.normalized().cast<float>();
      if (i > 0 && turn.dot(track.rotations.back()) < 0.0F) turn.coeffs() *= -1.0F;
      track.rotations.push_back(turn);
      if (joint == 0) track.translations.push_back(toFile(pose.p_WR));
      if (joint > 0 && moving)
        track.translations.push_back(
            (*motion.joint_positions)[static_cast<size_t>(i) * motion.skeleton.size() + joint]
                .cast<float>());
    }
    return track;
  }

  // What stands still is said by the node alone; but a motion has one track at least.
  void keepWhatMoves(GlbTrack& track, bool is_root) {
    const auto still = [](const auto& list) {
      for (const auto& one : list)
        if (!(one.isApprox(list.front(), 0.0F))) return false;
      return true;
    };
    if (still(track.rotations) && !is_root) track.rotations.clear();
    if (still(track.translations) && !is_root) track.translations.clear();
    if (!track.rotations.empty() || !track.translations.empty())
      file_.tracks.push_back(std::move(track));
  }

  int addSole(Side side, double length) {
    GlbPrimitive sole;
    sole.material = addMaterial(side == kLeft ? "left" : "right", sideColor(side), true);
    for (const Eigen::Vector2d& p : shoeOutline(side, length))
      sole.positions.push_back(toFile({p.x(), p.y(), 0.0}));
    const auto corners = static_cast<std::uint32_t>(sole.positions.size());
    sole.positions.push_back(Vector3f::Zero());
    sole.normals.assign(sole.positions.size(), Vector3f::UnitY());
    for (std::uint32_t i = 0; i < corners; ++i)
      sole.indices.insert(sole.indices.end(), {corners, i, (i + 1) % corners});
    return addMesh(side == kLeft ? "left sole" : "right sole", {std::move(sole)});
  }

  // Flat: a corner for each triangle that meets there, since edges of rooms are sharp.
  std::vector<GlbPrimitive> primitivesOf(const std::vector<const RoomSurface*>& surfaces) {
    std::map<int, GlbPrimitive> by_material;
    for (const RoomSurface* surface : surfaces) {
      const int material = addMaterial(hexColor(surface->color), surface->color, true);
      for (const auto& t : surface->mesh.triangles) {
        const Vector3d &a = surface->mesh.vertices[t[0]], &b = surface->mesh.vertices[t[1]],
                       &c = surface->mesh.vertices[t[2]];
        const Vector3f normal = toFile((b - a).cross(c - a).normalized());
        if (normal.isZero()) continue;  // it has no area
        GlbPrimitive& part = by_material[material];
        part.material = material;
        for (const Vector3d& p : {a, b, c}) {
          part.positions.push_back(toFile(p));
          part.normals.push_back(normal);
        }
      }
    }
    std::vector<GlbPrimitive> parts;
    for (auto& [material, part] : by_material) parts.push_back(std::move(part));
    return parts;
  }

  GlbFile file_;
  std::map<std::pair<std::string, bool>, int> materials_;
};

}  // namespace

void writeGlb(std::ostream& out, const Clip& clip, const Figure& figure) {
  GlbMaker maker(clip.name);
  maker.addMotion({clip.skeleton, clip.poses, clip.frame_time, &clip.joint_positions});
  maker.addFigure(figure);
  writeGlbFile(out, maker.take());
}

void writeGlb(std::ostream& out, const WalkView& view, const Figure& figure,
              const GlbWalkOptions& options) {
  GlbMaker maker(view.title);
  const Skeleton named =
      options.joint_names.empty() ? *view.skeleton : renamed(*view.skeleton, options.joint_names);
  maker.addMotion({named, view.animation->poses, view.animation->frame_time, nullptr});
  maker.addFigure(figure);
  maker.addPath(view);
  maker.addFootprints(view);
  if (options.scene && view.scene != nullptr) maker.addScene(*view.scene, view.floor);
  maker.addReport(options.report);
  writeGlbFile(out, maker.take());
}

}  // namespace amble
