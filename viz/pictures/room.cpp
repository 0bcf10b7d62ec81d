#include "viz/pictures/room.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/parallel.h"
#include "base/text.h"
#include "viz/pictures/draw_mesh.h"
#include "viz/pictures/thin_mesh.h"

namespace amble {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kFloorLevel = 0.03;  // tops up to here belong to the floor: rugs, thresholds [m]
constexpr double kRugLift = 0.002;    // what lies higher on the floor is a rug [m]
constexpr double kBroad = 2.0;        // a floor or a ceiling is this wide and long at least [m]
constexpr double kRoomHigh = 2.15;    // walls reach this height at least; bookcases do not [m]
constexpr double kHeadHigh = 1.9;     // ceilings begin above this [m]
constexpr double kThin = 0.40;        // walls are no thicker, unless they are long [m]
constexpr double kLong = 3.0;         // what is as high as a room and this long is a wall [m]
constexpr double kSkirting = 0.10;    // what is left of a wall on the eye's side [m]
constexpr double kParapet = 0.90;     // what is left of a wall that hides the walk [m]
constexpr double kBeyond = 0.35;      // how far beyond a wall its other side is looked for [m]
constexpr double kOnWall = 0.15;      // what lies this close to a wall hangs on it [m]

RoomPart partOf(const AlignedBox3d& box, double floor) {
  const Vector3d size = box.sizes();
  const double wide = std::max(size.x(), size.y());
  const double thin = std::min(size.x(), size.y());
  const double top = box.max().z() - floor;
  const double bottom = box.min().z() - floor;
  if (top < kFloorLevel && wide > 0.5) return RoomPart::kFloor;
  if (bottom > kHeadHigh && thin > kBroad) return RoomPart::kCeiling;
  if (top > kRoomHigh && wide > 0.6 && (thin < kThin || wide > kLong))
    return bottom < 0.5                 ? RoomPart::kWall
           : bottom > 1.0 && wide > 1.5 ? RoomPart::kOverhead
                                        : RoomPart::kFurniture;
  return RoomPart::kFurniture;
}

Color colorOf(RoomPart part, const AlignedBox3d& box, double floor, const SceneObject& object,
              int piece) {
  const std::optional<Color> named = namedColor(object.name, object.part);
  if (part == RoomPart::kFloor)
    return named.value_or(box.max().z() > floor + kRugLift ? kRugColor : kFloorColor);
  if (part != RoomPart::kFurniture) return named.value_or(kWallColor);
  if (isMotley(object.part)) return mix(*named, motleyColor(piece), 0.7f);
  return tinted(named.value_or(otherColor(object.name)), piece);
}

// Families whose tops rise by a step each: the upper treads of a stair reach as high as walls do,
// and are none.
std::set<std::string> stairsOf(const Scene& scene) {
  constexpr double kSame = 0.02, kStep = 0.35;  // between tops that are one, and of a step [m]
  constexpr size_t kLeast = 4;                  // tops
  std::map<std::string, std::vector<double>> tops;
  for (const SceneObject& object : scene.objects)
    if (familyName(object.name) != object.name)
      tops[familyName(object.name)].push_back(worldBounds(object.shape, object.X_WO).max().z());
  std::set<std::string> stairs;
  for (auto& [family, heights] : tops) {
    std::sort(heights.begin(), heights.end());
    size_t steps = 1;
    bool even = true;
    for (size_t i = 1; i < heights.size(); ++i) {
      const double rise = heights[i] - heights[i - 1];
      steps += rise > kSame;
      even = even && rise < kStep;
    }
    if (even && steps >= kLeast) stairs.insert(family);
  }
  return stairs;
}

// Whether the segment passes through the box.
bool crosses(const AlignedBox3d& box, const Vector3d& from, const Vector3d& to) {
  double enter = 0, leave = 1;
  for (int a = 0; a < 3; ++a) {
    const double way = to[a] - from[a];
    if (std::abs(way) < 1e-12) {
      if (from[a] < box.min()[a] || from[a] > box.max()[a]) return false;
      continue;
    }
    const double t0 = (box.min()[a] - from[a]) / way, t1 = (box.max()[a] - from[a]) / way;
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  }
  return enter <= leave;
}

bool crosses(const TriangleMesh& mesh, const std::array<int, 3>& t, const Vector3d& from,
             const Vector3d& to) {
  const Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  const Vector3d way = to - from, ab = b - a, ac = c - a;
  const Vector3d p = way.cross(ac);
  const double det = ab.dot(p);
  if (std::abs(det) < 1e-14) return false;
  const double u = (from - a).dot(p) / det;
  const Vector3d q = (from - a).cross(ab);
  const double v = way.dot(q) / det;
  const double s = ac.dot(q) / det;
  return u >= 0 && v >= 0 && u + v <= 1 && s > 0 && s < 1;
}

bool hides(const RoomSurface& surface, const RoomSight& sight) {
  for (const Vector3d& point : sight.watched) {
    if (!crosses(surface.box, sight.eye, point)) continue;
    for (const auto& t : surface.mesh.triangles)
      if (crosses(surface.mesh, t, sight.eye, point)) return true;
  }
  return false;
}

bool overFloor(const std::vector<RoomSurface>& room, const Vector2d& p) {
  return std::any_of(room.begin(), room.end(), [&](const RoomSurface& s) {
    return s.part == RoomPart::kFloor && p.x() > s.box.min().x() && p.x() < s.box.max().x() &&
           p.y() > s.box.min().y() && p.y() < s.box.max().y();
  });
}

// A thin wall with the eye on that side of it where there is no floor.
bool onEyeSide(const std::vector<RoomSurface>& room, const RoomSurface& wall,
               const RoomSight& sight) {
  const Vector3d size = wall.box.sizes();
  const int across = size.x() < size.y() ? 0 : 1;
  if (size[across] > kThin) return false;
  const Vector3d middle = wall.box.center();
  const double towards = sight.eye[across] > middle[across] ? 1 : -1;
  Vector2d outside = middle.head<2>();
  outside[across] += towards * (size[across] / 2 + kBeyond);
  return !overFloor(room, outside);
}

// The part of the mesh below (or above) the height; triangles on it are cut.
TriangleMesh cutLevel(const TriangleMesh& mesh, double height, bool below) {
  TriangleMesh part;
  const double sign = below ? 1 : -1;
  for (const auto& t : mesh.triangles) {
    std::vector<Vector3d> polygon;
    for (int k = 0; k < 3; ++k) {
      const Vector3d &a = mesh.vertices[t[k]], &b = mesh.vertices[t[(k + 1) % 3]];
      const double da = sign * (height - a.z()), db = sign * (height - b.z());
      if (da >= 0) polygon.push_back(a);
      if ((da > 0 && db < 0) || (da < 0 && db > 0)) polygon.push_back(a + da / (da - db) * (b - a));
    }
    const int base = static_cast<int>(part.vertices.size());
    if (polygon.size() < 3) continue;
    part.vertices.insert(part.vertices.end(), polygon.begin(), polygon.end());
    for (int k = 2; k < static_cast<int>(polygon.size()); ++k)
      part.triangles.push_back({base, base + k - 1, base + k});
  }
  return part;
}

// Things that hang on a wall which is cut away go with it.
bool hangsOn(const RoomSurface& thing, const std::vector<const RoomSurface*>& cut) {
  if (thing.part == RoomPart::kFloor) return false;
  return std::any_of(cut.begin(), cut.end(), [&](const RoomSurface* wall) {
    if (wall == &thing) return false;
    AlignedBox3d around = wall->box;
    around.min().array() -= kOnWall;
    around.max().array() += kOnWall;
    return around.contains(thing.thing);
  });
}

// Whether the walk stands on top of the surface, above the floor.
bool isWalkedOn(const RoomSurface& s, const RoomSight& sight) {
  constexpr double kNear = 0.12;  // less than a step's height [m]
  const double top = s.box.max().z();
  if (top < sight.floor + kNear) return false;
  return std::any_of(sight.watched.begin(), sight.watched.end(), [&](const Eigen::Vector3d& p) {
    return std::abs(p.z() - RoomSight::kFeet - top) < kNear && p.x() > s.box.min().x() &&
           p.x() < s.box.max().x() && p.y() > s.box.min().y() && p.y() < s.box.max().y();
  });
}

void addWhole(const std::vector<DrawTriangle>& surface, const Color& color, int flags,
              std::vector<DrawTriangle>& triangles) {
  const size_t first = triangles.size();
  triangles.insert(triangles.end(), surface.begin(), surface.end());
  for (size_t i = first; i < triangles.size(); ++i) {
    triangles[i].color = color;
    triangles[i].flags = static_cast<uint8_t>(flags);
  }
}

}  // namespace

