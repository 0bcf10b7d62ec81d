#include "animation/clips/level_capture.h"

#include <gtest/gtest.h>

#include "animation/clips/foot_paths.h"
#include "base/rotation.h"
#include "tests/animation/captures.h"
#include "tests/animation/moved_clip.h"

namespace amble {
namespace {

std::filesystem::path file() {
  return sharedFolder() / "mocap/accad_female1/Female1_B03_Walk1.bvh";
}

CapturedMotion capture() { return readMotion(file()); }

// The lowest that each foot's toe and ankle come to [m].
std::array<double, 4> lowest(const Clip& clip, const JointRoles& roles) {
  std::array<double, 4> low;
  for (const Side side : {kLeft, kRight}) {
    const Eigen::MatrixXd path = footPaths(clip, roles)[side];
    low[2 * side] = path.col(2).minCoeff(), low[2 * side + 1] = path.col(5).minCoeff();
  }
  return low;
}

TEST(LevelCapture, AClipIsLevelledTheSameFromWhateverHeight) {
  AMBLE_NEEDS_CAPTURES();
  const CapturedMotion motion = capture();
  const auto low = lowest(levelled(motion.clip, motion.roles), motion.roles);
  const Clip lifted = moved(motion.clip, Eigen::Quaterniond::Identity(), {0.0, 0.0, 0.4});
  const auto same = lowest(levelled(lifted, motion.roles), motion.roles);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(same[i], low[i], 1e-6);
}

// Two degrees under a walk of four metres are 0.14 m.
TEST(LevelCapture, ATiltedFloorIsLevelled) {
  AMBLE_NEEDS_CAPTURES();
  const CapturedMotion motion = capture();
  const auto low = lowest(levelled(motion.clip, motion.roles), motion.roles);
  for (const Eigen::Vector3d axis : {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()}) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(2.0 * kDegree, axis));
    FloorFit fit;
    const Clip level =
        levelled(moved(motion.clip, turn, Eigen::Vector3d::Zero()), motion.roles, &fit);
    const auto same = lowest(level, motion.roles);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(same[i], low[i], 0.003) << axis.transpose();
  }
}

TEST(LevelCapture, SaysWithWhichFrameOfTheFileItBegins) {
  AMBLE_NEEDS_CAPTURES();
  const LevelCapture level = readLevelCapture(file());
  const Clip whole = capture().clip;
  ASSERT_GE(level.first_frame, 0);
  ASSERT_LE(level.first_frame + level.motion.clip.frames(), whole.frames());
  for (int j = 1; j < whole.skeleton.size(); ++j) {  // the root is levelled, joints are not touched
    EXPECT_LT(level.motion.clip.poses.rotations(0)[j].angularDistance(
                  whole.poses.rotations(level.first_frame)[j]),
              1e-9);
  }
}

}  // namespace
}  // namespace amble
