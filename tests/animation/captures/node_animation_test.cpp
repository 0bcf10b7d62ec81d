#include "animation/captures/node_animation.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/error.h"
#include "base/rotation.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

std::string refusal(const AnimatedNodes& scene, std::optional<double> frame_time = {}) {
  try {
    clipOfNodes(scene, "nodes.fbx", frame_time);
  } catch (const InputError& error) {
    return error.what();
  }
  return "made without an error";
}

/// A clip as nodes: each with a key a frame, in file axes that X_WFile takes to World, its rest
/// turned by a rotation of its own as rigs of modelling programs are.
AnimatedNodes nodesOf(const Clip& clip, const Eigen::Affine3d& X_WFile, Generator& generator) {
  const int joints = clip.skeleton.size();
  const Eigen::Affine3d X_FileW = X_WFile.inverse();
  const double unit = std::cbrt(X_FileW.linear().determinant());  // file units a metre
  const Eigen::Quaterniond q_FileW(Eigen::Matrix3d(X_FileW.linear() / unit));
  AnimatedNodes scene;
  scene.X_WFile = X_WFile;
  scene.nodes.resize(joints);
  std::vector<Eigen::Quaterniond> turn, q_rest_W;  // node in joint; node in World at rest
  std::vector<Eigen::Affine3d> X_rest;
  for (int j = 0; j < joints; ++j) {
    const Joint& joint = clip.skeleton.joint(j);
    turn.push_back(randomRotation(generator));
    const Eigen::Vector3d p_rest =
        j == 0 ? Eigen::Vector3d(0, 0, 0)
               : Eigen::Vector3d(X_rest[joint.parent].translation() +
                                 unit * (q_FileW * yUpToWorld() * joint.offset));
    X_rest.push_back(Eigen::Translation3d(p_rest) * (q_FileW * yUpToWorld() * turn[j]));
    AnimatedNode& node = scene.nodes[j];
    node.name = joint.name;
    node.parent = joint.parent;
    node.X_PN = j == 0 ? X_rest[0] : X_rest[joint.parent].inverse() * X_rest[j];
  }
  std::vector<JointFrame> at(joints);
  for (int i = 0; i < clip.frames(); ++i) {
    forwardKinematics(clip, i, at);
    for (int j = 0; j < joints; ++j) {
      const auto place = [&](int k) {
        return Eigen::Affine3d(Eigen::Translation3d(X_FileW * at[k].p_WJ) *
                               (q_FileW * at[k].q_WJ * turn[k]));
      };
      const int parent = scene.nodes[j].parent;
      const Eigen::Affine3d X = parent < 0 ? place(j) : place(parent).inverse() * place(j);
      NodeTracks& tracks = scene.nodes[j].tracks;
      for (auto* times : {&tracks.translations.times, &tracks.rotations.times}) {
        times->push_back(2.0 + i * clip.frame_time);
      }
      tracks.translations.values.push_back(X.translation());
      tracks.rotations.values.push_back(Eigen::Quaterniond(X.linear()));
    }
  }
  return scene;
}

/// Smooth movement, so that half a frame between two of them is near both.
Clip smoothClip(Generator& generator) {
  Clip clip = randomClip(generator, 12, 31);
  // A chain of three at least hangs on the root twice, as legs do.
  std::vector<Joint> joints = clip.skeleton.joints();
  for (int j = 1; j < 12; ++j) joints[j].parent = j == 1 || j == 5 || j == 9 ? 0 : j - 1;
  clip.skeleton = Skeleton(joints);
  clip.frame_time = 1.0 / 30.0;
  std::vector<Eigen::Quaterniond> from(12), to(12);
  for (int j = 0; j < 12; ++j) {
    from[j] = randomRotation(generator);
    to[j] = from[j] * expRotation(randomVector(generator, 0.5));
  }
  for (int i = 0; i < clip.frames(); ++i) {
    clip.poses.p_WR(i) = Eigen::Vector3d(0.03 * i, 0.01 * i, 1.0);
    for (int j = 0; j < 12; ++j) clip.poses.rotations(i)[j] = from[j].slerp(i / 30.0, to[j]);
  }
  return clip;
}

double farthestOf(const Clip& a, int frame_a, const Clip& b, int frame_b) {
  const std::vector<JointFrame> x = jointFrames(a, frame_a), y = jointFrames(b, frame_b);
  double worst = 0.0;
  for (int j = 0; j < a.skeleton.size(); ++j) {
    const int other = b.skeleton.find(a.skeleton.joint(j).name);
    EXPECT_GE(other, 0);
    worst = std::max(worst, (x[j].p_WJ - y[other].p_WJ).norm());
  }
  return worst;
}

