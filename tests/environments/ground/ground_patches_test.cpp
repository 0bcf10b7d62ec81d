#include "environments/ground/ground_patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <set>
#include <thread>

#include "base/sample_stream.h"
#include "environments/ground/plan_strip.h"
#include "environments/ground/scene_ground.h"
#include "environments/scene/scene_pieces.h"
#include "test_paths.h"
#include "tests/environments/random_scenes.h"

namespace amble {
namespace {

// Level slabs of drawn sizes, heights and places beside and over one another, and, where asked for,
// one that is tilted.
Scene drawnSlabs(std::uint64_t seed, bool tilted) {
  SampleStream random(seed, 0);
  std::vector<SceneObject> slabs = {makeObject("floor", Box{{4, 4, 0.1}}, {0, 0, -0.05})};
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d at =
        drawnPoint(random, {Eigen::Vector3d(-1.8, -1.8, 0.0), Eigen::Vector3d(1.8, 1.8, 0.4)});
    slabs.push_back(makeObject("slab",
                               Box{{random.uniform(0.05, 1.5), random.uniform(0.05, 1.5), 0.02}},
                               at, Role::kGround));
    slabs.back().X_WO.linear() = aboutZ(i < 4 ? 0.0 : random.uniform(0.0, 3.0)).toRotationMatrix();
  }
  if (tilted) {
    slabs.back().X_WO.linear() =
        Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()).toRotationMatrix();
  }
  return sceneOf(std::move(slabs));
}

Scene shippedScene(const std::string& name) {
  return readScene(std::filesystem::path(AMBLE_SOURCE_DIR) / "environments/scenes" / name /
                   "scene.yaml");
}

// Heights at a point of all the ground's triangles.
std::set<double> heightsAt(const SceneGround& ground, const Eigen::Vector2d& p) {
  std::set<double> heights;
  for (const Triangle3& t : ground.surfaces().triangles())
    if (const auto height = heightOver(t, p.x(), p.y())) heights.insert(*height);
  return heights;
}

Eigen::Vector2d pointBeside(SampleStream& random, const Eigen::AlignedBox2d& box) {
  return {random.uniform(box.min().x() - 0.1, box.max().x() + 0.1),
          random.uniform(box.min().y() - 0.1, box.max().y() + 0.1)};
}

// Asks about so many drawn points, half of them on the border of a patch, and those that are level
// against all triangles. @return how many were
int compareLevels(const SceneGround& ground, int points, std::uint64_t seed) {
  const GroundPatches patches(ground.surfaces(), ground.all());
  SampleStream random(seed, 1);
  int level = 0;
  for (int n = 0; n < points; ++n) {
    Eigen::Vector2d p = pointBeside(random, ground.all().extent());
    const Eigen::Vector2d& corner = ground.all().extent().min();
    if (n % 2 == 0) {
      const double steps = std::round((p.x() - corner.x()) / GroundPatches::kPatch);
      p.x() = corner.x() + GroundPatches::kPatch * steps;
    }
    for (int k = 0; k < GroundPatches::kAskedBefore; ++k) patches.levelsAt(p.x(), p.y());
    const auto levels = patches.levelsAt(p.x(), p.y());
    if (!levels) continue;
    ++level;
    EXPECT_TRUE(std::is_sorted(levels->begin(), levels->end()));
    EXPECT_EQ(std::set<double>(levels->begin(), levels->end()), heightsAt(ground, p))
        << p.transpose();
  }
  return level;
}

TEST(GroundPatches, LevelsOfDrawnSlabsAreThoseOfTheTrianglesToTheBit) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const SceneGround ground(drawnSlabs(seed, seed % 2 == 0), 0.0);
    EXPECT_GT(compareLevels(ground, 3000, seed), 1500);
  }
}

TEST(GroundPatches, LevelsOfShippedScenesAreThoseOfTheTrianglesToTheBit) {
  for (const char* name : {"living-room", "low-head-room-on-stairs", "stairs-or-ramp", "kerb"}) {
    const SceneGround ground(shippedScene(name));
    EXPECT_GT(compareLevels(ground, 2000, 7), 600) << name;
  }
}

TEST(GroundPatches, SlopesAreLeftToTheTriangles) {
  SceneObject ramp = makeObject("ramp", Box{{2, 2, 0.1}}, {0, 0, 0}, Role::kGround);
  ramp.X_WO.linear() = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const SceneGround ground(sceneOf({ramp}));
  const GroundPatches patches(ground.surfaces(), ground.all());
  for (int k = 0; k < 2 * GroundPatches::kAskedBefore; ++k)
    EXPECT_FALSE(patches.levelsAt(0.3, 0.2));
}