std::vector<RoomSurface> sortRoom(const Scene& scene, double floor) {
  std::vector<RoomSurface> room;
  std::map<std::string, AlignedBox3d> things;
  for (const SceneObject& object : scene.objects)
    for (const Vector3d& p : worldMesh(object).vertices) things[object.name].extend(p);
  const std::set<std::string> stairs = stairsOf(scene);
  for (const SceneObject& object : scene.objects) {
    const size_t first = room.size();
    const bool tread = stairs.contains(familyName(object.name));
    for (MeshComponent& piece : splitComponents(worldMesh(object))) {
      RoomSurface surface;
      for (const Vector3d& p : piece.mesh.vertices) surface.box.extend(p);
      surface.part = tread ? RoomPart::kFurniture : partOf(surface.box, floor);
      surface.color =
          colorOf(surface.part, surface.box, floor, object, static_cast<int>(room.size() - first));
      surface.thing = things[object.name];
      surface.object = static_cast<int>(&object - scene.objects.data());
      surface.closed = piece.closed;
      surface.mesh = std::move(piece.mesh);
      room.push_back(std::move(surface));
    }
    // What is in one part with walls (lintels, sills) is painted as they are.
    const bool walls = std::any_of(room.begin() + static_cast<std::ptrdiff_t>(first), room.end(),
                                   [](const RoomSurface& s) { return s.part == RoomPart::kWall; });
    if (!walls || namedColor(object.name, object.part)) continue;
    for (size_t i = first; i < room.size(); ++i)
      if (room[i].part == RoomPart::kFurniture) room[i].color = kWallColor;
  }
  return room;
}

