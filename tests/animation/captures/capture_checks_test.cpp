#include "animation/captures/capture_checks.h"

#include <gtest/gtest.h>

#include <random>

#include "animation/captures/motion_reader.h"
#include "base/rotation.h"
#include "tests/animation/captures.h"
#include "tests/animation/person.h"

namespace amble {
namespace {

/// The one warning of a case that holds these words; "" for none.
std::string warningOf(const std::string& name, const std::string& words) {
  for (const std::string& warning : readMotion(sharedFolder() / "cases/captures" / name).warnings) {
    if (warning.find(words) != warning.npos) return warning;
  }
  return "";
}

bool haveCases() { return std::filesystem::exists(sharedFolder() / "cases/captures"); }

Clip shaken(Clip clip, double degrees) {
  std::mt19937_64 generator(3);
  std::normal_distribution<double> noise(0.0, degrees * kDegree);
  for (int i = 0; i < clip.frames(); ++i) {
    for (Eigen::Quaterniond& q : clip.poses.rotations(i)) {
      const double x = noise(generator), y = noise(generator);
      q = q * expRotation({x, y, noise(generator)});
    }
  }
  return clip;
}

TEST(CaptureChecks, NoiseIsMeasuredToItsSizeAndMovementIsNone) {
  const Clip walk = walkingPerson();
  EXPECT_LT(jointJitter(walk), 0.1 * kDegree);
  for (const double degrees : {1.0, 2.0}) {
    EXPECT_NEAR(jointJitter(shaken(walk, degrees)), degrees * kDegree, 0.2 * degrees * kDegree);
  }
}

TEST(CaptureChecks, AJumpOfTheRootIsFoundWhereItIs) {
  Clip walk = walkingPerson();
  EXPECT_TRUE(rootJumps(walk).empty());
  for (int i = 31; i < walk.frames(); ++i) walk.poses.p_WR(i).x() -= 1.5;
  const std::vector<RootJump> jumps = rootJumps(walk);
  ASSERT_EQ(jumps.size(), 1u);
  EXPECT_EQ(jumps[0].frame, 30);
  EXPECT_NEAR(jumps[0].distance, 1.5, 0.05);
}

TEST(CaptureChecks, ARootThatIsOutForAFrameJumpsThereAndBack) {
  for (const int out : {1, 2, 5}) {
    Clip walk = walkingPerson();
    for (int i = 31; i < 31 + out; ++i) walk.poses.p_WR(i).z() += 1.5;
    const std::vector<RootJump> jumps = rootJumps(walk);
    ASSERT_EQ(jumps.size(), 2u) << out;
    EXPECT_EQ(jumps[0].frame, 30);
    EXPECT_EQ(jumps[1].frame, 30 + out);
  }
}

TEST(CaptureChecks, AFrameTimeThatIsTimesTooLongIsToldHoweverSlowItMakesTheWalk) {
  const Clip walk = walkingPerson();
  for (const double times : {4.0, 6.0, 15.0}) {
    Clip slow = walk;
    slow.frame_time *= times;
    const std::vector<std::string> warnings = captureWarnings(slow, rolesByName(slow.skeleton));
    ASSERT_EQ(warnings.size(), 1u) << times;
    EXPECT_NE(warnings[0].find("times too long; --file-fps 30 "), std::string::npos) << warnings[0];
  }
}

TEST(CaptureChecks, ASprintIsNoJump) {
  Clip walk = walkingPerson();
  for (int i = 0; i < walk.frames(); ++i) walk.poses.p_WR(i).x() = 12.0 * i * walk.frame_time;
  EXPECT_TRUE(rootJumps(walk).empty());
}

TEST(CaptureChecks, AGoodWalkHasNoWarning) {
  const Clip walk = walkingPerson();
  const JointRoles roles = readMotion([&] {
                             static const TestFolder folder;
                             const auto file = folder.path() / "walk.bvh";
                             writeBvh(file, walk);
                             return file;
                           }())
                               .roles;
  EXPECT_TRUE(captureWarnings(walk, roles).empty());
}

TEST(CaptureChecksOfCases, SayWhatIsWrong) {
  if (!haveCases()) GTEST_SKIP() << "no cases in " << sharedFolder();
  EXPECT_NE(warningOf("b01_in_place.bvh", "on the spot").find("goes back under it at 1.1"),
            std::string::npos);
  EXPECT_NE(warningOf("b05_jitter_1.5deg.bvh", "noisy").find("by 1.5 degrees"), std::string::npos);
  EXPECT_NE(warningOf("b08_jump_back.bvh", "jumps").find("between frames 59 and 60"),
            std::string::npos);
  EXPECT_NE(warningOf("a12_wrong_frame_time_24.bvh", "steps a minute")
                .find("4.1 times too short; --file-fps 30"),
            std::string::npos);
  const CapturedMotion mended = readMotion(
      sharedFolder() / "cases/captures/a12_wrong_frame_time_24.bvh", {.frame_time = 1.0 / 30.0});
  EXPECT_EQ(mended.clip.frame_time, 1.0 / 30.0);
  EXPECT_TRUE(mended.warnings.empty());
}

TEST(CaptureChecksOfCaptures, GoodCapturesHaveNoWarning) {
  AMBLE_NEEDS_CAPTURES();
  for (const Capture& capture : captures()) {
    const CapturedMotion motion = readMotion(capture.file);
    for (const std::string& warning : motion.warnings) {
      EXPECT_TRUE(warning.starts_with("unsure of ")) << capture.path << " " << warning;
    }
  }
}

}  // namespace
}  // namespace amble
