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