std::string thinRoom(std::vector<RoomSurface>& room, size_t most) {
  std::vector<const TriangleMesh*> meshes;
  size_t all = 0, left = 0;
  for (const RoomSurface& surface : room) {
    meshes.push_back(&surface.mesh);
    all += surface.mesh.triangles.size();
  }
  const double cell = thinningCell(meshes, most);
  if (cell == 0.0) return {};
  for (RoomSurface& surface : room) {
    surface.mesh = thinMesh(surface.mesh, cell);
    left += surface.mesh.triangles.size();
  }
  return std::to_string(left) + " of " + std::to_string(all) +
         " triangles, for looking at; no corner moved by more than " +
         shortNumber(1e3 * std::sqrt(3.0) * cell, 3) + " mm";
}

DrawnSurfaces drawSurfaces(const std::vector<RoomSurface>& room, int threads) {
  DrawnSurfaces drawn(room.size());
  parallelFor(static_cast<int>(room.size()), threads,
              [&](int i, int) { drawn[i] = drawnMesh(room[i].mesh, room[i].color); });
  return drawn;
}

void addRoom(const std::vector<RoomSurface>& room, const DrawnSurfaces& drawn,
             const RoomSight& sight, std::vector<DrawTriangle>& triangles) {
  std::vector<const RoomSurface*> cut;
  for (const RoomSurface& surface : room)
    if (!sight.inside && surface.part == RoomPart::kWall && onEyeSide(room, surface, sight) &&
        !isWalkedOn(surface, sight))
      cut.push_back(&surface);
  for (size_t i = 0; i < room.size(); ++i) {
    const RoomSurface& s = room[i];
    const uint8_t sides = s.closed ? 0 : kTwoSided;
    if (isWalkedOn(s, sight)) {
      const bool storey = s.part == RoomPart::kCeiling && s.color == kWallColor;
      addWhole(drawn[i], storey ? kFloorColor : s.color, sides | (storey ? kPlanks : 0), triangles);
      continue;
    }
    const bool is_cut = std::find(cut.begin(), cut.end(), &s) != cut.end();
    if (s.part == RoomPart::kCeiling && sight.inside) {
      addWhole(drawn[i], s.color, kNoShadow | sides, triangles);
      continue;
    }
    if (s.part == RoomPart::kCeiling || hangsOn(s, cut)) continue;
    if (is_cut) {
      addMesh(cutLevel(s.mesh, sight.floor + kSkirting, true), s.color, kNoShadow | kCut,
              triangles);
    } else if (s.part == RoomPart::kFloor) {
      addWhole(drawn[i], s.color, kNoShadow | sides | (s.color == kFloorColor ? kPlanks : 0),
               triangles);
    } else if (s.part == RoomPart::kWall && hides(s, sight)) {
      addMesh(cutLevel(s.mesh, sight.floor + kParapet, true), s.color, kNoShadow | kCut, triangles);
      addMesh(cutLevel(s.mesh, sight.floor + kParapet, false), s.color,
              static_cast<uint8_t>(kNoShadow | kSeeThrough | sides), triangles);
    } else if (s.part == RoomPart::kWall) {
      addWhole(drawn[i], s.color, kNoShadow | sides, triangles);
    } else if (s.part == RoomPart::kOverhead) {
      addWhole(drawn[i], s.color, kNoShadow | sides | (hides(s, sight) ? kSeeThrough : 0),
               triangles);
    } else {
      addWhole(drawn[i], s.color, sides, triangles);
    }
  }
}

}  // namespace amble
