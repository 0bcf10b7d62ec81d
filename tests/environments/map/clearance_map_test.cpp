#include "environments/map/clearance_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "base/sample_stream.h"
#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

constexpr double kCell = ClearanceMap::kCell;
// Legs, arms and head of somebody.
const ClearanceMap::Breadth kBody = {{{0.25, 0.7, 0.2}, {0.7, 1.45, 0.33}, {1.45, 1.75, 0.1}},
                                     0.15};
const Eigen::AlignedBox2d kAround{Eigen::Vector2d(-5, -5), Eigen::Vector2d(5, 5)};

struct Mapped {
  explicit Mapped(std::vector<SceneObject> objects, const Eigen::AlignedBox2d& bounds = kAround)
      : scene(sceneOf(std::move(objects))), ground(scene), map(ground, bounds, kBody) {}

  double spareAt(double x, double y, double z = 0.0) const {
    const int place = map.placeAt({x, y, z});
    return place < 0 ? -HUGE_VAL : map.spare(place);
  }

  Scene scene;
  SceneGround ground;
  ClearanceMap map;
};

SceneObject wall(double x, double y0, double y1) {
  return makeObject("wall", Box{{0.1, y1 - y0, 2.5}}, {x, 0.5 * (y0 + y1), 1.25});
}

TEST(ClearanceMap, InTheMiddleOfACorridorIsHalfItsBreadthLessTheBodys) {
  for (const double breadth : {0.7, 0.9, 1.2}) {
    const Mapped corridor(
        {floorSlab(), wall(-0.5 * breadth - 0.05, -4, 4), wall(0.5 * breadth + 0.05, -4, 4)});
    EXPECT_NEAR(corridor.spareAt(0, 0), 0.5 * breadth - 0.33, 1.6 * kCell) << breadth;
  }
}

TEST(ClearanceMap, WhatIsAtOtherHeightsThanAPartIsNotInItsWay) {
  // A bench beside legs, a shelf beside arms, and a lamp over all.
  const Mapped bench({floorSlab(), makeObject("bench", Box{{0.4, 2, 0.45}}, {0.7, 0, 0.225})});
  EXPECT_NEAR(bench.spareAt(0, 0), 0.5 - 0.2, kCell);
  const Mapped shelf({floorSlab(), makeObject("shelf", Box{{0.4, 2, 0.1}}, {0.7, 0, 1.2})});
  EXPECT_NEAR(shelf.spareAt(0, 0), 0.5 - 0.33, kCell);
  const Mapped lamp({floorSlab(), makeObject("lamp", Box{{0.4, 2, 0.1}}, {0, 0, 2.0})});
  EXPECT_NEAR(lamp.spareAt(0, 0), ClearanceMap::kFarthest, 1e-6);
}

TEST(ClearanceMap, WhatIsSteppedOverIsNotInTheWay) {
  const Mapped log(
      {floorSlab(), makeObject("log", Box{{0.2, 2, 0.2}}, {0, 0, 0.1}, Role::kObstacle)});
  EXPECT_NEAR(log.spareAt(0, 0), ClearanceMap::kFarthest, 1e-6);
}

// From place to place it changes by no more than the way between them, and what it is measured to.
TEST(ClearanceMap, ChangesNoFasterThanOneWalks) {
  const Mapped room({floorSlab(), wall(-1, -2, 1), wall(1.5, -1, 3),
                     makeObject("table", Box{{1.0, 0.8, 0.75}}, {0.4, -1.5, 0.375})});
  int compared = 0;
  for (int place = 0; place < room.map.size(); ++place) {
    for (const auto& [dx, dy] : {std::pair(1, 0), {0, 1}, {1, 1}}) {
      const int other = room.map.beside(place, dx, dy);
      if (other < 0) continue;
      ++compared;
      const double way = kCell * std::hypot(dx, dy);
      ASSERT_LE(std::abs(room.map.spare(place) - room.map.spare(other)), way + 0.5 * kCell + 1e-4)
          << room.map.at(place).transpose();
    }
  }
  EXPECT_GT(compared, 10000);
}

