// What holds of the ground of any scene, asked for in different ways: one surface, floors, where
// one stands, what is stepped over.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "base/union_find.h"
#include "environments/ground/ground_cells.h"
#include "environments/ground/scene_ground.h"
#include "tests/environments/random_scenes.h"

namespace amble {
namespace {

// Slabs of several heights over and beside one another, a flight of stairs, a ramp and furniture.
std::vector<SceneObject> drawnStoreys(std::uint64_t seed) {
  SampleStream random(seed, 1);
  std::vector<SceneObject> objects = stairs(10, 0.17, 0.29);
  objects.push_back(makeObject("floor", Box{{12, 12, 0.1}}, {0, 0, -0.05}));
  objects.push_back(makeObject("deck", Box{{4, 6, 0.1}}, {4.9, 0, 1.65}));
  SceneObject ramp = makeObject("ramp", Box{{3, 1.5, 0.05}}, {-2.5, 3.0, 0.2});
  ramp.X_WO.linear() = expRotation({0, -0.15, 0}).toRotationMatrix();
  objects.push_back(ramp);
  for (int i = 0; i < 10; ++i) {
    const Eigen::Vector3d size(random.uniform(0.3, 2.5), random.uniform(0.3, 2.5),
                               random.uniform(0.02, 0.4));
    const double under = i % 3 == 0 ? random.uniform(0.5, 2.0) : 0.0;
    objects.push_back(
        makeObject("slab " + std::to_string(i), Box{size},
                   {random.uniform(-5, 3), random.uniform(-5, 5), under + 0.5 * size.z()}));
    objects.back().X_WO.linear() = aboutZ(random.uniform(-3, 3)).toRotationMatrix();
  }
  return objects;
}

struct Storeys {
  explicit Storeys(std::uint64_t seed) : Storeys(drawnStoreys(seed)) {}
  explicit Storeys(std::vector<SceneObject> objects)
      : scene(sceneOf(std::move(objects))), ground(scene) {}

  // Heights of the ground's triangles over p, each as a loop over all of them has it.
  std::vector<double> heightsAt(const Eigen::Vector2d& p) const {
    std::vector<double> heights;
    for (const Triangle3& t : ground.surfaces().triangles())
      if (const auto z = heightOver(t, p.x(), p.y())) heights.push_back(*z);
    std::sort(heights.begin(), heights.end());
    return heights;
  }

