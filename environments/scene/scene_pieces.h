/// The scene's surfaces as connected pieces in World: the one list of triangles that ground and
/// obstacles are made of.
#pragma once

#include <cstdint>
#include <vector>

#include "environments/scene/scene.h"
#include "environments/scene/triangle_grid.h"

namespace amble {

/// An edge-connected piece of an object's surface. Closed pieces are turned outside out, those that
/// are the hollow of another inside out; open ones face as they are wound.
struct ScenePiece {
  int object = 0;  ///< of the scene
  TriangleMesh mesh;
  bool closed = false;
  int first = 0;  ///< its triangles have the numbers first .. first + mesh.triangles.size()
};

struct ScenePieces {
  std::vector<ScenePiece> pieces;    ///< in ascending order of their objects; the ignored left out
  std::vector<Triangle3> triangles;  ///< of all pieces
  std::vector<int> piece_of;         ///< of each triangle

  const ScenePiece& pieceOf(int triangle) const { return pieces[piece_of[triangle]]; }
};

ScenePieces splitScene(const Scene& scene);

/// z of the unit normal: 1 faces up, -1 down [-1 to 1].
double upwardness(const Triangle3& t);

}  // namespace amble
