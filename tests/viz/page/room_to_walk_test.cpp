#include "viz/page/room_to_walk.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

using Eigen::Vector3d;

const ClearanceMap::Breadth kLegsAndArms = {{{0.25, 0.7, 0.2}, {0.7, 1.45, 0.33}}, 0.15};

// A floor with a wall and a chest on it.
struct RoomMap {
  Scene scene = sceneOf({floorSlab(), makeObject("wall", Box{{0.1, 3, 2.5}}, {0.6, 0, 1.25}),
                         makeObject("chest", Box{{0.7, 0.5, 0.8}}, {-1, 1, 0.4}),
                         makeObject("step", Box{{1.0, 4.0, 0.12}}, {2.5, 0, 0.06})});
  SceneGround ground{scene};
  ClearanceMap map{ground, {Eigen::Vector2d(-3, -3), Eigen::Vector2d(3, 3)}, kLegsAndArms};
};

int kindOfSpare(double spare) { return spare < 0.05 ? 0 : spare < 0.20 ? 1 : 2; }

// Strips that hold the middle of a place.
std::vector<size_t> stripsAt(const PageGround& ground, const Vector3d& p) {
  std::vector<size_t> found;
  for (size_t i = 0; i < ground.strips.size(); ++i) {
    const auto& [from, to] = ground.strips[i];
    if (p.x() > from.x() && p.x() < to.x() && std::abs(p.y() - from.y()) < 0.5 * ground.breadth &&
        std::abs(p.z() - from.z()) < 0.05)
      found.push_back(i);
  }
  return found;
}

TEST(RoomToWalk, EveryPlaceWithRoomIsInOneStripOfItsKindAndNoOtherIs) {
  const RoomMap room;
  const PageGround ground = roomToWalk(room.map);
  ASSERT_EQ(ground.strips.size(), ground.kind.size());
  int with_room = 0;
  for (int place = 0; place < room.map.size(); place += 3) {
    const std::vector<size_t> strips = stripsAt(ground, room.map.at(place));
    const double spare = room.map.spare(place);
    EXPECT_EQ(strips.size(), spare < 0.0 ? 0u : 1u) << room.map.at(place).transpose();
    if (spare < 0.0 || strips.empty()) continue;
    EXPECT_EQ(ground.kind[strips[0]], kindOfSpare(spare));
    ++with_room;
  }
  EXPECT_GT(with_room, 1000);
}

TEST(RoomToWalk, StripsCoverAsMuchGroundAsThereArePlacesWithRoom) {
  const RoomMap room;
  const PageGround ground = roomToWalk(room.map);
  std::array<double, 3> area{}, places{};
  for (size_t i = 0; i < ground.strips.size(); ++i)
    area[ground.kind[i]] += ground.breadth * (ground.strips[i].to - ground.strips[i].from).x();
  for (int place = 0; place < room.map.size(); ++place)
    if (room.map.spare(place) >= 0.0)
      places[kindOfSpare(room.map.spare(place))] += std::pow(room.map.cell(), 2);
  for (int kind = 0; kind < 3; ++kind) {
    EXPECT_NEAR(area[kind], places[kind], 1e-6) << kind;
    EXPECT_GT(area[kind], 0.0) << kind;
  }
}

TEST(RoomToWalk, AStripIsLevel) {
  const RoomMap room;
  const PageGround ground = roomToWalk(room.map);
  bool high = false;
  for (const auto& [from, to] : ground.strips) {
    EXPECT_NEAR(from.z(), to.z(), 0.01);
    EXPECT_EQ(from.y(), to.y());
    EXPECT_LT(from.x(), to.x());
    high = high || from.z() > 0.1;  // on the step
  }
  EXPECT_TRUE(high);
}

TEST(RoomToWalk, StripsAreFarFewerThanPlaces) {
  const RoomMap room;
  EXPECT_LT(roomToWalk(room.map).strips.size(), room.map.size() / 8);
}

TEST(ReachedGround, ReachesHalfAStripBeyondTheMiddlesOfItsEnds) {
  ReachedRegion reached;
  reached.breadth = 0.1;
  reached.strips = {{{0, 0, 0}, {1, 0, 0}}, {{2, 1, 0.5}, {2, 1, 0.5}}};
  const PageGround ground = reachedGround(reached);
  ASSERT_EQ(ground.strips.size(), 2u);
  EXPECT_EQ(ground.kind, (std::vector<std::uint8_t>{0, 0}));
  EXPECT_EQ(ground.strips[0].from, Vector3d(-0.05, 0, 0));
  EXPECT_EQ(ground.strips[0].to, Vector3d(1.05, 0, 0));
  EXPECT_NEAR(ground.strips[1].to.x() - ground.strips[1].from.x(), 0.1, 1e-12);  // one place
}

TEST(ReachedGround, OfNothingIsNothing) { EXPECT_TRUE(reachedGround({}).strips.empty()); }

}  // namespace
}  // namespace amble
