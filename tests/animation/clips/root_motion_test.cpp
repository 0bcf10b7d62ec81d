#include "animation/clips/root_motion.h"

#include <gtest/gtest.h>

#include "tests/animation/planted_clip.h"

namespace amble {
namespace {

// Turned by far more than half a turn, so that headings have to be followed.
const GroundShift kElsewhere{2.9, {-4.0, 11.0}};

TEST(RootMotion, StepsAddedUpFromElsewhereAreTheMotionMovedThere) {
  AMBLE_NEEDS_CAPTURES();
  const PlantedClip turn = plantedClip("accad_female1/Female1_B15_WalkTurnAround180.bvh");
  const int last = turn.clip.frames() - 1;
  const RootMotion motion = rootMotion(turn.clip, turn.roles, 0, last);
  Clip moved = turn.clip, rebuilt = turn.clip;
  moveRoot(moved.poses, 0, last, kElsewhere);
  RootPlace place = rootMotion(moved, turn.roles, 0, 0).places[0];
  for (int i = 0; i <= last; ++i) {
    placeRoot(rebuilt.poses, i, place, motion.carriages[i]);
    if (i < last) place = advanced(place, motion.step(i));
    ASSERT_LT((rebuilt.poses.p_WR(i) - moved.poses.p_WR(i)).norm(), 1e-9) << i;
    ASSERT_LT(rebuilt.poses.rotations(i)[0].angularDistance(moved.poses.rotations(i)[0]), 1e-7);
  }
}

TEST(RootMotion, TheShiftBetweenTwoPlacesTakesTheOneToTheOther) {
  const RootPlace from{{3.0, -1.0}, 0.4}, to{{-2.0, 5.0}, -2.5};
  const GroundShift shift = between(from, to);
  const Eigen::Vector3d ahead(from.at.x() + std::cos(0.4), from.at.y() + std::sin(0.4), 0.7);
  const Eigen::Vector3d expected(to.at.x() + std::cos(-2.5), to.at.y() + std::sin(-2.5), 0.7);
  EXPECT_LT((shift * ahead - expected).norm(), 1e-12);
}

}  // namespace
}  // namespace amble
