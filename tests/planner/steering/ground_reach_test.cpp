#include "planner/steering/ground_reach.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "base/rotation.h"
#include "base/sample_stream.h"
#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

constexpr double kStep = 0.9;  // longest step [m]

SceneObject platform(const std::string& name, double x0, double x1, double top) {
  return makeObject(name, Box{{x1 - x0, 4, 0.1}}, {0.5 * (x0 + x1), 0, top - 0.05});
}

/// Of the ground from x = -2 to x = 2 beside each other.
std::optional<GroundGap> gapIn(const std::vector<SceneObject>& objects, double goal_z = 0.0) {
  const Scene scene = sceneOf(objects);
  const SceneGround ground(scene);
  return findGap(ground, {-2, 0, 0}, {2, 0, goal_z}, kStep);
}

TEST(GroundReach, OneFloorLeadsEverywhereOnIt) { EXPECT_FALSE(gapIn({floorSlab()}).has_value()); }

TEST(GroundReach, AGapWiderThanAStepIsFoundWithItsWidth) {
  const auto gap = gapIn({platform("west", -4, -1, 0), platform("east", 1, 4, 0)});
  ASSERT_TRUE(gap.has_value());
  EXPECT_NEAR(gap->width(), 2.0, 0.25);  // from the middle of a square to that of another
  EXPECT_NEAR(gap->near.x(), -1.0, 0.15);
  EXPECT_NEAR(gap->far.x(), 1.0, 0.15);
  EXPECT_NEAR(gap->rise(), 0.0, 1e-9);
}

TEST(GroundReach, AGapThatAStepCrossesIsNone) {
  EXPECT_FALSE(gapIn({platform("west", -4, -0.3, 0), platform("east", 0.3, 4, 0)}).has_value());
}

// Wherever it lies to the squares' middles, level or turned.
TEST(GroundReach, APlankThatIsSaidToBeGroundLeadsAcrossHoweverNarrowItIs) {
  SampleStream stream(5, 0);
  for (int i = 0; i < 40; ++i) {
    SceneObject plank = makeObject("plank", Box{{2.4, stream.uniform(0.01, 0.12), 0.1}},
                                   {0, stream.uniform(-1.0, 1.0), -0.05}, Role::kGround);
    if (i % 2 == 0)
      plank.X_WO.rotate(Eigen::AngleAxisd(stream.uniform(-0.3, 0.3), Eigen::Vector3d::UnitZ()));
    const std::vector<SceneObject> sides = {platform("west", -4, -1, 0), platform("east", 1, 4, 0)};
    EXPECT_FALSE(gapIn({sides[0], plank, sides[1]}).has_value()) << i;
    plank.role = Role::kObstacle;
    EXPECT_TRUE(gapIn({sides[0], plank, sides[1]}).has_value()) << i;
  }
}

TEST(GroundReach, APlankThatIsBroadEnoughForAFootLeadsAcrossAtAnyStature) {
  SampleStream stream(6, 0);
  for (int i = 0; i < 24; ++i) {
    const double stature = stream.uniform(0.5, 2.2), foot = 0.055 * stature;
    GroundSettings settings;
    settings.foot_length = 0.106 * stature;
    settings.foot_breadth = foot;
    const Scene scene = sceneOf(
        {platform("west", -4, -1, 0), platform("east", 1, 4, 0),
         makeObject("plank", Box{{2.0, 1.31 * foot, 0.1}}, {0, stream.uniform(-1.0, 1.0), -0.05})});
    const SceneGround ground(scene, settings);
    EXPECT_FALSE(findGap(ground, {-2, 0, 0}, {2, 0, 0}, 0.3 * stature).has_value()) << stature;
  }
}

TEST(GroundReach, ALedgeThatNobodyClimbsIsAGap) {
  const auto gap = gapIn({platform("west", -4, 0, 0), platform("east", 0, 4, 1.5)}, 1.5);
  ASSERT_TRUE(gap.has_value());
  EXPECT_NEAR(gap->rise(), 1.5, 1e-6);
  EXPECT_LT(gap->width(), kStep);
}

