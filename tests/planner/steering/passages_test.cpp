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

}  // namespace
}  // namespace amble
