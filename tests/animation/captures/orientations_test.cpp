// What a file leaves open is guessed from the person alone: under every turn of its axes, in every
// unit, from every view.

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "animation/captures/capture_checks.h"
#include "animation/captures/motion_guesses.h"
#include "animation/captures/role_guess.h"
#include "animation/captures/role_tree.h"
#include "animation/captures/step_rhythm.h"
#include "animation/captures/unit_guess.h"
#include "base/rotation.h"
#include "tests/animation/moved_clip.h"
#include "tests/animation/person.h"
#include "tests/animation/random_clip.h"
#include "tests/animation/some_captures.h"

namespace amble {
namespace {

/// The 24 turns of a cube.
std::vector<Eigen::Quaterniond> axisTurns() {
  std::vector<Eigen::Quaterniond> turns;
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 4; ++y) {
      for (int z = 0; z < 4; ++z) {
        const Eigen::Quaterniond q =
            fromEuler(0.5 * kPi * Eigen::Vector3d(x, y, z), {'X', 'Y', 'Z'});
        if (std::none_of(turns.begin(), turns.end(), [&](const Eigen::Quaterniond& other) {
              return q.angularDistance(other) < 0.1;
            })) {
          turns.push_back(q);
        }
      }
    }
  }
  return turns;
}

void expectRoles(const JointRoles& found, const JointRoles& wanted, const std::string& what) {
  for (const std::string& role : roleNames()) {
    EXPECT_EQ(roleJoint(found, role), roleJoint(wanted, role)) << role << ' ' << what;
  }
}

TEST(Orientations, ThereAreTwentyFourTurnsOfACube) { EXPECT_EQ(axisTurns().size(), 24u); }

// Standing along y or z it is found there; along any other axis the usual one is taken and said to
// be unsure. It is never surely wrong.
TEST(Orientations, UpIsFoundUnderEveryTurnOfTheAxesOrSaidToBeUnsure) {
  const Clip person = walkingPerson();
  const JointRoles roles = guessJointRoles(person.skeleton, "person");
  std::map<UpAxis, int> surely;
  for (const Eigen::Quaterniond& turn : axisTurns()) {
    const Reading<UpAxis> up = guessUp(moved(person, turn, {0, 0, 0}), roles);
    const Eigen::Vector3d vertical = turn * Eigen::Vector3d::UnitZ();
    EXPECT_TRUE(up.guessed);
    EXPECT_EQ(up.sure, vertical.y() > 0.5 || vertical.z() > 0.5) << vertical.transpose();
    if (!up.sure) continue;
    EXPECT_EQ(up.value, vertical.z() > 0.5 ? UpAxis::kZ : UpAxis::kY) << vertical.transpose();
    ++surely[up.value];
  }
  EXPECT_EQ(surely[UpAxis::kY], 4);
  EXPECT_EQ(surely[UpAxis::kZ], 4);
}

TEST(Orientations, RolesByShapeAreTheSameUnderEveryTurnOfTheAxes) {
  AMBLE_NEEDS_CAPTURES();
  int rigs = 0;
  std::set<std::string> folders;
  for (const SomeCapture& one : someCaptures()) {
    if (!folders.insert(one.path.substr(0, one.path.find('/'))).second) continue;
    const JointRoles here = rolesByTree(one.clip);
    for (const Eigen::Quaterniond& turn : axisTurns()) {
      expectRoles(rolesByTree(moved(one.clip, turn, {1.0, 2.0, 3.0})), here, one.path);
    }
    ++rigs;
  }
  EXPECT_GT(rigs, 4);
}

// Seen in a mirror a person's left is the right.
TEST(Orientations, RolesByShapeOfAMirrorImageAreThoseOfTheOtherSide) {
  AMBLE_NEEDS_CAPTURES();
  const auto flip = [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return {p.x(), -p.y(), p.z()};
  };
  for (const SomeCapture& one : someCaptures()) {
    JointRoles wanted = rolesByTree(one.clip);
    if (!missingRole(wanted).empty()) continue;
    std::swap(wanted.legs[kLeft], wanted.legs[kRight]);
    std::swap(wanted.arms[kLeft], wanted.arms[kRight]);
    Clip image = one.clip;
    std::vector<Joint> joints = image.skeleton.joints();
    for (Joint& joint : joints) joint.offset = flip(joint.offset);
    image.skeleton = Skeleton(joints);
    for (int i = 0; i < image.frames(); ++i) {
      image.poses.p_WR(i) = flip(image.poses.p_WR(i));
      for (Eigen::Quaterniond& q : image.poses.rotations(i)) {
        q = Eigen::Quaterniond(q.w(), -q.x(), q.y(), -q.z());
      }
    }
    for (Eigen::Vector3d& p : image.joint_positions) p = flip(p);
    expectRoles(rolesByTree(image), wanted, one.path);
  }
}

