#include "planner/steering/reached_region.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

const ClearanceMap::Breadth kBreadth = {{{0.25, 1.75, 0.3}}, 0.15};
const Eigen::Vector3d kWestEnd(-3, -2, 0), kEastEnd(3, -2, 0), kNowhere(0, 50, 0);

// A room of 8 x 6 m about the origin, with a wall along x = 0 that has doors.
std::vector<SceneObject> roomWithDoors(const std::vector<std::pair<double, double>>& doors) {
  std::vector<SceneObject> objects = {makeObject("floor", Box{{8, 6, 0.1}}, {0, 0, -0.05})};
  double from = -3.0;
  const auto addWall = [&](double low, double high) {
    objects.push_back(
        makeObject("wall", Box{{0.1, high - low, 2.5}}, {0, 0.5 * (low + high), 1.25}));
  };
  for (const auto& [low, high] : doors) {
    addWall(from, low);
    from = high;
  }
  addWall(from, 3.0);
  return objects;
}

struct Mapped {
  explicit Mapped(const std::vector<SceneObject>& objects) : scene(sceneOf(objects)) {}
  std::optional<ReachedRegion> reached(const Eigen::Vector3d& stopped_at = kNowhere) const {
    return reachedRegion(map, kWestEnd, kEastEnd, stopped_at);
  }
  Scene scene;
  SceneGround ground{scene};
  ClearanceMap map{ground, {Eigen::Vector2d(-4, -3), Eigen::Vector2d(4, 3)}, kBreadth};
};

bool holds(const ReachedRegion& region, double x, double y) {
  const double half = 0.5 * region.breadth;
  for (const ReachedRegion::Strip& strip : region.strips) {
    if (x >= strip.from.x() - half && x <= strip.to.x() + half &&
        std::abs(y - strip.from.y()) <= half)
      return true;
  }
  return false;
}

TEST(ReachedRegion, EndsAtAWallThatHasNoDoor) {
  const auto region = Mapped(roomWithDoors({})).reached();
  ASSERT_TRUE(region.has_value());
  EXPECT_TRUE(holds(*region, -3, -2) && holds(*region, -3.5, 2.5));
  for (const ReachedRegion::Strip& strip : region->strips) EXPECT_LT(strip.to.x(), -0.3);
  EXPECT_LT(region->near.x(), 0);
  EXPECT_GT(region->far.x(), 0);
  // As near as the body comes to either face, to a cell.
  EXPECT_NEAR((region->far - region->near).head<2>().norm(), 0.1 + 2 * 0.3, 0.15);
}

TEST(ReachedRegion, ComesNearestAtAGapThatIsTooNarrow) {
  const auto region = Mapped(roomWithDoors({{1.0, 1.4}})).reached();
  ASSERT_TRUE(region.has_value());
  EXPECT_FALSE(holds(*region, 3, -2));
  EXPECT_NEAR(region->near.y(), 1.2, 0.15);
  EXPECT_NEAR(region->far.y(), 1.2, 0.15);
}

// All are shut that are no wider, else one would get round the one that is named.
TEST(ReachedRegion, StopsAtEveryPlaceWithHardlyRoom) {
  const auto region = Mapped(roomWithDoors({{-1.6, -1.0}, {0.5, 1.1}})).reached();
  ASSERT_TRUE(region.has_value());
  EXPECT_FALSE(holds(*region, 3, -2));
  EXPECT_FALSE(holds(*region, 3, 2));
}

TEST(ReachedRegion, WhereThereIsRoomItEndsWhereAWalkWasStopped) {
  const Mapped room(roomWithDoors({{0.5, 1.5}}));
  EXPECT_FALSE(room.reached().has_value());  // stopped elsewhere, the goal is reached
  const auto region = room.reached(Eigen::Vector3d(0, 1, 1.2));
  ASSERT_TRUE(region.has_value());
  EXPECT_TRUE(holds(*region, -1, 1));
  EXPECT_FALSE(holds(*region, 1, 1));
  EXPECT_LT(region->near.x(), 0);
  EXPECT_GT(region->far.x(), 0);
}

TEST(ReachedRegion, OfAStartOffTheMapThereIsNone) {
  const Mapped room(roomWithDoors({}));
  EXPECT_FALSE(reachedRegion(room.map, {30, 0, 0}, kEastEnd, kNowhere).has_value());
}

// Of the places of the map those that are joined to the start, by hand, are in one strip each.
TEST(ReachedRegion, StripsHoldEveryPlaceOnce) {
  std::vector<SceneObject> objects = roomWithDoors({});
  objects.push_back(makeObject("table", Box{{0.8, 0.6, 0.7}}, {-2, 0.5, 0.35}));
  objects.push_back(makeObject("post", Box{{0.1, 0.1, 2.0}}, {-1.2, -1.5, 1.0}));
  const Mapped room(objects);
  const auto region = room.reached();
  ASSERT_TRUE(region.has_value());
  std::multiset<std::pair<int, int>> covered;
  const auto key = [&](double x, double y) {
    return std::pair<int, int>(std::lround(x / region->breadth - 0.5),
                               std::lround(y / region->breadth - 0.5));
  };
  for (const ReachedRegion::Strip& strip : region->strips) {
    EXPECT_EQ(strip.from.y(), strip.to.y());
    const int count = std::lround((strip.to.x() - strip.from.x()) / region->breadth);
    for (int i = 0; i <= count; ++i)
      covered.insert(key(strip.from.x() + i * region->breadth, strip.from.y()));
  }
  int inside = 0;
  for (int place = 0; place < room.map.size(); ++place) {
    const Eigen::Vector3d p = room.map.at(place);
    const bool is_in = p.x() < 0 && room.map.spare(place) >= 0.0;
    inside += is_in;
    EXPECT_EQ(covered.count(key(p.x(), p.y())), is_in ? 1u : 0u) << p.transpose();
  }
  EXPECT_EQ(static_cast<int>(covered.size()), inside);
}

TEST(ReachedRegion, StripsLieOnTheGroundThatRises) {
  std::vector<SceneObject> objects = {makeObject("floor", Box{{1.1, 6, 0.1}}, {-3.45, 0, -0.05})};
  SceneObject ramp = makeObject("ramp", Box{{4, 6, 0.1}}, {-1, 0, 0.28});
  ramp.X_WO.linear() = Eigen::AngleAxisd(-0.17, Eigen::Vector3d::UnitY()).toRotationMatrix();
  objects.push_back(ramp);
  const Mapped room(objects);
  const auto region = room.reached();
  ASSERT_TRUE(region.has_value());
  double highest = 0.0;
  for (const ReachedRegion::Strip& strip : region->strips) {
    for (const double t : {0.0, 0.3, 0.5, 0.9, 1.0}) {
      const Eigen::Vector3d p = strip.from + t * (strip.to - strip.from);
      const auto ground = room.ground.height(p.x(), p.y(), p.z(), 0.1);
      ASSERT_TRUE(ground.has_value()) << p.transpose();
      EXPECT_NEAR(p.z(), *ground, 0.05) << p.transpose();
      highest = std::max(highest, p.z());
    }
  }
  EXPECT_GT(highest, 0.3);
}

}  // namespace
}  // namespace amble