// By brute force: the exact distances in plan from a place to boxes that reach through all bands.
TEST(ClearanceMap, IsTheDistanceToTheNearestThingLessTheBody) {
  SampleStream stream(5, 0);
  std::vector<SceneObject> objects = {floorSlab()};
  std::vector<Eigen::AlignedBox2d> boxes;
  for (int i = 0; i < 12; ++i) {
    const Eigen::Vector2d at(stream.uniform(-4, 4), stream.uniform(-4, 4));
    const Eigen::Vector2d half(stream.uniform(0.05, 0.5), stream.uniform(0.05, 0.5));
    boxes.emplace_back(at - half, at + half);
    objects.push_back(makeObject("box", Box{{2 * half.x(), 2 * half.y(), 2}}, {at.x(), at.y(), 1}));
  }
  const Mapped room(objects);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d p(stream.uniform(-3.9, 3.9), stream.uniform(-3.9, 3.9));
    double distance = ClearanceMap::kFarthest + 0.33;
    for (const auto& box : boxes) distance = std::min(distance, box.exteriorDistance(p));
    const int place = room.map.placeAt({p.x(), p.y(), 0});
    if (distance < kCell || place < 0) continue;
    const double expected = std::min(distance - 0.33, ClearanceMap::kFarthest);
    if (expected < 0.4) {
      EXPECT_NEAR(room.map.spare(place), expected, 1.6 * kCell) << p.transpose();
    }
  }
}

TEST(ClearanceMap, FloorsOverOneAnotherHaveRoomsOfTheirOwn) {
  const Mapped two({floorSlab(), makeObject("deck", Box{{8, 8, 0.1}}, {0, 0, 2.95}),
                    makeObject("stove", Box{{1, 1, 1}}, {0, 0, 0.5})});
  EXPECT_LT(two.spareAt(0.6, 0, 0.0), 0.0);
  EXPECT_NEAR(two.spareAt(0.6, 0, 3.0), ClearanceMap::kFarthest, 1e-6);
}

TEST(ClearanceMap, FeetStayOnTheGround) {
  const Mapped pier({makeObject("pier", Box{{8, 1, 0.2}}, {0, 0, -0.1})});
  EXPECT_NEAR(pier.spareAt(0, 0), 0.5 - 0.15, 1.5 * kCell);
  EXPECT_LT(pier.spareAt(0, 0.45), 0.0);
  EXPECT_EQ(pier.map.placeAt({0, 2, 0}), -1);
}

// As many as there may be, each as broad as the band that they are cut from.
TEST(ClearanceMap, ManyThinBandsAreAsOneAndMoreAreRefused) {
  const Scene scene = sceneOf(
      {floorSlab(), wall(-0.6, -4, 4), makeObject("shelf", Box{{0.4, 2, 0.1}}, {0.7, 0, 1.2})});
  const SceneGround ground(scene);
  const auto cutInto = [](int count) {
    ClearanceMap::Breadth body{{}, 0.15};
    for (int i = 0; i < count; ++i)
      body.bands.push_back({0.25 + 1.5 * i / count, 0.25 + 1.5 * (i + 1) / count, 0.33});
    return body;
  };
  const ClearanceMap one(ground, kAround, cutInto(1)),
      many(ground, kAround, cutInto(ClearanceMap::kMostBands));
  ASSERT_EQ(one.size(), many.size());
  for (int place = 0; place < one.size(); ++place)
    EXPECT_NEAR(one.spare(place), many.spare(place), 1e-3) << one.at(place).transpose();
  EXPECT_THROW(ClearanceMap(ground, kAround, cutInto(ClearanceMap::kMostBands + 1)),
               std::invalid_argument);
}

TEST(ClearanceMap, IsEmptyWhereItIsStopped) {
  const Scene scene = sceneOf({floorSlab()});
  const SceneGround ground(scene);
  EXPECT_EQ(ClearanceMap(ground, kAround, kBody, [] { return true; }).size(), 0);
}

TEST(ClearanceMap, IsEmptyBesideTheGround) {
  const Mapped nothing({floorSlab()}, {Eigen::Vector2d(50, 50), Eigen::Vector2d(60, 60)});
  EXPECT_EQ(nothing.map.size(), 0);
  EXPECT_EQ(nothing.map.placeAt({55, 55, 0}), -1);
}

}  // namespace
}  // namespace amble
