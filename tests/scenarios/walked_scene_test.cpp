#include "scenarios/walked_scene.h"

#include "scenarios/walker_ground.h"
#include "tests/scenarios/small_room.h"

namespace amble {
namespace {

class WalkedScenes : public SmallRoom {
 protected:
  WalkedScene open() const {
    return WalkedScene(std::make_shared<const Scene>(readScene(folder_ / "scene.yaml")));
  }
};

TEST_F(WalkedScenes, PeopleOfOneSizeShareTheirGround) {
  const WalkedScene scene = open();
  const auto tall = scene.ground(walkerGround(1.9, {}), {});
  EXPECT_NE(scene.ground(walkerGround(1.5, {}), {}), tall);
  EXPECT_EQ(scene.ground(walkerGround(1.9, {}), {}), tall);
  GroundLimits careful;
  careful.max_climb = 0.1;
  EXPECT_NE(scene.ground(walkerGround(1.9, careful), {}), tall);
}

TEST_F(WalkedScenes, GroundIsWhatItIsToOneAlone) {
  const WalkedScene scene = open();
  const GroundSettings settings = walkerGround(1.7, {});
  const SceneGround alone(*scene.scene(), settings);
  EXPECT_EQ(scene.ground(settings, {})->groundTriangles(), alone.groundTriangles());
}

TEST_F(WalkedScenes, WhoHasTheSameGroundTouchesTheSameThings) {
  const WalkedScene scene = open();
  const auto tall = scene.ground(walkerGround(1.9, {}), {});
  const auto small = scene.ground(walkerGround(1.5, {}), {});
  EXPECT_EQ(scene.layers(*tall, {}), scene.layers(*small, {}));
}

TEST_F(WalkedScenes, WhoHasOtherGroundTouchesOtherThings) {
  // A loft that is floor to who can stand below the roof.
  std::string low = kScene;
  low += "  - {name: roof, box: {size: [6, 3.2, 0.1]}, at: [3, 1.5, 1.05]}\n";
  write("scene.yaml", low);
  const WalkedScene scene = open();
  const auto tall = scene.ground(walkerGround(1.9, {}), {});
  const auto small = scene.ground(walkerGround(1.2, {}), {});
  ASSERT_NE(tall->groundTriangles(), small->groundTriangles());
  EXPECT_NE(scene.layers(*tall, {}), scene.layers(*small, {}));
}

TEST_F(WalkedScenes, KeepAFewOfEachOnly) {
  const WalkedScene scene = open();
  std::weak_ptr<const SceneGround> first = scene.ground(walkerGround(1.0, {}), {});
  for (int i = 1; i < WalkedScene::kKept; ++i) scene.ground(walkerGround(1.0 + 0.1 * i, {}), {});
  EXPECT_FALSE(first.expired());
  scene.ground(walkerGround(2.0, {}), {});
  EXPECT_TRUE(first.expired());
}

}  // namespace
}  // namespace amble
