#include "animation/captures/motion_reader.h"

#include <gtest/gtest.h>

#include <fstream>

#include "animation/analysis/motion_measures.h"
#include "animation/body/pelvis.h"
#include "animation/captures/bvh.h"
#include "animation/captures/find_asf.h"
#include "base/error.h"
#include "base/rotation.h"
#include "tests/animation/captures.h"
#include "tests/animation/person.h"

namespace amble {
namespace {

std::string fileRefusal(const std::filesystem::path& file, const MotionReadOptions& options = {}) {
  try {
    readMotion(file, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "read without an error";
}

TEST(MotionReader, RefusesWhatItDoesNotKnowAndWhatIsNotThere) {
  const TestFolder folder;
  EXPECT_NE(fileRefusal(folder.write("walk.txt", "a walk")).find("no kind of capture"),
            std::string::npos);
  EXPECT_NE(fileRefusal(folder.path() / "none").find("none: is not there"), std::string::npos);
  EXPECT_NE(fileRefusal(folder.path() / "none.bvh").find("cannot be opened"), std::string::npos);
  EXPECT_NE(fileRefusal(folder.write("walk.bvh", "HIERARCHX\n")).find("walk.bvh:1: 'HIERARCHX'"),
            std::string::npos);
}

TEST(MotionReader, UnitAndVerticalAreTheFilesWhicheverTheyAre) {
  const TestFolder folder;
  for (const double unit : {1.0, 0.01, 0.0254, 0.056444, 0.001}) {
    for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
      const Clip walker = walkingPerson();
      const auto file = folder.path() / "walk.bvh";
      writeInAxes(file, walker, unit, up);
      const CapturedMotion motion = readMotion(file);
      EXPECT_EQ(motion.metres_per_unit.value, unit);
      EXPECT_TRUE(motion.metres_per_unit.guessed);
      // CMU's unit goes with CMU's rate, which this walk has not: a child in inches is as likely.
      const bool sure = unit != 0.056444;
      EXPECT_EQ(motion.metres_per_unit.sure, sure);
      EXPECT_EQ(motion.up.value, up) << motion.up.text;
      EXPECT_TRUE(motion.up.guessed && motion.up.sure);
      EXPECT_EQ(motion.warnings.empty(), sure) << motion.warnings[0];
      ASSERT_EQ(motion.clip.frames(), walker.frames());
      const int last = walker.frames() - 1;
      EXPECT_LT((motion.clip.poses.p_WR(last) - walker.poses.p_WR(last)).norm(), 1e-5);
      EXPECT_NEAR(motion.facing.value, wrapAngle(pelvisHeadings(walker, motion.roles)[0]), 1e-6);
    }
  }
}

TEST(MotionReader, WhatIsAskedForIsNoGuess) {
  const TestFolder folder;
  const auto file = folder.path() / "walk.bvh";
  writeInAxes(file, walkingPerson(), 0.01, UpAxis::kY);
  MotionReadOptions options;
  options.metres_per_unit = 0.02;
  options.up = UpAxis::kZ;
  options.facing = 0.5;
  const CapturedMotion motion = readMotion(file, options);
  EXPECT_EQ(motion.metres_per_unit.value, 0.02);
  EXPECT_EQ(motion.up.value, UpAxis::kZ);
  EXPECT_EQ(motion.facing.value, 0.5);
  EXPECT_FALSE(motion.metres_per_unit.guessed || motion.up.guessed || motion.facing.guessed);
}

TEST(MotionReader, FacingTurnsTheWholeClip) {
  const TestFolder folder;
  const auto file = folder.path() / "walk.bvh";
  writeInAxes(file, walkingPerson(), 0.01, UpAxis::kY);
  const CapturedMotion as_it_is = readMotion(file);
  MotionReadOptions options;
  options.facing = -2.0;
  const CapturedMotion turned = readMotion(file, options);
  EXPECT_NEAR(pelvisHeadings(turned.clip, turned.roles)[0], -2.0, 1e-9);
  const int last = turned.clip.frames() - 1;
  const Eigen::Vector3d way = as_it_is.clip.poses.p_WR(last) - as_it_is.clip.poses.p_WR(0);
  const Eigen::Vector3d turned_way = turned.clip.poses.p_WR(last) - turned.clip.poses.p_WR(0);
  EXPECT_LT((aboutZ(-2.0 - as_it_is.facing.value) * way - turned_way).norm(), 1e-9);
}

TEST(MotionReader, ExchangedSidesAreSaid) {
  const TestFolder folder;
  std::vector<Joint> joints = walkingPerson().skeleton.joints();
  for (Joint& joint : joints) {
    if (joint.name.starts_with("Left")) {
      joint.name.replace(0, 4, "Right");
    } else if (joint.name.starts_with("Right")) {
      joint.name.replace(0, 5, "Left");
    }
  }
  Clip walker = walkingPerson();
  walker.skeleton = Skeleton(joints);
  const auto file = folder.path() / "walk.bvh";
  writeInAxes(file, walker, 0.01, UpAxis::kY);
  const CapturedMotion motion = readMotion(file);
  EXPECT_FALSE(motion.facing.sure) << motion.facing.text;
  EXPECT_NE(motion.facing.text.find("exchanged"), std::string::npos);
  EXPECT_NE(motion.facing.text.find("backwards"), std::string::npos) << motion.facing.text;
}

TEST(MotionReader, ALyingPersonIsNotTakenForAnUprightOne) {
  const TestFolder folder;
  Clip lying = walkingPerson();
  // Onto the back, head along +x of World: neither axis has the head over the feet.
  const Eigen::Quaterniond fall(Eigen::AngleAxisd(0.5 * kPi, Eigen::Vector3d::UnitY()));
  for (int i = 0; i < lying.frames(); ++i) {
    lying.poses.p_WR(i) = fall * lying.poses.p_WR(i);
    lying.poses.rotations(i)[0] = fall * lying.poses.rotations(i)[0];
  }
  const auto file = folder.path() / "lying.bvh";
  writeInAxes(file, lying, 0.01, UpAxis::kY);
  const CapturedMotion motion = readMotion(file);
  EXPECT_EQ(motion.up.value, UpAxis::kY);
  EXPECT_FALSE(motion.up.sure);
}

TEST(MotionReader, AnAmcFindsItsSkeleton) {
  const TestFolder folder;
  const std::filesystem::path amc = folder.write("07_05-walk.amc", "");
  const auto found = [&amc] { return findAsf(amc).filename().string(); };
  EXPECT_NE(fileRefusal(amc).find("no .asf lies beside it; expected its skeleton, given by --asf"),
            std::string::npos);
  folder.write("other.asf", "");
  EXPECT_EQ(found(), "other.asf");
  folder.write("08-run.asf", "");
  EXPECT_NE(fileRefusal(amc).find("several .asf lie beside it"), std::string::npos);
  folder.write("07-walk.asf", "");
  EXPECT_EQ(found(), "07-walk.asf");
  folder.write("07.ASF", "");
  EXPECT_EQ(found(), "07.ASF");
  folder.write("0.asf", "");
  EXPECT_EQ(found(), "07.ASF");
  folder.write("07_05-walk.asf", "");
  EXPECT_EQ(found(), "07_05-walk.asf");
}

TEST(MotionReaderOfCaptures, AcclaimTrialsAreReadWithTheirSkeletons) {
  AMBLE_NEEDS_CAPTURES();
  for (const char* const trial :
       {"07_05-walk.amc", "09_06-run.amc", "01_01.amc", "11_01.amc", "pirouette.amc"}) {
    const CapturedMotion motion = readMotion(sharedFolder() / "mocap/cmu_asfamc" / trial);
    EXPECT_EQ(motion.metres_per_unit.value, 0.056444) << trial;
    EXPECT_EQ(motion.up.value, UpAxis::kY) << trial;
    EXPECT_TRUE(motion.frame_time.guessed) << trial;
    EXPECT_TRUE(motion.facing.sure) << trial << " " << motion.facing.text;
  }
}

TEST(MotionReaderOfCaptures, AllStandUprightAndFaceTheWayTheirFeetPoint) {
  AMBLE_NEEDS_CAPTURES();
  for (const Capture& capture : captures()) {
    const CapturedMotion motion = readMotion(capture.file);
    EXPECT_EQ(motion.metres_per_unit.value, capture.metres_per_unit) << capture.path;
    EXPECT_EQ(motion.up.value, UpAxis::kY) << capture.path << " " << motion.up.text;
    EXPECT_TRUE(motion.facing.sure) << capture.path << " " << motion.facing.text;
  }
}

TEST(MotionReaderOfCaptures, ReadAsBvhReaderDoes) {
  AMBLE_NEEDS_CAPTURES();
  const Capture& capture = captures().front();
  const Clip plain = readBvh(capture.file, {.metres_per_unit = capture.metres_per_unit});
  const CapturedMotion motion = readMotion(capture.file);
  for (int i = 0; i < plain.frames(); ++i) {
    EXPECT_EQ(plain.poses.p_WR(i), motion.clip.poses.p_WR(i));
    for (int j = 0; j < plain.skeleton.size(); ++j) {
      EXPECT_EQ(plain.poses.rotations(i)[j].coeffs(), motion.clip.poses.rotations(i)[j].coeffs());
    }
  }
}

}  // namespace
}  // namespace amble
