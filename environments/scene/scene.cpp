#include "environments/scene/scene.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>

#include "base/error.h"
#include "base/file_axes.h"
#include "base/rotation.h"
#include "base/strict_yaml.h"
#include "base/text.h"
#include "environments/scene/kept_meshes.h"
#include "environments/scene/mesh_reader.h"
#include "environments/scene/mesh_warnings.h"

namespace amble {
namespace {

constexpr double kSmallestScene = 0.5;    // [m] smaller is a unit that was not said
constexpr double kLargestScene = 1000.0;  // [m]
constexpr double kUsualScene = 10.0;      // [m] what a suggested scale aims at
constexpr double kLargestLength = 1e5;    // [m] of a size or a radius
constexpr double kFarthestPlace = 1e8;    // [m] what brings a mesh back from a map's coordinates
constexpr FileKind kSceneFile = {"a scene (YAML)", size_t{16} << 20};

Role readRole(const YamlNode& node) {
  return node.asEnum<Role>({{"auto", Role::kAuto},
                            {"ground", Role::kGround},
                            {"obstacle", Role::kObstacle},
                            {"ignore", Role::kIgnore}});
}

const std::vector<std::string> kShapes = {"box", "mesh", "cylinder", "sphere", "capsule"};

struct PartRule {
  std::string pattern;
  Role role;
  YamlNode node;
  bool used = false;
};

}  // namespace

// What is read of a scene file so far; mesh files are read once each.
class SceneReading::Reader {
 public:
  Reader(const std::filesystem::path& file, const LoadLimits& limits)
      : file_(file), limits_(limits) {}

  // The file itself; its meshes are begun.
  void begin() {
    root_ = readYaml(file_, kSceneFile);
    root_.requireKeys({"name", "objects"});
    scene_.file = file_;
    scene_.inputs.push_back(file_);
    scene_.name = root_.has("name") ? root_.at("name").asString() : file_.stem().string();
    readAhead(root_.at("objects"));
  }

  Scene finish() {
    const YamlNode objects = root_.at("objects");
    ahead_ = small_->take();
    limits_.stop.check();
    for (const YamlNode& item : objects.items()) readObject(item);
    checkSize(objects);
    return std::move(scene_);
  }

 private:
  // Small meshes together; what is wrong with one is said where its object is read.
  void readAhead(const YamlNode& objects) {
    std::vector<std::filesystem::path> files;
    for (const YamlNode& item : objects.items()) {
      if (!item.isMap()) continue;
      const YamlNode mesh = item["mesh"];
      if (mesh && mesh.isScalar() && !mesh.isNull()) files.push_back(mesh.asPath());
    }
    std::erase_if(files, [&](const std::filesystem::path& file) { return takeKept(file); });
    small_.emplace(files, limits_.memory, stopped());
  }

  std::function<bool()> stopped() const {
    return [this] { return limits_.stop.asked(); };
  }

  void readObject(const YamlNode& node) {
    limits_.stop.check();
    node.requireKeys({"name", "box", "mesh", "cylinder", "sphere", "capsule", "up", "scale", "at",
                      "turn", "rotate", "role", "parts"});
    SceneObject object;
    object.name = node.at("name").asString();
    if (!line_of_.emplace(object.name, node.line()).second)
      node.at("name").fail("a second object '" + object.name + "', the first is at line " +
                               std::to_string(line_of_[object.name]),
                           "object names that are unique");
    const std::string shape = shapeOf(node);
    if (const YamlNode role = node["role"]) object.role = readRole(role);
    object.X_WO = readPlacing(node);
    if (shape == "mesh") return readMeshParts(node, object);
    for (const char* key : {"up", "scale", "parts"})
      if (const YamlNode unwanted = node[key])
        unwanted.fail(std::string("'") + key + "' of a " + shape, "it with `mesh` only");
    object.shape = readPrimitive(shape, node.at(shape));
    addObject(std::move(object), node);
  }

  static std::string shapeOf(const YamlNode& node) {
    std::string found;
    for (const std::string& shape : kShapes) {
      if (!node.has(shape)) continue;
      if (!found.empty())
        node.at(shape).fail("an object with both " + found + " and " + shape, "one shape");
      found = shape;
    }
    if (found.empty())
      node.fail("an object without a shape", "one of box, mesh, cylinder, sphere, capsule");
    return found;
  }

