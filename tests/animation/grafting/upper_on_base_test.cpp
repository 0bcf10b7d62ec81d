#include "animation/grafting/upper_on_base.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "tests/animation/grafting/graft_sources.h"
#include "tests/animation/person.h"

namespace amble {
namespace {

LocomotiveClip personOf(Clip clip) {
  const JointRoles roles = guessJointRoles(clip.skeleton, "person");
  return locomotiveClip(std::move(clip), roles, "person");
}

// The same rig with other joint frames, names and size: bones point along x, say.
Clip reframed(const Clip& clip, double scale) {
  const int n = clip.skeleton.size();
  std::vector<Eigen::Quaterniond> q_JK(n);
  for (int j = 0; j < n; ++j) q_JK[j] = expRotation({0.3 * j, 1.0 - 0.1 * j, 0.2});
  std::vector<Joint> joints = clip.skeleton.joints();
  Clip result = clip;
  for (int j = 0; j < n; ++j) {
    const int parent = joints[j].parent;
    joints[j].name = "rig:" + joints[j].name;
    if (parent >= 0) joints[j].offset = scale * (q_JK[parent].conjugate() * joints[j].offset);
    for (Eigen::Vector3d& tip : joints[j].end_sites) tip = scale * (q_JK[j].conjugate() * tip);
  }
  for (int i = 0; i < clip.frames(); ++i) {
    result.poses.p_WR(i) *= scale;
    for (int j = 0; j < n; ++j) {
      const int parent = joints[j].parent;
      const Eigen::Quaterniond& q = clip.poses.rotations(i)[j];
      result.poses.rotations(i)[j] =
          parent < 0 ? q * q_JK[j] : q_JK[parent].conjugate() * q * q_JK[j];
    }
  }
  result.skeleton = Skeleton(std::move(joints));
  return result;
}

TEST(UpperOnBase, OfTheSameRigIsTheClipToTheBit) {
  const LocomotiveClip person = personOf(walkingPerson());
  const UpperOnBase upper = upperOnBase(person, person);
  EXPECT_EQ(upper.poses.rotations(17)[12].coeffs(), person.clip.poses.rotations(17)[12].coeffs());
  std::vector<Eigen::Quaterniond> out(person.clip.skeleton.size());
  upper.at(17.0, {12}, out);
  EXPECT_EQ(out[12].coeffs(), person.clip.poses.rotations(17)[12].coeffs());
}

TEST(UpperOnBase, OtherNamesAxesAndSizesTurnAllJointsAlike) {
  const Clip clip = walkingPerson();
  const LocomotiveClip upper = personOf(reframed(clip, 1.4)), base = personOf(clip);
  const UpperOnBase on = upperOnBase(upper, base);
  for (const char* const name : {"LeftArm", "LeftForeArm", "RightArm", "RightHand", "Head"}) {
    const int joint = clip.skeleton.find(name);
    ASSERT_TRUE(on.follows[joint]) << name;
    for (int i = 0; i < clip.frames(); i += 9) {
      EXPECT_LT(on.poses.rotations(i)[joint].angularDistance(clip.poses.rotations(i)[joint]), 0.02)
          << name;
    }
  }
}

TEST(UpperOnBase, FingersFollowTheirNamesakesAndATailFollowsNothing) {
  Clip clip = walkingPerson();
  std::vector<Joint> joints = clip.skeleton.joints();
  const auto add = [&](const char* name, const char* parent) {
    Joint joint;
    joint.name = name;
    joint.parent = clip.skeleton.find(parent);
    joint.offset = {0.05, 0.0, 0.0};
    joints.push_back(joint);
  };
  add("LeftThumb", "LeftHand");
  Clip with = clip;
  with.skeleton = Skeleton(joints);
  add("Tail", "Hips");
  Clip tailed = clip;
  tailed.skeleton = Skeleton(joints);
  for (Clip* const each : {&with, &tailed}) {
    each->poses = PoseArray(each->skeleton.size());
    each->poses.resize(clip.frames());
    for (int i = 0; i < clip.frames(); ++i) {
      each->poses.p_WR(i) = clip.poses.p_WR(i);
      std::copy_n(clip.poses.rotations(i).begin(), clip.skeleton.size(),
                  each->poses.rotations(i).begin());
      each->poses.rotations(i)[each->skeleton.find("LeftThumb")] = expRotation({0, 0.01 * i, 0});
    }
  }
  const UpperOnBase on = upperOnBase(personOf(with), personOf(tailed));
  const int thumb = tailed.skeleton.find("LeftThumb");
  EXPECT_TRUE(on.follows[thumb]);
  EXPECT_FALSE(on.follows[tailed.skeleton.find("Tail")]);
  EXPECT_LT(on.poses.rotations(30)[thumb].angularDistance(expRotation({0, 0.3, 0})), 1e-6);
}

// A turn at an even rate is one between frames as well, and smooth where they meet.
TEST(UpperOnBase, BetweenFramesTurnsGoOnWithoutAJerk) {
  UpperOnBase upper{PoseArray(1), {true}, 0, 19};
  upper.poses.resize(20);
  for (int i = 0; i < 20; ++i) {
    const double t = 0.1 * i;
    upper.poses.rotations(i)[0] = expRotation({std::sin(t), 0.3 * std::cos(t), 0.1});
  }
  double worst = 0.0;
  std::vector<Eigen::Quaterniond> q(1);
  for (double frame = 2.0; frame < 17.0; frame += 0.13) {
    const double t = 0.1 * frame;
    upper.at(frame, {0}, q);
    worst =
        std::max(worst, q[0].angularDistance(expRotation({std::sin(t), 0.3 * std::cos(t), 0.1})));
  }
  EXPECT_LT(worst, 5e-5);  // by slerp 1.2e-3
}

}  // namespace
}  // namespace amble
