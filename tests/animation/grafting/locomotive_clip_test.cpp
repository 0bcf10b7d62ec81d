#include "animation/grafting/locomotive_clip.h"

#include <gtest/gtest.h>

#include "animation/captures/motion_reader.h"
#include "base/error.h"
#include "base/rotation.h"
#include "tests/animation/captures.h"
#include "tests/animation/moved_clip.h"
#include "tests/environments/test_files.h"

namespace amble {
namespace {

class LocomotiveClips : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    AMBLE_NEEDS_CAPTURES();
    motion = readMotion(sharedFolder() / "mocap" / GetParam());
    seen = locomotiveClip(motion.clip, motion.roles, GetParam());
  }
  CapturedMotion motion;
  LocomotiveClip seen;
};

// Grafting writes the base's own frames: none may be levelled or left out.
TEST_P(LocomotiveClips, KeepEveryFrameUntouched) {
  ASSERT_EQ(seen.clip.frames(), motion.clip.frames());
  for (int i = 0; i < motion.clip.frames(); ++i) {
    EXPECT_EQ(seen.clip.poses.p_WR(i), motion.clip.poses.p_WR(i));
    for (int j = 0; j < motion.clip.skeleton.size(); ++j)
      EXPECT_EQ(seen.clip.poses.rotations(i)[j].coeffs(),
                motion.clip.poses.rotations(i)[j].coeffs());
  }
}

TEST_P(LocomotiveClips, KnowEveryFrameAndNothingOfThoseThatAreNoMotion) {
  ASSERT_EQ(static_cast<int>(seen.kind.frames.size()), motion.clip.frames());
  EXPECT_EQ(seen.plants.frames, motion.clip.frames());
  EXPECT_GE(seen.first, 0);
  EXPECT_LE(seen.first, seen.last);
  EXPECT_LT(seen.last, motion.clip.frames());
  for (int i = 0; i < seen.first; ++i) EXPECT_EQ(seen.kind.frames[i], MotionType::kUnknown);
  for (int i = seen.last + 1; i < motion.clip.frames(); ++i)
    EXPECT_EQ(seen.kind.frames[i], MotionType::kUnknown);
  for (const MotionSegment& segment : seen.kind.segments) {
    EXPECT_GE(segment.first, seen.first);
    EXPECT_LE(segment.last, seen.last);
    for (int i = segment.first; i <= segment.last; ++i)
      EXPECT_EQ(seen.kind.frames[i], segment.type) << i;
  }
  for (const Side side : {kLeft, kRight}) {
    for (const FootPlant& plant : seen.plants.plants[side]) {
      EXPECT_GE(plant.first, seen.first);
      EXPECT_LE(plant.last, seen.last);
    }
  }
}

TEST_P(LocomotiveClips, HaveNoLongerStretchOfOneKindThanTheirs) {
  const MotionStretch best = stretchOf(seen);
  int run = 0;
  for (int i = 0; i < seen.clip.frames(); ++i) {
    const MotionType type = seen.kind.frames[i];
    run = i > 0 && type == seen.kind.frames[i - 1] ? run + 1 : 1;
    if (type != MotionType::kUnknown) {
      EXPECT_LE(run, best.frames()) << i;
    }
  }
  for (int i = best.first; i <= best.last; ++i) EXPECT_EQ(seen.kind.frames[i], best.type);
}

TEST_P(LocomotiveClips, WithinSomeFramesHaveTheStretchOfThose) {
  const std::pair<int, int> within{seen.first + seen.clip.frames() / 4,
                                   seen.last - seen.clip.frames() / 4};
  const MotionStretch best = stretchOf(seen, within);
  if (best.type == MotionType::kUnknown) return;
  EXPECT_GE(best.first, within.first);
  EXPECT_LE(best.last, within.second);
  EXPECT_LE(best.frames(), stretchOf(seen).frames());
}

// Cut to some frames, feet stand at those of them at which they stood.
TEST_P(LocomotiveClips, PlantsWithinAreThePlantsSeenFromThere) {
  const int first = seen.first + 13, last = seen.last - 17;
  const FootPlants within = plantsWithin(seen.plants, first, last);
  EXPECT_EQ(within.frames, last - first + 1);
  for (const Side side : {kLeft, kRight}) {
    for (int i = first; i <= last; ++i)
      EXPECT_EQ(within.planted(side, i - first), seen.plants.planted(side, i)) << i;
  }
  const FootPlants all = plantsWithin(seen.plants, 0, seen.clip.frames() - 1);
  for (const Side side : {kLeft, kRight}) EXPECT_EQ(all.planted(side), seen.plants.planted(side));
}

TEST_P(LocomotiveClips, AreTheSameKindWhereverTheyWereTaken) {
  const Clip there = moved(motion.clip, aboutZ(2.0), {-4.0, 9.0, 0.3});
  const LocomotiveClip gone = locomotiveClip(there, motion.roles, GetParam());
  EXPECT_EQ(gone.first, seen.first);
  EXPECT_EQ(gone.last, seen.last);
  EXPECT_EQ(gone.kind.frames, seen.kind.frames);
}

INSTANTIATE_TEST_SUITE_P(, LocomotiveClips,
                         testing::Values("accad_female1/Female1_B03_Walk1.bvh",
                                         "accad_female1/Female1_C05_WalkToRun.bvh",
                                         "accad_female1/Female1_A01_Stand.bvh", "cmu_mb2/02_01.bvh",
                                         "cmu_mb2/01_01.bvh"));

TEST(LocomotiveClip, WithoutFramesIsRefusedByName) {
  const std::string refused = errorOf([] { locomotiveClip({}, {}, "empty.bvh"); });
  EXPECT_NE(refused.find("empty.bvh"), std::string::npos);
  EXPECT_NE(refused.find("holds no frames"), std::string::npos);
}

TEST(LocomotiveClip, OfNoneOfTheFourKindsHasNoStretch) {
  LocomotiveClip clip;
  clip.clip.poses = PoseArray(1);
  clip.clip.poses.resize(10);
  clip.kind.segments = {{MotionType::kUnknown, 0, 9}};
  EXPECT_EQ(stretchOf(clip).type, MotionType::kUnknown);
  EXPECT_EQ(stretchOf(clip).frames(), 0);
}

}  // namespace
}  // namespace amble
