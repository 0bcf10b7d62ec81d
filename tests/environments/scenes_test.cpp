// The committed scenes (environments/scenes/*/scene.yaml) are what their scenarios need.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "environments/scene/scene.h"
#include "test_paths.h"

namespace amble {
namespace {

const std::filesystem::path kScenes =
    std::filesystem::path(AMBLE_SOURCE_DIR) / "environments" / "scenes";

Scene readCommitted(const std::string& name) { return readScene(kScenes / name / "scene.yaml"); }

Eigen::AlignedBox3d boxOf(const Scene& scene, const std::string& name) {
  Eigen::AlignedBox3d box;
  for (const SceneObject& object : scene.objects)
    if (object.name == name)
      for (const auto& p : worldMesh(object).vertices) box.extend(p);
  return box;
}

TEST(Scenes, AllCanBeRead) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kScenes)) {
    const auto file = entry.path() / "scene.yaml";
    if (!std::filesystem::exists(file)) continue;
    if (entry.path().filename() == "apartment") continue;  // its mesh is not in the repository
    EXPECT_NO_THROW({
      const Scene scene = readScene(file);
      EXPECT_EQ(scene.name, entry.path().filename().string());
    }) << file;
    ++count;
  }
  EXPECT_GE(count, 19);
}

TEST(Scenes, ApartmentLiesInTheRoomsThatItsCommentNames) {
  if (!std::filesystem::exists(std::filesystem::path(AMBLE_SHARED) /
                               "scenes/apartment/apartment.obj"))
    GTEST_SKIP() << "no scenes/apartment in " << AMBLE_SHARED;
  const auto file = kScenes / "apartment" / "scene.yaml";
  if (!std::filesystem::exists(kScenes / "../../../shared/scenes/apartment/apartment.obj"))
    GTEST_SKIP() << "shared/ does not lie beside the repository, where the scene looks for it";
  EXPECT_TRUE(readScene(file).bounds().contains(Eigen::Vector3d(-5.7, 6.0, 2.4)));
}

TEST(LivingRoom, HasTwentyToSeventyThousandTriangles) {
  const int triangles = readCommitted("living-room").triangleCount();
  EXPECT_GE(triangles, 20000);
  EXPECT_LE(triangles, 70000);  // more would be slow to load, not more believable
}

TEST(LivingRoom, IsPartedFromWallToWallButForThePassageAtTheStool) {
  const Scene room = readCommitted("living-room");
  // Along y: south wall, sofa, low table, passage, stool, piano, north wall.
  const auto sofa = boxOf(room, "sofa"), table = boxOf(room, "low-table");
  const auto stool = boxOf(room, "piano-stool"), piano = boxOf(room, "piano");
  constexpr double kShut = 0.2;  // nobody walks through less [m]
  EXPECT_LT(sofa.min().y() - 0.0, kShut);
  EXPECT_LT(table.min().y() - sofa.max().y(), kShut);
  EXPECT_LT(piano.min().y() - stool.max().y(), kShut);
  EXPECT_LT(6.0 - piano.max().y(), kShut);
  const double passage = stool.min().y() - table.max().y();
  EXPECT_GT(passage, 0.50);  // legs fit
  EXPECT_LT(passage, 0.80);  // the cylinder around a walker with swinging arms does not
}

TEST(LivingRoom, ArmsSwingOverWhatIsBesideThePassage) {
  const Scene room = readCommitted("living-room");
  EXPECT_LT(boxOf(room, "piano-stool").max().z(), 0.51);
  EXPECT_LT(boxOf(room, "low-table").max().z(), 0.51);
}

TEST(NarrowGap, IsAsWideAsItsNameSays) {
  for (const int width : {100, 80, 70, 60, 55, 50, 45, 40, 30, 20}) {
    const std::string number = std::to_string(1000 + width).substr(1);
    const Scene scene = readCommitted("narrow-gap-" + number);
    const double gap =
        boxOf(scene, "divider-north").min().y() - boxOf(scene, "divider-south").max().y();
    EXPECT_NEAR(gap, width / 100.0, 1e-9);
  }
}

TEST(LowBeam, HangsAtOneMetreSixty) {
  EXPECT_NEAR(boxOf(readCommitted("low-beam"), "beam").min().z(), 1.60, 1e-9);
}

TEST(Maze, LeadsFromEveryCellToEveryOther) {
  // Cells of 1.4 m; a wall stands between two of them where some maze wall crosses the line of
  // their middles.
  constexpr int kCells = 7;
  constexpr double kCell = 1.4;
  const Scene maze = readCommitted("maze");
  std::vector<Eigen::AlignedBox3d> walls;
  for (const SceneObject& object : maze.objects)
    if (object.name.rfind("maze-", 0) == 0) walls.push_back(boxOf(maze, object.name));
  const auto open = [&](int i, int j, int di, int dj) {
    const Eigen::Vector3d between((i + 0.5 + di * 0.5) * kCell, (j + 0.5 + dj * 0.5) * kCell, 1);
    return std::none_of(walls.begin(), walls.end(),
                        [&](const auto& wall) { return wall.contains(between); });
  };
  std::vector<bool> seen(kCells * kCells);
  std::vector<int> todo = {0};
  seen[0] = true;
  int doors = 0;
  while (!todo.empty()) {
    const int cell = todo.back(), i = cell % kCells, j = cell / kCells;
    todo.pop_back();
    for (const auto& [di, dj] :
         {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
      if (i + di < 0 || i + di >= kCells || j + dj < 0 || j + dj >= kCells || !open(i, j, di, dj))
        continue;
      ++doors;
      const int next = (j + dj) * kCells + i + di;
      if (!seen[next]) todo.push_back(next);
      seen[next] = true;
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), true), kCells * kCells);
  EXPECT_EQ(doors / 2, kCells * kCells - 1);  // a tree: one way only
}

}  // namespace
}  // namespace amble
