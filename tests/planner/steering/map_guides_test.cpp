// Ways over a map, and how far one gets on it, against floods and unions over all of its places.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <queue>

#include "base/union_find.h"
#include "planner/steering/reached_region.h"
#include "planner/steering/way_finder.h"
#include "tests/environments/random_scenes.h"

namespace amble {
namespace {

constexpr double kLeastRoom = -0.06;  // by which a way still leads [m]

// A room of 9 x 9 m full of things, and places with room in it.
struct DrawnMap {
  explicit DrawnMap(std::uint64_t seed, int things = 60)
      : scene(sceneOf(drawnThings(seed, things))), random(seed, 7) {}

  int roomyPlace() {
    for (;;) {
      const int place = random.below(map->size());
      if (map->spare(place) > 0.1) return place;
    }
  }
  template <typename Visit>
  void eachJoint(Visit visit) const {
    for (int place = 0; place < map->size(); ++place) {
      for (const auto& [dx, dy] : {std::pair(1, 0), {0, 1}, {1, 1}, {1, -1}}) {
        const int other = map->beside(place, dx, dy);
        if (other >= 0) visit(place, other);
      }
    }
  }
  // Sets of places with at least so much room that are beside one another.
  UnionFind joinedWith(double room) const {
    UnionFind sets(map->size());
    eachJoint([&](int a, int b) {
      if (map->spare(a) >= room && map->spare(b) >= room) sets.join(a, b);
    });
    return sets;
  }
  // Room of the narrowest place of the widest way: places are joined from the roomiest on.
  double bottleneck(int from, int to) const {
    std::vector<int> order(map->size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return map->spare(a) > map->spare(b); });
    UnionFind sets(map->size());
    std::vector<bool> in(map->size(), false);
    for (const int place : order) {
      in[place] = true;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const int other = dx == 0 && dy == 0 ? -1 : map->beside(place, dx, dy);
          if (other >= 0 && in[other]) sets.join(place, other);
        }
      }
      if (in[from] && in[to] && sets.find(from) == sets.find(to)) return map->spare(place);
    }
    return -HUGE_VAL;
  }

  Scene scene;
  SceneGround ground{scene};
  std::shared_ptr<const ClearanceMap> map = std::make_shared<const ClearanceMap>(
      ground, Eigen::AlignedBox2d(Eigen::Vector2d(-4.5, -4.5), Eigen::Vector2d(4.5, 4.5)),
      ClearanceMap::Breadth{{{0.25, 1.75, 0.3}}, 0.15});
  SampleStream random;
};

TEST(MapGuides, AWayIsThereJustWhereRoomyPlacesJoinItsEnds) {
  int there = 0, none = 0;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    DrawnMap drawn(seed, 90);
    UnionFind sets = drawn.joinedWith(kLeastRoom);
    for (int n = 0; n < 12; ++n) {
      const int from = drawn.roomyPlace(), to = drawn.roomyPlace();
      if (from == to) continue;
      WayFinder finder(drawn.map, drawn.map->at(from), drawn.map->at(to), 0.6);
      const bool joins = sets.find(from) == sets.find(to);
      (joins ? there : none) += 1;
      EXPECT_EQ(finder.next().has_value(), joins) << seed << " " << n;
    }
  }
  EXPECT_GT(there, 5);
  EXPECT_GT(none, 2);
}

TEST(MapGuides, EveryStanceOfAWayIsAPlaceWithRoomHeadedFromTheOneBefore) {
  int stances = 0;
  for (const std::uint64_t seed : {5, 6, 7}) {
    DrawnMap drawn(seed);
    for (int n = 0; n < 12; ++n) {
      const Eigen::Vector3d from = drawn.map->at(drawn.roomyPlace()),
                            to = drawn.map->at(drawn.roomyPlace());
      const auto way = WayFinder(drawn.map, from, to, 0.6).next();
      if (!way) continue;
      Eigen::Vector3d before = from;
      for (const Stance& stance : *way) {
        ++stances;
        EXPECT_TRUE(stance.standing);
        const int place = drawn.map->placeAt(stance.position);
        EXPECT_LT((drawn.map->at(place) - stance.position).norm(), 1e-6);
        EXPECT_GE(drawn.map->spare(place), kLeastRoom);
        const Eigen::Vector3d along = stance.position - before;
        EXPECT_NEAR(stance.heading, std::atan2(along.y(), along.x()), 1e-12);
        before = stance.position;
      }
    }
  }
  EXPECT_GT(stances, 10);
}

