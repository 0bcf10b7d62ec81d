#include "viz/figure/bone_figure.h"

#include <gtest/gtest.h>

#include "animation/captures/motion_reader.h"
#include "tests/animation/captures.h"
#include "tests/animation/random_clip.h"
#include "viz/figure/captured_figure.h"
#include "viz/figure/posed_figure.h"

namespace amble {
namespace {

using Eigen::Vector3d;

// Places of both ends of each bone, of a pose.
std::vector<std::pair<Vector3d, Vector3d>> bonesAt(const Skeleton& skeleton,
                                                   const std::vector<JointFrame>& frames) {
  std::vector<std::pair<Vector3d, Vector3d>> bones;
  for (int j = 0; j < skeleton.size(); ++j) {
    const Joint& joint = skeleton.joint(j);
    if (joint.parent >= 0) bones.emplace_back(frames[joint.parent].p_WJ, frames[j].p_WJ);
    for (const Vector3d& tip : joint.end_sites) bones.emplace_back(frames[j].p_WJ, frames[j] * tip);
  }
  return bones;
}

TEST(BoneFigure, EveryCornerHangsOnOneJointAlone) {
  Generator random(1);
  const Skeleton skeleton = randomSkeleton(random, 30);
  const Figure figure = makeBoneFigure(skeleton);
  ASSERT_EQ(figure.bind.size(), static_cast<size_t>(skeleton.size()));
  for (size_t i = 0; i < figure.vertices.size(); ++i) {
    EXPECT_EQ(figure.weights[i], (std::array<float, 4>{1, 0, 0, 0}));
    EXPECT_LT(figure.joints[i][0], skeleton.size());
    EXPECT_NEAR(figure.normals[i].norm(), 1.0F, 1e-5F);
  }
}

// Eight faces a joint, and eight a bone that has a length.
TEST(BoneFigure, HasAnOctahedronForEveryJointAndBone) {
  Generator random(2);
  for (const int joints : {1, 2, 12, 40}) {
    const Skeleton skeleton = randomSkeleton(random, joints);
    size_t bones = static_cast<size_t>(joints) - 1;
    for (const Joint& joint : skeleton.joints()) bones += joint.end_sites.size();
    EXPECT_EQ(makeBoneFigure(skeleton).triangles.size(), 8 * (joints + bones));
  }
}

TEST(BoneFigure, InAnyPoseABonesTipsAreAtItsJoints) {
  Generator random(3);
  const Skeleton skeleton = randomSkeleton(random, 20);
  const Figure figure = makeBoneFigure(skeleton);
  for (int round = 0; round < 5; ++round) {
    Pose pose;
    pose.p_WR = randomVector(random, 3.0);
    for (int j = 0; j < skeleton.size(); ++j) pose.rotations.push_back(randomRotation(random));
    std::vector<JointFrame> frames(skeleton.size());
    forwardKinematics(skeleton, pose, frames);
    const PosedFigure posed = poseFigure(figure, frames);
    for (const auto& [from, to] : bonesAt(skeleton, frames)) {
      for (const Vector3d& end : {from, to}) {
        float least = 1e9F;
        for (const Eigen::Vector3f& p : posed.vertices)
          least = std::min(least, (p - end.cast<float>()).norm());
        EXPECT_LT(least, 1e-5F);
      }
    }
  }
}

// Of an octahedron the middle sees all faces from inside.
TEST(BoneFigure, NormalsPointOutwards) {
  Generator random(4);
  const Figure figure = makeBoneFigure(randomSkeleton(random, 15));
  for (size_t first = 0; first < figure.triangles.size(); first += 8) {
    Eigen::Vector3f middle = Eigen::Vector3f::Zero();
    for (size_t t = first; t < first + 8; ++t)
      for (const auto corner : figure.triangles[t]) middle += figure.vertices[corner] / 24.0F;
    for (size_t t = first; t < first + 8; ++t) {
      const auto corner = figure.triangles[t][0];
      EXPECT_GT(figure.normals[corner].dot(figure.vertices[corner] - middle), 0.0F);
    }
  }
}

TEST(BoneFigure, GrowsWithItsSkeleton) {
  Generator random(5);
  const Skeleton skeleton = randomSkeleton(random, 12);
  const Figure small = makeBoneFigure(skeleton), large = makeBoneFigure(skeleton.scaled(100.0));
  ASSERT_EQ(small.vertices.size(), large.vertices.size());
  for (size_t i = 0; i < small.vertices.size(); ++i)
    EXPECT_LT((100.0F * small.vertices[i] - large.vertices[i]).norm(), 1e-3F);
}

TEST(BoneFigure, ASingleJointIsSeen) {
  Joint only;
  only.name = "only";
  const Figure figure = makeBoneFigure(Skeleton({only}));
  EXPECT_EQ(figure.triangles.size(), 8u);
  float most = 0.0F;
  for (const Eigen::Vector3f& p : figure.vertices) most = std::max(most, p.norm());
  EXPECT_GT(most, 0.005F);
}

TEST(CapturedFigure, IsAPersonWhereThereIsOneAndBonesElsewhere) {
  AMBLE_NEEDS_CAPTURES();
  for (const char* const name : {"accad_female1/Female1_B03_Walk1.bvh", "cmu_mb2/07_01.bvh"}) {
    const CapturedMotion motion = readMotion(sharedFolder() / "mocap" / name, {});
    const Figure person = capturedFigure(motion.clip, motion.roles);
    const Figure bones = capturedFigure(motion.clip, JointRoles{});
    EXPECT_GT(person.triangles.size(), 2000u) << name;
    EXPECT_EQ(bones.triangles.size(), makeBoneFigure(motion.clip.skeleton).triangles.size());
    EXPECT_EQ(person.bind.size(), bones.bind.size());
  }
}

// As tall in the poses of the capture as his joints are far apart, and no deeper than his feet.
TEST(CapturedFigure, SurroundsTheJointsOfEveryPose) {
  AMBLE_NEEDS_CAPTURES();
  const CapturedMotion motion =
      readMotion(sharedFolder() / "mocap/accad_female1/Female1_B03_Walk1.bvh", {});
  const Figure person = capturedFigure(motion.clip, motion.roles);
  std::vector<JointFrame> frames(motion.clip.skeleton.size());
  for (int frame = 0; frame < motion.clip.frames(); frame += 20) {
    forwardKinematics(motion.clip, frame, frames);
    const PosedFigure posed = poseFigure(person, frames);
    for (const int joint :
         {motion.roles.hips, motion.roles.legs[kLeft].leg, motion.roles.arms[kRight].fore_arm}) {
      Eigen::AlignedBox3f around;
      for (const Eigen::Vector3f& p : posed.vertices)
        if ((p - frames[joint].p_WJ.cast<float>()).norm() < 0.2F) around.extend(p);
      EXPECT_TRUE(around.contains(frames[joint].p_WJ.cast<float>())) << frame << " " << joint;
    }
  }
}

}  // namespace
}  // namespace amble
