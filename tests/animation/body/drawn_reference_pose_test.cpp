#include <gtest/gtest.h>

#include "animation/body/foot_shape.h"
#include "animation/body/pelvis.h"
#include "animation/body/reference_pose.h"
#include "base/rotation.h"
#include "tests/animation/moved_clip.h"
#include "tests/animation/other_axes.h"
#include "tests/animation/person.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

JointRoles personRoles(const Clip& person) { return guessJointRoles(person.skeleton, "person"); }

std::vector<Eigen::Quaterniond> randomTurns(Generator& generator, int joints) {
  std::vector<Eigen::Quaterniond> turns;
  for (int j = 0; j < joints; ++j) turns.push_back(randomRotation(generator));
  return turns;
}

TEST(DrawnReferencePose, PosedJointsAreTurnedAsSaidAndHangOnTheirParents) {
  Generator generator(401);
  for (int round = 0; round < 20; ++round) {
    const Skeleton skeleton = randomSkeleton(generator, 25);
    const std::vector<Eigen::Quaterniond> q = randomTurns(generator, 25);
    const std::vector<JointFrame> frames = posed(skeleton, q);
    EXPECT_EQ(frames[0].p_WJ, Eigen::Vector3d::Zero());
    for (int j = 0; j < 25; ++j) {
      EXPECT_EQ(frames[j].q_WJ.coeffs(), q[j].coeffs());
      const int parent = skeleton.joint(j).parent;
      if (parent < 0) continue;
      const Eigen::Vector3d bone = q[parent] * skeleton.joint(j).offset;
      EXPECT_LT((frames[j].p_WJ - frames[parent].p_WJ - bone).norm(), 1e-12);
    }
  }
}

TEST(DrawnReferencePose, PosedAsAFrameOfAClipIsThatFrame) {
  Generator generator(402);
  const Clip clip = randomClip(generator, 20, 3);
  for (int i = 0; i < 3; ++i) {
    const std::vector<JointFrame> wanted = jointFrames(clip, i);
    std::vector<Eigen::Quaterniond> q;
    for (const JointFrame& joint : wanted) q.push_back(joint.q_WJ);
    const std::vector<JointFrame> found = posed(clip.skeleton, q);
    for (int j = 0; j < 20; ++j) {
      EXPECT_LT((found[j].p_WJ - (wanted[j].p_WJ - wanted[0].p_WJ)).norm(), 1e-12);
    }
  }
}

TEST(DrawnReferencePose, TheLegIsTheMeanOfBothLegsAndGrowsWithTheSkeleton) {
  const Clip person = walkingPerson();
  const JointRoles roles = personRoles(person);
  EXPECT_NEAR(legOf(person.skeleton, roles), Rig::kThigh + Rig::kShank, 1e-12);
  std::vector<Joint> joints = person.skeleton.joints();
  joints[roles.legs[kLeft].leg].offset *= 1.1;
  EXPECT_NEAR(legOf(Skeleton(joints), roles), 1.05 * Rig::kThigh + Rig::kShank, 1e-12);
  EXPECT_NEAR(legOf(person.skeleton.scaled(0.6), roles), 0.6 * (Rig::kThigh + Rig::kShank), 1e-12);
}

// Rest poses in which somebody stands need no motion: whatever the clip does, they are it.
TEST(DrawnReferencePose, AnUprightRestPoseIsTheReferenceWhateverTheClipDoes) {
  Clip person = walkingPerson();
  const JointRoles roles = personRoles(person);
  const Eigen::Quaterniond rest = restToHeading(person.skeleton, roles);
  Generator generator(403);
  for (int round = 0; round < 3; ++round) {
    for (const Eigen::Quaterniond& q : referenceOf(person, roles).q_HJ) {
      EXPECT_LT(q.angularDistance(rest), 1e-9);
    }
    for (int i = 0; i < person.frames(); ++i) {
      for (Eigen::Quaterniond& q : person.poses.rotations(i)) q = randomRotation(generator);
    }
  }
}

TEST(DrawnReferencePose, InItFeetAreBelowHipsAndTheHeadAboveAndLeftIsLeft) {
  const Clip person = walkingPerson();
  const JointRoles roles = personRoles(person);
  for (const ReferencePose& pose : {referenceOf(person, roles), meanPose(person, roles)}) {
    const std::vector<JointFrame> joints = posed(person.skeleton, pose.q_HJ);
    const auto at = [&](int joint) -> Eigen::Vector3d { return joints[joint].p_WJ; };
    EXPECT_GT(at(roles.head).z(), at(roles.hips).z() + 0.3);
    EXPECT_GT(at(roles.legs[kLeft].up_leg).y(), at(roles.legs[kRight].up_leg).y() + 0.1);
    for (const LegJoints& leg : roles.legs) {
      EXPECT_LT(at(leg.foot).z(), at(leg.leg).z());
      EXPECT_LT(at(leg.leg).z(), at(leg.up_leg).z());
      EXPECT_GT(at(leg.toe).x(), at(leg.foot).x() + 0.05);
    }
  }
}

