// What holds of the map of any room: it moves and turns with the room, grows with it, and is the
// least over the body's bands.
#include <gtest/gtest.h>

#include <cmath>

#include "environments/map/clearance_map.h"
#include "tests/environments/random_scenes.h"

namespace amble {
namespace {

const ClearanceMap::Breadth kWalker = {{{0.25, 0.7, 0.2}, {0.7, 1.45, 0.33}, {1.45, 1.75, 0.1}},
                                       0.15};
// Distances that spread from cell to cell may miss the nearest obstacle by less than this [m].
constexpr double kSpreading = ClearanceMap::kCell;
const Eigen::AlignedBox2d kRoomOfMap{Eigen::Vector2d(-5, -5), Eigen::Vector2d(5, 5)};

struct DrawnRoom {
  explicit DrawnRoom(std::vector<SceneObject> objects, const ClearanceMap::Breadth& body = kWalker,
                     const Eigen::AlignedBox2d& bounds = kRoomOfMap)
      : scene(sceneOf(std::move(objects))), ground(scene), map(ground, bounds, body) {}

  /// Of the place over whose cell p lies; none where there is no such.
  std::optional<double> spareAt(const Eigen::Vector3d& p) const {
    const int place = map.placeAt(p);
    if (place < 0 || (map.at(place) - p).norm() > 1e-3) return std::nullopt;
    return map.spare(place);
  }

  Scene scene;
  SceneGround ground;
  ClearanceMap map;
};

// Both maps have a place at each other's, with as much room.
void expectSameRoom(const DrawnRoom& a, const DrawnRoom& b, const Eigen::Isometry3d& X_BA,
                    double tolerance) {
  ASSERT_EQ(a.map.size(), b.map.size());
  for (int place = 0; place < a.map.size(); ++place) {
    const auto there = b.spareAt(X_BA * a.map.at(place));
    ASSERT_TRUE(there) << a.map.at(place).transpose();
    ASSERT_NEAR(*there, a.map.spare(place), tolerance) << a.map.at(place).transpose();
  }
}

TEST(ClearanceMapLaws, MovesWithTheRoom) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const auto objects = drawnThings(seed, 25);
    const DrawnRoom here(objects);
    const Eigen::Vector3d by(37.35, -12.2, 4.0);
    const Eigen::Isometry3d X = turnedAndMoved(0.0, by);
    Eigen::AlignedBox2d bounds = kRoomOfMap;
    bounds.translate(by.head<2>());
    expectSameRoom(here, DrawnRoom(movedObjects(objects, X), kWalker, bounds), X, 1e-5);
  }
}

// Distances spread over the cells in another order then; they are of the same obstacles.
TEST(ClearanceMapLaws, TurnsWithTheRoom) {
  for (const std::uint64_t seed : {4, 5, 6}) {
    const auto objects = drawnThings(seed, 25);
    const DrawnRoom here(objects);
    for (const int quarters : {1, 2, 3}) {
      const Eigen::Isometry3d X = turnedAndMoved(0.5 * kPi * quarters, {0, 0, 0});
      expectSameRoom(here, DrawnRoom(movedObjects(objects, X)), X, kSpreading);
    }
  }
}

TEST(ClearanceMapLaws, OfAMirroredRoomIsMirrored) {
  const auto objects = drawnThings(7, 25);
  const DrawnRoom here(objects), mirror(mirroredObjects(objects));
  ASSERT_EQ(here.map.size(), mirror.map.size());
  for (int place = 0; place < here.map.size(); ++place) {
    const auto there = mirror.spareAt(mirroredPoint(here.map.at(place)));
    ASSERT_TRUE(there);
    // Round things are meshes there, smaller by their chords.
    ASSERT_NEAR(*there, here.map.spare(place), 1.5 * ClearanceMap::kCell);
  }
}

