#include "environments/scene/scene_pieces.h"

#include <algorithm>
#include <utility>

#include "environments/scene/parity.h"

namespace amble {
namespace {

double signedVolume(const TriangleMesh& mesh) {
  double volume = 0.0;
  const Eigen::Vector3d origin = mesh.vertices.front();
  for (const std::array<int, 3>& t : mesh.triangles)
    volume += (mesh.vertices[t[0]] - origin)
                  .dot((mesh.vertices[t[1]] - origin).cross(mesh.vertices[t[2]] - origin));
  return volume;
}

// Whether part i is the hollow of others: all of it within solid, by parity over the closed parts
// that are around it.
bool isHollow(size_t i, const std::vector<MeshComponent>& parts,
              const std::vector<Eigen::AlignedBox3d>& boxes) {
  TriangleMesh around;
  for (size_t k = 0; k < parts.size(); ++k) {
    if (k == i || !parts[k].closed || !boxes[k].contains(boxes[i])) continue;
    const TriangleMesh& mesh = parts[k].mesh;
    const int base = static_cast<int>(around.vertices.size());
    around.vertices.insert(around.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const std::array<int, 3>& t : mesh.triangles)
      around.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
  if (around.triangles.empty()) return false;
  const Parity solid(around);
  return std::all_of(parts[i].mesh.vertices.begin(), parts[i].mesh.vertices.end(),
                     [&](const Eigen::Vector3d& v) { return solid.inside(v); });
}

}  // namespace

double upwardness(const Triangle3& t) { return (t[1] - t[0]).cross(t[2] - t[0]).normalized().z(); }

ScenePieces splitScene(const Scene& scene) {
  ScenePieces all;
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    if (scene.objects[i].role == Role::kIgnore) continue;
    const std::vector<MeshComponent> parts = splitComponents(worldMesh(scene.objects[i]));
    std::vector<Eigen::AlignedBox3d> boxes(parts.size());
    for (size_t k = 0; k < parts.size(); ++k)
      for (const Eigen::Vector3d& v : parts[k].mesh.vertices) boxes[k].extend(v);
    for (size_t k = 0; k < parts.size(); ++k) {
      ScenePiece piece{static_cast<int>(i), parts[k].mesh, parts[k].closed,
                       static_cast<int>(all.triangles.size())};
      const bool inside_out =
          piece.closed && (signedVolume(piece.mesh) < 0.0) != isHollow(k, parts, boxes);
      for (std::array<int, 3>& t : piece.mesh.triangles) {
        if (inside_out) std::swap(t[1], t[2]);
        all.triangles.push_back(
            {piece.mesh.vertices[t[0]], piece.mesh.vertices[t[1]], piece.mesh.vertices[t[2]]});
        all.piece_of.push_back(static_cast<int>(all.pieces.size()));
      }
      all.pieces.push_back(std::move(piece));
    }
  }
  return all;
}

}  // namespace amble
