// A library of any rig's walk is written, read and written again without the loss of a byte, and
// what is read is what was prepared, to the digits that files have.

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "animation/library/library_parts_writer.h"
#include "animation/library/motion_library_reader.h"
#include "animation/library/motion_library_writer.h"
#include "animation/library/speed_engine_reader.h"
#include "animation/library/speed_engine_writer.h"
#include "animation/preparation/motion_library_add.h"
#include "animation/preparation/speed_engine_fit.h"
#include "base/rotation.h"
#include "tests/animation/captures.h"
#include "tests/environments/test_files.h"

namespace amble {
namespace {

constexpr double kDigits = 0.51e-7;  // files have seven after the point

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Made once for all tests.
const MotionLibrary& libraryOf(const std::string& clip) {
  static std::map<std::string, MotionLibrary> known;
  const auto found = known.find(clip);
  if (found != known.end()) return found->second;
  MotionRequest request;
  request.name = "walk";
  request.file = sharedFolder() / "mocap" / clip;
  request.source = {clip, {0, 0}, false, "as the captures'", "their makers"};
  MotionLibrary& library = known[clip];
  addMotion(library, request);
  library.skeleton_file = "rig.bvh";
  return library;
}

class EveryRigsLibrary : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { AMBLE_NEEDS_CAPTURES(); }
};

TEST_P(EveryRigsLibrary, IsWrittenAgainAsItWasWritten) {
  const TestFolder folder;
  const MotionLibrary& library = libraryOf(GetParam());
  writeMotionLibrary(library, folder.path() / "a/library.yaml");
  const MotionLibrary read = readMotionLibrary(folder.path() / "a/library.yaml");
  writeMotionLibrary(read, folder.path() / "b/library.yaml");
  for (const char* const file : {"library.yaml", "rig.bvh"}) {
    EXPECT_EQ(bytesOf(folder.path() / "a" / file), bytesOf(folder.path() / "b" / file)) << file;
    EXPECT_FALSE(bytesOf(folder.path() / "a" / file).empty());
  }
}

TEST_P(EveryRigsLibrary, IsReadAsItWasPrepared) {
  const TestFolder folder;
  const MotionLibrary& library = libraryOf(GetParam());
  writeMotionLibrary(library, folder.path() / "library.yaml");
  const MotionLibrary read = readMotionLibrary(folder.path() / "library.yaml");
  EXPECT_NEAR(read.stature, library.stature, kDigits);
  ASSERT_EQ(read.skeleton.size(), library.skeleton.size());
  for (const std::string& role : roleNames())
    EXPECT_EQ(roleJoint(read.roles, role), roleJoint(library.roles, role)) << role;
  const WalkCycle &was = library.find("walk")->cycle, &is = read.find("walk")->cycle;
  EXPECT_EQ(is.cycles, was.cycles);
  EXPECT_NEAR(is.speed, was.speed, kDigits);
  EXPECT_NEAR(is.period, was.period, kDigits);
  EXPECT_NEAR(is.step_width, was.step_width, kDigits);
  EXPECT_LT((is.series.alpha - was.series.alpha).cwiseAbs().maxCoeff(), kDigits);
  EXPECT_LT((is.series.beta - was.series.beta).cwiseAbs().maxCoeff(), kDigits);
  for (const Side side : {kLeft, kRight}) {
    EXPECT_NEAR(is.toe_out[side], was.toe_out[side], kDigits * kDegree);
    EXPECT_NEAR(is.foot_drops.value()[side], was.foot_drops.value()[side], kDigits * kDegree);
    for (double tau = 0.0; tau <= 1.0; tau += 0.125) {
      EXPECT_NEAR(swingProgress(is.feet[side], tau), swingProgress(was.feet[side], tau), 1e-7);
      EXPECT_NEAR(footPitch(is.feet[side], 2.0 * tau), footPitch(was.feet[side], 2.0 * tau), 1e-6);
    }
  }
  for (int j = 0; j < library.skeleton.size(); ++j) {
    EXPECT_LT(read.stand().rotations[j].angularDistance(library.stand().rotations[j]), 1e-6);
    EXPECT_LT((read.skeleton.joint(j).offset - library.skeleton.joint(j).offset).norm(), 1e-5);
  }
}

TEST_P(EveryRigsLibrary, HasASkeletonThatIsKnownForALibrarys) {
  const TestFolder folder;
  const MotionLibrary& library = libraryOf(GetParam());
  writeMotionLibrary(library, folder.path() / "library.yaml");
  EXPECT_TRUE(isLibrarySkeleton(folder.path() / "rig.bvh"));
  EXPECT_EQ(skeletonNameBeside(folder.path() / "rig.yaml"), "rig-skeleton.bvh");  // not its own
  writeMotionLibrary(library, folder.path() / "rig.yaml");
  EXPECT_EQ(skeletonNameBeside(folder.path() / "rig.yaml"), "rig-skeleton.bvh");  // nor only its
  std::filesystem::remove(folder.path() / "library.yaml");
  EXPECT_EQ(skeletonNameBeside(folder.path() / "rig.yaml"), "rig.bvh");
  if (std::string(GetParam()).ends_with(".bvh")) {
    EXPECT_FALSE(isLibrarySkeleton(sharedFolder() / "mocap" / GetParam()));
  }
}

// Whoever cannot walk is told so when the library is opened, not in the middle of a plan.
TEST_P(EveryRigsLibrary, LacksNothingThatWalkingNeeds) {
  const TestFolder folder;
  writeMotionLibrary(libraryOf(GetParam()), folder.path() / "library.yaml");
  const MotionLibrary open = openMotionLibrary("library.yaml", folder.path());
  EXPECT_EQ(whatItLacks(open).problem, "");
}

INSTANTIATE_TEST_SUITE_P(, EveryRigsLibrary,
                         testing::Values("accad_female1/Female1_B03_Walk1.bvh",
                                         "accad_male1/Male1_B3_Walk.bvh", "cmu_mb2/07_01.bvh",
                                         "cmu_asfamc/07_05-walk.amc", "cmu_daz/07_01.bvh",
                                         "cmu_style_loops/142_08_EDIT_LOOP.bvh",
                                         "formats/mass_walk.bvh"));

TEST(LibrarySkeleton, ANameBesideCapturesIsNeverOneOfThem) {
  AMBLE_NEEDS_CAPTURES();
  const TestFolder folder;
  const std::string capture = bytesOf(sharedFolder() / "mocap/cmu_mb2/07_01.bvh");
  EXPECT_EQ(skeletonNameBeside(folder.path() / "walk.yaml"), "walk.bvh");
  folder.write("walk.bvh", capture);
  EXPECT_EQ(skeletonNameBeside(folder.path() / "walk.yaml"), "walk-skeleton.bvh");
  folder.write("walk-skeleton.bvh", capture);
  EXPECT_EQ(skeletonNameBeside(folder.path() / "walk.yaml"), "walk-skeleton-2.bvh");
  folder.write("walk-skeleton-2.bvh", "no BVH at all");
  EXPECT_EQ(skeletonNameBeside(folder.path() / "walk.yaml"), "walk-skeleton-3.bvh");
}

TEST(LibrarySkeleton, OverACaptureNoLibraryIsWrittenAndNothingChanges) {
  AMBLE_NEEDS_CAPTURES();
  const TestFolder folder;
  const MotionLibrary& library = libraryOf("cmu_mb2/07_01.bvh");
  const std::string capture = bytesOf(sharedFolder() / "mocap/accad_male1/Male1_B3_Walk.bvh");
  folder.write("rig.bvh", capture);
  const std::string refused =
      errorOf([&] { writeMotionLibrary(library, folder.path() / "library.yaml"); });
  EXPECT_NE(refused.find("is a capture"), std::string::npos) << refused;
  EXPECT_EQ(bytesOf(folder.path() / "rig.bvh"), capture);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "library.yaml"));
}