TEST(ClearanceMapLaws, DoesNotDependOnTheOrderOfThings) {
  auto objects = drawnThings(8, 25);
  const DrawnRoom one(objects);
  std::reverse(objects.begin(), objects.end());
  expectSameRoom(one, DrawnRoom(objects), Eigen::Isometry3d::Identity(), kSpreading);
}

TEST(ClearanceMapLaws, OneMoreThingLeavesNoMoreRoomAnywhere) {
  for (const std::uint64_t seed : {9, 10}) {
    auto objects = drawnThings(seed, 16);
    const DrawnRoom all(objects);
    objects.pop_back();
    const DrawnRoom fewer(objects);
    int less = 0;
    ASSERT_EQ(all.map.size(), fewer.map.size());
    for (int place = 0; place < all.map.size(); ++place) {
      ASSERT_LE(all.map.spare(place), fewer.map.spare(place) + 1e-3);
      less += all.map.spare(place) < fewer.map.spare(place) - 0.01;
    }
    EXPECT_GT(less, 10);
    EXPECT_LT(less, all.map.size() / 2);
  }
}

TEST(ClearanceMapLaws, WhoIsBroaderAllOverHasLessByThat) {
  constexpr double kMore = 0.07;
  ClearanceMap::Breadth broad = kWalker;
  broad.feet += kMore;
  for (auto& band : broad.bands) band.half_breadth += kMore;
  const auto objects = drawnThings(11, 25);
  const DrawnRoom thin(objects), thick(objects, broad);
  ASSERT_EQ(thin.map.size(), thick.map.size());
  for (int place = 0; place < thin.map.size(); ++place) {
    if (thick.map.spare(place) > ClearanceMap::kFarthest - kMore - 0.01) continue;
    ASSERT_NEAR(thick.map.spare(place), thin.map.spare(place) - kMore, 1e-3);
  }
}

TEST(ClearanceMapLaws, WhoIsBroaderAtOneHeightHasNoMoreRoomAnywhere) {
  const auto objects = drawnThings(12, 25);
  const DrawnRoom usual(objects);
  for (size_t i = 0; i < kWalker.bands.size(); ++i) {
    ClearanceMap::Breadth broad = kWalker;
    broad.bands[i].half_breadth += 0.1;
    const DrawnRoom other(objects, broad);
    for (int place = 0; place < usual.map.size(); ++place)
      ASSERT_LE(other.map.spare(place), usual.map.spare(place) + 1e-3) << i;
  }
}

TEST(ClearanceMapLaws, IsTheLeastOfTheMapsOfEachBand) {
  const auto objects = drawnThings(13, 25);
  const DrawnRoom whole(objects);
  std::vector<double> least(whole.map.size(), ClearanceMap::kFarthest);
  for (const auto& band : kWalker.bands) {
    const DrawnRoom one(objects, {{band}, kWalker.feet});
    for (int place = 0; place < whole.map.size(); ++place)
      least[place] = std::min(least[place], one.map.spare(place));
  }
  for (int place = 0; place < whole.map.size(); ++place)
    ASSERT_NEAR(whole.map.spare(place), least[place], kSpreading)
        << whole.map.at(place).transpose();
}

