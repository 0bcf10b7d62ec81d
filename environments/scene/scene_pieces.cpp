#include "environments/scene/scene_pieces.h"

#include <algorithm>
#include <memory>
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

// Of an object's parts which are the hollow of others: all of them within solid, by parity over the
// closed parts that are around them.
std::vector<bool> findHollows(const std::vector<MeshComponent>& parts, const StopRequest& stop) {
  std::vector<Eigen::AlignedBox3d> boxes(parts.size());
  std::vector<int> by_x;  // closed parts, from their lowest x on
  for (size_t k = 0; k < parts.size(); ++k) {
    for (const Eigen::Vector3d& v : parts[k].mesh.vertices) boxes[k].extend(v);
    if (parts[k].closed) by_x.push_back(static_cast<int>(k));
  }
  std::sort(by_x.begin(), by_x.end(), [&](int a, int b) {
    return std::pair(boxes[a].min().x(), a) < std::pair(boxes[b].min().x(), b);
  });
  std::vector<std::unique_ptr<Parity>> solids(parts.size());  // made when first asked
  std::vector<bool> hollow(parts.size(), false);
  for (const int i : by_x) {
    stop.check();
    std::vector<bool> inside(parts[i].mesh.vertices.size(), false);
    for (const int k : by_x) {
      if (boxes[k].min().x() > boxes[i].min().x()) break;
      if (k == i || !boxes[k].contains(boxes[i])) continue;
      if (!solids[k]) solids[k] = std::make_unique<Parity>(parts[k].mesh);
      for (size_t v = 0; v < inside.size(); ++v)
        if (solids[k]->inside(parts[i].mesh.vertices[v])) inside[v] = !inside[v];
    }
    hollow[i] = std::find(inside.begin(), inside.end(), false) == inside.end();
  }
  return hollow;
}

// Primitives are of one piece as they are made.
std::vector<MeshComponent> partsOf(const SceneObject& object) {
  if (std::holds_alternative<TriangleMesh>(object.shape)) return splitComponents(worldMesh(object));
  std::vector<MeshComponent> whole;
  whole.push_back({worldMesh(object), true});
  return whole;
}

std::vector<Triangle3> trianglesOf(const std::vector<ScenePiece>& pieces, size_t count) {
  std::vector<Triangle3> triangles;
  triangles.reserve(count);
  for (const ScenePiece& piece : pieces)
    for (const std::array<int, 3>& t : piece.mesh.triangles)
      triangles.push_back(
          {piece.mesh.vertices[t[0]], piece.mesh.vertices[t[1]], piece.mesh.vertices[t[2]]});
  return triangles;
}

}  // namespace

double upwardness(const Triangle3& t) { return (t[1] - t[0]).cross(t[2] - t[0]).normalized().z(); }

std::span<const ScenePiece> ScenePieces::ofObject(int object) const {
  const auto [begin, end] = std::ranges::equal_range(pieces, object, {}, &ScenePiece::object);
  return {begin, end};
}

ScenePieces splitScene(const Scene& scene, const StopRequest& stop) {
  ScenePieces all;
  size_t count = 0;
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    if (scene.objects[i].role == Role::kIgnore) continue;
    std::vector<MeshComponent> parts = partsOf(scene.objects[i]);
    const std::vector<bool> hollow = findHollows(parts, stop);
    for (size_t k = 0; k < parts.size(); ++k) {
      ScenePiece piece{static_cast<int>(i), std::move(parts[k].mesh), parts[k].closed, hollow[k],
                       static_cast<int>(count)};
      const bool inside_out = piece.closed && (signedVolume(piece.mesh) < 0.0) != piece.hollow;
      if (inside_out)
        for (std::array<int, 3>& t : piece.mesh.triangles) std::swap(t[1], t[2]);
      count += piece.mesh.triangles.size();
      all.pieces.push_back(std::move(piece));
    }
  }
  all.grid = TriangleGrid(trianglesOf(all.pieces, count));
  all.piece_of.reserve(count);
  for (size_t k = 0; k < all.pieces.size(); ++k)
    all.piece_of.insert(all.piece_of.end(), all.pieces[k].mesh.triangles.size(),
                        static_cast<int>(k));
  return all;
}

}  // namespace amble
