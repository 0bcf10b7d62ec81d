#include "environments/furniture/furniture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <sstream>

#include "test_paths.h"

namespace amble {
namespace {

const std::filesystem::path kScenes =
    std::filesystem::path(AMBLE_SOURCE_DIR) / "environments" / "scenes";

std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string objText(const Furniture& piece) {
  std::ostringstream out;
  writeObj(out, piece);
  return out.str();
}

std::vector<Furniture> allPieces() {
  auto pieces = makeLivingRoomFurniture();
  pieces.push_back(makeCupboard());
  return pieces;
}

// Six times the volume of each connected piece, by the piece's first vertex.
std::map<int, double> componentVolumes(const Surface& surface) {
  std::vector<int> parent(surface.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& t : surface.triangles) {
    parent[root(t[1])] = root(t[0]);
    parent[root(t[2])] = root(t[0]);
  }
  std::map<int, double> volumes;
  for (const auto& t : surface.triangles) {
    const auto &a = surface.vertices[t[0]], &b = surface.vertices[t[1]],
               &c = surface.vertices[t[2]];
    volumes[root(t[0])] += a.dot(b.cross(c));
  }
  return volumes;
}

double top(const Furniture& piece, const std::string& group) {
  double highest = 0;
  for (const auto& [name, surface] : piece.groups) {
    if (name != group) continue;
    for (const auto& p : surface.vertices) highest = std::max(highest, p.z());
  }
  return highest;
}

TEST(Furniture, EveryEdgeHasTwoTrianglesOnceEachWay) {
  for (const Furniture& piece : allPieces()) {
    for (const auto& [name, surface] : piece.groups) {
      std::map<std::pair<int, int>, int> edges;
      for (const auto& t : surface.triangles)
        for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
      for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1) << piece.name << ' ' << name;
        ASSERT_EQ(edges.count({edge.second, edge.first}), 1u) << piece.name << ' ' << name;
      }
    }
  }
}

TEST(Furniture, EveryClosedSurfaceIsWoundOutwards) {
  for (const Furniture& piece : allPieces())
    for (const auto& [name, surface] : piece.groups)
      for (const auto& [component, volume] : componentVolumes(surface))
        EXPECT_GT(volume, 0) << piece.name << ' ' << name << ' ' << component;
}

TEST(Furniture, NoTriangleVanishesAtFiveDecimals) {
  for (const Furniture& piece : allPieces()) {
    for (const auto& [name, surface] : piece.groups) {
      for (const auto& t : surface.triangles) {
        for (int k = 0; k < 3; ++k) {
          const double edge = (surface.vertices[t[k]] - surface.vertices[t[(k + 1) % 3]]).norm();
          ASSERT_GT(edge, 5e-5) << piece.name << ' ' << name;
        }
      }
    }
  }
}

TEST(Furniture, StandsOnTheFloor) {
  for (const Furniture& piece : allPieces()) {
    if (piece.name == "picture") continue;  // hangs
    double lowest = 1;
    for (const auto& group : piece.groups)
      for (const auto& p : group.second.vertices) lowest = std::min(lowest, p.z());
    EXPECT_NEAR(lowest, 0, 0.002) << piece.name;
  }
}

TEST(Furniture, HasTheHeightsThatThePassageNeeds) {
  EXPECT_NEAR(top(makePianoStool(), "seat"), 0.50, 0.005);  // the arm swings over it
  EXPECT_NEAR(top(makeLowTable(), "top"), 0.42, 0.001);
  EXPECT_LT(top(makeLowTable(), "bowl"), 0.50);
}

TEST(Furniture, CommittedMeshesAreWhatTheGeneratorMakes) {
  for (const Furniture& piece : makeLivingRoomFurniture()) {
    const auto file = kScenes / "living-room" / "meshes" / (piece.name + ".obj");
    EXPECT_TRUE(contents(file) == objText(piece)) << file << " differs: run make_furniture";
  }
  const auto file = kScenes / "goal-inside-closed-cupboard" / "meshes" / "cupboard.obj";
  EXPECT_TRUE(contents(file) == objText(makeCupboard())) << file << " differs: run make_furniture";
  const auto hills = kScenes / "rolling-terrain" / "meshes" / "terrain.obj";
  EXPECT_TRUE(contents(hills) == objText(makeTerrain())) << hills << " differs: run make_furniture";
}

TEST(Furniture, TheTerrainIsNowhereSteeperThanFifteenDegrees) {
  const Furniture terrain = makeTerrain();
  const Surface& surface = terrain.groups.at(0).second;
  double steepest = 1.0;
  for (const auto& t : surface.triangles) {
    const Eigen::Vector3d &a = surface.vertices[t[0]], &b = surface.vertices[t[1]],
                          &c = surface.vertices[t[2]];
    const double up = (b - a).cross(c - a).normalized().z();
    if (up > 0.1) steepest = std::min(steepest, up);
  }
  EXPECT_GT(steepest, std::cos(15.0 * 3.14159265 / 180.0));
  EXPECT_LT(steepest, std::cos(13.0 * 3.14159265 / 180.0));
}

}  // namespace
}  // namespace amble