  static Eigen::Isometry3d readPlacing(const YamlNode& node) {
    const YamlNode turn = node["turn"], rotate = node["rotate"], at = node["at"];
    if (turn && rotate) rotate.fail("both turn and rotate", "one of them");
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    if (turn)
      X.linear() = aboutZ(turn.asDouble(-36000, 36000, "angle [deg]") * kDegree).toRotationMatrix();
    if (rotate) {
      const Eigen::Vector3d angles = kDegree * rotate.asVec(3, "angles [deg]", -36000, 36000);
      X.linear() =
          fromEuler({angles.z(), angles.y(), angles.x()}, {'Z', 'Y', 'X'}).toRotationMatrix();
    }
    if (at) X.translation() = at.asVec(3, "place [m]", -kFarthestPlace, kFarthestPlace);
    return X;
  }

  static Shape readPrimitive(const std::string& shape, const YamlNode& node) {
    const auto length = [&](const char* key) {
      return node.at(key).asPositive(std::string(key) + " [m]", kLargestLength);
    };
    if (shape == "box") {
      node.requireKeys({"size"});
      const Eigen::Vector3d size = node.at("size").asVec(3, "lengths [m]", 0.0, kLargestLength);
      if (size.minCoeff() <= 0.0)
        node.at("size").fail("a box without a size", "three lengths > 0 [m]");
      return Box{size};
    }
    if (shape == "sphere") {
      node.requireKeys({"radius"});
      return Sphere{length("radius")};
    }
    node.requireKeys({"radius", "height"});
    const double radius = length("radius"), height = length("height");
    if (shape == "cylinder") return Cylinder{radius, height};
    if (height <= 2.0 * radius)
      node.at("height").fail("a capsule that is no higher than wide",
                             "a whole height > 2 radius [m]");
    return CapsuleShape{radius, height};
  }

  void readMeshParts(const YamlNode& node, const SceneObject& object) {
    const YamlNode mesh = node.at("mesh");
    const std::filesystem::path path = mesh.asPath();
    const MeshFile& file = meshFile(path, mesh);
    const YamlNode up = node["up"];
    if (file.has_axes && up)
      up.fail("'up' for " + path.filename().string(),
              "no `up`: this format says its axes itself; a file that is z up all the same is "
              "righted by `rotate: [-90, 0, 0]`");
    if (!file.has_axes && !up)
      mesh.fail("'up' is missing for " + path.filename().string(), "`up: y` or `up: z`");
    const UpAxis axis = up && up.indexIn({"y", "z"}) == 0 ? UpAxis::kY : UpAxis::kZ;
    const YamlNode scale_node = node["scale"];
    const double scale = scale_node ? scale_node.asPositive("scale", 1e9) : 1.0;
    std::vector<PartRule> rules = readRules(node);
    for (std::string& warning :
         meshWarnings(object.name, file, scale, !scale_node, axis == UpAxis::kY))
      scene_.warnings.push_back(std::move(warning));
    for (const MeshPart& part : file.parts) {
      SceneObject piece = object;
      if (file.parts.size() > 1 && !part.names.empty()) piece.part = part.names.front();
      piece.role = roleOf(part, rules, object.role);
      TriangleMesh placed = part.mesh;
      for (Eigen::Vector3d& v : placed.vertices) v = scale * fileToWorld(v, axis);
      piece.shape = std::move(placed);
      addObject(std::move(piece), node);
    }
    for (const PartRule& rule : rules)
      if (!rule.used)
        rule.node.fail("'" + rule.pattern + "' matches no part of " + path.filename().string(),
                       "a pattern of " + someNames(file));
  }

  static std::vector<PartRule> readRules(const YamlNode& node) {
    std::vector<PartRule> rules;
    const YamlNode parts = node["parts"];
    if (!parts) return rules;
    for (const YamlNode& item : parts.items()) {
      item.requireKeys({"match", "role"});
      rules.push_back(
          {item.at("match").asString(), readRole(item.at("role")), item.at("match"), false});
    }
    return rules;
  }

  static Role roleOf(const MeshPart& part, std::vector<PartRule>& rules, Role otherwise) {
    const PartRule* first = nullptr;
    for (PartRule& rule : rules) {
      const bool matches = std::any_of(part.names.begin(), part.names.end(), [&](const auto& name) {
        return matchesPattern(rule.pattern, name);
      });
      if (!matches) continue;
      rule.used = true;
      if (!first) first = &rule;
    }
    return first ? first->role : otherwise;
  }

