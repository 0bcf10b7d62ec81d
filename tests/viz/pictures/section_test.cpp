#include "viz/pictures/section.h"

#include <gtest/gtest.h>

#include "tests/viz/test_walk.h"

namespace amble {
namespace {

Scene sceneOfBox() {
  Scene scene;
  scene.objects = {testBox("box", {0.4, 2.0, 0.6}, {3, 0, 0.3})};
  return scene;
}

TEST(SceneSection, OfABoxIsItsOutline) {
  const Scene scene = sceneOfBox();
  const auto lines = SceneSection(scene).cut({1, 0.1, 5}, Eigen::Vector3d::UnitX(), 10.0);
  double length = 0.0;
  for (const SectionLine& line : lines) {
    for (const Eigen::Vector2d& p : {line.from, line.to}) {
      EXPECT_TRUE(std::abs(std::abs(p.x() - 2.0) - 0.2) < 1e-9 || p.y() < 1e-9 ||
                  std::abs(p.y() - 0.6) < 1e-9)
          << p.transpose();
    }
    length += (line.to - line.from).norm();
  }
  EXPECT_NEAR(length, 2 * (0.4 + 0.6), 1e-9);
}

TEST(SceneSection, AlongIsToTheSideThatWasAsked) {
  const Scene scene = sceneOfBox();
  for (const SectionLine& line :
       SceneSection(scene).cut({3, 5, 0}, -Eigen::Vector3d::UnitY(), 10.0)) {
    EXPECT_GE(std::min(line.from.x(), line.to.x()), 4.0 - 1e-9);
    EXPECT_LE(std::max(line.from.x(), line.to.x()), 6.0 + 1e-9);
  }
}

TEST(SceneSection, IsEmptyBesideThingsAndBeyondItsReach) {
  const Scene scene = sceneOfBox();
  EXPECT_TRUE(SceneSection(scene).cut({1, 1.1, 0}, Eigen::Vector3d::UnitX(), 10.0).empty());
  EXPECT_TRUE(SceneSection(scene).cut({1, 0, 0}, Eigen::Vector3d::UnitX(), 1.5).empty());
}

}  // namespace
}  // namespace amble
