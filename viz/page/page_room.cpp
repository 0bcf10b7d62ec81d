// The room of a page: its surfaces, each a box in which a mesh lies, so that equal things, and
// boxes of all sizes, share one mesh.
#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "viz/page/page_data.h"
#include "viz/pictures/room.h"
#include "viz/pictures/thin_mesh.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;
using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr double kGrid = 65535.0;  // steps along a side of a surface's box
constexpr size_t kMost = 150'000;  // triangles of different meshes that a page has: 2 MB or so

// Corners on the grid of the surface's own box, three numbers each, and triangles.
struct GridMesh {
  std::vector<std::uint16_t> corners;
  std::vector<std::uint32_t> triangles;
  bool operator<(const GridMesh& other) const {
    return std::tie(corners, triangles) < std::tie(other.corners, other.triangles);
  }
};

// Where a mesh stands: where its box's corners (0, 0, 0) and unit axes lie in World.
struct Instance {
  Eigen::Matrix<float, 3, 4> placing;
  const RoomSurface* surface;
};

AlignedBox3d boxAround(const TriangleMesh& mesh, const Eigen::Isometry3d& X_OW) {
  AlignedBox3d box;
  for (const Vector3d& p : mesh.vertices) box.extend(X_OW * p);
  return box;
}

GridMesh onGrid(const TriangleMesh& mesh, const Eigen::Isometry3d& X_OW, const AlignedBox3d& box) {
  const Vector3d size = box.sizes();
  GridMesh grid;
  grid.corners.reserve(mesh.vertices.size() * 3);
  for (const Vector3d& p : mesh.vertices) {
    const Vector3d q = X_OW * p - box.min();
    for (int i = 0; i < 3; ++i) {
      const double share = size[i] > 0.0 ? std::clamp(q[i] / size[i], 0.0, 1.0) : 0.0;
      grid.corners.push_back(static_cast<std::uint16_t>(std::lround(kGrid * share)));
    }
  }
  for (const auto& t : mesh.triangles)
    for (const int corner : t) grid.triangles.push_back(static_cast<std::uint32_t>(corner));
  return grid;
}

Json named(const std::string& reference) { return Json::parse(reference); }

Json indicesOf(const GridMesh& mesh, PageBytes& bytes) {
  if (mesh.corners.size() / 3 > kGrid)
    return named(bytes.add(std::span<const std::uint32_t>(mesh.triangles)));
  const std::vector<std::uint16_t> few(mesh.triangles.begin(), mesh.triangles.end());
  return named(bytes.add(std::span<const std::uint16_t>(few)));
}

const char* kindName(RoomPart part) {
  switch (part) {
    case RoomPart::kFloor:
      return "floor";
    case RoomPart::kWall:
      return "wall";
    case RoomPart::kOverhead:
      return "overhead";
    case RoomPart::kCeiling:
      return "ceiling";
    case RoomPart::kFurniture:
      break;
  }
  return "thing";
}

Json instancesJson(const std::vector<Instance>& instances, PageBytes& bytes) {
  std::vector<float> placings;
  std::vector<std::uint8_t> colors;
  std::vector<std::uint32_t> objects;
  Json kinds = Json::array();
  for (const Instance& instance : instances) {
    placings.insert(placings.end(), instance.placing.data(), instance.placing.data() + 12);
    for (int i = 0; i < 3; ++i)
      colors.push_back(static_cast<std::uint8_t>(std::lround(255.0f * instance.surface->color[i])));
    objects.push_back(static_cast<std::uint32_t>(instance.surface->object));
    kinds.push_back(kindName(instance.surface->part));
  }
  return {{"placings", named(bytes.add(std::span<const float>(placings)))},
          {"colors", named(bytes.add(std::span<const std::uint8_t>(colors)))},
          {"objects", named(bytes.add(std::span<const std::uint32_t>(objects)))},
          {"kinds", std::move(kinds)}};
}

using Meshes = std::map<GridMesh, std::vector<Instance>>;

Meshes meshesOf(const Scene& scene, const std::vector<RoomSurface>& room) {
  Meshes meshes;
  for (const RoomSurface& surface : room) {
    const Eigen::Isometry3d& X_WO = scene.objects[surface.object].X_WO;
    const Eigen::Isometry3d X_OW = X_WO.inverse();
    const AlignedBox3d box = boxAround(surface.mesh, X_OW);
    Eigen::Matrix<float, 3, 4> placing;
    placing.leftCols<3>() = (X_WO.linear() * box.sizes().asDiagonal()).cast<float>();
    placing.col(3) = (X_WO * box.min()).cast<float>();
    meshes[onGrid(surface.mesh, X_OW, box)].push_back({placing, &surface});
  }
  return meshes;
}

// The mesh of a surface with fewer triangles, in the same box.
GridMesh thinned(const Scene& scene, const RoomSurface& surface, double cell) {
  const Eigen::Isometry3d X_OW = scene.objects[surface.object].X_WO.inverse();
  return onGrid(thinMesh(surface.mesh, cell), X_OW, boxAround(surface.mesh, X_OW));
}

double thinningCell(const Meshes& meshes) {
  std::vector<const TriangleMesh*> different;
  for (const auto& [mesh, instances] : meshes)
    different.push_back(&instances.front().surface->mesh);
  return thinningCell(different, kMost);
}

}  // namespace

std::string roomJson(const Scene& scene, double floor, PageBytes& bytes) {
  const std::vector<RoomSurface> room = sortRoom(scene, floor);
  const Meshes by_mesh = meshesOf(scene, room);
  const double cell = thinningCell(by_mesh);
  Json meshes = Json::array(), names = Json::array();
  size_t triangles = 0, shown = 0;
  for (const auto& [mesh, instances] : by_mesh) {
    const GridMesh thin =
        cell > 0.0 ? thinned(scene, *instances.front().surface, cell) : GridMesh{};
    const GridMesh& used = cell > 0.0 ? thin : mesh;
    triangles += mesh.triangles.size() / 3 * instances.size();
    shown += used.triangles.size() / 3 * instances.size();
    if (used.triangles.empty()) continue;
    Json json = instancesJson(instances, bytes);
    json["corners"] = named(bytes.add(std::span<const std::uint16_t>(used.corners)));
    json["triangles"] = indicesOf(used, bytes);
    meshes.push_back(std::move(json));
  }
  for (const SceneObject& object : scene.objects) names.push_back(objectName(object));
  const Json json = {
      {"floor", floor},  {"triangles", triangles},      {"shown", shown},
      {"thinned", cell}, {"objects", std::move(names)}, {"meshes", std::move(meshes)}};
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

}  // namespace amble
