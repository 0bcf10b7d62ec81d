#include "animation/body/pose.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/rotation.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

/// X_WJ as the product of 4 x 4 matrices down the tree: the definition.
Eigen::Matrix4d jointMatrix(const Skeleton& skeleton, PoseView pose, int joint) {
  Eigen::Matrix4d X = Eigen::Matrix4d::Identity();
  X.topLeftCorner<3, 3>() = pose.rotations[joint].toRotationMatrix();
  X.topRightCorner<3, 1>() = joint == 0 ? pose.p_WR : skeleton.joint(joint).offset;
  const int parent = skeleton.joint(joint).parent;
  return parent < 0 ? X : Eigen::Matrix4d(jointMatrix(skeleton, pose, parent) * X);
}

TEST(Pose, ForwardKinematicsIsTheProductDownTheTree) {
  Generator generator(21);
  for (int i = 0; i < 20; ++i) {
    const Clip clip = randomClip(generator, 30, 1);
    const std::vector<JointFrame> frames = jointFrames(clip, 0);
    for (int j = 0; j < clip.skeleton.size(); ++j) {
      const Eigen::Matrix4d X = jointMatrix(clip.skeleton, clip.poses[0], j);
      const Eigen::Vector4d p(0.3, -0.2, 0.1, 1.0);
      EXPECT_LT((frames[j] * Eigen::Vector3d(p.head<3>()) - (X * p).head<3>()).norm(), 1e-13);
    }
  }
}

TEST(Pose, AChainsJointsStandWhereAllOfThemPutThem) {
  Generator generator(23);
  for (int i = 0; i < 20; ++i) {
    const Clip clip = randomClip(generator, 30, 1);
    const std::vector<JointFrame> all = jointFrames(clip, 0);
    const std::vector<int> ends = {i, 29 - i / 2};
    const std::vector<int> chain = chainOf(clip.skeleton, ends);
    std::vector<JointFrame> frames(all.size());
    forwardKinematics(clip.skeleton, clip.poses[0], chain, frames);
    for (const int end : ends) EXPECT_NE(std::find(chain.begin(), chain.end(), end), chain.end());
    for (const int j : chain) {
      EXPECT_EQ(frames[j].p_WJ, all[j].p_WJ);
      EXPECT_EQ(frames[j].q_WJ.coeffs(), all[j].q_WJ.coeffs());
    }
  }
}

TEST(Pose, MovingJointsStandWhereTheirPositionsSay) {
  Generator generator(22);
  Clip clip = randomClip(generator, 10, 3);
  const Clip fixed = clip;
  for (int frame = 0; frame < clip.frames(); ++frame) {
    for (int j = 0; j < clip.skeleton.size(); ++j) {
      clip.joint_positions.push_back((frame + 1.0) * clip.skeleton.joint(j).offset);
    }
  }
  // Offsets twice as long place every joint twice as far from the root.
  const std::vector<JointFrame> one = jointFrames(fixed, 1), two = jointFrames(clip, 1);
  for (int j = 0; j < clip.skeleton.size(); ++j) {
    EXPECT_LT(((two[j].p_WJ - two[0].p_WJ) - 2.0 * (one[j].p_WJ - one[0].p_WJ)).norm(), 1e-13);
  }
}

TEST(Pose, NewFramesAreTheIdentityAtTheOrigin) {
  PoseArray poses(3);
  poses.resize(2);
  EXPECT_EQ(poses.size(), 2);
  EXPECT_EQ(poses[1].p_WR, Eigen::Vector3d::Zero());
  for (const Eigen::Quaterniond& q : poses[1].rotations) EXPECT_EQ(q.w(), 1.0);
  poses.clear();
  EXPECT_TRUE(poses.empty());
}

TEST(Pose, AppendedFramesAreThoseThatWereGivenEvenOurOwn) {
  Generator generator(23);
  PoseArray poses = randomClip(generator, 7, 5).poses;
  const PoseArray before = poses;
  for (int i = 0; i < 50; ++i) poses.append(poses[i % 5]);  // grows, so that memory moves
  poses.append(poses, 2, 3);
  poses.append(before, 1, 2);
  ASSERT_EQ(poses.size(), 60);
  for (int frame = 0; frame < 60; ++frame) {
    const int source = frame < 55 ? frame % 5 : (frame < 58 ? frame - 53 : frame - 57);
    EXPECT_EQ(poses[frame].p_WR, before[source].p_WR);
    for (int j = 0; j < 7; ++j) {
      EXPECT_EQ(poses[frame].rotations[j].coeffs(), before[source].rotations[j].coeffs());
    }
  }
}

TEST(Pose, InterpolationMeetsBothEndsAndTurnsEvenlyOnTheShorterWay) {
  Generator generator(24);
  const Clip clip = randomClip(generator, 12, 2);
  Pose out;
  for (const double t : {0.0, 0.25, 0.5, 1.0}) {
    interpolatePose(clip.poses[0], clip.poses[1], t, out);
    const Eigen::Vector3d p = clip.poses.p_WR(0) + t * (clip.poses.p_WR(1) - clip.poses.p_WR(0));
    EXPECT_LT((out.p_WR - p).norm(), 1e-14);
    for (int j = 0; j < 12; ++j) {
      const Eigen::Quaterniond a = clip.poses[0].rotations[j], b = clip.poses[1].rotations[j];
      const Eigen::Quaterniond expected = a * expRotation(t * logRotation(a.conjugate() * b));
      EXPECT_LT((expected.toRotationMatrix() - out.rotations[j].toRotationMatrix()).norm(), 1e-13);
    }
  }
}

