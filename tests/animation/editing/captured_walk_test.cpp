#include "animation/editing/captured_walk.h"

#include <gtest/gtest.h>

#include "animation/captures/capture_checks.h"
#include "animation/clips/floor_fit.h"
#include "base/error.h"
#include "base/rotation.h"
#include "tests/animation/editing/edited_walks.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

TEST(CapturedWalk, WalksAreWalksAndOthersSayWhatTheyAre) {
  AMBLE_NEEDS_CAPTURES();
  const std::array<std::pair<std::string, std::string>, 7> said = {{
      {"mocap/accad_female1/Female1_B03_Walk1.bvh", ""},
      {"mocap/accad_female1/Female1_B05_WalkBackwards.bvh", ""},
      {"mocap/accad_male1/Male1_B1_StandToWalk.bvh", ""},
      {"mocap/cmu_mb2/01_01.bvh", "is a jump for"},
      {"mocap/cmu_mb2/02_03.bvh", "is a run for 100 %"},
      {"mocap/accad_female1/Female1_A01_Stand.bvh", "stands for 100 %"},
      {"mocap/cmu_style_loops/120_08_EDIT_LOOP.bvh", "shows 0 whole steps"},
  }};
  for (const auto& [path, why] : said) {
    const std::string found = whyNoWalk(capturedWalk(path));
    EXPECT_EQ(found.substr(0, why.size()), why) << path;
    EXPECT_EQ(found.empty(), why.empty()) << path << ": " << found;
  }
}

TEST(CapturedWalk, AReferencePoseAtTheBeginIsCutOff) {
  AMBLE_NEEDS_CAPTURES();
  const CapturedWalk walk = capturedWalk("mocap/cmu_mb2/07_03.bvh");
  EXPECT_EQ(walk.first_frame, 1);  // as MANIFEST says
  EXPECT_EQ(walk.clip.frames(), 415);
}

TEST(CapturedWalk, TheFloorIsLevelled) {
  AMBLE_NEEDS_CAPTURES();
  const std::string path = "mocap/cmu_mb2/09_12.bvh";  // all over the room, tilted by 0.4 degrees
  const CapturedMotion motion = readMotion(sharedFolder() / path);
  EXPECT_GT(fitFloor(motion.clip, motion.roles).tilt(), 0.005);
  const CapturedWalk walk = capturedWalk(path);
  EXPECT_LT(fitFloor(walk.clip, walk.roles).tilt(), 0.0005);
}

// Of straight walks the fit would find a floor across the way in how high either foot stands.
TEST(CapturedWalk, WhatIsLevelStaysWhereItIs) {
  AMBLE_NEEDS_CAPTURES();
  for (const char* path :
       {"mocap/cmu_mb2/07_01.bvh", "mocap/cmu_mb2/08_01.bvh", "mocap/cmu_mb2/09_12.bvh",
        "mocap/accad_male1/Male1_B3_Walk.bvh", "mocap/accad_female1/Female1_B05_WalkBackwards.bvh",
        "mocap/accad_female1/Female1_B22_SideStepLeft.bvh"}) {
    const CapturedWalk walk = capturedWalk(path);
    CapturedMotion motion;
    motion.clip = walk.clip;
    motion.roles = walk.roles;
    const CapturedWalk again = captureWalk(motion, path);
    ASSERT_EQ(again.clip.frames(), walk.clip.frames()) << path;
    for (int i = 0; i < walk.clip.frames(); ++i) {
      EXPECT_LT((again.clip.poses.p_WR(i) - walk.clip.poses.p_WR(i)).norm(), 5e-4) << path;
      EXPECT_LT(again.clip.poses.rotations(i)[0].angularDistance(walk.clip.poses.rotations(i)[0]),
                0.01 * kDegree)
          << path;
    }
  }
}

TEST(CapturedWalk, NoJointIsSmoothedHoweverNoisy) {
  AMBLE_NEEDS_CAPTURES();
  const std::string path = "mocap/accad_male1/Male1_B3_Walk.bvh";
  CapturedMotion motion = readMotion(sharedFolder() / path);
  Generator generator(1);
  for (int i = 0; i < motion.clip.frames(); ++i) {
    for (Eigen::Quaterniond& q : motion.clip.poses.rotations(i)) {
      q = q * expRotation(randomVector(generator, 0.05));
    }
  }
  ASSERT_GT(jointJitter(motion.clip), kNoisy);
  const Clip before = motion.clip;
  const CapturedWalk walk = captureWalk(motion, path);
  for (int i = 0; i < walk.clip.frames(); i += 20) {
    const auto noisy = before.poses.rotations(i + walk.first_frame);
    const auto after = walk.clip.poses.rotations(i);
    for (int j = 1; j < walk.clip.skeleton.size(); ++j) {
      EXPECT_EQ(after[j].coeffs(), noisy[j].coeffs());
    }
  }
}

TEST(CapturedWalk, AFileWithoutAFrameIsNamed) {
  CapturedMotion motion;
  motion.clip.skeleton = Skeleton({Joint{}});
  motion.clip.poses = PoseArray(1);
  try {
    captureWalk(motion, "empty.bvh");
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("empty.bvh: holds no frames"), std::string::npos);
  }
}

}  // namespace
}  // namespace amble
