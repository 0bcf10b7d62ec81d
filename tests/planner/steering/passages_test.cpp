#include "planner/steering/passages.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

std::vector<Passage> passagesOf(const std::vector<SceneObject>& objects) {
  const Scene scene = sceneOf(objects);
  return findPassages(SceneGround(scene));
}

TEST(Passages, OfLevelGroundAreNone) {
  EXPECT_TRUE(passagesOf({}).empty());
  EXPECT_TRUE(
      passagesOf({floorSlab(), makeObject("rug", Box{{2, 2, 0.01}}, {0, 0, 0.005})}).empty());
}

TEST(Passages, LeadStraightUpAFlightThatIsTurnedAnyWay) {
  for (const double turn : {0.0, 17.0, 133.0}) {
    const Eigen::Isometry3d X(Eigen::AngleAxisd(turn * kDegree, Eigen::Vector3d::UnitZ()));
    std::vector<SceneObject> objects = stairs(8, 0.17, 0.29);
    objects.push_back(makeObject("upper", Box{{3, 3, 0.2}}, {8 * 0.29 + 1.5, 0, 9 * 0.17 - 0.1}));
    for (SceneObject& object : objects) object.X_WO = X * object.X_WO;
    objects.push_back(floorSlab());
    int count = 0;
    for (const Passage& passage : passagesOf(objects)) {
      const Eigen::Vector3d low = X.inverse() * passage.low, high = X.inverse() * passage.high;
      EXPECT_NEAR(low.z(), 0.0, 1e-9);
      if (high.z() < 9 * 0.17 - 1e-9) continue;  // onto the lowest treads from their sides
      ++count;
      EXPECT_LT(low.x(), -0.2);
      EXPECT_GT(high.x(), 8 * 0.29 + 0.2);
      EXPECT_NEAR(low.y(), high.y(), 0.05);
      EXPECT_LT(std::abs(low.y()), 1.0);
      EXPECT_NEAR(wrapAngle(passage.heading - turn * kDegree), 0.0, 1.0 * kDegree);
    }
    EXPECT_GE(count, 1) << turn;
    EXPECT_LE(count, 3) << turn;
  }
}

TEST(Passages, MeetOnALanding) {
  std::vector<SceneObject> objects = stairs(4, 0.17, 0.29);
  const double edge = 4 * 0.29, level = 5 * 0.17;
  objects.push_back(makeObject("landing", Box{{1.2, 2, level}}, {edge + 0.6, 0, 0.5 * level}));
  for (SceneObject step : stairs(4, 0.17, 0.29)) {
    step.X_WO.translation() += Eigen::Vector3d(edge + 1.2, 0, level);
    objects.push_back(step);
  }
  objects.push_back(makeObject("upper", Box{{3, 3, 0.2}}, {2 * edge + 2.7, 0, 2 * level - 0.1}));
  objects.push_back(floorSlab());
  bool first = false, second = false;
  for (const Passage& passage : passagesOf(objects)) {
    const bool to_landing = std::abs(passage.high.z() - level) < 0.01;
    const bool from_landing = std::abs(passage.low.z() - level) < 0.01;
    first = first || to_landing;
    second = second || from_landing;
    if (to_landing) {
      EXPECT_NEAR(passage.high.x(), edge + 0.6, 0.1);
    }
    if (from_landing) {
      EXPECT_NEAR(passage.low.x(), edge + 0.6, 0.1);
    }
  }
  EXPECT_TRUE(first && second);
}

TEST(Passages, LeadUpRampsAndKerbs) {
  SceneObject ramp = makeObject("ramp", Box{{4, 2, 0.02}}, {0, 0, 0.34});
  ramp.X_WO.linear() = expRotation({0, -10 * kDegree, 0}).toRotationMatrix();
  const double end = 2.0 * std::cos(10 * kDegree), top = 0.34 + 2.0 * std::sin(10 * kDegree);
  const SceneObject upper = makeObject("upper", Box{{3, 3, 0.1}}, {end + 1.5, 0, top - 0.04});
  ASSERT_FALSE(passagesOf({floorSlab(), ramp, upper}).empty());
  EXPECT_NEAR(passagesOf({floorSlab(), ramp, upper})[0].heading, 0.0, 1.0 * kDegree);
  const auto kerbs = passagesOf({floorSlab(), makeObject("kerb", Box{{4, 4, 0.12}}, {3, 3, 0.06})});
  ASSERT_FALSE(kerbs.empty());
  for (const Passage& passage : kerbs) EXPECT_NEAR(passage.high.z() - passage.low.z(), 0.12, 1e-9);
}

TEST(Passages, BeginAndEndOnLevelGroundTheLowerFirst) {
  std::vector<SceneObject> objects = stairs(6, 0.16, 0.3);
  objects.push_back(makeObject("upper", Box{{3, 4, 0.2}}, {6 * 0.3 + 1.5, 0, 7 * 0.16 - 0.1}));
  objects.push_back(makeObject("kerb", Box{{3, 3, 0.12}}, {-5, 4, 0.06}));
  objects.push_back(floorSlab());
  const Scene scene = sceneOf(objects);
  const SceneGround ground(scene);
  const auto passages = findPassages(ground);
  ASSERT_GE(passages.size(), 2u);
  for (size_t i = 0; i < passages.size(); ++i) {
    const Passage& passage = passages[i];
    EXPECT_LT(passage.low.z(), passage.high.z());
    if (i > 0) {
      EXPECT_GE(passage.low.z(), passages[i - 1].low.z() - 1e-9);
    }
    const Eigen::Vector3d way = passage.high - passage.low;
    EXPECT_NEAR(wrapAngle(passage.heading - std::atan2(way.y(), way.x())), 0.0, 1e-6);
    for (const Eigen::Vector3d& end : {passage.low, passage.high}) {
      const auto under = ground.surface(end.x(), end.y(), end.z(), 0.01);
      ASSERT_TRUE(under.has_value());
      EXPECT_NEAR(under->height, end.z(), 1e-9);
      EXPECT_NEAR(under->normal.z(), 1.0, 1e-9);
    }
  }
}

TEST(Passages, LeadUpNoLedgeThatIsHigherThanAStep) {
  for (const auto& [rise, leads] : {std::pair{0.2, true}, std::pair{0.5, false}}) {
    const auto passages = passagesOf(
        {floorSlab(), makeObject("ledge", Box{{4, 4, rise}}, {3, 3, rise / 2}, Role::kGround)});
    EXPECT_EQ(!passages.empty(), leads) << rise;
  }
}

TEST(Passages, AreTheSameTwice) {
  std::vector<SceneObject> objects = stairs(5, 0.17, 0.29);
  objects.push_back(makeObject("upper", Box{{3, 3, 0.2}}, {5 * 0.29 + 1.5, 0, 6 * 0.17 - 0.1}));
  objects.push_back(floorSlab());
  const auto once = passagesOf(objects), again = passagesOf(objects);
  ASSERT_EQ(once.size(), again.size());
  for (size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].low, again[i].low);
    EXPECT_EQ(once[i].high, again[i].high);
  }
}

}  // namespace
}  // namespace amble