// Between the middles of two level feet no slope explains a rise.
TEST(GroundReach, APlatformUnderTheLongestStepIsAGapWhereItIsHigherThanTheHighest) {
  const auto high = gapIn({platform("west", -4, 0, 0), platform("east", 0, 4, 0.5)}, 0.5);
  ASSERT_TRUE(high.has_value());
  EXPECT_NEAR(high->rise(), 0.5, 1e-6);
  EXPECT_FALSE(gapIn({platform("west", -4, 0, 0), platform("east", 0, 4, 0.24)}, 0.24).has_value());
}

TEST(GroundReach, ARampLeadsUpToWhatIsTooHighForAStep) {
  constexpr double kSlope = 15.0 * kDegree, kTop = 0.5;
  const double length = kTop / std::sin(kSlope), end = kTop / std::tan(kSlope);
  SceneObject ramp = makeObject("ramp", Box{{length, 4, 0.002}}, {0.5 * end, 0, 0.5 * kTop});
  ramp.X_WO.linear() = expRotation({0, -kSlope, 0}).toRotationMatrix();
  const SceneObject upper = platform("upper", end, end + 2.0, kTop);
  const auto leads = [&](const std::vector<SceneObject>& objects) {
    const Scene scene = sceneOf(objects);
    return !findGap(SceneGround(scene), {-2, 0, 0}, {end + 1.0, 0, kTop}, kStep);
  };
  EXPECT_TRUE(leads({floorSlab(), ramp, upper}));
  EXPECT_FALSE(leads({floorSlab(), upper}));
}

TEST(GroundReach, StairsLeadUp) {
  std::vector<SceneObject> objects = stairs(8, 0.17, 0.29);
  objects.push_back(makeObject("upper", Box{{3, 3, 0.2}}, {8 * 0.29 + 1.5, 0, 9 * 0.17 - 0.1}));
  objects.push_back(floorSlab());
  const Scene scene = sceneOf(objects);
  const SceneGround ground(scene);
  EXPECT_FALSE(findGap(ground, {-2, 0, 0}, {3.5, 0, 9 * 0.17}, kStep).has_value());
}

TEST(GroundReach, AFloorOverTheOtherIsReachedByNothing) {
  const auto gap = gapIn({floorSlab(), platform("upper", -4, 4, 2.8)}, 2.8);
  ASSERT_TRUE(gap.has_value());
  EXPECT_NEAR(gap->rise(), 2.8, 1e-6);
}

TEST(GroundReach, IsTheSameBothWays) {
  const Scene scene = sceneOf({platform("west", -4, -1, 0), platform("east", 1, 4, 0)});
  const SceneGround ground(scene);
  const auto there = findGap(ground, {-2, 0, 0}, {2, 0, 0}, kStep);
  const auto back = findGap(ground, {2, 0, 0}, {-2, 0, 0}, kStep);
  ASSERT_TRUE(there && back);
  EXPECT_NEAR(there->width(), back->width(), 1e-9);
}

TEST(GroundReach, WhereNothingIsKnownNothingIsSaid) {
  const Scene scene = sceneOf({platform("west", -4, -1, 0)});
  const SceneGround ground(scene);
  EXPECT_FALSE(findGap(ground, {-2, 0, 0}, {9, 0, 0}, kStep).has_value());
}

// Platforms in a row: the first gap that no step crosses is the one that is found.
TEST(GroundReach, OfRandomRowsIsTheFirstGapThatIsTooWide) {
  std::mt19937_64 generator(3);
  std::uniform_real_distribution<double> length(1.5, 3.0), gap(0.2, 2.2);
  // What is wider than a step, but for the squares and the feet that it is widened by, may be
  // either.
  constexpr double kDoubt = 0.45;
  int open = 0, closed = 0;
  for (int n = 0; n < 40; ++n) {
    std::vector<SceneObject> row;
    double x = 0.0;
    std::optional<double> first;  // where the ground ends
    bool doubtful = false;
    Eigen::Vector3d last;
    for (int i = 0; i < 5; ++i) {
      const double end = x + length(generator);
      row.push_back(platform("p", x, end, 0.0));
      last = {0.5 * (x + end), 0, 0};
      const double wide = gap(generator);
      if (i < 4) {
        doubtful = doubtful || (!first && wide > kStep - 0.05 && wide < kStep + kDoubt);
        if (wide > kStep && !first) first = end;
      }
      x = end + wide;
    }
    if (doubtful) continue;
    const Scene scene = sceneOf(row);
    const SceneGround ground(scene);
    const auto found = findGap(ground, {0.7, 0, 0}, last, kStep);
    ASSERT_EQ(found.has_value(), first.has_value()) << n;
    ++(first ? open : closed);
    if (!found) continue;
    EXPECT_NEAR(found->near.x(), *first, 0.15);
    EXPECT_GT(found->width(), kStep - 0.05);
  }
  EXPECT_GT(open, 3);
  EXPECT_GE(closed, 1);
}

