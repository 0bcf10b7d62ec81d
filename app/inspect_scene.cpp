// What `amble inspect` says of scenes, meshes and scenarios.

#include <fmt/format.h>

#include "app/findings.h"
#include "base/file_axes.h"
#include "base/rotation.h"
#include "environments/ground/ground_warnings.h"
#include "environments/scene/mesh_reader.h"
#include "environments/scene/scene.h"
#include "scenarios/problem.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFloorSamples = 24;  // a side, where floors are looked for: finds rooms, not ledges

const char* roleName(Role role) {
  switch (role) {
    case Role::kAuto:
      return "auto";
    case Role::kGround:
      return "ground";
    case Role::kObstacle:
      return "obstacle";
    case Role::kIgnore:
      break;
  }
  return "ignore";
}

const char* shapeName(const Shape& shape) {
  constexpr const char* kNames[] = {"box", "cylinder", "sphere", "capsule", "mesh"};
  return kNames[shape.index()];
}

Eigen::AlignedBox3d boundsOf(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : mesh.vertices) box.extend(vertex);
  return box;
}

std::string sizeText(const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d size = box.sizes();
  return fmt::format("{:.2f} x {:.2f} x {:.2f}", size.x(), size.y(), size.z());
}

Json boxJson(const Eigen::AlignedBox3d& box) {
  return {{"min", {box.min().x(), box.min().y(), box.min().z()}},
          {"max", {box.max().x(), box.max().y(), box.max().z()}}};
}

int openComponents(const TriangleMesh& mesh) {
  int open = 0;
  for (const MeshComponent& component : splitComponents(mesh)) open += component.closed ? 0 : 1;
  return open;
}

void describeObject(const SceneObject& object, Findings& out) {
  const TriangleMesh world = worldMesh(object);
  const Eigen::AlignedBox3d box = boundsOf(world);
  const std::string name = objectName(object);
  std::string text =
      fmt::format("{}, {}, {} m", shapeName(object.shape), roleName(object.role), sizeText(box));
  Json entry = {{"name", object.name},
                {"part", object.part},
                {"shape", shapeName(object.shape)},
                {"role", roleName(object.role)},
                {"bounds", boxJson(box)}};
  if (const auto* mesh = std::get_if<TriangleMesh>(&object.shape)) {
    const int open = openComponents(*mesh);
    text += fmt::format(", {} triangles, {}", mesh->triangles.size(), open == 0 ? "solid" : "open");
    entry["triangles"] = mesh->triangles.size();
    entry["open_components"] = open;
    if (open > 0 && object.role != Role::kIgnore) {
      out.warnings.push_back(
          fmt::format("{}: {} of its pieces {} not closed, so only the surface counts", name, open,
                      open == 1 ? "is" : "are"));
    }
  }
  out.facts.emplace_back(name, text);
  out.data["objects"].push_back(std::move(entry));
}

// Heights that can be stood on at the points of a grid, lowest first, those within kLevel as one.
std::vector<double> floorHeights(const SceneGround& ground, const Eigen::AlignedBox3d& box) {
  std::vector<double> heights;
  for (int i = 0; i < kFloorSamples * kFloorSamples; ++i) {
    const Eigen::Vector2d share((i % kFloorSamples + 0.5) / kFloorSamples,
                                (static_cast<int>(i / kFloorSamples) + 0.5) / kFloorSamples);
    const Eigen::Vector2d at = box.min().head<2>() + box.sizes().head<2>().cwiseProduct(share);
    for (const double height : ground.floors(at.x(), at.y())) heights.push_back(height);
  }
  std::sort(heights.begin(), heights.end());
  std::vector<double> distinct;
  for (const double height : heights) {
    if (distinct.empty() || height > distinct.back() + SceneGround::kLevel) {
      distinct.push_back(height);
    }
  }
  return distinct;
}

// As a scene does by its `up` and `scale`.
void placeMesh(const MotionReadOptions& axes, MeshFile& mesh) {
  for (MeshPart& part : mesh.parts) {
    for (Eigen::Vector3d& vertex : part.mesh.vertices) {
      vertex =
          axes.metres_per_unit.value_or(1.0) * fileToWorld(vertex, axes.up.value_or(UpAxis::kZ));
    }
  }
}

std::string placeText(const Place& place) {
  std::string text = fmt::format("({:g}, {:g})", place.at.x(), place.at.y());
  if (place.z) text += fmt::format(" on the floor near z = {:g}", *place.z);
  return text + (place.heading ? fmt::format(", heading {:g} degrees", *place.heading / kDegree)
                               : ", any heading");
}

std::string paceText(const WalkSpec& walk) {
  const std::string speed =
      walk.own_speed ? "at its own speed" : fmt::format("{:g} m/s", walk.speed);
  return walk.style.empty() ? speed : fmt::format("in the style {}, {}", walk.style, speed);
}

}  // namespace

