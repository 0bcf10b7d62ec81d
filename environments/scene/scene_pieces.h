/// The scene's surfaces as connected pieces in World: the one list of triangles that ground and
/// obstacles are made of, about 130 bytes each.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "environments/scene/parity.h"
#include "environments/scene/scene.h"
#include "environments/scene/triangle_grid.h"

namespace amble {

/// An edge-connected piece of an object's surface. Closed pieces are turned outside out, those that
/// are the hollow of another inside out; open ones face as they are wound.
struct ScenePiece {
  int object = 0;  ///< of the scene
  TriangleMesh mesh;
  bool closed = false;
  bool hollow = false;  ///< closed, and all of it in the solid of others: see hollows.h
  int solid_of = 0;     ///< object whose inside it bounds: its own, or that whose hollow it is
  int first = 0;        ///< its triangles have the numbers first .. first + mesh.triangles.size()
};

struct ScenePieces {
  std::vector<ScenePiece> pieces;   ///< in ascending order of their objects; the ignored left out
  TriangleGrid grid;                ///< of the triangles of all pieces, in their order
  std::vector<int> piece_of;        ///< of each triangle
  std::multimap<int, int> hollows;  ///< of objects: pieces of others that are hollows of theirs

  const std::vector<Triangle3>& triangles() const { return grid.triangles(); }
  const ScenePiece& pieceOf(int triangle) const { return pieces[piece_of[triangle]]; }
  /// Those of an object.
  std::span<const ScenePiece> ofObject(int object) const;
};

/// What bounds the inside of an object: its closed pieces that are not another's hollow, and of
/// others those that are its own.
SolidMesh solidOf(int object, const ScenePieces& pieces);

ScenePieces splitScene(const Scene& scene, const StopRequest& stop = {});

/// z of the unit normal: 1 faces up, -1 down [-1 to 1].
double upwardness(const Triangle3& t);

}  // namespace amble