TEST(Orientations, RolesByShapeDoNotDependOnTheOrderOfBranches) {
  AMBLE_NEEDS_CAPTURES();
  Generator generator(601);
  for (const SomeCapture& one : someCaptures()) {
    const Skeleton& skeleton = one.clip.skeleton;
    const JointRoles here = rolesByTree(one.clip);
    // Any order in which parents precede their children.
    std::vector<int> order = {0}, place(skeleton.size(), -1);
    std::vector<int> open;
    for (int j = 1; j < skeleton.size(); ++j) {
      if (skeleton.joint(j).parent == 0) open.push_back(j);
    }
    while (!open.empty()) {
      const size_t k = std::uniform_int_distribution<size_t>(0, open.size() - 1)(generator);
      const int joint = open[k];
      open.erase(open.begin() + static_cast<std::ptrdiff_t>(k));
      order.push_back(joint);
      for (int j = joint + 1; j < skeleton.size(); ++j) {
        if (skeleton.joint(j).parent == joint) open.push_back(j);
      }
    }
    std::vector<Joint> joints;
    for (size_t i = 0; i < order.size(); ++i) {
      place[order[i]] = static_cast<int>(i);
      joints.push_back(skeleton.joint(order[i]));
      if (i > 0) joints.back().parent = place[joints.back().parent];
    }
    Clip other{"shuffled", Skeleton(joints), one.clip.frame_time, PoseArray(skeleton.size()), {}};
    Pose pose;
    for (int i = 0; i < one.clip.frames(); i += 10) {
      pose.p_WR = one.clip.poses.p_WR(i);
      pose.rotations.clear();
      for (const int j : order) pose.rotations.push_back(one.clip.poses.rotations(i)[j]);
      other.poses.append(pose);
    }
    const JointRoles there = rolesByTree(other);
    for (const std::string& role : roleNames()) {
      const int joint = roleJoint(here, role);
      EXPECT_EQ(roleJoint(there, role), joint < 0 ? -1 : place[joint]) << role << ' ' << one.path;
    }
  }
}

TEST(Orientations, AClipWithoutFramesIsGuessedAsTheUsualAndSaidToBeUnsure) {
  Clip person = walkingPerson();
  const JointRoles roles = guessJointRoles(person.skeleton, "person");
  person.poses.clear();
  EXPECT_EQ(guessUp(person, roles).value, UpAxis::kY);
  EXPECT_FALSE(guessUp(person, roles).sure);
  EXPECT_EQ(guessFacing(person, roles).value, 0.0);
  EXPECT_FALSE(guessFacing(person, roles).sure);
  expectRoles(guessRoles(person, "it").roles, roles, "without frames");
}

TEST(Orientations, FacingTurnsWithEveryCaptureAndTheMannerOfGoingStays) {
  AMBLE_NEEDS_CAPTURES();
  for (const SomeCapture& one : someCaptures()) {
    const Reading<double> here = guessFacing(one.clip, one.roles);
    const auto manner = [](const std::string& text) { return text.substr(text.find(';')); };
    for (const double turn : {0.8, 3.0, -1.6}) {
      const Reading<double> there =
          guessFacing(moved(one.clip, aboutZ(turn), {5.0, 5.0, 0.0}), one.roles);
      EXPECT_NEAR(wrapAngle(there.value - here.value - turn), 0.0, 1e-9) << one.path;
      EXPECT_EQ(there.sure, here.sure) << one.path;
      EXPECT_EQ(manner(there.text), manner(here.text)) << one.path;
    }
  }
}

TEST(Orientations, WhoWalksBackwardsIsSaidToAndFacesAsBefore) {
  const Clip person = walkingPerson();
  const JointRoles roles = guessJointRoles(person.skeleton, "person");
  Clip back = person;
  for (int i = 0; i < person.frames(); ++i) {
    const int from = person.frames() - 1 - i;
    back.poses.p_WR(i) = person.poses.p_WR(from);
    const auto q = person.poses.rotations(from);
    std::copy(q.begin(), q.end(), back.poses.rotations(i).begin());
  }
  EXPECT_NE(guessFacing(person, roles).text.find("goes forwards"), std::string::npos);
  EXPECT_NE(guessFacing(back, roles).text.find("goes backwards"), std::string::npos);
  EXPECT_TRUE(guessFacing(back, roles).sure);
}