TEST(MapGuides, TheNarrowestPlaceIsTheBottleneckOfAllWays) {
  int narrow = 0;
  for (const std::uint64_t seed : {8, 9, 10}) {
    DrawnMap drawn(seed, 80);
    for (int n = 0; n < 8; ++n) {
      const int from = drawn.roomyPlace(), to = drawn.roomyPlace();
      const Eigen::Vector3d a = drawn.map->at(from), b = drawn.map->at(to);
      const auto found = WayFinder(drawn.map, a, b, 0.6).narrowest();
      const double least = drawn.bottleneck(from, to);
      if (!found) {
        // Room everywhere, but beside its ends, which are as they are.
        const bool wide = least > 0.04 || least == -HUGE_VAL;
        EXPECT_TRUE(wide || (a - b).norm() < 3.0) << least;
        continue;
      }
      ++narrow;
      const double room = drawn.map->spare(drawn.map->placeAt(found->at));
      EXPECT_GE(room, least - 1e-6);
      EXPECT_LE(room, 0.04 + 1e-6);
      EXPECT_EQ(found->may_pass, room >= kLeastRoom);
      for (const Eigen::Vector3d& end : {a, b})
        EXPECT_GE((found->at - end).head<2>().norm(), 0.5 - 1e-9);
    }
  }
  EXPECT_GT(narrow, 2);
}

TEST(MapGuides, AskedAgainAWayIsTheSameUntilAPlaceIsAvoided) {
  int changed = 0, asked = 0;
  for (const std::uint64_t seed : {11, 12}) {
    DrawnMap drawn(seed);
    for (int n = 0; n < 8; ++n) {
      const Eigen::Vector3d from = drawn.map->at(drawn.roomyPlace()),
                            to = drawn.map->at(drawn.roomyPlace());
      WayFinder finder(drawn.map, from, to, 0.6);
      const auto first = finder.next(), second = finder.next();
      ASSERT_EQ(first.has_value(), second.has_value());
      if (!first || first->empty()) continue;
      ASSERT_EQ(first->size(), second->size());
      for (size_t i = 0; i < first->size(); ++i)
        EXPECT_EQ((*first)[i].position, (*second)[i].position);
      ++asked;
      for (int k = 0; k < 3; ++k) finder.avoid((*first)[0].position);
      const auto other = finder.next();
      ASSERT_TRUE(other);  // places that are avoided count more, and are not shut
      changed += other->size() != first->size() || (*other)[0].position != (*first)[0].position;
    }
  }
  EXPECT_GT(asked, 3);
  EXPECT_GT(changed, asked / 2);
}

// Strips cover the places with room that are joined to the start, and no others but by breadth.
TEST(MapGuides, WhatIsReachedIsWhatAFloodReaches) {
  int regions = 0;
  for (const std::uint64_t seed : {13, 14, 15, 16}) {
    DrawnMap drawn(seed, 110);
    for (int n = 0; n < 10; ++n) {
      const int from = drawn.roomyPlace(), to = drawn.roomyPlace();
      const Eigen::Vector3d a = drawn.map->at(from), b = drawn.map->at(to);
      UnionFind sets = drawn.joinedWith(0.0);
      if ((a - b).norm() < 1.5 || sets.find(from) == sets.find(to)) continue;
      const auto region = reachedRegion(*drawn.map, a, b, {50, 50, 0});
      ASSERT_TRUE(region);
      ++regions;
      const auto holds = [&](const Eigen::Vector3d& p) {
        const double half = 0.5 * region->breadth + 1e-6;
        return std::any_of(region->strips.begin(), region->strips.end(), [&](const auto& strip) {
          return std::abs(p.y() - strip.from.y()) <= half && p.x() >= strip.from.x() - half &&
                 p.x() <= strip.to.x() + half;
        });
      };
      EXPECT_TRUE(holds(a));
      EXPECT_FALSE(holds(b));
      EXPECT_TRUE(holds(region->near));
      EXPECT_FALSE(holds(region->far));
      for (int place = 0; place < drawn.map->size(); place += 97) {
        if (!holds(drawn.map->at(place)) || drawn.map->spare(place) < 0.0) continue;
        if ((drawn.map->at(place) - a).norm() < 0.6) continue;
        EXPECT_EQ(sets.find(place), sets.find(from));
      }
    }
  }
  EXPECT_GT(regions, 2);
}

}  // namespace
}  // namespace amble
