#include "animation/captures/root_at_hips.h"

#include <gtest/gtest.h>

#include <sstream>

#include "animation/captures/motion_reader.h"
#include "base/rotation.h"
#include "tests/animation/person.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

/// A walk below a reference that stands turned and moved and does not move: the hips carry it.
Clip belowAReference(const Clip& walk) {
  std::vector<Joint> joints = walk.skeleton.joints();
  for (Joint& joint : joints) ++joint.parent;
  Joint reference;
  reference.name = "Reference";
  joints.insert(joints.begin(), reference);
  Clip clip{walk.name, Skeleton(joints), walk.frame_time, PoseArray(walk.skeleton.size() + 1), {}};
  clip.poses.resize(walk.frames());
  const Eigen::Quaterniond q_WR = aboutZ(0.7) * yUpToWorld();
  const Eigen::Vector3d p_WR(1.0, -2.0, 0.0);
  for (int i = 0; i < walk.frames(); ++i) {
    const auto from = walk.poses.rotations(i);
    const auto to = clip.poses.rotations(i);
    clip.poses.p_WR(i) = p_WR;
    to[0] = q_WR;
    std::copy(from.begin(), from.end(), to.begin() + 1);
    to[1] = q_WR.conjugate() * from[0];
    clip.joint_positions.emplace_back(0, 0, 0);
    clip.joint_positions.push_back(q_WR.conjugate() * (walk.poses.p_WR(i) - p_WR));
    for (int j = 1; j < walk.skeleton.size(); ++j) {
      clip.joint_positions.push_back(walk.skeleton.joint(j).offset);
    }
  }
  return clip;
}

JointRoles rolesOf(const Clip& clip) { return rolesByName(clip.skeleton); }

TEST(RootAtHips, AWalkIsLeftAsItIs) {
  Clip walk = walkingPerson();
  JointRoles roles = rolesOf(walk);
  EXPECT_FALSE(rootAtHips(walk, roles));
  EXPECT_EQ(walk.skeleton.size(), walkingPerson().skeleton.size());
}

TEST(RootAtHips, HipsThatCarryTheMotionBecomeTheRoot) {
  const Clip walk = walkingPerson();
  Clip clip = belowAReference(walk);
  JointRoles roles = rolesOf(clip);
  ASSERT_TRUE(rootAtHips(clip, roles));
  EXPECT_EQ(roles.hips, 0);
  EXPECT_EQ(clip.skeleton.joint(roles.head).name, "Head");
  ASSERT_EQ(clip.skeleton.size(), walk.skeleton.size());
  for (int i = 0; i < walk.frames(); ++i) {
    const std::vector<JointFrame> a = jointFrames(walk, i), b = jointFrames(clip, i);
    for (size_t j = 0; j < a.size(); ++j) EXPECT_LT((a[j].p_WJ - b[j].p_WJ).norm(), 1e-9);
  }
}

/// A BVH whose root stands still and whose hips have six channels.
std::string bvhBelowAReference(const Clip& walk) {
  std::ostringstream out;
  writeBvh(out, walk);
  std::string text = out.str();
  const size_t root = text.find("ROOT "), motion = text.find("MOTION");
  text.insert(motion, "}\n");
  text.replace(root, 5,
               "ROOT Reference\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nJOINT ");
  size_t line = text.find('\n', text.find("Frame Time:")) + 1;
  while (line < text.size()) {
    text.insert(line, "0 0 0 ");
    line = text.find('\n', line) + 1;
  }
  return text;
}

TEST(RootAtHips, ABvhBelowAReferenceKeepsItsTravel) {
  const TestFolder folder;
  const Clip walk = walkingPerson();
  const CapturedMotion motion = readMotion(folder.write("walk.bvh", bvhBelowAReference(walk)));
  EXPECT_EQ(motion.clip.skeleton.joint(0).name, "Hips");
  EXPECT_TRUE(motion.clip.joint_positions.empty());
  const int last = walk.frames() - 1;
  EXPECT_LT((motion.clip.poses.p_WR(last) - walk.poses.p_WR(last)).norm(), 1e-5);
}

}  // namespace
}  // namespace amble