Eigen::Affine3d zUpCentimetres() { return Eigen::Affine3d(Eigen::Scaling(0.01)); }
Eigen::Affine3d yUpMetres() { return Eigen::Affine3d(yUpToWorld()); }

TEST(NodeAnimation, ASceneWithoutAnimatedNodesIsRefused) {
  AnimatedNodes scene;
  EXPECT_EQ(refusal(scene), "nodes.fbx: holds no animation; expected animated nodes of a skeleton");
  scene.nodes.resize(2);
  scene.nodes[1].parent = 0;
  EXPECT_EQ(refusal(scene), "nodes.fbx: holds no animation; expected animated nodes of a skeleton");
  scene.nodes[0].bone = scene.nodes[1].bone = true;
  EXPECT_EQ(refusal(scene), "nodes.fbx: holds no animation; expected animated nodes of a skeleton");
}

TEST(NodeAnimation, KeysThatAreNoneAreRefused) {
  Generator generator(1);
  const AnimatedNodes good = nodesOf(smoothClip(generator), yUpMetres(), generator);
  EXPECT_EQ(refusal(good), "made without an error");
  AnimatedNodes bad = good;
  bad.nodes[3].tracks.translations.values[4].x() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(bad),
            "nodes.fbx: key 4 of 'joint_3' is none; expected ascending times, finite values");
  bad = good;
  bad.nodes[3].tracks.rotations.times[4] = 0.0;
  EXPECT_NE(refusal(bad).find("key 4 of 'joint_3'"), std::string::npos);
  bad = good;
  bad.nodes[3].tracks.rotations.values[0].w() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal(bad).find("key 0 of 'joint_3'"), std::string::npos);
  bad = good;
  bad.nodes[2].X_PN.translation().y() = 1e30;
  EXPECT_NE(refusal(bad).find("the transform of 'joint_2' is not finite"), std::string::npos);
}

TEST(NodeAnimation, AnAnimationThatWouldFillTheMemoryIsRefused) {
  Generator generator(1);
  AnimatedNodes scene = nodesOf(smoothClip(generator), yUpMetres(), generator);
  scene.nodes[0].tracks.translations.times.back() = 1e6;
  EXPECT_NE(refusal(scene).find("too long an animation"), std::string::npos);
  EXPECT_NE(refusal(scene, 1e-300).find("too long an animation"), std::string::npos);
}

TEST(NodeAnimation, AClipComesBackWhateverTheFilesAxesUnitAndRest) {
  Generator generator(2);
  const Clip clip = smoothClip(generator);
  for (const Eigen::Affine3d& X_WFile : {yUpMetres(), zUpCentimetres()}) {
    const Clip back = clipOfNodes(nodesOf(clip, X_WFile, generator), "nodes");
    ASSERT_EQ(back.frames(), clip.frames());
    EXPECT_NEAR(back.frame_time, clip.frame_time, 1e-12);
    EXPECT_TRUE(back.joint_positions.empty());
    for (int i = 0; i < clip.frames(); ++i) EXPECT_LT(farthestOf(clip, i, back, i), 1e-9);
  }
}

TEST(NodeAnimation, AtRestJointsAreParallelToAYUpFile) {
  Generator generator(3);
  const Clip clip = smoothClip(generator);
  const Clip back = clipOfNodes(nodesOf(clip, zUpCentimetres(), generator), "nodes");
  for (const Joint& joint : clip.skeleton.joints()) {
    const int other = back.skeleton.find(joint.name);
    EXPECT_LT((back.skeleton.joint(other).offset - joint.offset).norm(), 1e-9) << joint.name;
  }
}

TEST(NodeAnimation, SamplingBetweenKeysIsLinearInPlaceAndBySlerp) {
  Generator generator(4);
  const Clip clip = smoothClip(generator);
  const Clip fine = clipOfNodes(nodesOf(clip, yUpMetres(), generator), "nodes", 1.0 / 60.0);
  ASSERT_EQ(fine.frames(), 61);
  Pose between;
  for (int i = 0; i + 1 < clip.frames(); ++i) {
    EXPECT_LT(farthestOf(clip, i, fine, 2 * i), 1e-9);
    interpolatePose(clip.poses[i], clip.poses[i + 1], 0.5, between);
    EXPECT_LT((between.p_WR - fine.poses.p_WR(2 * i + 1)).norm(), 1e-9);
  }
}

