#include "animation/clips/good_frames.h"

#include <gtest/gtest.h>

#include <cmath>

#include "animation/captures/bvh.h"
#include "tests/animation/captures.h"

namespace amble {
namespace {

// Two joints that swing for two seconds at 60 frames a second.
Clip swinging() {
  std::vector<Joint> joints(2);
  joints[0].name = "a", joints[1].name = "b";
  joints[1].parent = 0;
  joints[1].offset = {0.0, 0.4, 0.0};
  Clip clip{"swinging", Skeleton(joints), 1.0 / 60.0, PoseArray(2), {}};
  clip.poses.resize(120);
  for (int i = 0; i < 120; ++i) {
    const double angle = 0.5 * std::sin(0.1 * i);
    for (Eigen::Quaterniond& q : clip.poses.rotations(i)) {
      q = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX());
    }
  }
  return clip;
}

void setFrame(Clip& clip, int frame, double angle) {
  for (Eigen::Quaterniond& q : clip.poses.rotations(frame)) {
    q = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX());
  }
}

TEST(GoodFrames, AMotionWithoutFaultIsGoodAsAWhole) {
  const GoodFrames good = goodFrames(swinging());
  EXPECT_EQ(good.first, 0);
  EXPECT_EQ(good.last, 119);
}

TEST(GoodFrames, AReferencePoseAtTheStartIsLeftOut) {
  Clip clip = swinging();
  setFrame(clip, 0, 1.5);
  EXPECT_EQ(goodFrames(clip).first, 1);
}

TEST(GoodFrames, FrozenFramesAfterTheReferencePoseAreLeftOut) {
  Clip clip = swinging();
  for (int i = 0; i < 3; ++i) setFrame(clip, i, 1.5);
  for (int i = 3; i < 7; ++i) setFrame(clip, i, 0.5 * std::sin(0.7));
  EXPECT_EQ(goodFrames(clip).first, 7);
}

TEST(GoodFrames, WhereTheRootJumpsTheLongestStretchIsKept) {
  Clip clip = swinging();
  for (int i = 0; i < 120; ++i) clip.poses.p_WR(i).x() = 0.02 * i + (i >= 40 ? 1.5 : 0.0);
  const GoodFrames good = goodFrames(clip);
  EXPECT_EQ(good.first, 40);
  EXPECT_EQ(good.last, 119);
}

TEST(GoodFrames, AClipTooShortToJudgeIsTakenAsItIs) {
  Clip clip = trimmed(swinging(), 0, 20);
  setFrame(clip, 0, 1.5);
  EXPECT_EQ(goodFrames(clip).first, 0);
}

TEST(GoodFrames, TrimmingKeepsThePosesOfItsFrames) {
  const Clip clip = swinging();
  const Clip part = trimmed(clip, 10, 19);
  ASSERT_EQ(part.frames(), 10);
  EXPECT_EQ(part.poses.rotations(3)[1].coeffs(), clip.poses.rotations(13)[1].coeffs());
}

// The manifest's own count of bad frames: where a slide out of a reference pose ends is a matter of
// a frame or two.
TEST(GoodFrames, StartsOfCapturesAreFoundWhereTheManifestHasThem) {
  AMBLE_NEEDS_CAPTURES();
  for (const Capture& capture : captures()) {
    EXPECT_NEAR(
        goodFrames(readBvh(capture.file, {.metres_per_unit = capture.metres_per_unit})).first,
        capture.skip, 2)
        << capture.path;
  }
}

}  // namespace
}  // namespace amble
