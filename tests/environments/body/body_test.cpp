#include "environments/body/body.h"

#include <gtest/gtest.h>

#include "animation/body/reference_pose.h"
#include "animation/body/rest_feet.h"
#include "animation/captures/bvh.h"
#include "animation/captures/motion_reader.h"
#include "test_paths.h"
#include "tests/environments/test_walker.h"

namespace amble {
namespace {

struct Placed {
  std::vector<Eigen::Vector3d> from, to;
};

Placed place(const Skeleton& skeleton, const Body& body, PoseView pose) {
  std::vector<JointFrame> frames(skeleton.size());
  forwardKinematics(skeleton, pose, frames);
  Placed placed{std::vector<Eigen::Vector3d>(body.parts.size()),
                std::vector<Eigen::Vector3d>(body.parts.size())};
  placeBody(body, frames, placed.from, placed.to);
  return placed;
}

TEST(Body, HasEveryPartOnce) {
  const TestWalker walker;
  for (const char* name : {"head", "neck", "chest", "abdomen", "pelvis", "left hand", "right hand",
                           "left thigh", "right shank", "left sole, outside", "left sole, inside",
                           "left toes", "right toes", "right upper arm", "left forearm"})
    EXPECT_GE(walker.part(name), 0) << name;
  for (const BodyPart& part : walker.body.parts) {
    EXPECT_GT(part.radius, 0.0);
    const bool is_foot = part.name.find("sole") != std::string::npos ||
                         part.name.find("toes") != std::string::npos ||
                         part.name.find("instep") != std::string::npos;
    EXPECT_EQ(part.sole >= 0, is_foot) << part.name;
    if (is_foot) {
      EXPECT_EQ(part.sole, part.name.starts_with("left") ? kLeft : kRight);
    }
  }
}

// People stand with bent knees and a bowed neck; they are as tall as they say all the same.
TEST(Body, IsAsTallAsItSaysAsItStands) {
  const TestWalker walker;
  for (const double bow : {0.0, 0.2}) {
    Pose pose = walker.standing(0, 0);
    pose.p_WR.z() -= 0.013;
    pose.rotations[walker.roles.head] = expRotation({bow, 0, 0});
    std::vector<JointFrame> joints(walker.skeleton.size());
    forwardKinematics(walker.skeleton, pose, joints);
    const Body body = makeBody(walker.skeleton, walker.roles, walker.stature,
                               evenSoles({0.06, 0.02}), {.head = joints[walker.roles.head]});
    const Placed placed = place(walker.skeleton, body, pose);
    const auto head = std::find_if(body.parts.begin(), body.parts.end(),
                                   [](const BodyPart& part) { return part.name == "head"; });
    ASSERT_NE(head, body.parts.end());
    EXPECT_NEAR(placed.to[head - body.parts.begin()].z() + head->radius, walker.stature, 1e-9)
        << bow;
  }
}

TEST(Body, StandsOnTheFloorWithItsCrownAtItsStature) {
  const TestWalker walker;
  const Placed placed = place(walker.skeleton, walker.body, walker.standing(0, 0));
  double lowest = 1e9, highest = -1e9;
  for (size_t i = 0; i < walker.body.parts.size(); ++i) {
    const double r = walker.body.parts[i].radius;
    lowest = std::min({lowest, placed.from[i].z() - r, placed.to[i].z() - r});
    highest = std::max({highest, placed.from[i].z() + r, placed.to[i].z() + r});
  }
  EXPECT_NEAR(lowest, 0.0, 1e-9);
  EXPECT_NEAR(highest, walker.stature, 1e-9);
  for (const char* name : {"left sole, outside", "right sole, inside", "left toes"}) {
    const int i = walker.part(name);
    EXPECT_NEAR(placed.from[i].z() - walker.body.parts[i].radius, 0.0, 1e-9) << name;
    EXPECT_NEAR(placed.to[i].z() - walker.body.parts[i].radius, 0.0, 1e-9) << name;
  }
}

TEST(Body, OnlySolesComeNearTheFloorWhileStanding) {
  const TestWalker walker;
  const Placed placed = place(walker.skeleton, walker.body, walker.standing(0, 0));
  for (size_t i = 0; i < walker.body.parts.size(); ++i) {
    if (walker.body.parts[i].sole >= 0) continue;
    EXPECT_GT(std::min(placed.from[i].z(), placed.to[i].z()) - walker.body.parts[i].radius, 0.03)
        << walker.body.parts[i].name;
  }
}

TEST(Body, IsAsBroadAndDeepAsPeopleAre) {
  const TestWalker walker;
  const Placed placed = place(walker.skeleton, walker.body, walker.standing(0, 0));  // faces +x
  const auto extent = [&](const std::string& name, int axis) {
    const int i = walker.part(name);
    return std::abs(placed.from[i][axis] - placed.to[i][axis]) + 2.0 * walker.body.parts[i].radius;
  };
  // Gordon et al. 1989 over 1.756 m, times 1.70 m.
  EXPECT_NEAR(extent("chest", 1), 0.322 / 1.756 * 1.70, 1e-9);
  EXPECT_NEAR(extent("chest", 0), 0.243 / 1.756 * 1.70, 1e-9);
  EXPECT_NEAR(extent("pelvis", 1), 0.342 / 1.756 * 1.70, 1e-9);
  EXPECT_NEAR(extent("left sole, outside", 0), 0.152 * 1.70 - 0.06 + walker.foot.radius, 1e-6);
  const int l = walker.part("left shoulder"), r = walker.part("right shoulder");
  EXPECT_NEAR(std::abs(placed.to[l].y() - placed.to[r].y()) + 2.0 * walker.body.parts[l].radius,
              0.46, 0.02);
}

TEST(Body, FeetPointForwardAndSolesSpreadToEitherSide) {
  const TestWalker walker;
  const Placed placed = place(walker.skeleton, walker.body, walker.standing(0, 0));
  const int outside = walker.part("left sole, outside"), inside = walker.part("left sole, inside");
  EXPECT_GT(placed.to[outside].x(), placed.from[outside].x() + 0.1);
  EXPECT_GT(placed.to[outside].y(), placed.to[inside].y() + 0.03);  // left is +y
  EXPECT_EQ(placed.from[outside], placed.from[inside]);
}

TEST(Body, ScalesWithStature) {
  const TestWalker walker;
  const double factor = 0.8;
  const Body small =
      makeBody(walker.skeleton.scaled(factor), walker.roles, factor * walker.stature,
               evenSoles({factor * walker.foot.ankle_height, factor * walker.foot.radius}));
  ASSERT_EQ(small.parts.size(), walker.body.parts.size());
  for (size_t i = 0; i < small.parts.size(); ++i) {
    EXPECT_NEAR(small.parts[i].radius, factor * walker.body.parts[i].radius, 1e-12);
    EXPECT_LT((small.parts[i].from - factor * walker.body.parts[i].from).norm(), 1e-9)
        << small.parts[i].name;
    EXPECT_LT((small.parts[i].to - factor * walker.body.parts[i].to).norm(), 1e-9);
  }
}

TEST(Body, AFootThatRollsOverHeelAndBallDoesNotSinkIn) {
  const TestWalker walker;
  const LegJoints& leg = walker.roles.legs[kLeft];
  for (double pitch = -0.5; pitch <= 1.0; pitch += 0.05) {
    // The ankle as FootShape has it over a sole at the origin; the toes stay flat once the heel is
    // up.
    const Eigen::Vector3d ankle = rolledAnkle(walker.foot, pitch);
    const Eigen::Quaterniond q_WF(Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                                  walker.foot.q_SF);
    const JointFrame foot{q_WF, ankle};
    JointFrame toe{q_WF, foot * walker.skeleton.joint(leg.toe).offset};
    if (pitch > 0.0) toe.q_WJ = walker.foot.q_SF;
    for (const BodyPart& part : walker.body.parts) {
      if (part.sole != kLeft) continue;
      const JointFrame& frame = part.joint == leg.toe ? toe : foot;
      const double lowest = std::min((frame * part.from).z(), (frame * part.to).z()) - part.radius;
      EXPECT_GT(lowest, -1e-9) << part.name << " at " << pitch;
    }
  }
}

// Feet that drop differently have soles of their own: in the rest pose, where both are flat, each
// reaches down to the ground and nothing of it below.
TEST(Body, BothSolesLieOnTheGroundThoughFeetDropDifferently) {
  const TestWalker walker;
  for (const auto& [left, right] : {std::pair(0.65, 0.5), std::pair(0.25, 0.42)}) {
    const Skeleton skeleton = withFootDrops(walker.skeleton, walker.roles, {left, right});
    const std::array<FootShape, 2> feet = makeFootShapes(skeleton, walker.roles, walker.stature);
    const Body body = makeBody(skeleton, walker.roles, walker.stature, soleHeights(feet));
    std::array<std::vector<double>, 2> lowest;
    for (const BodyPart& part : body.parts) {
      if (part.sole < 0) continue;
      const Side side = static_cast<Side>(part.sole);
      const LegJoints& leg = walker.roles.legs[side];
      const JointFrame foot{feet[side].q_SF, Eigen::Vector3d(0.0, 0.0, feet[side].ankle_height)};
      const JointFrame toe{feet[side].q_SF, foot * skeleton.joint(leg.toe).offset};
      const JointFrame& frame = part.joint == leg.toe ? toe : foot;
      lowest[side].push_back(std::min((frame * part.from).z(), (frame * part.to).z()) -
                             part.radius);
    }
    for (const Side side : {kLeft, kRight}) {
      EXPECT_NEAR(*std::min_element(lowest[side].begin(), lowest[side].end()), 0.0, 1e-9);
    }
  }
}

TEST(Body, CanBeMadeOfEveryCommonRig) {
  const std::filesystem::path mocap = std::filesystem::path(AMBLE_SHARED) / "mocap";
  if (!std::filesystem::exists(mocap)) GTEST_SKIP() << mocap << " is not there";
  for (const char* name : {"accad_female1/Female1_B03_Walk1.bvh", "accad_male1/Male1_B3_Walk.bvh",
                           "cmu_mb2/07_01.bvh", "cmu_daz/07_01.bvh", "cmu_max/131_01.bvh"}) {
    Clip clip = readBvh(mocap / name);
    const JointRoles roles = guessJointRoles(clip.skeleton, name);
    const Skeleton skeleton = clip.skeleton.scaled(guessUnit(clip.skeleton, roles));
    const double stature = statureOf(skeleton, roles);
    const Body body =
        makeBody(skeleton, roles, stature, evenSoles({0.039 * stature, 0.0095 * stature}));
    EXPECT_EQ(body.parts.size(), 25u) << name;
    for (const BodyPart& part : body.parts) {
      EXPECT_TRUE(part.from.allFinite() && part.to.allFinite()) << name << part.name;
      EXPECT_LT((part.to - part.from).norm(), 0.35 * stature) << name << " " << part.name;
    }
  }
}

// Of a rig whose joints all point along their bones nobody stands in the rest pose: whoever is
// upright in it has his wrists bent as it happens.
TEST(Body, AHandIsWhereItsRigHasItHoweverTheWristIsBent) {
  std::vector<Joint> joints = TestWalker::joints();
  for (Joint& joint : joints)
    if (joint.name == "LeftHand") joint.end_sites = {{0.08, 0.0, 0.06}};
  const Skeleton skeleton(joints);
  const TestWalker walker;
  const int hand = walker.roles.arms[kLeft].hand;
  for (const double bent : {-0.6, 0.0, 0.5}) {
    // Arms hang, which parts them from the rest pose.
    const Pose standing = walker.standing(0, 0);
    BodyStance stance;
    for (int j = 0; j < skeleton.size(); ++j) {
      const int parent = skeleton.joint(j).parent;
      Eigen::Quaterniond q = standing.rotations[j];
      if (j == hand) q = expRotation(bent * Eigen::Vector3d(0.3, 0.8, 0.5));
      stance.upright.q_HJ.push_back(parent < 0 ? q : stance.upright.q_HJ[parent] * q);
    }
    const Body body = makeBody(skeleton, walker.roles, walker.stature,
                               evenSoles({walker.foot.ankle_height, walker.foot.radius}), stance);
    const BodyPart& part = body.parts[walker.part("left hand")];
    ASSERT_EQ(part.joint, hand);
    EXPECT_LT((part.to - part.from).normalized().cross(Eigen::Vector3d(0.8, 0, 0.6)).norm(), 1e-9)
        << bent;
    // The other has no end: it goes on from its forearm.
    const BodyPart& other = body.parts[walker.part("right hand")];
    EXPECT_LT((other.to - other.from).normalized().cross(Eigen::Vector3d::UnitX()).norm(), 1e-9);
  }
}

// Else a bar might go through a throat that is not there.
TEST(Body, HeadAndNeckMeetInEveryCommonRig) {
  const std::filesystem::path mocap = std::filesystem::path(AMBLE_SHARED) / "mocap";
  if (!std::filesystem::exists(mocap)) GTEST_SKIP() << mocap << " is not there";
  for (const char* name : {"accad_female1/Female1_B03_Walk1.bvh", "accad_male1/Male1_B3_Walk.bvh",
                           "cmu_mb2/07_01.bvh", "cmu_daz/07_01.bvh", "cmu_max/131_01.bvh"}) {
    const CapturedMotion motion = readMotion(mocap / name);
    const double stature = statureOf(motion.clip.skeleton, motion.roles);
    for (const bool upright : {false, true}) {
      BodyStance options;
      if (upright) options.upright = referenceOf(motion.clip, motion.roles);
      const Body body = makeBody(motion.clip.skeleton, motion.roles, stature,
                                 evenSoles({0.039 * stature, 0.0095 * stature}), options);
      const BodyPart& head = body.parts[body.head];
      const auto neck = std::find_if(body.parts.begin(), body.parts.end(),
                                     [](const BodyPart& part) { return part.name == "neck"; });
      ASSERT_NE(neck, body.parts.end());
      const Placed placed =
          place(motion.clip.skeleton, body, motion.clip.poses[motion.clip.frames() / 2]);
      const size_t at_head = body.head, at_neck = neck - body.parts.begin();
      const double gap =
          (placed.to[at_neck] - placed.from[at_head]).norm() - head.radius - neck->radius;
      EXPECT_LT(gap, 0.0) << name;
    }
  }
}

// Of rigs whose joints point along their bones the rest pose is nobody's: their trunks lie across
// it.
TEST(Body, TrunksAreWhereTheirJointsAreInAnyRigThatWalks) {
  const std::filesystem::path mocap = std::filesystem::path(AMBLE_SHARED) / "mocap";
  if (!std::filesystem::exists(mocap)) GTEST_SKIP() << mocap << " is not there";
  for (const char* name : {"accad_female1/Female1_B03_Walk1.bvh", "accad_male1/Male1_B3_Walk.bvh",
                           "cmu_mb2/07_01.bvh", "cmu_daz/07_01.bvh", "cmu_max/131_01.bvh"}) {
    const CapturedMotion motion = readMotion(mocap / name);
    const Clip& clip = motion.clip;
    const JointRoles& roles = motion.roles;
    const double stature = statureOf(clip.skeleton, roles);
    const Body body =
        makeBody(clip.skeleton, roles, stature, evenSoles({0.039 * stature, 0.0095 * stature}),
                 {.upright = referenceOf(clip, roles)});
    const int frame = clip.frames() / 2;
    std::vector<JointFrame> joints(clip.skeleton.size());
    forwardKinematics(clip, frame, joints);
    const auto at = [&](int joint) { return joints[joint].p_WJ; };
    const Eigen::Vector3d hips =
        0.5 * (at(roles.legs[kLeft].up_leg) + at(roles.legs[kRight].up_leg));
    const Eigen::Vector3d neck = 0.5 * (at(roles.arms[kLeft].arm) + at(roles.arms[kRight].arm));
    const Eigen::Vector3d across =
        (at(roles.legs[kLeft].up_leg) - at(roles.legs[kRight].up_leg)).normalized();
    const Placed placed = place(clip.skeleton, body, clip.poses[frame]);
    for (size_t i = 0; i < body.parts.size(); ++i) {
      const BodyPart& part = body.parts[i];
      if (part.name != "pelvis" && part.name != "abdomen" && part.name != "chest") continue;
      const Eigen::Vector3d middle = 0.5 * (placed.from[i] + placed.to[i]);
      const Eigen::Vector3d up = (neck - hips).normalized();
      const Eigen::Vector3d off = middle - hips - up.dot(middle - hips) * up;
      EXPECT_LT(off.norm(), 0.05 * stature) << name << " " << part.name;
      EXPECT_GT((placed.from[i] - placed.to[i]).normalized().dot(across), 0.9)
          << name << " " << part.name;
    }
  }
}

}  // namespace
}  // namespace amble