  Scene scene;
  SceneGround ground;
};

template <typename Visit>
void atPlacesOf(const std::vector<std::uint64_t>& seeds, int places, Visit visit) {
  for (const std::uint64_t seed : seeds) {
    const Storeys storeys(seed);
    SampleStream random(seed, 2);
    for (int n = 0; n < places; ++n)
      visit(storeys, Eigen::Vector2d(random.uniform(-6.5, 7.5), random.uniform(-6.5, 6.5)), random);
  }
}

TEST(GroundLaws, ASurfaceIsTheHighestOfAllTrianglesWithinReach) {
  int found = 0;
  atPlacesOf({1, 2, 3}, 600, [&](const Storeys& storeys, const Eigen::Vector2d& p, auto& random) {
    const double z = random.uniform(-0.5, 2.2), reach = random.uniform(0.0, 0.6);
    std::optional<double> expected;
    for (const double height : storeys.heightsAt(p))
      if (std::abs(height - z) <= reach) expected = height;
    const auto point = storeys.ground.surface(p.x(), p.y(), z, reach);
    ASSERT_EQ(point.has_value(), expected.has_value()) << p.transpose() << " " << z;
    if (!point) return;
    ++found;
    EXPECT_EQ(point->height, *expected);
    EXPECT_NEAR(point->normal.norm(), 1.0, 1e-12);
    EXPECT_GE(point->normal.z(), std::cos(storeys.ground.settings().limits.max_slope) - 1e-6);
  });
  EXPECT_GT(found, 300);
}

TEST(GroundLaws, AFartherReachFindsNoLowerSurface) {
  atPlacesOf({4, 5}, 400, [](const Storeys& storeys, const Eigen::Vector2d& p, auto& random) {
    const double z = random.uniform(-0.5, 2.2);
    double highest = -HUGE_VAL;
    for (const double reach : {0.0, 0.05, 0.2, 0.5, 1.0, 3.0}) {
      const double height = storeys.ground.height(p.x(), p.y(), z, reach).value_or(-HUGE_VAL);
      EXPECT_GE(height, highest);
      EXPECT_LE(height, z + reach);
      highest = height;
    }
  });
}

TEST(GroundLaws, FloorsComeLowestFirstApartByALevelAndAreSurfaces) {
  int several = 0;
  atPlacesOf({6, 7, 8}, 500, [&](const Storeys& storeys, const Eigen::Vector2d& p, auto&) {
    const std::vector<double> floors = storeys.ground.floors(p.x(), p.y());
    several += floors.size() > 1;
    for (size_t i = 0; i < floors.size(); ++i) {
      if (i > 0) {
        EXPECT_GT(floors[i], floors[i - 1] + SceneGround::kLevel);
      }
      if (storeys.heightsAt(p).empty()) continue;  // what could be ground, where none is
      EXPECT_TRUE(storeys.ground.surface(p.x(), p.y(), floors[i], 1e-9)) << p.transpose();
    }
  });
  EXPECT_GT(several, 20);
}

// By the definition: ground with no other ground over it within the headroom, but rugs.
TEST(GroundLaws, AFloorHasHeadroomBelowWhateverElseIsGround) {
  atPlacesOf({9, 10}, 500, [](const Storeys& storeys, const Eigen::Vector2d& p, auto&) {
    const std::vector<double> heights = storeys.heightsAt(p);
    for (const double floor : storeys.ground.floors(p.x(), p.y())) {
      for (const double z : heights) {
        EXPECT_FALSE(z > floor + SceneGround::kLevel &&
                     z < floor + storeys.ground.settings().headroom)
            << p.transpose() << " floor " << floor << " under " << z;
      }
    }
    if (!heights.empty()) {
      EXPECT_NEAR(storeys.ground.floors(p.x(), p.y()).back(), heights.back(),
                  SceneGround::kLevel + 1e-12);
    }
  });
}

TEST(GroundLaws, MainFloorsAreFloorsOrLieUnderWhatNobodyClimbs) {
  int main = 0;
  atPlacesOf({11, 12, 13}, 500, [&](const Storeys& storeys, const Eigen::Vector2d& p, auto&) {
    const std::vector<double> floors = storeys.ground.floors(p.x(), p.y()),
                              chosen = storeys.ground.mainFloors(p.x(), p.y());
    EXPECT_EQ(chosen.empty(), floors.empty()) << p.transpose();
    EXPECT_TRUE(std::is_sorted(chosen.begin(), chosen.end()));
    const std::vector<double> heights = storeys.heightsAt(p);
    for (const double floor : chosen) {
      ++main;
      if (heights.empty()) continue;
      EXPECT_TRUE(std::find(heights.begin(), heights.end(), floor) != heights.end());
    }
  });
  EXPECT_GT(main, 1000);
}

TEST(GroundLaws, OneStandsOnTheNearestFloorWithinReachAndOnWhatLiesOnIt) {
  int standing = 0;
  atPlacesOf({14, 15, 16}, 500,
             [&](const Storeys& storeys, const Eigen::Vector2d& p, auto& random) {
               const double z = random.uniform(-0.5, 2.5), reach = random.uniform(0.0, 1.0);
               double nearest = HUGE_VAL;
               for (const double floor : storeys.ground.floors(p.x(), p.y()))
                 nearest = std::min(nearest, std::abs(floor - z));
               const auto point = storeys.ground.stand(p.x(), p.y(), z, reach);
               if (storeys.heightsAt(p).empty()) return;
               ASSERT_EQ(point.has_value(), nearest <= reach) << p.transpose() << " " << z;
               if (!point) return;
               ++standing;
               EXPECT_NEAR(std::abs(point->height - z), nearest, SceneGround::kLevel + 1e-12);
             });
  EXPECT_GT(standing, 300);
}

TEST(GroundLaws, WhereOneStandsOneStandsAgain) {
  atPlacesOf({17, 18}, 500, [](const Storeys& storeys, const Eigen::Vector2d& p, auto& random) {
    const auto first = storeys.ground.stand(p.x(), p.y(), random.uniform(-0.3, 2.0), 0.5);
    if (!first) return;
    const auto again = storeys.ground.stand(p.x(), p.y(), first->height, SceneGround::kLevel);
    ASSERT_TRUE(again) << p.transpose();
    EXPECT_EQ(again->height, first->height);
    EXPECT_EQ(again->normal, first->normal);
  });
}

struct DrawnStrip {
  Eigen::Vector2d a, b;
  double half;
};

DrawnStrip drawnStrip(SampleStream& random) {
  const Eigen::Vector2d a(random.uniform(-5, 6), random.uniform(-5, 5));
  const Eigen::Vector2d way(random.uniform(-1, 1), random.uniform(-1, 1));
  return {a, a + way, random.uniform(0.01, 0.2)};
}

TEST(GroundLaws, CrestsGrowWithTheStripAndWithWhatMayBeSteppedOver) {
  atPlacesOf({19, 20}, 300, [](const Storeys& storeys, const Eigen::Vector2d&, auto& random) {
    const DrawnStrip strip = drawnStrip(random);
    const auto crest = [&](double half, double low, double high) {
      return storeys.ground.crest(strip.a, strip.b, half, low, high);
    };
    const double usual = crest(strip.half, -0.1, 0.5);
    EXPECT_LE(usual, crest(strip.half + 0.05, -0.1, 0.5) + 1e-9);
    EXPECT_LE(usual, crest(strip.half, -0.1, 0.9) + 1e-9);
    EXPECT_LE(usual, crest(strip.half, -0.4, 0.5) + 1e-9);
    EXPECT_LE(usual, 0.5);
    EXPECT_TRUE(usual >= -0.1 || usual == -HUGE_VAL) << usual;
  });
}

TEST(GroundLaws, ACrestIsTheSameFromEitherEndAndTheHighestOfItsParts) {
  atPlacesOf({21, 22}, 300, [](const Storeys& storeys, const Eigen::Vector2d&, auto& random) {
    const DrawnStrip strip = drawnStrip(random);
    const auto crest = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
      return storeys.ground.crest(a, b, strip.half, -0.1, 0.6);
    };
    const double whole = crest(strip.a, strip.b), back = crest(strip.b, strip.a);
    const Eigen::Vector2d middle = strip.a + random.uniform(0.1, 0.9) * (strip.b - strip.a);
    const double parts = std::max(crest(strip.a, middle), crest(middle, strip.b));
    if (whole == -HUGE_VAL) {
      EXPECT_EQ(back, whole);
      EXPECT_EQ(parts, whole);
      return;
    }
    EXPECT_NEAR(back, whole, 1e-9);
    EXPECT_NEAR(parts, whole, 1e-9);
  });
}

// Where somebody stands the crest of what is under is no lower than that.
TEST(GroundLaws, UnderAStripIsAtLeastTheGroundOfItsLine) {
  atPlacesOf({23, 24}, 300, [](const Storeys& storeys, const Eigen::Vector2d&, auto& random) {
    const DrawnStrip strip = drawnStrip(random);
    const double crest = storeys.ground.crest(strip.a, strip.b, strip.half, -0.1, 0.45);
    for (double t = 0.0; t <= 1.0; t += 0.1) {
      const Eigen::Vector2d p = strip.a + t * (strip.b - strip.a);
      const auto height = storeys.ground.height(p.x(), p.y(), 0.0, 0.1);
      if (height) {
        EXPECT_GE(crest, *height - 1e-9) << p.transpose();
      }
    }
  });
}

// The same ground elsewhere: its triangles are the same, asked at places that went along.
void expectSameGround(const Storeys& here, const Storeys& there, const Eigen::Isometry3d& X,
                      std::uint64_t seed) {
  SampleStream random(seed, 3);
  ASSERT_EQ(here.ground.groundTriangles(), there.ground.groundTriangles());
  EXPECT_EQ(here.ground.isLevel(), there.ground.isLevel());
  EXPECT_NEAR(here.ground.heights().min()[0] + X.translation().z(), there.ground.heights().min()[0],
              1e-9);
  int compared = 0;
  for (int n = 0; n < 600; ++n) {
    const Eigen::Vector3d p(random.uniform(-6, 7), random.uniform(-6, 6), random.uniform(-0.3, 2));
    // Not at an edge, where rounding decides what is over the place.
    const auto floors = here.ground.floors(p.x(), p.y());
    bool at_edge = false;
    for (const double angle : {0.0, 1.6, 3.2, 4.8})
      at_edge |= here.ground.floors(p.x() + 1e-3 * std::cos(angle), p.y() + 1e-3 * std::sin(angle))
                     .size() != floors.size();
    if (at_edge) continue;
    ++compared;
    const Eigen::Vector3d q = X * p;
    const auto there_floors = there.ground.floors(q.x(), q.y());
    ASSERT_EQ(floors.size(), there_floors.size()) << p.transpose();
    for (size_t i = 0; i < floors.size(); ++i)
      EXPECT_NEAR(floors[i] + X.translation().z(), there_floors[i], 2e-3);
  }
  EXPECT_GT(compared, 400);
}

TEST(GroundLaws, MovesWithTheScene) {
  for (const std::uint64_t seed : {25, 26}) {
    const auto objects = drawnStoreys(seed);
    const Eigen::Isometry3d X = turnedAndMoved(0.0, {31.4, -7.2, 5.5});
    expectSameGround(Storeys(objects), Storeys(movedObjects(objects, X)), X, seed);
  }
}

TEST(GroundLaws, TurnsWithTheSceneByQuarters) {
  for (const int quarters : {1, 2, 3}) {
    const auto objects = drawnStoreys(27);
    const Eigen::Isometry3d X = turnedAndMoved(0.5 * kPi * quarters, {0, 0, 0});
    expectSameGround(Storeys(objects), Storeys(movedObjects(objects, X)), X, 27);
  }
}

TEST(GroundLaws, OfAMirroredSceneIsMirrored) {
  const auto objects = drawnStoreys(28);
  const Storeys here(objects), mirror(mirroredObjects(objects));
  SampleStream random(28, 4);
  for (int n = 0; n < 500; ++n) {
    const Eigen::Vector2d p(random.uniform(-6, 7), random.uniform(-6, 6));
    const double z = random.uniform(-0.2, 2.0);
    const auto a = here.ground.surface(p.x(), p.y(), z, 0.3),
               b = mirror.ground.surface(p.x(), -p.y(), z, 0.3);
    ASSERT_EQ(a.has_value(), b.has_value()) << p.transpose();
    if (!a) continue;
    EXPECT_NEAR(a->height, b->height, 1e-9);
    EXPECT_LT((mirroredPoint(a->normal) - b->normal).norm(), 1e-9);
  }
}

TEST(GroundLaws, DoesNotDependOnTheOrderOfThingsNorOfTheirTriangles) {
  SampleStream random(29, 5);
  auto objects = drawnStoreys(29);
  const Storeys usual(objects);
  std::reverse(objects.begin(), objects.end());
  for (SceneObject& object : objects)
    object.shape = shuffled(makeBox(std::get<Box>(object.shape).size), random);
  const Storeys other(objects);
  const int count = static_cast<int>(objects.size());
  for (int i = 0; i < count; ++i)
    EXPECT_EQ(usual.ground.isGround(i), other.ground.isGround(count - 1 - i)) << i;
  for (int n = 0; n < 800; ++n) {
    const Eigen::Vector2d p(random.uniform(-6, 7), random.uniform(-6, 6));
    const auto a = usual.ground.floors(p.x(), p.y()), b = other.ground.floors(p.x(), p.y());
    ASSERT_EQ(a.size(), b.size()) << p.transpose();
    for (size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-9);
  }
}

// Cells hold what is over their middles, each once.
TEST(GroundLaws, SpansOfASquareAreTheSurfacesOverItsMiddle) {
  for (const std::uint64_t seed : {30, 31}) {
    const Storeys storeys(seed);
    const GroundCells& cells = storeys.ground.cells();
    int ground_spans = 0;
    for (int row = 0; row < cells.rows(); ++row) {
      for (int column = 0; column < cells.columns(); ++column) {
        const Eigen::Vector2d p = cells.middle(column, row);
        double last = -HUGE_VAL;
        for (const GroundCells::Span& span : cells.spans(column, row)) {
          ASSERT_GT(span.height, last);
          last = span.height;
          if (!span.ground) continue;
          ++ground_spans;
          ASSERT_TRUE(storeys.ground.surface(p.x(), p.y(), span.height, SceneGround::kLevel))
              << p.transpose() << " " << span.height;
        }
      }
    }
    EXPECT_GT(ground_spans, 10000);
  }
}

TEST(GroundLaws, WhatIsStandableBelongsToAPartAndGroundToAFloor) {
  const Storeys storeys(32);
  const GroundCells& cells = storeys.ground.cells();
  int most = 0;
  for (int row = 0; row < cells.rows(); ++row) {
    for (int column = 0; column < cells.columns(); ++column) {
      int standing = 0;
      for (const GroundCells::Span& span : cells.spans(column, row)) {
        ASSERT_EQ(span.standable, span.part >= 0);
        ASSERT_EQ(span.ground, span.floor >= 0);
        standing += span.ground && span.standable;
        if (span.floor >= 0) {
          ASSERT_GT(cells.area(span.floor), 0.0);
        }
      }
      ASSERT_LE(standing, cells.layers());
      most = std::max(most, standing);
    }
  }
  EXPECT_EQ(most, cells.layers());
}

// However its rows are shared out among threads: by sets of all that is over all squares.
TEST(GroundLaws, PartsAreWhatStepsJoinOverUpToThreeSquares) {
  constexpr int kReach = 3;
  for (const std::uint64_t seed : {41, 42, 43}) {
    const Storeys storeys(seed);
    const GroundCells& cells = storeys.ground.cells();
    const double step = storeys.ground.settings().limits.highestStep();
    std::vector<int> first = {0};  // of each square's spans
    for (int row = 0; row < cells.rows(); ++row)
      for (int column = 0; column < cells.columns(); ++column)
        first.push_back(first.back() + static_cast<int>(cells.spans(column, row).size()));
    const auto number = [&](int column, int row) { return first[row * cells.columns() + column]; };
    UnionFind sets(first.back());
    std::vector<int> part(first.back(), -1);
    for (int row = 0; row < cells.rows(); ++row) {
      for (int column = 0; column < cells.columns(); ++column) {
        const auto here = cells.spans(column, row);
        for (size_t i = 0; i < here.size(); ++i) {
          part[number(column, row) + i] = here[i].part;
          if (!here[i].standable) continue;
          for (int far = 1; far <= kReach; ++far) {
            for (const auto& [x, y] : {std::pair(column + far, row), {column, row + far}}) {
              const auto there = cells.spans(x, y);
              for (size_t k = 0; k < there.size(); ++k) {
                if (there[k].standable && std::abs(there[k].height - here[i].height) <= step)
                  sets.join(number(column, row) + static_cast<int>(i),
                            number(x, y) + static_cast<int>(k));
              }
            }
          }
        }
      }
    }
    std::map<int, int> set_of_part, part_of_set;
    for (int i = 0; i < sets.size(); ++i) {
      if (part[i] < 0) continue;
      ASSERT_EQ(set_of_part.try_emplace(part[i], sets.find(i)).first->second, sets.find(i)) << i;
      ASSERT_EQ(part_of_set.try_emplace(sets.find(i), part[i]).first->second, part[i]) << i;
    }
    EXPECT_GT(part_of_set.size(), 3u);
  }
}

TEST(GroundLaws, WhoClimbsMoreHasNoLessGround) {
  for (const std::uint64_t seed : {33, 34}) {
    const Scene scene = sceneOf(drawnStoreys(seed));
    GroundSettings settings;
    std::vector<bool> before;
    for (const double slope : {2.0, 9.0, 20.0}) {
      settings.limits.max_slope = slope * kDegree;
      const std::vector<bool> now = SceneGround(scene, settings).groundTriangles();
      for (size_t i = 0; i < before.size(); ++i) EXPECT_LE(before[i], now[i]) << slope;
      before = now;
    }
  }
}

}  // namespace
}  // namespace amble
