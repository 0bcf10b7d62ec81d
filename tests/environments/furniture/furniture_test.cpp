#include "environments/furniture/furniture.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "test_paths.h"
#include "tests/environments/furniture/pieces.h"

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
      for (const Surface& component : componentsOf(surface))
        EXPECT_GT(volumeOf(component), 0) << piece.name << ' ' << name;
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
    EXPECT_NEAR(boxOf(piece).min().z(), 0, 0.002) << piece.name;
  }
}

TEST(Furniture, HasTheHeightsThatThePassageNeeds) {
  EXPECT_NEAR(boxOf(makePianoStool(), "seat").max().z(), 0.50, 0.005);  // the arm swings over it
  EXPECT_NEAR(boxOf(makeLowTable(), "top").max().z(), 0.42, 0.001);
  EXPECT_LT(boxOf(makeLowTable(), "bowl").max().z(), 0.50);
}

// Width, depth and height as furniture.h states them, of the group that has them or of all [m].
TEST(Furniture, IsOfTheSizeThatIsStated) {
  struct Stated {
    Furniture piece;
    const char* group;
    Eigen::Vector3d size;  // 0: not stated
  };
  const std::vector<Stated> all = {
      {makePiano(), "", {1.5, 1.58, 0}},        {makePianoStool(), "seat", {0.44, 0.34, 0}},
      {makeSofa(), "", {2.15, 0.92, 0}},        {makeArmchair(), "", {0.86, 0.86, 0}},
      {makeLowTable(), "top", {0.60, 0.90, 0}}, {makeDiningTable(), "top", {1.50, 0.85, 0}},
      {makeChair(), "", {0.44, 0.48, 0.92}},    {makeLamp(), "shade", {0.42, 0.42, 0}},
      {makeLamp(), "", {0, 0, 1.62}},           {makeBookshelf(), "", {1.20, 0.30, 2.0}},
      {makePlant(), "", {0, 0, 1.3}},           {makeDoor(), "leaf", {0.80, 0, 2.00}},
      {makePicture(), "", {0.9, 0, 0.6}},       {makeCupboard(), "body", {1.10, 0, 2.10}},
      {makeTerrain(), "", {16, 10, 0}}};
  for (const Stated& stated : all) {
    const Eigen::Vector3d size = boxOf(stated.piece, stated.group).sizes();
    const double slack = stated.piece.name == "plant" ? 0.1 : 0.02;
    for (int axis = 0; axis < 3; ++axis) {
      if (stated.size[axis] == 0.0) continue;
      EXPECT_NEAR(size[axis], stated.size[axis], slack) << stated.piece.name << ' ' << axis;
    }
  }
}

TEST(Furniture, SeatsAndTopsAreAsHighAsIsStated) {
  EXPECT_NEAR(boxOf(makeDiningTable(), "top").max().z(), 0.74, 1e-9);
  EXPECT_NEAR(boxOf(makeLowTable(), "top").max().z(), 0.42, 1e-9);
  EXPECT_NEAR(boxOf(makeChair(), "seat").max().z(), 0.45, 0.005);
}

// Parts whose boxes are a few millimetres apart hold one another; what holds nothing would float.
TEST(Furniture, NothingOfItFloats) {
  constexpr double kJoint = 0.006;  // [m]
  for (const Furniture& piece : allPieces()) {
    const auto parts = componentsOf(piece);
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const Surface& part : parts) {
      boxes.push_back(boxOf(part));
      boxes.back().min().array() -= kJoint / 2;
      boxes.back().max().array() += kJoint / 2;
    }
    UnionFind held(static_cast<int>(boxes.size()));
    for (size_t i = 0; i < boxes.size(); ++i)
      for (size_t k = 0; k < i; ++k)
        if (boxes[i].intersects(boxes[k])) held.join(static_cast<int>(i), static_cast<int>(k));
    for (int i = 0; i < held.size(); ++i)
      EXPECT_EQ(held.find(i), 0) << piece.name << ' ' << boxes[i].center().transpose();
  }
}

// Over the feet, by their box: a stool or a lamp that fell over would be no furniture.
TEST(Furniture, ItsCentreOfMassIsOverItsFeet) {
  for (const Furniture& piece : allPieces()) {
    if (piece.name == "picture" || piece.name == "door") continue;  // are held by walls
    Eigen::AlignedBox2d feet;
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    double volume = 0.0;
    for (const Surface& part : componentsOf(piece)) {
      moment += volumeOf(part) * centroidOf(part);
      volume += volumeOf(part);
      for (const auto& p : part.vertices)
        if (p.z() < 0.005) feet.extend(p.head<2>().eval());
    }
    EXPECT_TRUE(feet.contains((moment / volume).head<2>())) << piece.name;
  }
}

TEST(Furniture, EveryMakerGivesTheSameTwice) {
  const auto once = allPieces(), again = allPieces();
  ASSERT_EQ(once.size(), again.size());
  for (size_t i = 0; i < once.size(); ++i) EXPECT_EQ(objText(once[i]), objText(again[i]));
}

TEST(Furniture, NamesAreUniqueOfPiecesAndOfTheirGroups) {
  std::map<std::string, int> pieces;
  for (const Furniture& piece : allPieces()) {
    EXPECT_EQ(++pieces[piece.name], 1) << piece.name;
    std::map<std::string, int> groups;
    for (const auto& [name, surface] : piece.groups) EXPECT_EQ(++groups[name], 1) << name;
  }
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

TEST(Furniture, TheTerrainIsABlockWithHillsWithinTheStatedHeights) {
  const Furniture terrain = makeTerrain();
  const Surface& surface = terrain.groups.at(0).second;
  EXPECT_EQ(boxOf(surface).min().z(), -1.0);
  double lowest = 1.0, highest = -1.0;
  for (const Eigen::Vector3d& p : surface.vertices) {
    if (p.z() == -1.0) continue;
    lowest = std::min(lowest, p.z());
    highest = std::max(highest, p.z());
  }
  EXPECT_LE(highest, 0.47);
  EXPECT_GE(lowest, -0.47);
  EXPECT_GT(highest - lowest, 0.6);  // it does roll
}

}  // namespace
}  // namespace amble