// The mean pose is seen from the heading: turned, moved and slower, a walk has the same.
TEST(DrawnReferencePose, TheMeanPoseDoesNotKnowWhereTheWalkGoes) {
  const Clip person = walkingPerson();
  const JointRoles roles = personRoles(person);
  const ReferencePose here = meanPose(person, roles);
  for (const double turn : {0.4, 1.9, -2.8}) {
    const ReferencePose there = meanPose(moved(person, aboutZ(turn), {3.0, -8.0, 0.2}), roles);
    for (size_t j = 0; j < here.q_HJ.size(); ++j) {
      EXPECT_LT(there.q_HJ[j].angularDistance(here.q_HJ[j]), 1e-7) << turn << ' ' << j;
    }
  }
}

TEST(DrawnReferencePose, TheMeanPoseIsTheSameBodyWhateverItsJointFrames) {
  const Clip person = walkingPerson();
  const JointRoles roles = personRoles(person);
  const ReferencePose own = meanPose(person, roles);
  const std::vector<JointFrame> wanted = posed(person.skeleton, own.q_HJ);
  Generator generator(404);
  for (int round = 0; round < 5; ++round) {
    const auto turns = randomTurns(generator, person.skeleton.size());
    const Clip other = otherAxes(person, turns);
    const ReferencePose pose = meanPose(other, roles);
    const std::vector<JointFrame> found = posed(other.skeleton, pose.q_HJ);
    for (size_t j = 0; j < wanted.size(); ++j) {
      EXPECT_LT((found[j].p_WJ - wanted[j].p_WJ).norm(), 1e-9) << j;
      EXPECT_LT(pose.q_HJ[j].angularDistance(own.q_HJ[j] * turns[j]), 1e-7) << j;
    }
  }
}

// A rig whose rest pose is nobody's stance takes what its clip stands in.
TEST(DrawnReferencePose, WhereNobodyStandsAtRestTheClipsMeanIsTaken) {
  const Clip person = walkingPerson();
  const JointRoles roles = personRoles(person);
  Generator generator(405);
  const Clip strange = otherAxes(person, randomTurns(generator, person.skeleton.size()));
  const ReferencePose reference = referenceOf(strange, roles), mean = meanPose(strange, roles);
  for (size_t j = 0; j < mean.q_HJ.size(); ++j) {
    EXPECT_LT(reference.q_HJ[j].angularDistance(mean.q_HJ[j]), 1e-12);
  }
}

TEST(DrawnReferencePose, OfAStillClipTheMeanIsItsPose) {
  Clip person = walkingPerson();
  const JointRoles roles = personRoles(person);
  for (int i = 1; i < person.frames(); ++i) {
    const auto first = person.poses.rotations(0);
    std::copy(first.begin(), first.end(), person.poses.rotations(i).begin());
    person.poses.p_WR(i) = person.poses.p_WR(0);
  }
  const std::vector<JointFrame> joints = jointFrames(person, 0);
  const Eigen::Quaterniond back = aboutZ(-pelvisHeading(joints, roles));
  const ReferencePose mean = meanPose(person, roles);
  for (size_t j = 0; j < joints.size(); ++j) {
    EXPECT_LT(mean.q_HJ[j].angularDistance(back * joints[j].q_WJ), 1e-7) << j;
  }
}

TEST(DrawnReferencePose, OfALibraryItIsTheRestPoseOrElseTheStance) {
  const Clip person = walkingPerson();
  const JointRoles roles = personRoles(person);
  const auto first = person.poses.rotations(0);
  const std::vector<Eigen::Quaterniond> stand(first.begin(), first.end());
  const Eigen::Quaterniond rest = restToHeading(person.skeleton, roles);
  for (const Eigen::Quaterniond& q : referenceOf(person.skeleton, roles, stand).q_HJ) {
    EXPECT_LT(q.angularDistance(rest), 1e-9);
  }
  Generator generator(406);
  const Clip strange = otherAxes(person, randomTurns(generator, person.skeleton.size()));
  const auto stance = strange.poses.rotations(0);
  const ReferencePose pose =
      referenceOf(strange.skeleton, roles, std::vector(stance.begin(), stance.end()));
  const std::vector<JointFrame> wanted = jointFrames(strange, 0);
  for (size_t j = 0; j < wanted.size(); ++j) {
    EXPECT_LT(pose.q_HJ[j].angularDistance(wanted[j].q_WJ), 1e-7);
  }
}

TEST(DrawnReferencePose, KneesBendAboutTheBodysLeftHoweverThighsAreFramed) {
  const Clip person = walkingPerson();
  const JointRoles roles = personRoles(person);
  Generator generator(407);
  for (int round = 0; round < 5; ++round) {
    const auto turns = randomTurns(generator, person.skeleton.size());
    const Clip other = otherAxes(person, turns);
    const ReferencePose pose = meanPose(other, roles);
    const auto axes = kneeAxes(roles, pose);
    for (const Side side : {kLeft, kRight}) {
      const Eigen::Vector3d left = pose.q_HJ[roles.legs[side].up_leg] * axes[side];
      EXPECT_LT((left - Eigen::Vector3d::UnitY()).norm(), 1e-12);
    }
  }
}

}  // namespace
}  // namespace amble