TEST(GroundReach, ALongerStepNeverFindsAGapThatAShorterDoesNot) {
  const Scene scene = sceneOf(
      {platform("a", -4, -1.6, 0), platform("b", -0.9, 0.2, 0), platform("c", 1.3, 4, 0.2)});
  const SceneGround ground(scene);
  bool found = true;
  for (double step = 0.3; step < 2.0; step += 0.1) {
    const bool here = findGap(ground, {-2, 0, 0}, {2, 0, 0.2}, step).has_value();
    EXPECT_TRUE(found || !here) << step;
    found = here;
  }
  EXPECT_FALSE(found);
}

// What is climbed at most, and what is stepped down [m].
GroundLimits limitsOf(double climb, double drop) {
  GroundLimits limits;
  limits.max_climb = climb;
  limits.max_drop = drop;
  return limits;
}

TEST(GroundReach, AKerbThatIsNotClimbedIsAGapOneWay) {
  for (const double high : {0.08, 0.15, 0.24}) {
    const Scene scene = sceneOf({platform("road", -4, 0, 0), platform("pavement", 0, 4, high)});
    const Eigen::Vector3d road(-2, 0, 0), pavement(2, 0, high);
    GroundSettings settings;
    settings.limits = limitsOf(0.02, 0.25);
    const SceneGround climbs_little(scene, settings);
    const auto up = findGap(climbs_little, road, pavement, kStep);
    ASSERT_TRUE(up.has_value()) << high;
    EXPECT_NEAR(up->rise(), high, 1e-6);
    EXPECT_FALSE(findGap(climbs_little, pavement, road, kStep).has_value()) << high;
    settings.limits = limitsOf(0.25, 0.02);
    const SceneGround drops_little(scene, settings);
    EXPECT_FALSE(findGap(drops_little, road, pavement, kStep).has_value()) << high;
    EXPECT_TRUE(findGap(drops_little, pavement, road, kStep).has_value()) << high;
  }
}

TEST(GroundReach, AThresholdIsWalkedOverWhateverIsClimbed) {
  GroundSettings settings;
  settings.limits = limitsOf(0.0, 0.25);
  const Scene scene = sceneOf({platform("west", -4, 0, 0), platform("east", 0, 4, 0.055)});
  const SceneGround ground(scene, settings);
  EXPECT_FALSE(findGap(ground, {-2, 0, 0}, {2, 0, 0.055}, kStep).has_value());
}

// A ramp beside the kerb, and another kerb that is stepped down on the way back to the road.
TEST(GroundReach, ARampLeadsUpToAKerbThatIsNotClimbed) {
  constexpr double kTop = 0.2, kRun = 2.0;
  const double tilt = std::atan2(kTop, kRun);
  SceneObject ramp =
      makeObject("ramp", Box{{std::hypot(kTop, kRun), 1, 0.002}}, {-0.5 * kRun, 3, 0.5 * kTop});
  ramp.X_WO.linear() = expRotation({0, -tilt, 0}).toRotationMatrix();
  GroundSettings settings;
  settings.limits = limitsOf(0.02, 0.25);
  for (const bool has_ramp : {false, true}) {
    std::vector<SceneObject> objects = {
        makeObject("road", Box{{4, 8, 0.1}}, {-2, 1, -0.05}),
        makeObject("pavement", Box{{4, 8, 0.1}}, {2, 1, kTop - 0.05})};
    if (has_ramp) objects.push_back(ramp);
    const Scene scene = sceneOf(objects);
    const SceneGround ground(scene, settings);
    EXPECT_EQ(findGap(ground, {-3, 0, 0}, {2, 0, kTop}, kStep).has_value(), !has_ramp);
  }
}

