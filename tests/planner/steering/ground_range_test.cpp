#include "planner/steering/ground_range.h"

#include <gtest/gtest.h>

#include "environments/ground/ground_cells.h"
#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

// A floor of 8 x 6 m about the origin, and a platform on its east side, from x = 1.
Scene platformScene(double height) {
  return sceneOf({makeObject("floor", Box{{8, 6, 0.1}}, {0, 0, -0.05}),
                  makeObject("platform", Box{{3, 6, height}}, {2.5, 0, 0.5 * height})});
}

TEST(GroundRange, HoldsWhatIsWithinReachAndNothingHigherThatIsMuchFarther) {
  const double height = 0.2, far = 0.8, slack = 0.3;  // squares of 0.1 m
  const Scene scene = platformScene(height);
  const SceneGround ground(scene);
  const ReachedGround all(ground, {0.0, 0.0, 50.0}, 1.0);  // nobody stands there
  const GroundRange range(ground, all, far);
  ASSERT_TRUE(range.isKnown());
  for (double x = -3.0; x < 3.5; x += 0.07) {
    const Eigen::AlignedBox1d around = range.around({x, 0.3});
    ASSERT_FALSE(around.isEmpty()) << x;
    if (x - far < 1.0) {
      EXPECT_NEAR(around.min()[0], 0.0, 1e-6) << x;
    }
    if (x + far > 1.0) {
      EXPECT_NEAR(around.max()[0], height, 1e-6) << x;
    }
    if (x + far + slack < 1.0) {
      EXPECT_NEAR(around.max()[0], 0.0, 1e-6) << x;
    }
  }
  EXPECT_TRUE(range.around({9, 9}).isEmpty());
}

TEST(GroundRange, OfGroundInSeveralLayersNothingIsKnown) {
  Scene scene = platformScene(0.2);
  scene.objects.push_back(makeObject("gallery", Box{{8, 6, 0.1}}, {0, 0, 2.95}, Role::kGround));
  const SceneGround ground(scene);
  ASSERT_GE(ground.cells().layers(), 2);
  EXPECT_FALSE(GroundRange(ground, ReachedGround(ground, {0.0, 0.0, 50.0}, 1.0), 0.8).isKnown());
}

}  // namespace
}  // namespace amble
