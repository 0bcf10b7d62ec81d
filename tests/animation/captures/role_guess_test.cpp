#include "animation/captures/role_guess.h"

#include <gtest/gtest.h>

#include "animation/captures/bvh.h"
#include "animation/captures/role_tree.h"
#include "base/error.h"
#include "base/rotation.h"
#include "tests/animation/captures.h"
#include "tests/animation/person.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

/// The same clip with names that say nothing.
Clip nameless(Clip clip) {
  std::vector<Joint> joints = clip.skeleton.joints();
  for (size_t j = 0; j < joints.size(); ++j) joints[j].name = "bone" + std::to_string(j);
  clip.skeleton = Skeleton(joints);
  return clip;
}

/// The same clip in other axes, root and all.
Clip turned(Clip clip, const Eigen::Quaterniond& turn) {
  for (int i = 0; i < clip.frames(); ++i) {
    clip.poses.p_WR(i) = turn * clip.poses.p_WR(i);
    clip.poses.rotations(i)[0] = turn * clip.poses.rotations(i)[0];
  }
  return clip;
}

TEST(RoleGuess, AFileOfRolesIsRefusedByLineWhereItNamesWhatIsNot) {
  const TestFolder folder;
  const Clip clip = walkingPerson();
  const auto refused = [&](const std::string& yaml) {
    const auto file = folder.write("roles.yaml", yaml);
    return errorOf([&] { guessRoles(clip, "walk.bvh", file); });
  };
  EXPECT_NE(refused("hips: Hips\nleft_fot: LeftFoot\n").find("roles.yaml:2: "), std::string::npos);
  EXPECT_NE(refused("left_foot: LeftFoof\n").find("'LeftFoot'?"), std::string::npos);
  EXPECT_NE(refused("hips: [Hips]\n").find("roles.yaml:1: "), std::string::npos);
  EXPECT_THROW(guessRoles(clip, "walk.bvh", folder.path() / "none.yaml"), InputError);
}

TEST(RoleGuess, WhatTheFileSaysHolds) {
  const TestFolder folder;
  const Clip clip = walkingPerson();
  const auto file =
      folder.write("roles.yaml", "left_foot: RightFoot\nright_foot: LeftFoot\nneck: none\n");
  const RoleGuess guess = guessRoles(clip, "walk.bvh", file);
  EXPECT_EQ(guess.roles.legs[kLeft].foot, clip.skeleton.find("RightFoot"));
  EXPECT_EQ(guess.roles.legs[kRight].foot, clip.skeleton.find("LeftFoot"));
  EXPECT_EQ(guess.roles.neck, -1);
  EXPECT_EQ(guess.roles.head, clip.skeleton.find("Head"));
}

TEST(RoleGuess, WhatIsUnsureIsTold) {
  Clip clip = walkingPerson();
  EXPECT_TRUE(guessRoles(clip, "walk.bvh").unsure.empty());
  std::vector<Joint> joints = clip.skeleton.joints();
  joints[clip.skeleton.find("LeftToeBase")].name = "Thing";
  clip.skeleton = Skeleton(joints);
  const RoleGuess guess = guessRoles(clip, "walk.bvh");
  ASSERT_EQ(guess.unsure.size(), 1u);
  EXPECT_EQ(guess.unsure[0], "left_toe: no joint fits");
}

TEST(RoleGuess, ALimbInTheWrongOrderIsTold) {
  Clip clip = walkingPerson();
  std::vector<Joint> joints = clip.skeleton.joints();
  std::swap(joints[clip.skeleton.find("LeftLeg")].name,
            joints[clip.skeleton.find("LeftFoot")].name);
  clip.skeleton = Skeleton(joints);
  const RoleGuess guess = guessRoles(clip, "walk.bvh");
  ASSERT_FALSE(guess.unsure.empty());
  EXPECT_EQ(guess.unsure[0], "left_foot: does not hang below left_leg");
}

TEST(RoleGuess, AThingThatIsNoPersonHasAMissingRole) {
  Generator generator(3);
  EXPECT_EQ(guessRoles(randomClip(generator, 1, 2), "ball.bvh").missing, "left_up_leg");
  EXPECT_THROW(guessRoles(Clip(), "none.bvh"), InputError);
}

TEST(RoleGuess, WithoutNamesTheShapeOfTheSkeletonTells) {
  const Clip person = walkingPerson();
  const JointRoles named = rolesByName(person.skeleton);
  // Whichever axis is up, and with or without frames.
  for (const Eigen::Quaterniond& turn :
       {Eigen::Quaterniond::Identity(), yUpToWorld(), expRotation({1.0, 2.0, -0.5})}) {
    const RoleGuess guess = guessRoles(turned(nameless(person), turn), "walk.bvh");
    EXPECT_EQ(guess.missing, "");
    for (const std::string& role : roleNames()) {
      EXPECT_EQ(roleJoint(guess.roles, role), roleJoint(named, role)) << role;
    }
    EXPECT_GE(guess.unsure.size(), 15u) << "every role is told to be guessed by the shape";
  }
  Clip still = nameless(person);
  still.poses.clear();
  EXPECT_EQ(roleJoint(rolesByTree(still), "left_foot"), roleJoint(named, "left_foot"));
}

TEST(RoleGuess, NamesThatSayALittleAreHeard) {
  Clip person = walkingPerson();
  std::vector<Joint> joints = person.skeleton.joints();
  joints[person.skeleton.find("Head")].name = "Top";
  person.skeleton = Skeleton(joints);
  const RoleGuess guess = guessRoles(person, "walk.bvh");
  EXPECT_EQ(guess.roles.head, person.skeleton.find("Top"));
  EXPECT_EQ(guess.roles.legs[kLeft].foot, person.skeleton.find("LeftFoot"));
  EXPECT_NE(std::find(guess.unsure.begin(), guess.unsure.end(),
                      "head: by the shape of the skeleton, Top"),
            guess.unsure.end());
}

TEST(RoleGuess, ALimbIsToldByNamesOrByTheShapeAndNoJointHasTwoRoles) {
  const Clip person = walkingPerson();
  // Only the clavicle of each arm has a name that says something: an arm's, taken alone.
  Clip half = person;
  std::vector<Joint> joints = half.skeleton.joints();
  for (const char* const bone : {"LeftArm", "LeftForeArm", "RightArm", "RightForeArm"})
    joints[half.skeleton.find(bone)].name = std::string("bone of ") + bone[0];
  half.skeleton = Skeleton(joints);
  const JointRoles named = rolesByName(person.skeleton);
  const RoleGuess guess = guessRoles(half, "walk.bvh");
  for (const std::string& role : roleNames())
    EXPECT_EQ(roleJoint(guess.roles, role), roleJoint(named, role)) << role;
}

TEST(RoleGuessOfCaptures, TheShapeAloneFindsWhatNamesSay) {
  AMBLE_NEEDS_CAPTURES();
  int all = 0, same = 0;
  for (const Capture& capture : captures()) {
    const Clip clip = readBvh(capture.file, {.metres_per_unit = capture.metres_per_unit});
    const JointRoles named = rolesByName(clip.skeleton), shaped = rolesByTree(clip);
    for (const char* const role :
         {"hips", "head", "left_up_leg", "left_leg", "left_foot", "right_up_leg", "right_leg",
          "right_foot", "left_arm", "left_fore_arm", "right_arm", "right_fore_arm"}) {
      ++all;
      same += roleJoint(named, role) == roleJoint(shaped, role);
    }
  }
  // Two of the captures hang things on one forearm that reach farther than the hand.
  EXPECT_GE(same, all - all / 25);
}

}  // namespace
}  // namespace amble