  static std::string someNames(const MeshFile& file) {
    std::string text;
    for (size_t i = 0; i < file.parts.size() && i < 5; ++i)
      if (!file.parts[i].names.empty()) text += (text.empty() ? "" : ", ") + file.parts[i].names[0];
    if (file.parts.size() > 5) text += ", ...";
    return text.empty() ? "the file's names, of which it has none" : text;
  }

  const MeshFile& meshFile(const std::filesystem::path& path, const YamlNode& node) {
    const auto found = meshes_.find(path);
    if (found != meshes_.end()) return *found->second;
    std::error_code error;
    if (!std::filesystem::exists(path, error))
      node.fail("no such file: " + path.string(), "a mesh beside the scene file");
    scene_.inputs.push_back(path);
    const auto file = takeMesh(path);
    meshes_.emplace(path, file);
    scene_.inputs.insert(scene_.inputs.end(), file->others.begin(), file->others.end());
    return *file;
  }

  // Whether a scene before this one has read it.
  bool takeKept(const std::filesystem::path& path) {
    if (limits_.meshes == nullptr) return false;
    if (kept_.count(path) > 0) return true;
    const KeptMeshes::Stamp& stamp = stamps_[path] = KeptMeshes::stampOf(path);
    const auto mesh = limits_.meshes->find(stamp);
    if (mesh) kept_.emplace(path, mesh);
    return mesh != nullptr;
  }

  std::shared_ptr<const MeshFile> takeMesh(const std::filesystem::path& path) {
    const auto kept = kept_.find(path);
    if (kept != kept_.end()) return kept->second;
    const auto mesh = std::make_shared<const MeshFile>(readNow(path));
    if (limits_.meshes) limits_.meshes->keep(stamps_.at(path), mesh);
    return mesh;
  }

  MeshFile readNow(const std::filesystem::path& path) {
    if (auto ready = ahead_.extract(path)) return std::move(ready.mapped());
    try {
      return readMesh(path, limits_.memory, stopped());
    } catch (const InputError&) {
      limits_.stop.check();
      throw;
    }
  }

  void addObject(SceneObject object, const YamlNode& node) {
    if (object.role != Role::kIgnore) {
      const Eigen::AlignedBox3d box = worldBounds(object.shape, object.X_WO);
      bounds_.extend(box);
      const double reach =
          std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
      if (widest_ < 0.0 || reach > widest_) {
        widest_ = reach;
        widest_node_ = node;
      }
    }
    scene_.objects.push_back(std::move(object));
  }

  // The unit of a scene is known by its size only, where a format does not say it.
  void checkSize(const YamlNode& objects) const {
    if (scene_.objects.empty()) objects.fail("a scene without objects", "at least one");
    if (bounds_.isEmpty()) objects.fail("a scene of ignored objects only", "at least one other");
    const double size = bounds_.sizes().maxCoeff();
    if (size >= kSmallestScene && size <= kLargestScene) return;
    if (!widest_node_["mesh"])
      widest_node_.fail("the scene is " + shortNumber(size) + " m large",
                        "0.5 m to 1 km; lengths of what is no mesh are in metres");
    const YamlNode scale = widest_node_["scale"];
    const double now = scale ? scale.asPositive("scale") : 1.0;
    const double needed = now * std::pow(10.0, std::round(std::log10(kUsualScene / size)));
    widest_node_.fail("the scene is " + shortNumber(size) + " m large",
                      "0.5 m to 1 km; `scale: " + shortNumber(needed) + "` would make it so");
  }