TEST(NodeAnimation, SplinesAreSampledAsSplines) {
  Generator generator(4);
  AnimatedNodes scene = nodesOf(smoothClip(generator), yUpMetres(), generator);
  // About one axis by 0.3 sin, whose slopes the keys know: four numbers' slopes are q' = q w / 2.
  KeyTrack<Eigen::Quaterniond>& track = scene.nodes[2].tracks.rotations;
  track = {};
  track.shape = KeyShape::kCubic;
  const auto angle = [](double t) { return 0.6 * std::sin(2.0 * t); };
  for (int i = 0; i <= 4; ++i) {
    const double t = 0.25 * i, slope = 1.2 * std::cos(2.0 * t);
    const Eigen::Quaterniond q = expRotation({angle(t), 0, 0});
    const Eigen::Quaterniond half(0.0, 0.5 * slope, 0.0, 0.0);
    track.times.push_back(2.0 + t);
    track.values.push_back(q);
    track.in.push_back(q * half);
    track.out.push_back(q * half);
  }
  AnimatedNodes linear = scene;
  linear.nodes[2].tracks.rotations.shape = KeyShape::kLinear;
  const Clip cubic = clipOfNodes(scene, "nodes", 1.0 / 60.0);
  const Clip straight = clipOfNodes(linear, "nodes", 1.0 / 60.0);
  const auto turned = [](const Clip& clip, int frame) {
    const auto q0 = clip.poses.rotations(0)[2], q = clip.poses.rotations(frame)[2];
    return (q0.conjugate() * q).angularDistance(Eigen::Quaterniond::Identity());
  };
  double cubic_error = 0.0, straight_error = 0.0;
  for (int i = 0; i <= 60; ++i) {
    const double wanted = std::abs(angle(i / 60.0));
    cubic_error = std::max(cubic_error, std::abs(turned(cubic, i) - wanted));
    straight_error = std::max(straight_error, std::abs(turned(straight, i) - wanted));
  }
  EXPECT_LT(cubic_error, 5e-4);
  EXPECT_GT(straight_error, 10.0 * cubic_error);
}

TEST(NodeAnimation, SparseKeysAreFramesAmongThirtyASecond) {
  Generator generator(4);
  for (const double distance : {0.5, 1.0 / 6.0, 1.0 / 12.0}) {
    AnimatedNodes scene = nodesOf(smoothClip(generator), yUpMetres(), generator);
    for (AnimatedNode& node : scene.nodes) {
      for (auto* times : {&node.tracks.translations.times, &node.tracks.rotations.times}) {
        for (size_t i = 0; i < times->size(); ++i) (*times)[i] = distance * i;
      }
    }
    const double frame_time = clipOfNodes(scene, "nodes").frame_time;
    EXPECT_LE(frame_time, 1.03 / 30.0);
    EXPECT_NEAR(std::round(distance / frame_time), distance / frame_time, 1e-9);
  }
}

TEST(NodeAnimation, WhatMovesAboveTheHipsIsInTheRootsPlace) {
  Generator generator(5);
  const Clip clip = smoothClip(generator);
  AnimatedNodes scene = nodesOf(clip, yUpMetres(), generator);
  // Two nodes above, the upper of which carries everything along.
  for (AnimatedNode& node : scene.nodes) node.parent += 2;
  scene.nodes.insert(scene.nodes.begin(), 2, AnimatedNode());
  scene.nodes[0].name = "armature";
  scene.nodes[1].name = "motion";
  scene.nodes[1].parent = 0;
  scene.nodes[0].tracks.translations = {{2.0, 3.0}, {{0, 0, 0}, {0, 0, 1}}};
  const Clip back = clipOfNodes(scene, "nodes");
  EXPECT_EQ(back.skeleton.joint(0).name, "joint_0");
  const Eigen::Vector3d moved = back.poses.p_WR(30) - clip.poses.p_WR(30);
  EXPECT_LT((moved - yUpToWorld() * Eigen::Vector3d(0, 0, 1)).norm(), 1e-9);
}