TEST(GroundPatches, SayNothingBeforeTheyWereAskedOftenEnough) {
  const SceneGround ground(sceneOf({floorSlab()}), 0.0);
  const GroundPatches patches(ground.surfaces(), ground.all());
  for (int k = 0; k < GroundPatches::kAskedBefore; ++k) EXPECT_FALSE(patches.levelsAt(1, 1)) << k;
  ASSERT_TRUE(patches.levelsAt(1, 1));
  EXPECT_EQ(patches.levelsAt(1, 1)->size(), 1u);
  EXPECT_FALSE(patches.levelsAt(5, 5));  // another tile
  EXPECT_FALSE(patches.levelsAt(1e9, 1));
  EXPECT_FALSE(patches.levelsAt(std::nan(""), 1));
}

TEST(GroundPatches, OfNothingAreNowhere) {
  const TriangleGrid none;
  const GroundPatches patches(none, none);
  EXPECT_FALSE(patches.levelsAt(0, 0));
  ASSERT_TRUE(patches.endingOver({Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1)}, 0, 1));
  EXPECT_TRUE(patches.endingOver({Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1)}, 0, 1)->empty());
}

// Every triangle of which something within the box ends between the heights, but for what stands
// upright and goes on.
void expectAllThatEnds(const TriangleGrid& all, const GroundPatches& patches,
                       const Eigen::AlignedBox2d& box, double low, double high) {
  for (int k = 0; k < 4 * (GroundPatches::kAskedBefore + 1); ++k)
    patches.endingOver(box, low, high);
  const auto found = patches.endingOver(box, low, high);
  ASSERT_TRUE(found);
  EXPECT_TRUE(std::is_sorted(found->begin(), found->end()));
  EXPECT_EQ(std::adjacent_find(found->begin(), found->end()), found->end());
  for (int t = 0; t < static_cast<int>(all.triangles().size()); ++t) {
    const Triangle3& corners = all.triangles()[t];
    const auto part = heightsWithin(corners, box);
    if (!part || part->high < low || part->high > high) continue;
    const double top = std::max({corners[0].z(), corners[1].z(), corners[2].z()});
    if (top > high && std::abs(upwardness(corners)) < GroundPatches::kUpright) continue;
    EXPECT_TRUE(std::binary_search(found->begin(), found->end(), t)) << t;
  }
}

TEST(GroundPatches, WhatEndsOverABoxIsAllAmongWhatTheyName) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const SceneGround ground(sceneOf(drawnThings(seed, 30)), 0.0);
    const GroundPatches patches(ground.surfaces(), ground.all());
    SampleStream random(seed, 2);
    for (int n = 0; n < 150; ++n) {
      const Eigen::Vector2d at(random.uniform(-4, 4), random.uniform(-4, 4));
      const Eigen::Vector2d size(random.uniform(0.0, 0.5), random.uniform(0.0, 0.5));
      const double low = random.uniform(-0.4, 0.5);
      expectAllThatEnds(ground.all(), patches, {at, at + size}, low,
                        low + random.uniform(0.0, 0.3));
    }
  }
}

// Crests and surfaces of a ground that is new against one that has been asked often.
TEST(GroundPatches, GroundAnswersTheSameHoweverOftenItIsAsked) {
  for (const char* name : {"living-room", "low-head-room-on-stairs", "ramp-10", "kerb"}) {
    const Scene scene = shippedScene(name);
    const SceneGround often(scene);
    const Eigen::AlignedBox2d box = often.extent();
    SampleStream warm(11, 0);
    for (int n = 0; n < 40000; ++n) {
      const Eigen::Vector2d p = pointBeside(warm, box);
      often.surface(p.x(), p.y(), 0.0, 1.0);
    }
    const SceneGround fresh(scene);
    SampleStream random(11, 1);
    for (int n = 0; n < 100; ++n) {
      const Eigen::Vector2d a = pointBeside(random, box);
      const Eigen::Vector2d b = a + random.uniform(0.1, 0.8) * drawnVector(random).head<2>();
      const double z = random.uniform(-0.1, 0.8);
      const double crest = fresh.crest(a, b, 0.05, z, z + 0.35);
      EXPECT_EQ(often.crest(a, b, 0.05, z, z + 0.35), crest) << n;
      for (const SceneGround* ground : {&often, &fresh})
        EXPECT_EQ(ground->risesAbove(a, b, 0.05, z, z + 0.35), crest > z) << n;
      const auto one = often.surface(a.x(), a.y(), z, 0.4),
                 other = fresh.surface(a.x(), a.y(), z, 0.4);
      ASSERT_EQ(one.has_value(), other.has_value()) << n;
      if (!one) continue;
      EXPECT_EQ(one->height, other->height) << n;
      EXPECT_EQ(one->normal, other->normal) << n;
    }
  }
}