TEST(Pose, InterpolationBetweenEqualPosesIsThatPose) {
  Generator generator(25);
  const Clip clip = randomClip(generator, 5, 1);
  Pose out;
  interpolatePose(clip.poses[0], clip.poses[0], 0.3, out);
  for (int j = 0; j < 5; ++j) {
    EXPECT_LT((out.rotations[j].coeffs() - clip.poses[0].rotations[j].coeffs()).norm(), 1e-15);
  }
}

TEST(Pose, InterpolationFromTheOtherEndIsTheSame) {
  Generator generator(26);
  const Clip clip = randomClip(generator, 15, 2);
  Pose out, back;
  for (const double t : {0.0, 0.1, 0.37, 0.5, 0.9}) {
    interpolatePose(clip.poses[0], clip.poses[1], t, out);
    interpolatePose(clip.poses[1], clip.poses[0], 1.0 - t, back);
    EXPECT_LT((out.p_WR - back.p_WR).norm(), 1e-12);
    for (int j = 0; j < 15; ++j) {
      EXPECT_LT(out.rotations[j].angularDistance(back.rotations[j]), 1e-7);
    }
  }
}

TEST(Pose, InterpolationDoesNotKnowTheSignsOfQuaternions) {
  Generator generator(27);
  Clip clip = randomClip(generator, 10, 2);
  Pose plain, signs;
  interpolatePose(clip.poses[0], clip.poses[1], 0.3, plain);
  for (Eigen::Quaterniond& q : clip.poses.rotations(1)) q.coeffs() *= -1.0;
  interpolatePose(clip.poses[0], clip.poses[1], 0.3, signs);
  for (int j = 0; j < 10; ++j) {
    EXPECT_LT(plain.rotations[j].angularDistance(signs.rotations[j]), 1e-7);
  }
}

TEST(Pose, ATurnedRootTurnsTheWholeBodyAboutItself) {
  Generator generator(28);
  for (int round = 0; round < 20; ++round) {
    Clip clip = randomClip(generator, 20, 1);
    const std::vector<JointFrame> before = jointFrames(clip, 0);
    const Eigen::Quaterniond turn = randomRotation(generator);
    clip.poses.rotations(0)[0] = turn * clip.poses.rotations(0)[0];
    const std::vector<JointFrame> after = jointFrames(clip, 0);
    for (int j = 0; j < 20; ++j) {
      const Eigen::Vector3d arm = before[j].p_WJ - before[0].p_WJ;
      EXPECT_LT((after[j].p_WJ - before[0].p_WJ - turn * arm).norm(), 1e-12);
      EXPECT_LT(after[j].q_WJ.angularDistance(turn * before[j].q_WJ), 1e-7);
    }
  }
}

TEST(Pose, AJointTurnsWhatHangsOnItAndNothingElse) {
  Generator generator(29);
  for (int round = 0; round < 20; ++round) {
    Clip clip = randomClip(generator, 20, 1);
    const std::vector<JointFrame> before = jointFrames(clip, 0);
    const int turned = std::uniform_int_distribution<int>(0, 19)(generator);
    clip.poses.rotations(0)[turned] = randomRotation(generator);
    const std::vector<JointFrame> after = jointFrames(clip, 0);
    for (int j = 0; j < 20; ++j) {
      const double distance = (before[j].p_WJ - before[turned].p_WJ).norm();
      EXPECT_NEAR((after[j].p_WJ - after[turned].p_WJ).norm() * clip.skeleton.isAncestor(turned, j),
                  distance * clip.skeleton.isAncestor(turned, j), 1e-12);
      if (clip.skeleton.isAncestor(turned, j)) continue;
      EXPECT_EQ(after[j].p_WJ, before[j].p_WJ);
      EXPECT_EQ(after[j].q_WJ.coeffs(), before[j].q_WJ.coeffs());
    }
  }
}

TEST(Pose, AChainIsClosedTowardsTheRootAndAscends) {
  Generator generator(30);
  for (int round = 0; round < 50; ++round) {
    const Skeleton skeleton = randomSkeleton(generator, 30);
    std::vector<int> ends;
    for (int k = 0; k < 3; ++k) {
      ends.push_back(std::uniform_int_distribution<int>(0, 29)(generator));
    }
    const std::vector<int> chain = chainOf(skeleton, ends);
    ASSERT_FALSE(chain.empty());
    EXPECT_EQ(chain.front(), 0);
    for (int j = 0; j < 30; ++j) {
      const bool needed = std::any_of(ends.begin(), ends.end(),
                                      [&](int end) { return skeleton.isAncestor(j, end); });
      EXPECT_EQ(std::count(chain.begin(), chain.end(), j), needed ? 1 : 0);
    }
    EXPECT_TRUE(std::is_sorted(chain.begin(), chain.end()));
  }
}

}  // namespace
}  // namespace amble
