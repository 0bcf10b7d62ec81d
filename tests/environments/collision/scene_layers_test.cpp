#include "environments/collision/scene_layers.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "test_paths.h"
#include "tests/environments/test_files.h"
#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

// Every object whole, asked of FCL alone.
ObstacleSet everything(const Scene& scene) {
  std::vector<Obstacle> obstacles;
  for (size_t i = 0; i < scene.objects.size(); ++i)
    obstacles.push_back(obstacleOf(scene.objects[i], static_cast<int>(i)));
  return ObstacleSet(std::move(obstacles));
}

// Above the floor the layers together must give FCL's answer.
void expectSameAnswers(const Scene& scene, double floor, const Eigen::AlignedBox3d& box,
                       int count) {
  const SceneGround ground(scene, floor);
  const SceneLayers layers(scene, ground);
  const ObstacleSet exact = everything(scene);
  const auto scratch = ObstacleSet::makeScratch();
  std::mt19937_64 generator(14);
  int touching = 0, compared = 0;
  for (int n = 0; n < count; ++n) {
    const Capsule capsule = randomCapsule(generator, box);
    if (capsule.lowest() < floor) continue;
    ++compared;
    const int object = exact.touched(capsule, *scratch);
    const int obstacle = layers.touchedObstacle(capsule, 0.0, *scratch),
              ground_object = layers.ground().touched(capsule, 0.0, *scratch);
    const bool first = obstacle >= 0 && (ground_object < 0 || obstacle < ground_object);
    EXPECT_EQ(first ? obstacle : ground_object, object)
        << capsule.from.transpose() << " to " << capsule.to.transpose() << " radius "
        << capsule.radius;
    touching += object >= 0;
  }
  EXPECT_GT(touching, compared / 50);
  EXPECT_LT(touching, compared - compared / 50);
}

TEST(SceneLayers, GiveTheAnswersOfFclInARoomOfOneMesh) {
  // Floor slab, walls with a pillar of their own material, and a closed chest, as one mesh; a lamp
  // besides.
  TriangleMesh room;
  const auto add = [&](const Eigen::Vector3d& size, const Eigen::Vector3d& at) {
    TriangleMesh box = makeBox(size);
    for (Eigen::Vector3d& v : box.vertices) v += at;
    room = joined(room, box);
  };
  add({6, 6, 0.2}, {0, 0, -0.1});
  add({0.2, 6, 2.5}, {-3, 0, 1.25});
  add({6, 0.2, 2.5}, {0, 3, 1.25});
  add({0.5, 0.5, 2.5}, {1, 1, 1.25});
  add({1.0, 1.4, 0.8}, {-1, -1, 0.4});
  const Scene scene =
      sceneOf({makeObject("room", room, {0, 0, 0}), makeObject("lamp", Sphere{0.3}, {0, 0, 2.0})});
  expectSameAnswers(scene, 0.0, {Eigen::Vector3d(-3.2, -3.2, 0), Eigen::Vector3d(3.2, 3.2, 2.6)},
                    20000);
}

// The shells of a room, as one mesh and as two, with things in it and beside it.
TEST(SceneLayers, TouchWhatTheyDoWhetherShellsAreOneObjectOrTwo) {
  const TriangleMesh outer = makeBox({6.4, 5.4, 3.0}), inner = makeBox({6.0, 5.0, 2.6});
  const auto object = [](const TriangleMesh& mesh) {
    return makeObject("shell", mesh, {0, 0, 1.3});
  };
  const std::vector<SceneObject> things = {
      makeObject("yard", Box{{20, 20, 0.1}}, {0, 0, -0.25}),
      makeObject("chest", makeBox({1, 1.4, 0.8}), {-1, -1, 0.4}),
      makeObject("lamp", Sphere{0.3}, {1, 1, 2.0})};
  const auto with = [&](std::vector<SceneObject> shells) {
    shells.insert(shells.end(), things.begin(), things.end());
    return sceneOf(shells);
  };
  const Scene one = with({object(joined(outer, inner))}),
              two = with({object(outer), object(inner)});
  const SceneGround one_ground(one), two_ground(two);
  const SceneLayers one_layers(one, one_ground), two_layers(two, two_ground);
  const auto scratch = ObstacleSet::makeScratch();
  const auto touches = [&](const SceneLayers& layers, const Capsule& capsule) {
    return layers.touchedObstacle(capsule, 0.0, *scratch) >= 0 ||
           layers.ground().touched(capsule, 0.0, *scratch) >= 0;
  };
  std::mt19937_64 generator(6);
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-3.6, -3.0, -0.15), Eigen::Vector3d(3.6, 3.0, 2.9));
  int touching = 0;
  for (int n = 0; n < 20000; ++n) {
    const Capsule capsule = randomCapsule(generator, box, 0.3);
    const bool expected = touches(one_layers, capsule);
    ASSERT_EQ(touches(two_layers, capsule), expected)
        << capsule.from.transpose() << " to " << capsule.to.transpose() << " " << capsule.radius;
    touching += expected;
  }
  EXPECT_GT(touching, 5000);
  EXPECT_LT(touching, 15000);
}

TEST(SceneLayers, GiveTheAnswersOfFclInARealFlat) {
  const std::filesystem::path mesh =
      std::filesystem::path(AMBLE_SHARED) / "scenes/apartment/apartment.obj";
  if (!std::filesystem::exists(mesh)) GTEST_SKIP() << mesh << " is not there";
  const TestFolder folder;
  const Scene scene = readScene(folder.write(
      "s.yaml", "objects:\n  - {name: flat, mesh: " + std::filesystem::absolute(mesh).string() +
                    ", up: y}\n"));
  const std::vector<double> levels = SceneGround(scene).floors(-2, 2);
  ASSERT_EQ(levels.size(), 1u);
  expectSameAnswers(
      scene, levels[0],
      {Eigen::Vector3d(-5.7, -2.1, levels[0]), Eigen::Vector3d(1.4, 6.0, levels[0] + 2.0)}, 20000);
}

}  // namespace
}  // namespace amble