TEST(Orientations, TheRhythmIsTheSameInEveryUnitAndOnEveryWay) {
  AMBLE_NEEDS_CAPTURES();
  for (const SomeCapture& one : someCaptures()) {
    const StepRhythm here = stepRhythm(one.clip, one.roles);
    Clip other = moved(one.clip, aboutZ(2.1), {0.0, 7.0, 0.0});
    other.skeleton = other.skeleton.scaled(37.0);
    for (int i = 0; i < other.frames(); ++i) other.poses.p_WR(i) *= 37.0;
    for (Eigen::Vector3d& p : other.joint_positions) p *= 37.0;
    const StepRhythm there = stepRhythm(other, one.roles);
    EXPECT_EQ(there.steps, here.steps) << one.path;
    EXPECT_NEAR(there.cadence, here.cadence, 1e-9) << one.path;
    EXPECT_NEAR(there.speed, here.speed, 1e-6) << one.path;
    EXPECT_NEAR(there.ground_speed, here.ground_speed, 1e-6) << one.path;
  }
}

TEST(Orientations, ShownTwiceAsFastTheRhythmIsTwiceAsFast) {
  AMBLE_NEEDS_CAPTURES();
  for (const SomeCapture& one : someCaptures()) {
    const StepRhythm here = stepRhythm(one.clip, one.roles);
    Clip fast = one.clip;
    fast.frame_time *= 0.5;
    const StepRhythm there = stepRhythm(fast, one.roles);
    EXPECT_EQ(there.steps, here.steps) << one.path;
    EXPECT_NEAR(there.cadence, 2.0 * here.cadence, 1e-9) << one.path;
    EXPECT_NEAR(there.speed, 2.0 * here.speed, 1e-9) << one.path;
    EXPECT_NEAR(2.0 * there.least_step, here.least_step, 1e-9) << one.path;
  }
}

// Inman: cadence with the root of speed; a k times larger leg has a root of root of k slower one.
TEST(Orientations, CadenceOverUsualIsByTheLaw) {
  for (const double speed : {0.5, 1.5, 3.0}) {
    for (const double leg : {0.4, 0.83, 1.1}) {
      StepRhythm rhythm;
      rhythm.speed = speed;
      rhythm.cadence = 2.0 * 0.743 * std::sqrt(speed) * std::pow(0.83 / leg, 0.25);
      EXPECT_NEAR(cadenceOverUsual(rhythm, leg), 1.0, 1e-12);
      rhythm.cadence *= 1.3;
      EXPECT_NEAR(cadenceOverUsual(rhythm, leg), 1.3, 1e-12);
      rhythm.speed *= 4.0;
      EXPECT_NEAR(cadenceOverUsual(rhythm, leg), 0.65, 1e-12);
    }
  }
}

TEST(Orientations, JitterIsOfJointsAndNotOfPlaceHeadingOrSpeed) {
  AMBLE_NEEDS_CAPTURES();
  for (const SomeCapture& one : someCaptures()) {
    const double here = jointJitter(one.clip);
    EXPECT_NEAR(jointJitter(moved(one.clip, aboutZ(1.0), {3.0, 0.0, 0.0})), here, 1e-9);
    Clip fast = one.clip;
    fast.frame_time *= 0.25;
    EXPECT_EQ(jointJitter(fast), here) << one.path;
  }
}

TEST(Orientations, AJumpIsFoundInEveryCaptureInWhicheverDirectionItGoes) {
  AMBLE_NEEDS_CAPTURES();
  Generator generator(602);
  for (const SomeCapture& one : someCaptures()) {
    if (one.clip.frames() < 40 || !rootJumps(one.clip).empty()) continue;
    const int frame = std::uniform_int_distribution<int>(10, one.clip.frames() - 20)(generator);
    const Eigen::Vector3d by = 3.0 * (randomRotation(generator) * Eigen::Vector3d::UnitX());
    Clip broken = one.clip;
    for (int i = frame + 1; i < broken.frames(); ++i) broken.poses.p_WR(i) += by;
    const std::vector<RootJump> jumps = rootJumps(broken);
    ASSERT_EQ(jumps.size(), 1u) << one.path;
    EXPECT_EQ(jumps[0].frame, frame) << one.path;
    EXPECT_NEAR(jumps[0].distance, 3.0, 0.2) << one.path;
  }
}

TEST(Orientations, AUnitIsGuessedBySizeAndTheGuessScalesWithTheUnits) {
  for (const double unit : {1.0, 0.01, 0.001}) {
    for (const double leg : {0.74, 0.83, 0.95}) {
      const Reading<double> guess = guessUnit(leg / unit, {}, 1.0 / 30.0);
      EXPECT_EQ(guess.value, unit) << leg;
      EXPECT_TRUE(guess.guessed);
      EXPECT_FALSE(guess.text.empty());
    }
  }
}

}  // namespace
}  // namespace amble