class EveryRigsEngine : public testing::TestWithParam<const char*> {};

TEST_P(EveryRigsEngine, IsWrittenAgainAsItWasWritten) {
  AMBLE_NEEDS_CAPTURES();
  EngineRequest request;
  request.captures.push_back(
      {sharedFolder() / "mocap" / GetParam(), {}, GetParam(), "as the captures'", "their makers"});
  EngineData engine = fitSpeedEngine(request);
  engine.skeleton_file = "rig.bvh";
  const TestFolder folder;
  writeSpeedEngine(engine, folder.path() / "a/engine.yaml");
  writeSpeedEngine(readSpeedEngine(folder.path() / "a/engine.yaml"),
                   folder.path() / "b/engine.yaml");
  EXPECT_EQ(bytesOf(folder.path() / "a/engine.yaml"), bytesOf(folder.path() / "b/engine.yaml"));
  EXPECT_EQ(bytesOf(folder.path() / "a/rig.bvh"), bytesOf(folder.path() / "b/rig.bvh"));
}

INSTANTIATE_TEST_SUITE_P(, EveryRigsEngine,
                         testing::Values("accad_female1/Female1_B03_Walk1.bvh", "cmu_mb2/07_01.bvh",
                                         "cmu_asfamc/07_05-walk.amc", "cmu_daz/07_01.bvh"));

}  // namespace
}  // namespace amble