// What is level all over a box is what is found at each of its points.
TEST(GroundPatches, ALevelOverABoxIsTheSurfaceAtEachOfItsPoints) {
  int level = 0;
  for (const char* name : {"living-room", "low-head-room-on-stairs", "ramp-10", "kerb"}) {
    const SceneGround ground(shippedScene(name));
    SampleStream random(13, 0);
    for (int n = 0; n < 20000; ++n) {
      const Eigen::Vector2d at = pointBeside(random, ground.extent());
      const Eigen::AlignedBox2d box(
          at, at + Eigen::Vector2d(random.uniform(0.0, 0.3), random.uniform(0.0, 0.3)));
      const double z = random.uniform(-0.1, 0.4), reach = random.uniform(0.0, 0.5);
      const auto over = ground.levelOver(box, z, reach);
      if (!over) continue;
      ++level;
      for (const double u : {0.0, random.uniform(), 1.0}) {
        const Eigen::Vector2d p =
            at + box.sizes().cwiseProduct(Eigen::Vector2d(u, random.uniform()));
        const auto point = ground.surface(p.x(), p.y(), z, reach);
        ASSERT_TRUE(point) << name << ' ' << n;
        EXPECT_EQ(point->height, *over) << name << ' ' << n;
        EXPECT_NEAR(point->normal.z(), 1.0, 1e-9) << name << ' ' << n;
      }
    }
  }
  EXPECT_GT(level, 10000);
}

// Of all that ends over a strip nothing is missed, and some of what is beside it is left out.
TEST(GroundPatches, WhatEndsOverAStripIsAmongWhatTheyNameOfItsBox) {
  const SceneGround ground(sceneOf(drawnThings(3, 60)), 0.0);
  const GroundPatches patches(ground.surfaces(), ground.all());
  SampleStream random(17, 0);
  size_t in_box = 0, in_strip = 0;
  for (int n = 0; n < 300; ++n) {
    const Eigen::Vector2d a(random.uniform(-4, 4), random.uniform(-4, 4));
    const PlanStrip strip({a, a + random.uniform(0.3, 1.5) * drawnVector(random).head<2>()}, 0.05);
    for (int k = 0; k < 9 * (GroundPatches::kAskedBefore + 1); ++k)
      patches.endingOver(strip.plan(), 0.0, 0.3);
    const auto near = patches.endingOver(strip.plan(), 0.0, 0.3);
    const auto over = patches.endingOver(strip, 0.0, 0.3);
    ASSERT_TRUE(near && over);
    EXPECT_TRUE(std::includes(near->begin(), near->end(), over->begin(), over->end()));
    for (const int t : *near) {
      const Triangle3 own = strip.local(ground.all().triangles()[t]);
      if (crestWithin(own, strip.box, 0.0, 0.3) < 0.0) continue;
      EXPECT_TRUE(std::binary_search(over->begin(), over->end(), t)) << n << ' ' << t;
      EXPECT_EQ(patches.anyEnding(strip, 0.0, 0.3, [&](int one) { return one == t; }), true);
    }
    EXPECT_EQ(patches.anyEnding(strip, 0.0, 0.3, [](int) { return false; }), false);
    in_box += near->size();
    in_strip += over->size();
  }
  EXPECT_LT(in_strip, in_box);
}

TEST(GroundPatches, WhatEndsFarAboveOrBelowTheGroundIsLeftToTheTriangles) {
  const SceneGround ground(
      sceneOf({floorSlab(), makeObject("lamp", Box{{0.5, 0.5, 0.1}}, {0, 0, 2.0})}), 0.0);
  const GroundPatches patches(ground.surfaces(), ground.all());
  const Eigen::AlignedBox2d box(Eigen::Vector2d(0.1, 0.1), Eigen::Vector2d(0.2, 0.2));
  for (int k = 0; k < 2 * GroundPatches::kAskedBefore; ++k) patches.endingOver(box, 0.1, 0.4);
  ASSERT_TRUE(patches.endingOver(box, 0.1, 0.4));
  EXPECT_TRUE(patches.endingOver(box, 0.1, 0.4)->empty());
  EXPECT_FALSE(patches.endingOver(box, 0.1, 2.1));
  EXPECT_FALSE(patches.endingOver(box, -3.0, 0.4));
}

TEST(GroundPatches, ThreadsThatAskAtOnceHearTheSame) {
  const SceneGround ground(drawnSlabs(9, false), 0.0);
  const GroundPatches patches(ground.surfaces(), ground.all());
  std::array<int, 4> level = {};
  std::vector<std::thread> threads;
  for (int& own : level) {
    threads.emplace_back([&] {
      SampleStream random(9, 3);
      for (int n = 0; n < 30000; ++n) {
        const Eigen::Vector2d p = pointBeside(random, ground.all().extent());
        const auto levels = patches.levelsAt(p.x(), p.y());
        if (!levels) continue;
        if (n % 50 == 0 && std::set<double>(levels->begin(), levels->end()) != heightsAt(ground, p))
          return;
        ++own;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const int own : level) EXPECT_GT(own, 10000);
}

}  // namespace
}  // namespace amble