// Boxes that lie turned in plan, each at heights of its own, by their exact distances.
TEST(ClearanceMapLaws, IsTheLeastDistanceOfWhatIsAtABandsHeightsLessTheBreadthThere) {
  SampleStream random(14, 0);
  std::vector<SceneObject> objects = {floorSlab()};
  struct Thing {
    Eigen::AlignedBox2d plan;  // in its own frame
    Eigen::Isometry3d X_OW;
    double low, high;
  };
  std::vector<Thing> things;
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d size(random.uniform(0.1, 0.9), random.uniform(0.1, 0.9),
                               random.uniform(0.05, 0.8));
    const Eigen::Vector3d at(random.uniform(-4, 4), random.uniform(-4, 4),
                             random.uniform(0.5, 2.2));
    objects.push_back(makeObject("box", Box{size}, at, Role::kObstacle));
    objects.back().X_WO.linear() = aboutZ(random.uniform(-3, 3)).toRotationMatrix();
    const Eigen::Vector2d half = 0.5 * size.head<2>();
    things.push_back({{-half, half},
                      objects.back().X_WO.inverse(),
                      at.z() - 0.5 * size.z(),
                      at.z() + 0.5 * size.z()});
  }
  const DrawnRoom room(objects);
  int compared = 0;
  for (int place = 0; place < room.map.size(); ++place) {
    const Eigen::Vector3d p = room.map.at(place);
    double expected = ClearanceMap::kFarthest;
    bool over = false;
    for (const Thing& thing : things) {
      for (const auto& band : kWalker.bands) {
        if (thing.low >= band.high || thing.high <= band.low) continue;
        const Eigen::Vector3d local = thing.X_OW * p;
        const double distance = thing.plan.exteriorDistance(Eigen::Vector2d(local.head<2>()));
        over |= distance <= 0.0;  // surfaces count, not what is within them
        expected = std::min(expected, distance - band.half_breadth);
      }
    }
    if (over || std::abs(p.x()) > 4.4 || std::abs(p.y()) > 4.4) continue;
    ++compared;
    ASSERT_NEAR(room.map.spare(place), expected, 1.6 * ClearanceMap::kCell) << p.transpose();
  }
  EXPECT_GT(compared, 5000);
}

// A floor, a flight of steps beside it and a deck over it.
std::vector<SceneObject> storeysToMap() {
  std::vector<SceneObject> objects = stairs(10, 0.17, 0.29);
  objects.push_back(floorSlab());
  objects.push_back(makeObject("deck", Box{{4, 6, 0.1}}, {4.9, 0, 1.65}));
  return objects;
}

TEST(ClearanceMapLaws, EveryPlaceIsFoundWhereItIs) {
  const DrawnRoom room(storeysToMap());
  for (int place = 0; place < room.map.size(); ++place)
    ASSERT_EQ(room.map.placeAt(room.map.at(place)), place) << room.map.at(place).transpose();
}

TEST(ClearanceMapLaws, EveryPlaceIsOnTheGround) {
  const DrawnRoom room(storeysToMap());
  EXPECT_GT(room.map.size(), 40000);
  for (int place = 0; place < room.map.size(); ++place) {
    const Eigen::Vector3d p = room.map.at(place);
    // Heights are those of the middle of a square of the ground, which may be on the next tread.
    const auto height = room.ground.height(p.x(), p.y(), p.z(), 0.18);
    ASSERT_TRUE(height) << p.transpose();
  }
}

TEST(ClearanceMapLaws, NeighboursAreBesideAndNoFartherUpThanAStepBothWays) {
  const DrawnRoom room(storeysToMap());
  const double step = room.ground.settings().limits.highestStep();
  int pairs = 0;
  for (int place = 0; place < room.map.size(); ++place) {
    for (const auto& [dx, dy] : {std::pair(1, 0), {0, 1}, {1, 1}, {1, -1}}) {
      const int other = room.map.beside(place, dx, dy);
      if (other < 0) continue;
      ++pairs;
      const Eigen::Vector3d way = room.map.at(other) - room.map.at(place);
      ASSERT_NEAR(way.x(), dx * room.map.cell(), 1e-9);
      ASSERT_NEAR(way.y(), dy * room.map.cell(), 1e-9);
      ASSERT_LE(std::abs(way.z()), step + 1e-6);
      ASSERT_GE(room.map.beside(other, -dx, -dy), 0);
    }
  }
  EXPECT_GT(pairs, 100000);
}

TEST(ClearanceMapLaws, NeverHasMoreRoomThanItTellsApart) {
  for (const std::uint64_t seed : {15, 16}) {
    const DrawnRoom room(drawnThings(seed, 10));
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (int place = 0; place < room.map.size(); ++place) {
      least = std::min(least, room.map.spare(place));
      most = std::max(most, room.map.spare(place));
    }
    EXPECT_FLOAT_EQ(static_cast<float>(most), static_cast<float>(ClearanceMap::kFarthest));
    EXPECT_LT(least, 0.0);
    EXPECT_GE(least, -0.33 - 1e-6);  // in the middle of things the whole breadth is missing
  }
}