Findings inspectScene(const std::filesystem::path& file, const LoadLimits& limits) {
  const Scene scene = readScene(file, limits);
  Findings out{file.string(), "scene", {}, {}, {}};
  const Eigen::AlignedBox3d box = scene.bounds();
  const SceneGround ground(scene, {}, limits.stop);
  const std::vector<double> heights = floorHeights(ground, box);
  std::string text;
  for (const double height : heights)
    text += fmt::format("{}{:.2f}", text.empty() ? "" : ", ", height);
  out.facts = {{"name", scene.name},
               {"size", sizeText(box) + " m"},
               {"objects", fmt::format("{}, {} triangles in meshes", scene.objects.size(),
                                       scene.triangleCount())},
               {"levels", (text.empty() ? "none" : text + " m") + " (upward surfaces)"}};
  out.data = {{"name", scene.name},
              {"bounds", boxJson(box)},
              {"triangles", scene.triangleCount()},
              {"levels", heights},
              {"objects", Json::array()}};
  out.warnings = sceneWarnings(scene, ground);
  if (heights.empty()) out.warnings.push_back("there is nothing to stand on");
  for (const SceneObject& object : scene.objects) describeObject(object, out);
  return out;
}

Findings inspectMesh(const std::filesystem::path& file, const MotionReadOptions& axes,
                     const LoadLimits& limits) {
  const auto stopped = [&limits] { return limits.stop.asked(); };
  MeshFile mesh = readMesh(file, limits.memory, stopped);
  Findings out{file.string(), "mesh", {}, {}, {}};
  out.warnings = mesh.warnings;
  const char* unit = mesh.has_axes || axes.metres_per_unit ? "m" : "of the file's unit";
  if (mesh.has_axes && (axes.up || axes.metres_per_unit))
    out.warnings.push_back(
        "the file says its axes and unit itself: --up and --unit change nothing");
  if (!mesh.has_axes) placeMesh(axes, mesh);
  Eigen::AlignedBox3d box;
  size_t triangles = 0;
  out.data = {{"has_axes", mesh.has_axes}, {"parts", Json::array()}};
  for (const MeshPart& part : mesh.parts) {
    const Eigen::AlignedBox3d part_box = boundsOf(part.mesh);
    const std::string name = part.names.empty() ? "(no name)" : part.names.front();
    out.facts.emplace_back(name, fmt::format("{} {}, {} triangles", sizeText(part_box), unit,
                                             part.mesh.triangles.size()));
    out.data["parts"].push_back({{"names", part.names},
                                 {"triangles", part.mesh.triangles.size()},
                                 {"bounds", boxJson(part_box)}});
    box.extend(part_box);
    triangles += part.mesh.triangles.size();
  }
  out.facts.emplace_back("all", fmt::format("{} {}, {} triangles", sizeText(box), unit, triangles));
  out.data["bounds"] = boxJson(box);
  out.data["triangles"] = triangles;
  if (!mesh.has_axes && !axes.up) {
    out.warnings.push_back(
        "the file does not say which axis is up: a scene says `up: y` or `up: z`");
  }
  return out;
}

Findings inspectScenario(const ScenarioFile& file, const LoadLimits& limits) {
  const Scenario scenario = readScenario(file);
  const Scene scene = beginScene(scenario, limits).finish();
  const SceneGround ground(scene, groundSettings(scenario, loadLibrary(scenario)), limits.stop);
  Findings out{file.file.string(), "scenario", {}, {}, {}};
  const CharacterSpec& who = scenario.character;
  out.facts = {
      {"name", scenario.name},
      {"scene", fmt::format("{}, {} m, {} objects, {} triangles", scenario.scene.string(),
                            sizeText(scene.bounds()), scene.objects.size(), scene.triangleCount())},
      {"character", fmt::format("{}, library {}",
                                who.height > 0.0 ? fmt::format("{:g} m", who.height)
                                                 : std::string("the library's own height"),
                                who.library)},
      {"start", placeText(scenario.start)},
      {"goal", placeText(scenario.goal)},
      {"walk", fmt::format("{}, from {}, to {}", paceText(scenario.walk),
                           scenario.walk.from_standing ? "standing" : "walking",
                           scenario.walk.to_standing ? "standing" : "walking")},
      {"planner",
       fmt::format("{}, seed {}, {} failures, {:g} s", scenario.planner.name, scenario.planner.seed,
                   scenario.planner.max_failures, scenario.planner.time_limit)}};
  for (const Place& place : scenario.via) out.facts.emplace_back("via", placeText(place));
  for (const ScenarioQuery& query : scenario.queries) {
    out.facts.emplace_back("query", fmt::format("{}: {} to {}", query.name, placeText(query.start),
                                                placeText(query.goal)));
  }
  out.data = {{"name", scenario.name},
              {"scene", scenario.scene.string()},
              {"planner", scenario.planner.name},
              {"seed", scenario.planner.seed},
              {"style", scenario.walk.style},
              {"speed", scenario.walk.speed}};
  if (scenario.walk.own_speed) out.data["speed"] = nullptr;
  out.warnings = sceneWarnings(scene, ground);
  const Eigen::AlignedBox3d box = scene.bounds();
  for (const auto* place : {&scenario.start, &scenario.goal}) {
    const Eigen::Array2d at = place->at.array();
    if ((at < box.min().head<2>().array()).any() || (at > box.max().head<2>().array()).any()) {
      out.warnings.push_back(fmt::format("{} is outside the scene", placeText(*place)));
    }
  }
  if (!scenario.expect)
    out.warnings.push_back("there is no `expect`, so `amble check` judges nothing");
  return out;
}

}  // namespace amble