TEST(NodeAnimation, HelpersArePartsOfTheNodeBelowThem) {
  Generator generator(6);
  const Clip clip = smoothClip(generator);
  AnimatedNodes scene = nodesOf(clip, yUpMetres(), generator);
  // The last node's tracks are parted: its place in a helper, its turn in the node.
  AnimatedNode node = scene.nodes.back();
  AnimatedNode helper = node;
  helper.name += "_$AssimpFbx$_Translation";
  helper.helper = true;
  helper.tracks.rotations = {};
  helper.X_PN.linear().setIdentity();
  node.tracks.translations = {};
  node.X_PN.translation().setZero();
  node.parent = static_cast<int>(scene.nodes.size()) - 1;
  scene.nodes.back() = helper;
  scene.nodes.push_back(node);
  const Clip back = clipOfNodes(scene, "nodes");
  EXPECT_EQ(back.skeleton.size(), clip.skeleton.size());
  for (int i = 0; i < clip.frames(); ++i) EXPECT_LT(farthestOf(clip, i, back, i), 1e-9);
}

TEST(NodeAnimation, UnmovedNodesAtTheEndAreEndSitesAndThingsAreNone) {
  Generator generator(7);
  const Clip clip = smoothClip(generator);
  AnimatedNodes scene = nodesOf(clip, yUpMetres(), generator);
  AnimatedNode tip;
  tip.name = "tip";
  tip.parent = 4;
  tip.X_PN.translation() = Eigen::Vector3d(0.1, 0.2, 0.2);
  scene.nodes.push_back(tip);
  tip.name = "hat";
  tip.thing = true;
  scene.nodes.push_back(tip);
  const Clip back = clipOfNodes(scene, "nodes");
  ASSERT_EQ(back.skeleton.joint(4).end_sites.size(), 1u);
  EXPECT_NEAR(back.skeleton.joint(4).end_sites[0].norm(), 0.3, 1e-12);
  EXPECT_EQ(back.skeleton.find("hat"), -1);
}

TEST(NodeAnimation, BonesThatGrowMoveTheirJoints) {
  Generator generator(8);
  const Clip clip = smoothClip(generator);
  AnimatedNodes scene = nodesOf(clip, yUpMetres(), generator);
  scene.nodes[2].tracks.scales = {{2.0, 3.0}, {{1, 1, 1}, {2, 2, 2}}};
  const Clip back = clipOfNodes(scene, "nodes");
  ASSERT_FALSE(back.joint_positions.empty());
  const std::vector<JointFrame> was = jointFrames(clip, 30), is = jointFrames(back, 30);
  const Eigen::Vector3d bone = was[3].p_WJ - was[2].p_WJ;
  EXPECT_LT((is[3].p_WJ - is[2].p_WJ - 2.0 * bone).norm(), 1e-9);
}

TEST(NodeAnimation, TheLargestSkeletonIsTaken) {
  Generator generator(9);
  const Clip clip = smoothClip(generator);
  AnimatedNodes scene = nodesOf(clip, yUpMetres(), generator);
  AnimatedNode door;
  door.name = "door";
  door.tracks.translations = {{0.0, 90.0}, {{0, 0, 0}, {1, 0, 0}}};
  scene.nodes.push_back(door);
  const Clip back = clipOfNodes(scene, "nodes");
  EXPECT_EQ(back.skeleton.size(), clip.skeleton.size());
  EXPECT_EQ(back.frames(), clip.frames()) << "a door's animation is none of the person's";
}

TEST(NodeAnimation, StepsChangeInTheFrameOfTheirKeyThoughItsTimeHasButTwentyFourBits) {
  Generator generator(5);
  const Clip clip = randomClip(generator, 4, 200);
  AnimatedNodes scene = nodesOf(clip, Eigen::Affine3d::Identity(), generator);
  scene.frame_time = clip.frame_time;
  const Clip exact = clipOfNodes(scene, "nodes.glb", {});
  for (AnimatedNode& node : scene.nodes) {
    for (auto* times : {&node.tracks.translations.times, &node.tracks.rotations.times})
      for (double& t : *times) t = static_cast<float>(t);
    node.tracks.translations.shape = node.tracks.rotations.shape = KeyShape::kStep;
  }
  const Clip stepped = clipOfNodes(scene, "nodes.glb", {});
  ASSERT_EQ(stepped.frames(), exact.frames());
  for (int i = 0; i < exact.frames(); ++i) {
    for (int j = 0; j < exact.skeleton.size(); ++j) {
      EXPECT_LT(stepped.poses.rotations(i)[j].angularDistance(exact.poses.rotations(i)[j]), 1e-9)
          << i;
    }
  }
}

}  // namespace
}  // namespace amble