// Beside the edge of a smaller map feet stay off, as they do where ground ends.
TEST(ClearanceMapLaws, APartOfTheRoomIsMappedAsTheWholeAwayFromItsEdge) {
  const auto objects = drawnThings(17, 25);
  const DrawnRoom all(objects);
  const Eigen::AlignedBox2d half{Eigen::Vector2d(-2, -3), Eigen::Vector2d(3, 2)};
  const DrawnRoom part(objects, kWalker, half);
  const double rim = ClearanceMap::kFarthest + 0.33 + 2 * ClearanceMap::kCell;
  int compared = 0;
  for (int place = 0; place < part.map.size(); ++place) {
    const Eigen::Vector3d p = part.map.at(place);
    if (((p.head<2>() - half.min()).array() < rim).any() ||
        ((half.max() - p.head<2>()).array() < rim).any())
      continue;
    ++compared;
    const auto whole = all.spareAt(p);
    ASSERT_TRUE(whole);
    ASSERT_NEAR(part.map.spare(place), *whole, 1e-3) << p.transpose();
  }
  EXPECT_GT(compared, 1000);
}

// Strips of the room, each with some of what is beside it, are made one by one: among things on the
// ground and above it, below a gallery, under a beam, and for bodies of which more is beside them.
TEST(ClearanceMapLaws, IsTheSameToTheBitHoweverManyThreadsMakeIt) {
  for (const std::uint64_t seed : {31, 32, 33, 34, 35, 36}) {
    auto objects = drawnThings(seed, 60);
    if (seed % 2 == 0) objects.push_back(makeObject("gallery", Box{{4, 3, 0.2}}, {-2, 1, 2.6}));
    if (seed % 3 == 0) objects.push_back(makeObject("beam", Box{{9, 0.3, 0.2}}, {0, 0.4, 1.5}));
    ClearanceMap::Breadth body = kWalker;
    for (ClearanceMap::Band& band : body.bands) band.half_breadth += seed % 3 == 1 ? 0.3 : 0.0;
    const Scene scene = sceneOf(std::move(objects));
    const SceneGround ground(scene);
    const auto never = [] { return false; };
    const ClearanceMap one(ground, kRoomOfMap, body);
    ASSERT_GT(one.size(), 20000);
    for (const int threads : {2, 3, 5, 64}) {
      const ClearanceMap many(ground, kRoomOfMap, body, never, threads);
      ASSERT_EQ(many.size(), one.size()) << threads;
      for (int place = 0; place < one.size(); ++place) {
        ASSERT_EQ(many.at(place), one.at(place)) << threads << " " << place;
        ASSERT_EQ(many.spare(place), one.spare(place)) << threads << " " << place;
      }
    }
  }
}

TEST(ClearanceMapLaws, StoppedAtAnyMomentItIsEmptyElseItIsWhole) {
  const Scene scene = sceneOf(drawnThings(18, 10));
  const SceneGround ground(scene);
  const ClearanceMap whole(ground, kRoomOfMap, kWalker);
  int empty = 0, asked = 0;
  for (int stop_at = 1;; stop_at = stop_at * 3 / 2 + 1) {
    asked = 0;
    const ClearanceMap map(ground, kRoomOfMap, kWalker, [&] { return ++asked >= stop_at; });
    if (asked < stop_at) {
      ASSERT_EQ(map.size(), whole.size());
      for (int i = 0; i < map.size(); ++i) ASSERT_EQ(map.spare(i), whole.spare(i));
      break;
    }
    ++empty;
    EXPECT_EQ(map.size(), 0) << stop_at;
    EXPECT_EQ(map.placeAt({0, 0, 0}), -1);
  }
  EXPECT_GT(empty, 5);
}

}  // namespace
}  // namespace amble
