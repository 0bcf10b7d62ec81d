#include "animation/library/motion_library_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "animation/library/library_parts_writer.h"
#include "animation/library/motion_library_reader.h"
#include "base/error.h"
#include "test_paths.h"

namespace amble {
namespace {

const std::filesystem::path kOwnMotions =
    std::filesystem::path(AMBLE_SOURCE_DIR) / "animation/motions";

std::string textOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

/// A folder of the test's own.
class WriteLibrary : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / (std::string("amble_") + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_;
};

TEST_F(WriteLibrary, WhatIsWrittenReadsAsItWas) {
  const MotionLibrary library = readMotionLibrary(kOwnMotions / "default.yaml");
  writeMotionLibrary(library, folder_ / "again.yaml");
  EXPECT_EQ(textOf(folder_ / "again.yaml"), textOf(kOwnMotions / "default.yaml"));
  EXPECT_EQ(textOf(folder_ / "default.bvh"), textOf(kOwnMotions / "default.bvh"));
  const MotionLibrary again = readMotionLibrary(folder_ / "again.yaml");
  ASSERT_EQ(again.motions.size(), library.motions.size());
  for (size_t i = 0; i < library.motions.size(); ++i) {
    EXPECT_EQ(again.motions[i].name, library.motions[i].name);
    EXPECT_EQ(again.motions[i].cycle.series.alpha, library.motions[i].cycle.series.alpha);
    EXPECT_EQ(again.motions[i].cycle.series.beta, library.motions[i].cycle.series.beta);
    EXPECT_EQ(again.motions[i].cycle.turn_rate, library.motions[i].cycle.turn_rate);
  }
}

// Its inner coefficients only are kept.
TEST_F(WriteLibrary, ATurnOnTheSpotReadsAsItWas) {
  MotionLibrary library = readMotionLibrary(kOwnMotions / "default.yaml");
  const double standing = library.stand().root_height;
  Motion motion = *library.find("start");
  motion.name = "about";
  motion.kind = MotionKind::kTurnOnSpot;
  motion.style = "old-man";
  TurnSequence& turn = motion.turn;
  turn.angle = -2.5;
  turn.duration = 1.25;
  turn.first = kRight;
  turn.steps = 3;
  turn.twist = 0.5;
  turn.spline = Eigen::MatrixXd::Zero(3 + 3 * library.skeleton.size(), 11);
  turn.spline.row(2).setConstant(standing);
  turn.turned = Eigen::RowVectorXd::Zero(11);
  turn.turned.rightCols(3).setOnes();
  for (int i = 3; i < 8; ++i) {
    for (int row = 0; row < turn.spline.rows(); ++row)
      turn.spline(row, i) = 0.0078125 * row - 0.5 * i;
    turn.turned(i) = -0.25 + 0.25 * i;
  }
  library.motions.push_back(motion);
  writeMotionLibrary(library, folder_ / "again.yaml");
  const MotionLibrary read = readMotionLibrary(folder_ / "again.yaml");
  const Motion& again = read.motions.back();
  EXPECT_EQ(again.kind, MotionKind::kTurnOnSpot);
  EXPECT_EQ(again.style, "old-man");
  EXPECT_NEAR(again.turn.angle, -2.5, 1e-9);
  EXPECT_EQ(again.turn.duration, 1.25);
  EXPECT_EQ(again.turn.first, kRight);
  EXPECT_EQ(again.turn.steps, 3);
  EXPECT_NEAR(again.turn.twist, 0.5, 1e-9);
  EXPECT_EQ(again.turn.spline, turn.spline);
  EXPECT_EQ(again.turn.turned, turn.turned);
  writeMotionLibrary(read, folder_ / "once-more.yaml");
  std::string once = textOf(folder_ / "once-more.yaml");
  EXPECT_EQ(once, textOf(folder_ / "again.yaml"));
}

TEST_F(WriteLibrary, TextOfAnyMarksComesBack) {
  MotionLibrary library = readMotionLibrary(kOwnMotions / "default.yaml");
  for (const std::string text :
       {"\"Anna\" \\ Bert: # 'both'", "- a: b", "*a", "&a", "!a", "#a", "a #b", "[a", "{a: b}",
        "%a", "@a", "`a", "~", "null", "true", "010", " a ", "a\nb", "\xC3\xBC"}) {
    library.motions[1].name = library.motions[1].source.clip = text;
    library.motions[1].source.credit = library.motions[1].source.licence = text;
    writeMotionLibrary(library, folder_ / "again.yaml");
    const Motion again = readMotionLibrary(folder_ / "again.yaml").motions[1];
    EXPECT_EQ(again.name, text);
    EXPECT_EQ(again.source.clip, text);
    EXPECT_EQ(again.source.credit, text);
    EXPECT_EQ(again.source.licence, text);
  }
}

TEST_F(WriteLibrary, JointsAreCalledWhatTheirBvhCallsThem) {
  MotionLibrary library = readMotionLibrary(kOwnMotions / "default.yaml");
  std::vector<Joint> joints = library.skeleton.joints();
  for (Joint& joint : joints) joint.name = "rig: " + joint.name + " #1";
  library.skeleton = Skeleton(joints);
  writeMotionLibrary(library, folder_ / "rig.yaml");
  const MotionLibrary again = readMotionLibrary(folder_ / "rig.yaml");
  for (const std::string& role : roleNames()) {
    EXPECT_EQ(roleJoint(again.roles, role), roleJoint(library.roles, role)) << role;
  }
}

TEST_F(WriteLibrary, TimesAndClearancesOfValidityComeBack) {
  MotionLibrary library = readMotionLibrary(kOwnMotions / "default.yaml");
  const auto validOf = [](MotionLibrary& of, const std::string& name) -> Validity& {
    return std::find_if(of.motions.begin(), of.motions.end(),
                        [&](const Motion& motion) { return motion.name == name; })
        ->valid;
  };
  validOf(library, "carry") = {Validity::When::kBetween, 1.5, 3.25, 0.0};
  validOf(library, "hold-box") = {Validity::When::kClearanceAbove, 0.0, 0.0, 0.4};
  validOf(library, "stop") = {Validity::When::kAtEnd, 0.0, 0.0, 0.0};
  writeMotionLibrary(library, folder_ / "again.yaml");
  MotionLibrary again = readMotionLibrary(folder_ / "again.yaml");
  EXPECT_EQ(validOf(again, "carry").from, 1.5);
  EXPECT_EQ(validOf(again, "carry").to, 3.25);
  EXPECT_EQ(validOf(again, "hold-box").clearance, 0.4);
  EXPECT_EQ(validOf(again, "stop").when, Validity::When::kAtEnd);
}

TEST_F(WriteLibrary, OverAnotherSkeletonOnlyWhereThatIsALibrarys) {
  MotionLibrary library = readMotionLibrary(kOwnMotions / "default.yaml");
  writeMotionLibrary(library, folder_ / "a.yaml");
  EXPECT_TRUE(isLibrarySkeleton(folder_ / "default.bvh"));
  library.skeleton = library.skeleton.scaled(1.1);
  writeMotionLibrary(library, folder_ / "a.yaml");
  EXPECT_NEAR(readMotionLibrary(folder_ / "a.yaml").skeleton.joint(3).offset.norm(),
              library.skeleton.joint(3).offset.norm(), 1e-5);
  std::ofstream(folder_ / "default.bvh", std::ios::app) << "0 0 0\n";
  EXPECT_FALSE(isLibrarySkeleton(folder_ / "default.bvh"));
  EXPECT_FALSE(isLibrarySkeleton(folder_ / "nothing.bvh"));
}

TEST_F(WriteLibrary, OverAFileThatIsNoLibraryIsRefused) {
  const MotionLibrary library = readMotionLibrary(kOwnMotions / "default.yaml");
  std::ofstream(folder_ / "scene.yaml") << "name: room\nobjects: []\n";
  EXPECT_THROW(writeMotionLibrary(library, folder_ / "scene.yaml"), InputError);
  EXPECT_EQ(textOf(folder_ / "scene.yaml"), "name: room\nobjects: []\n");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "default.bvh"));
}

}  // namespace
}  // namespace amble
