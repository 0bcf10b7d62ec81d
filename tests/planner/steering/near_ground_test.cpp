#include "planner/steering/near_ground.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/sample_stream.h"
#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

constexpr double kStepOfNear = 1.0, kLeanOut = 0.25;  // [m]
constexpr double kOfSquares = 0.3;                    // that the grid adds to it, at most [m]

struct NearFloor {
  explicit NearFloor(const std::vector<SceneObject>& objects) : scene(sceneOf(objects)) {}
  bool has(double x, double y) const { return near.has({x, y}); }

  Scene scene;
  SceneGround ground{scene};
  ReachedGround reached{ground, {0, 0, 0}, kStepOfNear};
  NearGround near{ground, reached, kStepOfNear, kLeanOut};
};

// Of 6 by 4 m about the origin.
SceneObject nearFloorObject() { return makeObject("floor", Box{{6, 4, 0.1}}, {0, 0, -0.05}); }

TEST(NearGround, IsAllGroundAndWhatIsAsNearAsBodiesLeanOutAndNothingFarther) {
  const NearFloor near({nearFloorObject()});
  SampleStream stream(1, 0);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d p(stream.uniform(-4, 4), stream.uniform(-3, 3));
    const Eigen::Array2d off = (p.array().abs() - Eigen::Array2d(3, 2)).max(0.0);
    const double distance = off.matrix().norm();
    if (distance <= kLeanOut) {
      EXPECT_TRUE(near.has(p.x(), p.y())) << p.transpose();
    }
    if (distance > kLeanOut + 1e-9) {
      EXPECT_FALSE(near.has(p.x(), p.y())) << p.transpose();
    }
    const double around = stream.uniform(0.0, 0.05);
    EXPECT_EQ(near.near.has(p, around), distance <= kLeanOut + around) << p.transpose();
  }
}

TEST(NearGround, IsOverABreakThatIsSteppedOverAndNotOverAWideOne) {
  const auto floors = [](double apart) {
    return NearFloor(
        {nearFloorObject(), makeObject("beyond", Box{{6, 4, 0.1}}, {6 + apart, 0.3, -0.05})});
  };
  const NearFloor narrow = floors(0.6), wide = floors(2.4);
  for (const double y : {-1.4, 0.0, 1.7}) {
    for (double x = 3.0; x < 3.6; x += 0.05) EXPECT_TRUE(narrow.has(x, y)) << x << ' ' << y;
    EXPECT_FALSE(wide.has(4.2, y)) << y;
  }
}

// The top of a wall that is as large as a floor is none that steps lead to.
TEST(NearGround, IsNotOnTopOfWallsBeyondTheFloor) {
  const NearFloor near({nearFloorObject(), makeObject("wall", Box{{1, 10, 2.5}}, {0, 0, 1.25})});
  EXPECT_TRUE(near.has(0, 0)) << "between two parts of the floor";
  for (const double y : {2.0 + kLeanOut + kOfSquares, 4.5, -4.5}) EXPECT_FALSE(near.has(0, y)) << y;
}

// A floor's triangles go on under what stands on it: beyond an edge the nearest of them is no
// ground where that is a wall's end, but the floor beside the wall is.
TEST(NearGround, IsBesideTheEndOfAWallWhatIsNearTheFloorBesideIt) {
  constexpr double kWest = -3.0, kEast = 3.0, kEdge = 2.0;
  for (const double thick : {0.1, 0.4, 0.8, 1.5}) {
    for (const double middle : {0.0, 0.03, 0.07}) {
      const NearFloor near({nearFloorObject(),
                            makeObject("wall", Box{{thick, 2.0 * kEdge, 2.5}}, {middle, 0, 1.25})});
      const auto distance = [&](const Eigen::Vector2d& p, double west, double east) {
        return std::hypot(std::max({west - p.x(), p.x() - east, 0.0}), p.y() - kEdge);
      };
      SampleStream stream(1, 0);
      for (int i = 0; i < 500; ++i) {
        const Eigen::Vector2d p(stream.uniform(-1.2, 1.2), stream.uniform(kEdge, kEdge + kLeanOut));
        if (std::min(distance(p, kWest, middle - 0.5 * thick),
                     distance(p, middle + 0.5 * thick, kEast)) <= kLeanOut) {
          EXPECT_TRUE(near.has(p.x(), p.y())) << thick << ' ' << middle << ": " << p.transpose();
        }
      }
    }
  }
}

}  // namespace
}  // namespace amble
