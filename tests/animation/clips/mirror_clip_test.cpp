#include "animation/clips/mirror_clip.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "tests/animation/random_clip.h"
#include "tests/animation/rig.h"

namespace amble {
namespace {

TEST(MirrorClip, AMirroredClipsJointsAreTheMirrorImageOfTheOtherSides) {
  const Rig rig;  // its legs are alike
  const Clip clip = rig.walk(onACircle()), mirrored = mirrorClip(clip, rig.roles);
  for (int frame = 0; frame < clip.frames(); frame += 37) {
    const auto joints = jointFrames(clip, frame), images = jointFrames(mirrored, frame);
    for (int j = 0; j < clip.skeleton.size(); ++j) {
      const int other = j == 0 || j == 9 ? j : j <= 4 ? j + 4 : j - 4;
      const Eigen::Vector3d& p = joints[other].p_WJ;
      EXPECT_LT((images[j].p_WJ - Eigen::Vector3d(p.x(), -p.y(), p.z())).norm(), 1e-12);
    }
  }
}

TEST(MirrorClip, TwiceMirroredIsTheClipItself) {
  Generator generator(81);
  const Rig rig;
  Clip clip = rig.walk(onACircle());
  for (int frame = 0; frame < clip.frames(); ++frame) {
    for (Eigen::Quaterniond& q : clip.poses.rotations(frame)) q = randomRotation(generator);
  }
  const Clip twice = mirrorClip(mirrorClip(clip, rig.roles), rig.roles);
  for (int frame = 0; frame < clip.frames(); frame += 50) {
    EXPECT_LT((twice.poses.p_WR(frame) - clip.poses.p_WR(frame)).norm(), 1e-12);
    for (int j = 0; j < clip.skeleton.size(); ++j) {
      EXPECT_LT(twice.poses.rotations(frame)[j].angularDistance(clip.poses.rotations(frame)[j]),
                1e-7);
    }
  }
}

}  // namespace
}  // namespace amble