  std::filesystem::path file_;
  const LoadLimits limits_;
  YamlNode root_;
  Scene scene_;
  std::optional<SmallMeshes> small_;
  std::map<std::string, int> line_of_;               // of objects by name
  std::map<std::filesystem::path, MeshFile> ahead_;  // read and not yet asked for
  std::map<std::filesystem::path, std::shared_ptr<const MeshFile>> meshes_,  // asked for
      kept_;                                                   // of scenes before this one
  std::map<std::filesystem::path, KeptMeshes::Stamp> stamps_;  // of before they were read
  Eigen::AlignedBox3d bounds_;
  double widest_ = -1.0;  // largest coordinate of the object that reaches farthest [m]
  YamlNode widest_node_;
};

namespace {}  // namespace

Eigen::AlignedBox3d Scene::bounds() const {
  Eigen::AlignedBox3d box;
  for (const SceneObject& object : objects) {
    if (object.role == Role::kIgnore) continue;
    box.extend(worldBounds(object.shape, object.X_WO));
  }
  return box;
}

int Scene::triangleCount() const {
  size_t count = 0;
  for (const SceneObject& object : objects)
    if (const auto* mesh = std::get_if<TriangleMesh>(&object.shape))
      count += mesh->triangles.size();
  return static_cast<int>(count);
}

SceneReading::SceneReading(const std::filesystem::path& file, const LoadLimits& limits)
    : reader_(std::make_unique<Reader>(file, limits)) {
  reader_->begin();
}

SceneReading::~SceneReading() = default;

Scene SceneReading::finish() { return reader_->finish(); }

Scene readScene(const std::filesystem::path& file, const LoadLimits& limits) {
  return SceneReading(file, limits).finish();
}

std::string objectName(const SceneObject& object) {
  return object.part.empty() ? object.name : object.name + ": " + object.part;
}

bool matchesPattern(std::string_view pattern, std::string_view name) {
  // Greedy with one point to come back to: the last `*`.
  size_t p = 0, n = 0, star = std::string_view::npos, star_n = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      star_n = n;
    } else if (p < pattern.size() &&
               (pattern[p] == '?' || lowerCase(pattern[p]) == lowerCase(name[n]))) {
      ++p;
      ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      n = ++star_n;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

namespace {

// So many segments that their chords lie no deeper than kRoundness in a ball, if no more than 48
// do; by fours, so that it is as wide as the ball. Squared it is what a ball costs.
int segmentsOf(double radius) {
  constexpr double kRoundness = 0.005;  // [m]
  constexpr int kFewest = 12, kMost = 48;
  if (radius <= kRoundness) return kFewest;
  const int quarter =
      static_cast<int>(std::ceil(0.25 * kPi / std::acos(1.0 - kRoundness / radius)));
  return std::clamp(4 * quarter, kFewest, kMost);
}

}  // namespace

TriangleMesh worldMesh(const SceneObject& object) {
  struct ToMesh {
    TriangleMesh operator()(const Box& s) const { return makeBox(s.size); }
    TriangleMesh operator()(const Cylinder& s) const { return makeCylinder(s.radius, s.height); }
    TriangleMesh operator()(const Sphere& s) const {
      return makeSphere(s.radius, segmentsOf(s.radius));
    }
    TriangleMesh operator()(const CapsuleShape& s) const {
      return makeCapsule(s.radius, s.height, segmentsOf(s.radius));
    }
    TriangleMesh operator()(const TriangleMesh& s) const { return s; }
  };
  TriangleMesh mesh = std::visit(ToMesh{}, object.shape);
  for (Eigen::Vector3d& v : mesh.vertices) v = object.X_WO * v;
  return mesh;
}

Eigen::AlignedBox3d worldBounds(const Shape& shape, const Eigen::Isometry3d& X_WO) {
  if (const auto* mesh = std::get_if<TriangleMesh>(&shape)) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& v : mesh->vertices) box.extend(X_WO * v);
    return box;
  }
  // How far a primitive reaches along World's axes: half its sides, or an axis and what is round.
  struct Reach {
    const Eigen::Matrix3d& R;
    Eigen::Vector3d operator()(const Box& s) const { return R.cwiseAbs() * (0.5 * s.size); }
    Eigen::Vector3d operator()(const Cylinder& s) const {
      const Eigen::Array3d axis = R.col(2).array();
      return 0.5 * s.height * axis.abs() + s.radius * (1.0 - axis.square()).max(0.0).sqrt();
    }
    Eigen::Vector3d operator()(const Sphere& s) const {
      return Eigen::Vector3d::Constant(s.radius);
    }
    Eigen::Vector3d operator()(const CapsuleShape& s) const {
      return (0.5 * s.height - s.radius) * R.col(2).cwiseAbs() +
             Eigen::Vector3d::Constant(s.radius);
    }
    Eigen::Vector3d operator()(const TriangleMesh&) const { return Eigen::Vector3d::Zero(); }
  };
  const Eigen::Matrix3d R = X_WO.linear();
  const Eigen::Vector3d reach = std::visit(Reach{R}, shape), at = X_WO.translation();
  return {at - reach, at + reach};
}

}  // namespace amble
