/// The room as a picture shows it: walls that stand between the eye and the walk are cut, ceilings
/// left out.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "environments/scene/scene.h"
#include "viz/pictures/rasterizer.h"

namespace amble {

/// What a connected surface is to the picture.
enum class RoomPart {
  kFloor,     ///< a broad thing level with the floor
  kWall,      ///< as high as a room, and thin or as long as one
  kOverhead,  ///< hangs from wall to wall: a beam
  kCeiling,
  kFurniture,
};

struct RoomSurface {
  TriangleMesh mesh;          ///< World [m]
  Eigen::AlignedBox3d box;    ///< around it [m]
  Eigen::AlignedBox3d thing;  ///< around all surfaces of objects of the same name [m]
  RoomPart part = RoomPart::kFurniture;
  Color color = Color::Zero();
  int object = 0;  ///< of the scene
  bool closed = false;
};

/// Every connected surface of the scene, with its colour. Cost: linear in triangles; a few ms for a
/// room.
std::vector<RoomSurface> sortRoom(const Scene& scene, double floor);

/// Fewer triangles, `most` at most, for looking at (thin_mesh.h). @return what was done, for
/// people; "" nothing
std::string thinRoom(std::vector<RoomSurface>& room, size_t most);

/// The triangles of each surface, whole and without flags: made once for all places that a picture
/// may be taken from.
using DrawnSurfaces = std::vector<std::vector<DrawTriangle>>;
DrawnSurfaces drawSurfaces(const std::vector<RoomSurface>& room, int threads = 1);

/// Where the picture is taken from, and what it must show.
struct RoomSight {
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();  ///< World [m]
  std::vector<Eigen::Vector3d> watched;           ///< points of the walk [m]
  double floor = 0.0;                             ///< [m]
  bool inside = false;  ///< the eye is in the room: nothing is cut or left out

  /// Height over the ground of the lowest watched points: what such a point is over is walked on.
  static constexpr double kFeet = 0.1;  // [m]
};

/// Triangles to draw from there: walls on the eye's side of the room are cut to a skirting, others
/// that hide a watched point to a parapet with a ghost above, ceilings are left out, all else is
/// whole, and so is what the walk stands on.
/// @param drawn  of the room
void addRoom(const std::vector<RoomSurface>& room, const DrawnSurfaces& drawn,
             const RoomSight& sight, std::vector<DrawTriangle>& triangles);

}  // namespace amble
