#include "planner/steering/way_finder.h"

#include <gtest/gtest.h>

#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

const ClearanceMap::Breadth kBody = {{{0.25, 1.75, 0.3}}, 0.15};
constexpr double kShortest = 0.6;

// A room of 8 x 6 m about the origin, with a wall along x = 0 that doors lead through.
struct Room {
  explicit Room(const std::vector<std::pair<double, double>>& doors) {
    std::vector<SceneObject> objects = {makeObject("floor", Box{{8, 6, 0.1}}, {0, 0, -0.05})};
    double from = -3.0;
    for (const auto& [low, high] : doors) {
      addWall(objects, from, low);
      from = high;
    }
    addWall(objects, from, 3.0);
    scene = sceneOf(objects);
    ground = std::make_unique<SceneGround>(scene);
    const Eigen::AlignedBox2d bounds(Eigen::Vector2d(-4, -3), Eigen::Vector2d(4, 3));
    map = std::make_shared<const ClearanceMap>(*ground, bounds, kBody);
  }
  static void addWall(std::vector<SceneObject>& objects, double low, double high) {
    objects.push_back(
        makeObject("wall", Box{{0.1, high - low, 2.5}}, {0, 0.5 * (low + high), 1.25}));
  }
  WayFinder from(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    return {map, from, to, kShortest};
  }
  // Where the way through these places crosses the wall.
  static double crossing(std::vector<Stance> way, const Eigen::Vector3d& to) {
    Stance last;
    last.position = to;
    way.push_back(last);
    Eigen::Vector3d before = kWest;
    for (const Stance& stance : way) {
      if (stance.position.x() > 0.0)
        return before.y() + (stance.position.y() - before.y()) * -before.x() /
                                (stance.position.x() - before.x());
      before = stance.position;
    }
    return HUGE_VAL;
  }
  static const Eigen::Vector3d kWest, kEast;

  Scene scene;
  std::unique_ptr<SceneGround> ground;
  std::shared_ptr<const ClearanceMap> map;
};
const Eigen::Vector3d Room::kWest(-3, -2, 0), Room::kEast(3, -2, 0);

TEST(WayFinder, LeadsThroughTheDoorByPlacesThatSeeOneAnother) {
  const Room room({{1.0, 2.0}});
  WayFinder finder = room.from(Room::kWest, Room::kEast);
  const auto way = finder.next();
  ASSERT_TRUE(way.has_value());
  ASSERT_GE(way->size(), 1u);
  EXPECT_LE(way->size(), 4u);
  const double crossing = Room::crossing(*way, Room::kEast);
  EXPECT_GT(crossing, 1.0 + 0.3);
  EXPECT_LT(crossing, 2.0 - 0.3);
  for (const Stance& stance : *way) {
    EXPECT_TRUE(stance.standing);
    EXPECT_GT(room.map->spare(room.map->placeAt(stance.position)), 0.0);
  }
}

TEST(WayFinder, LeadsStraightWhereNothingIsBetween) {
  const Room room({{-3.0, 3.0}});
  const auto way = room.from(Room::kWest, Room::kEast).next();
  ASSERT_TRUE(way.has_value());
  EXPECT_TRUE(way->empty());
}

TEST(WayFinder, WhereSteeringRefusedTheNextWayIsElsewhere) {
  const Room room({{-2.3, -1.3}, {1.0, 2.0}});
  WayFinder finder = room.from(Room::kWest, Room::kEast);
  double crossing = Room::crossing(*finder.next(), Room::kEast);
  EXPECT_LT(crossing, 0.0);
  for (int i = 0; i < 10 && crossing < 0.0; ++i) {
    finder.avoid({0, crossing, 0});
    crossing = Room::crossing(*finder.next(), Room::kEast);
  }
  EXPECT_GT(crossing, 0.0);
}

// Nearer to a wall than its feet may be: a body stands there that does not walk so near.
TEST(WayFinder, WhoStandsNearAWallWalksAwayFromItAndIsNoNarrowPlace) {
  const Room room({{1.0, 2.0}});
  const Eigen::Vector3d at_the_wall(-0.3, -2, 0);
  ASSERT_LT(room.map->spare(room.map->placeAt(at_the_wall)), -0.06);
  WayFinder finder = room.from(at_the_wall, Room::kEast);
  const auto way = finder.next();
  ASSERT_TRUE(way.has_value());
  EXPECT_GE(way->size(), 1u);
  EXPECT_FALSE(finder.narrowest().has_value());
}