// Platforms on a grid, near or far from their neighbours, a step or more higher, which may be taken
// up or down only: by all pairs of them, some of which are joined by way of others only.
class PlatformGrid {
 public:
  static constexpr int kRow = 4, kCount = kRow * kRow;

  explicit PlatformGrid(std::mt19937& random) {
    constexpr double kSide = 2.2;
    const auto draw = [&](int count) { return static_cast<int>(random() % count); };
    std::array<std::array<double, kRow>, 2> low;  // of each column and row
    for (auto& line : low) {
      line[0] = 0.0;
      for (int i = 1; i < kRow; ++i) line[i] = line[i - 1] + kSide + (draw(3) < 2 ? 0.3 : 2.0);
    }
    for (int i = 0; i < kCount; ++i) {
      const double z = std::array{0.0, 0.15, 1.5, 1.65}[draw(4)];
      const Eigen::Vector3d corner(low[0][i % kRow], low[1][i / kRow], z);
      tops.emplace_back(corner, corner + Eigen::Vector3d(kSide, kSide, 0.0));
      objects.push_back(makeObject("platform " + std::to_string(i), Box{{kSide, kSide, 0.1}},
                                   tops[i].center() - Eigen::Vector3d(0, 0, 0.05)));
    }
  }

  bool isStep(int from, int to, const GroundLimits& limits) const {
    const double rise = tops[to].min().z() - tops[from].min().z();
    const double far = std::sqrt(tops[from].squaredExteriorDistance(tops[to]) - rise * rise);
    return far < kStep && rise < limits.max_climb && -rise < limits.max_drop;
  }
  /// Which are reached from each, by chains of steps.
  std::vector<std::vector<bool>> chains(const GroundLimits& limits) const {
    std::vector<std::vector<bool>> all(kCount, std::vector<bool>(kCount, false));
    for (int a = 0; a < kCount; ++a)
      for (int b = 0; b < kCount; ++b) all[a][b] = a == b || isStep(a, b, limits);
    for (int k = 0; k < kCount; ++k)
      for (int a = 0; a < kCount; ++a)
        for (int b = 0; b < kCount; ++b) all[a][b] = all[a][b] || (all[a][k] && all[k][b]);
    return all;
  }

  std::vector<SceneObject> objects;
  std::vector<Eigen::AlignedBox3d> tops;
};

TEST(GroundReach, OfPlatformsThoseAreReachedThatAChainOfStepsLeadsTo) {
  std::mt19937 random(3);
  int joined = 0, by_others = 0, apart = 0, one_way = 0;
  for (int scene_number = 0; scene_number < 6; ++scene_number) {
    const PlatformGrid grid(random);
    GroundSettings settings;
    settings.limits =
        limitsOf(scene_number % 3 == 1 ? 0.1 : 0.2, scene_number % 3 == 2 ? 0.1 : 0.2);
    const auto chains = grid.chains(settings.limits);
    const Scene scene = sceneOf(grid.objects);
    const SceneGround ground(scene, settings);
    const GroundCells& cells = ground.cells();
    for (int a = 0; a < PlatformGrid::kCount; ++a) {
      const auto reached = ReachedGround(ground, grid.tops[a].center(), kStep).heights();
      for (int b = 0; b < PlatformGrid::kCount; ++b) {
        if (a == b) continue;
        const Eigen::Vector2i at = cells.squareAt(grid.tops[b].center().head<2>());
        EXPECT_EQ(reached[at.y() * cells.columns() + at.x()].isEmpty(), !chains[a][b])
            << scene_number << ": " << a << " to " << b;
        (chains[a][b] ? joined : apart) += 1;
        by_others += chains[a][b] && !grid.isStep(a, b, settings.limits);
        one_way += chains[a][b] && !chains[b][a];
      }
    }
  }
  EXPECT_GT(joined, 100);
  EXPECT_GT(by_others, 10);
  EXPECT_GT(apart, 100);
  EXPECT_GT(one_way, 20);
}

}  // namespace
}  // namespace amble
