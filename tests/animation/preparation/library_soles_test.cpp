#include "animation/preparation/library_soles.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "animation/body/foot_shape.h"
#include "animation/body/rest_feet.h"
#include "animation/library/motion_library_reader.h"
#include "animation/preparation/motion_library_add.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "base/rotation.h"
#include "tests/animation/captures.h"

namespace amble {
namespace {

double ankleOverSole(const MotionLibrary& library) { return library.feet()[kLeft].ankle_height; }

/// Heights of the root, which are over the floor, over the ankles of feet that stand.
std::vector<double> overAnkles(const MotionLibrary& library) {
  std::vector<double> heights;
  for (const Motion& motion : library.motions) {
    switch (motion.kind) {
      case MotionKind::kWalk:
      case MotionKind::kMovement:
        heights.push_back(motion.cycle.series.alpha(2, 0));
        break;
      case MotionKind::kPosture:
      case MotionKind::kBlocking:
        heights.push_back(motion.posture.root_height);
        break;
      case MotionKind::kStart:
      case MotionKind::kStop:
        heights.push_back(motion.transition.sequence.spline.row(2).mean());
        break;
      case MotionKind::kTurnOnSpot:
        heights.push_back(motion.turn.spline.row(2).mean());
        break;
    }
    heights.back() -= ankleOverSole(library);
  }
  return heights;
}

MotionRequest soleWalk(const std::string& clip, bool mirrored = false) {
  MotionRequest request;
  request.name = mirrored ? "walk-mirrored" : "walk";
  request.file = sharedFolder() / "mocap" / clip;
  request.source = {"clip", {0, 0}, mirrored, "none", "none"};
  return request;
}

TEST(LibrarySoles, FeetDropAsThoseOfTheWalksInTheMeanAndRootsStayOverTheAnkles) {
  MotionLibrary library = openMotionLibrary("default");
  const std::vector<double> before = overAnkles(library);
  int walks = 0;
  for (Motion& motion : library.motions) {
    if (motion.kind != MotionKind::kWalk) continue;
    motion.cycle.foot_drops.reset();
    if (!motion.turning && walks++ < 2)
      motion.cycle.foot_drops = {(20.0 + 4.0 * walks) * kDegree, (30.0 - 6.0 * walks) * kDegree};
  }
  settleSoles(library);
  const std::array<double, 2> drops = footDrops(library.skeleton, library.roles);
  EXPECT_NEAR(drops[kLeft], 26.0 * kDegree, 1e-9);
  EXPECT_NEAR(drops[kRight], 21.0 * kDegree, 1e-9);
  for (Motion& motion : library.motions)
    if (motion.name == "turn-left") motion.cycle.foot_drops = {16.0 * kDegree, 31.0 * kDegree};
  settleSoles(library);
  const std::array<double, 2> with_turn = footDrops(library.skeleton, library.roles);
  EXPECT_NEAR(with_turn[kLeft], 20.0 * kDegree, 1e-9);
  EXPECT_NEAR(with_turn[kRight], 27.0 * kDegree, 1e-9);
  const std::vector<double> after = overAnkles(library);
  for (size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i], before[i], 1e-9) << i;
}

TEST(LibrarySoles, ALibraryThatNobodyWalkedInOnItsRigStaysAsItIs) {
  MotionLibrary library = openMotionLibrary("default");
  for (Motion& motion : library.motions) motion.cycle.foot_drops.reset();
  const Skeleton skeleton = library.skeleton;
  settleSoles(library);
  for (int j = 0; j < skeleton.size(); ++j)
    EXPECT_EQ(library.skeleton.joint(j).offset, skeleton.joint(j).offset);
}

// The person whose standing feet the markers tilt most differently: as captured they stand in the
// library's walk, and nothing of them below the floor.
TEST(LibrarySoles, APlantedFootIsTurnedAsTheCapturedOneStands) {
  AMBLE_NEEDS_CAPTURES();
  MotionLibrary library;
  addMotion(library, soleWalk("accad_male1/Male1_B3_Walk.bvh"));
  const std::array<double, 2> drops = *library.find("walk")->cycle.foot_drops;
  EXPECT_GT(drops[kLeft] - drops[kRight], 5.0 * kDegree);
  const FlatGround ground;
  const WalkSynthesizer walker(library, ground, {});
  Stance from, to;
  to.position.x() = 4.0;
  const RootPath path({makeBezier(from.position.head<2>(), 0.0, to.position.head<2>(), 0.0)});
  AnimationBuffer walk;
  ASSERT_EQ(walker.walk(from, to, path, true, walk).refused, WalkRule::kNone);
  std::vector<JointFrame> joints(library.skeleton.size());
  for (int i = 0; i < walk.size(); ++i) {
    forwardKinematics(library.skeleton, walk.poses[i], joints);
    for (const Side side : {kLeft, kRight}) {
      const LegJoints& leg = library.roles.legs[side];
      const Eigen::Vector3d toe = joints[leg.toe].p_WJ;
      EXPECT_GT(toe.z(), 0.0) << i;
      EXPECT_GT((joints[leg.toe] * library.skeleton.joint(leg.toe).end_sites[0]).z(), 0.0) << i;
      const FootState& foot = walk.states[i].feet[side];
      if (std::abs(foot.at - FootCycle::kFlat) > 0.7 * FootCycle::kFlatFor) continue;
      const Eigen::Vector3d bone = toe - joints[leg.foot].p_WJ;
      EXPECT_NEAR(std::atan2(-bone.z(), bone.head<2>().norm()), drops[side], 0.2 * kDegree) << i;
    }
  }
}

// A walk and its mirror image stand on soles that are the mirror of each other: together the
// library has both feet alike. And a walk is the same whatever the library stood on when it came.
TEST(LibrarySoles, MirrorImagesMakeBothFeetAlikeAndWalksAreThoseOfTheirOwnSoles) {
  AMBLE_NEEDS_CAPTURES();
  const std::string clip = "accad_female1/Female1_B03_Walk1.bvh";
  MotionLibrary alone, both;
  addMotion(alone, soleWalk(clip));
  addMotion(both, soleWalk(clip));
  addMotion(both, soleWalk(clip, true));
  const std::array<double, 2> drops = footDrops(both.skeleton, both.roles);
  EXPECT_NEAR(drops[kLeft], drops[kRight], 1e-4);
  EXPECT_EQ(both.feet()[kLeft].ankle_height, both.feet()[kRight].ankle_height);
  MotionLibrary after = both;
  std::erase_if(after.motions, [](const Motion& motion) { return motion.name == "walk"; });
  addMotion(after, soleWalk(clip));
  const WalkCycle &one = alone.find("walk")->cycle, &same = after.find("walk")->cycle;
  for (const Side side : {kLeft, kRight}) {
    EXPECT_NEAR((*one.foot_drops)[side], (*same.foot_drops)[side], 1e-4);
    for (size_t i = 0; i < one.feet[side].pitch.size(); ++i)
      EXPECT_NEAR(one.feet[side].pitch[i], same.feet[side].pitch[i], 1e-4) << i;
  }
}

}  // namespace
}  // namespace amble