TEST(WayFinder, WhoIsStoppedKnowsNoWay) {
  const Room room({{1.0, 2.0}});
  WayFinder finder(room.map, Room::kWest, Room::kEast, kShortest, [] { return true; });
  EXPECT_FALSE(finder.next().has_value());
  EXPECT_FALSE(finder.narrowest().has_value());
}

TEST(WayFinder, KnowsNoWayWhereTheWallIsWhole) {
  EXPECT_FALSE(Room({}).from(Room::kWest, Room::kEast).next().has_value());
}

TEST(WayFinder, ThroughWhatIsFarTooNarrowThereIsNoWayAndThatIsTheNarrowestPlace) {
  const Room room({{1.0, 1.35}});  // 0.25 m less than the body's breadth
  WayFinder finder = room.from(Room::kWest, Room::kEast);
  EXPECT_FALSE(finder.next().has_value());
  const auto narrowest = finder.narrowest();
  ASSERT_TRUE(narrowest.has_value());
  EXPECT_NEAR(narrowest->at.x(), 0.0, 0.15);
  EXPECT_NEAR(narrowest->at.y(), 1.175, 0.1);
  EXPECT_NEAR(narrowest->heading, 0.0, 0.3);  // eastwards, through the wall
  EXPECT_FALSE(narrowest->may_pass);
}

TEST(WayFinder, WhatMissesLittleMayBePassed) {
  const auto narrowest = Room({{1.0, 1.62}}).from(Room::kWest, Room::kEast).narrowest();
  ASSERT_TRUE(narrowest.has_value());
  EXPECT_TRUE(narrowest->may_pass);
}

TEST(WayFinder, BlockedIsAPlaceOnlyWhereNoneHasRoomBesideWhatIsInTheWay) {
  const auto whole = Room({}).from(Room::kWest, Room::kEast).narrowest();
  ASSERT_TRUE(whole.has_value());
  EXPECT_TRUE(whole->blocked);
  EXPECT_FALSE(whole->on_steps);
  EXPECT_FALSE(whole->may_pass);
  for (const double gap : {0.2, 0.35, 0.62}) {
    const auto beside = Room({{1.0, 1.0 + gap}}).from(Room::kWest, Room::kEast).narrowest();
    ASSERT_TRUE(beside.has_value()) << gap;
    EXPECT_FALSE(beside->blocked) << gap;
  }
}

TEST(WayFinder, WhatLiesRightAcrossIsCrossedWhereOneComesToIt) {
  const Room room({});
  for (const double y : {-2.0, -0.5, 1.3}) {
    const auto across = room.from({-3, y, 0}, {3, y, 0}).narrowest();
    ASSERT_TRUE(across.has_value());
    EXPECT_NEAR(across->at.x(), 0.0, 0.3);
    EXPECT_NEAR(across->at.y(), y, 0.1);
    EXPECT_NEAR(across->heading, 0.0, 1e-6);
  }
}

TEST(WayFinder, UnderABeamAcrossStairsAPlaceIsBlockedOnSteps) {
  std::vector<SceneObject> objects = stairs(8, 0.17, 0.29);
  objects.push_back(makeObject("floor", Box{{3, 2, 0.1}}, {-1.5, 0, -0.05}));
  objects.push_back(makeObject("landing", Box{{3, 2, 1.36}}, {8 * 0.29 + 1.5, 0, 0.68}));
  objects.push_back(makeObject("beam", Box{{0.2, 3, 0.5}}, {1.2, 0, 2.5}, Role::kObstacle));
  const Scene scene = sceneOf(objects);
  const SceneGround ground(scene);
  const Eigen::AlignedBox2d bounds(Eigen::Vector2d(-3, -1), Eigen::Vector2d(5.3, 1));
  const auto map = std::make_shared<const ClearanceMap>(ground, bounds, kBody);
  const auto narrowest = WayFinder(map, {-2, 0, 0}, {4.5, 0, 1.36}, kShortest).narrowest();
  ASSERT_TRUE(narrowest.has_value());
  EXPECT_NEAR(narrowest->at.x(), 1.2, 0.5);
  EXPECT_TRUE(narrowest->blocked);
  EXPECT_TRUE(narrowest->on_steps);
}

TEST(WayFinder, WithRoomEverywhereNoPlaceIsNarrow) {
  EXPECT_FALSE(Room({{0.0, 1.5}}).from(Room::kWest, Room::kEast).narrowest().has_value());
}

}  // namespace
}  // namespace amble
