#include "environments/scene/scene_pieces.h"

#include <algorithm>
#include <utility>

#include "base/parallel.h"
#include "environments/scene/hollows.h"

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

SolidMesh solidOf(int object, const ScenePieces& pieces) {
  SolidMesh solid;
  for (const ScenePiece& piece : pieces.ofObject(object))
    if (piece.closed && piece.solid_of == object) solid.add(piece.mesh, piece.hollow);
  const auto [begin, end] = pieces.hollows.equal_range(object);
  for (auto hollow = begin; hollow != end; ++hollow)
    solid.add(pieces.pieces[hollow->second].mesh, true);
  return solid;
}

ScenePieces splitScene(const Scene& scene, const StopRequest& stop) {
  ScenePieces all;
  std::vector<std::vector<MeshComponent>> parts(scene.objects.size());
  parallelFor(static_cast<int>(parts.size()), usualThreads(), [&](int i, int) {
    stop.check();
    if (scene.objects[i].role != Role::kIgnore) parts[i] = partsOf(scene.objects[i]);
  });
  size_t count = 0;
  for (size_t i = 0; i < parts.size(); ++i) {
    const int object = static_cast<int>(i);
    for (MeshComponent& part : parts[i]) {
      const int first = static_cast<int>(count);
      count += part.mesh.triangles.size();
      all.pieces.push_back({object, std::move(part.mesh), part.closed, false, object, first});
    }
  }
  markHollows(scene, all.pieces, stop);
  for (size_t k = 0; k < all.pieces.size(); ++k) {
    ScenePiece& piece = all.pieces[k];
    const bool inside_out = piece.closed && (signedVolume(piece.mesh) < 0.0) != piece.hollow;
    if (inside_out)
      for (std::array<int, 3>& t : piece.mesh.triangles) std::swap(t[1], t[2]);
    all.piece_of.insert(all.piece_of.end(), piece.mesh.triangles.size(), static_cast<int>(k));
    if (piece.solid_of != piece.object) all.hollows.emplace(piece.solid_of, static_cast<int>(k));
  }
  all.grid = TriangleGrid(trianglesOf(all.pieces, count));
  return all;
}

}  // namespace amble
