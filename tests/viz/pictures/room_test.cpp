#include "viz/pictures/room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/environments/test_meshes.h"
#include "tests/viz/test_walk.h"

namespace amble {
namespace {

using Eigen::Vector3d;

/// Whether a triangle that is drawn solid lies between two points (Moeller and Trumbore 1997).
bool hidden(const std::vector<DrawTriangle>& triangles, const Vector3d& eye, const Vector3d& p) {
  const Vector3d way = p - eye;
  return std::any_of(triangles.begin(), triangles.end(), [&](const DrawTriangle& t) {
    if (t.flags & kSeeThrough) return false;
    const Vector3d a = t.p[0].cast<double>(), ab = t.p[1].cast<double>() - a,
                   ac = t.p[2].cast<double>() - a;
    const Vector3d q = way.cross(ac), r = (eye - a).cross(ab);
    const double det = ab.dot(q);
    if (std::abs(det) < 1e-12) return false;
    const double u = (eye - a).dot(q) / det, v = way.dot(r) / det, s = ac.dot(r) / det;
    return u >= 0 && v >= 0 && u + v <= 1 && s > 1e-6 && s < 1 - 1e-6;
  });
}

double areaOf(const std::vector<DrawTriangle>& triangles, bool see_through) {
  double area = 0.0;
  for (const DrawTriangle& t : triangles) {
    if (static_cast<bool>(t.flags & kSeeThrough) != see_through) continue;
    area += 0.5 * static_cast<double>((t.p[1] - t.p[0]).cross(t.p[2] - t.p[0]).norm());
  }
  return area;
}

TEST(Room, LeavesOutTheCeilingAndCutsTheWallsTowardsTheEye) {
  Scene scene = testRoom();
  scene.objects.push_back(testBox("ceiling", {6, 4, 0.2}, {3, 2, 2.6}));
  scene.objects.push_back(
      testBox("picture", {0.8, 0.03, 0.5}, {3, 0.02, 1.5}));  // hangs on the south wall
  const auto room = sortRoom(scene, 0);
  const RoomSight sight{{3, -8, 6}, {{3, 2, 1}}, 0};  // the eye is south of the room
  std::vector<DrawTriangle> triangles;
  addRoom(room, drawSurfaces(room), sight, triangles);
  float highest = 0, south = 0, north = 0;
  for (const DrawTriangle& t : triangles) {
    for (const auto& p : t.p) {
      highest = std::max(highest, p.z());
      if (p.y() < -0.01f) south = std::max(south, p.z());  // the side walls end at 0 and at 4
      if (p.y() > 4.01f) north = std::max(north, p.z());
    }
  }
  EXPECT_NEAR(highest, 2.5, 1e-5);
  EXPECT_NEAR(north, 2.5, 1e-5);
  EXPECT_GT(south, 0.01f);
  EXPECT_LT(south, 0.3f);
  const auto on_south = [](const DrawTriangle& t) {
    return t.p[0].z() > 1 && t.p[0].y() < 0.05f && t.p[0].y() > 0.001f;
  };
  EXPECT_EQ(std::count_if(triangles.begin(), triangles.end(), on_south),
            0);  // no picture in the air
}

TEST(Room, TellsFloorsWallsBeamsAndFurniture) {
  Scene scene = testRoom();
  scene.objects.push_back(testBox("beam", {0.2, 4, 0.9}, {3, 2, 2.05}));
  const auto room = sortRoom(scene, 0);
  ASSERT_EQ(room.size(), 7u);
  EXPECT_EQ(room[0].part, RoomPart::kFloor);
  for (int i = 1; i <= 4; ++i) EXPECT_EQ(room[i].part, RoomPart::kWall);
  EXPECT_EQ(room[5].part, RoomPart::kFurniture);
  EXPECT_EQ(room[6].part, RoomPart::kOverhead);
}

TEST(Room, TheTreadsOfAStairAreNoWallsHoweverHighAndHaveOneColour) {
  Scene scene = testRoom();
  for (int i = 1; i <= 18; ++i)
    scene.objects.push_back(
        testBox("tread-" + std::to_string(i), {0.3, 1.2, 0.17 * i}, {0.3 * i, 2, 0.085 * i}));
  const auto room = sortRoom(scene, 0);
  for (size_t i = 6; i < room.size(); ++i) {
    EXPECT_EQ(room[i].part, RoomPart::kFurniture) << i;
    EXPECT_EQ(room[i].color, room[6].color) << i;
  }
}

TEST(Room, WallsThatAreNumberedAreWalls) {
  Scene scene = testRoom();
  for (int i = 1; i <= 4; ++i) scene.objects[i].name = "wall-" + std::to_string(i);
  const auto room = sortRoom(scene, 0);
  for (int i = 1; i <= 4; ++i) EXPECT_EQ(room[i].part, RoomPart::kWall);
}

TEST(Room, OfAnEmptySceneIsNothing) {
  EXPECT_TRUE(sortRoom(Scene{}, 0.0).empty());
  std::vector<DrawTriangle> triangles;
  addRoom({}, DrawnSurfaces{}, {{0, 0, 5}, {}, 0.0}, triangles);
  EXPECT_TRUE(triangles.empty());
}

TEST(Room, PartsAreTheSameAtWhateverHeightTheFloorIs) {
  Scene scene = testRoom();
  scene.objects.push_back(testBox("ceiling", {6, 4, 0.2}, {3, 2, 2.6}));
  scene.objects.push_back(testBox("rug", {2, 1, 0.01}, {3, 2, 0.005}));
  const auto here = sortRoom(scene, 0.0);
  for (SceneObject& object : scene.objects) object.X_WO.translation().z() += 6.5;
  const auto above = sortRoom(scene, 6.5);
  ASSERT_EQ(here.size(), above.size());
  for (size_t i = 0; i < here.size(); ++i) {
    EXPECT_EQ(here[i].part, above[i].part) << scene.objects[i].name;
    EXPECT_EQ(here[i].color, above[i].color) << scene.objects[i].name;
  }
}

TEST(Room, SurfacesKeepTheirTrianglesAndBoxes) {
  const Scene scene = testRoom();
  const auto room = sortRoom(scene, 0.0);
  ASSERT_EQ(room.size(), scene.objects.size());
  for (size_t i = 0; i < room.size(); ++i) {
    EXPECT_EQ(room[i].mesh.triangles.size(), 12u);
    EXPECT_TRUE(room[i].closed);
    const Eigen::AlignedBox3d box = boundsOf(worldMesh(scene.objects[i]));
    EXPECT_LT((room[i].box.min() - box.min()).norm() + (room[i].box.max() - box.max()).norm(),
              1e-9);
  }
}

TEST(Room, RugsAndPlanksAreToldByTheirHeight) {
  Scene scene = testRoom();
  scene.objects.push_back(testBox("mat", {2, 1, 0.01}, {3, 2, 0.005}));
  const auto room = sortRoom(scene, 0.0);
  EXPECT_EQ(room.front().color, kFloorColor);
  EXPECT_EQ(room.back().part, RoomPart::kFloor);
  EXPECT_EQ(room.back().color, kRugColor);
}

// Wherever the eye is: heads and hips of the walk are behind nothing but furniture and ghosts.
TEST(Room, WallsHideNoHeadFromAnyCorner) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> x(0.5, 5.5), y(0.5, 3.5);
  for (int n = 0; n < 20; ++n) {
    Scene scene = testRoom();
    scene.objects.pop_back();  // the chest
    scene.objects.push_back(testBox("divider", {0.1, 2.4, 2.5}, {x(generator), 1.25, 1.25}));
    const auto room = sortRoom(scene, 0.0);
    RoomSight sight;
    for (int i = 0; i < 4; ++i) {
      const Vector3d at(x(generator), y(generator), 0.0);
      if (std::abs(at.x() - scene.objects.back().X_WO.translation().x()) < 0.3) continue;
      for (const double height : {1.1, 1.6})
        sight.watched.push_back(at + height * Vector3d::UnitZ());
    }
    for (const Vector3d& eye :
         {Vector3d(-6, -6, 8), Vector3d(12, -6, 8), Vector3d(12, 10, 8), Vector3d(-6, 10, 8)}) {
      sight.eye = eye;
      std::vector<DrawTriangle> triangles;
      addRoom(room, drawSurfaces(room), sight, triangles);
      for (const Vector3d& p : sight.watched)
        EXPECT_FALSE(hidden(triangles, eye, p)) << n << ": " << p.transpose();
    }
  }
}

TEST(Room, AWallThatIsCutForTheWalkIsAParapetBelowAGhost) {
  Scene scene = testRoom();
  scene.objects.push_back(testBox("divider", {3, 0.1, 2.5}, {3, 1.5, 1.25}));
  const auto room = sortRoom(scene, 0.0);
  RoomSight sight{{3, -8, 5}, {{3, 3, 1.1}}, 0.0};
  std::vector<DrawTriangle> behind, beside;
  addRoom(room, drawSurfaces(room), sight, behind);
  sight.watched = {{3, 0.5, 1.1}};  // before it
  addRoom(room, drawSurfaces(room), sight, beside);
  // Both sides and ends of the divider above the parapet, and its top: a ghost's area.
  EXPECT_NEAR(areaOf(behind, true), 2 * (3 + 0.1) * 1.6 + 0.3, 1e-4);
  EXPECT_EQ(areaOf(beside, true), 0.0);
}

TEST(Room, FurnitureIsDrawnWholeWhereverTheEyeIs) {
  const Scene scene = testRoom();
  const auto room = sortRoom(scene, 0.0);
  const Color chest = room.back().color;
  for (const Vector3d& eye : {Vector3d(3, -8, 6), Vector3d(12, 2, 6), Vector3d(3, 12, 3)}) {
    std::vector<DrawTriangle> triangles;
    addRoom(room, drawSurfaces(room), {eye, {{3, 2, 1}}, 0.0}, triangles);
    EXPECT_EQ(std::count_if(triangles.begin(), triangles.end(),
                            [&](const DrawTriangle& t) { return t.color == chest; }),
              12);
  }
}

TEST(Room, WhatTheWalkStandsOnIsDrawnWholeThoughItIsAWall) {
  Scene scene = testRoom();
  scene.objects.push_back(testBox("rampart", {6, 0.35, 2.3}, {3, 0.3, 1.15}));
  const auto room = sortRoom(scene, 0.0);
  ASSERT_EQ(room.back().part, RoomPart::kWall);
  RoomSight sight{{3, -8, 9}, {{3, 0.3, 2.3 + RoomSight::kFeet}}, 0.0};
  std::vector<DrawTriangle> triangles;
  addRoom(room, drawSurfaces(room), sight, triangles);
  float top = 0.0f;
  for (const DrawTriangle& t : triangles)
    for (const auto& p : t.p)
      if (p.y() > 0.1f && p.y() < 0.5f) top = std::max(top, p.z());
  EXPECT_NEAR(top, 2.3f, 1e-5f);
}

}  // namespace
}  // namespace amble
