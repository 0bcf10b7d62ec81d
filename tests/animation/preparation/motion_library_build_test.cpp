#include "animation/preparation/motion_library_build.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "animation/library/motion_library_reader.h"
#include "animation/library/motion_library_writer.h"
#include "base/error.h"
#include "test_paths.h"
#include "tests/animation/engine_library.h"

namespace amble {
namespace {

const std::filesystem::path kMotions =
    std::filesystem::path(AMBLE_SOURCE_DIR) / "animation/motions";

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

/// A folder of the test's own.
class BuildLibrary : public testing::Test {
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

TEST_F(BuildLibrary, RefusesARecipeWhoseClipIsNotThere) {
  std::ofstream(folder_ / "r.yaml") << "skeleton: r.bvh\ncaptures: .\nlicence: none\ncredit: us\n"
                                       "motions:\n  - {name: stand, kind: posture, clip: no.bvh}\n";
  try {
    buildMotionLibrary(folder_ / "r.yaml");
    FAIL() << "nothing was refused";
  } catch (const InputError& refused) {
    EXPECT_NE(std::string(refused.what()).find("no.bvh"), std::string::npos) << refused.what();
  }
}

TEST_F(BuildLibrary, TheDefaultLibraryIsWhatItsRecipeMakesOfTheCaptures) {
  AMBLE_NEEDS_CAPTURES();
  const MotionLibrary built =
      buildMotionLibrary(kMotions / "default.recipe.yaml", sharedFolder() / "mocap");
  writeMotionLibrary(built, folder_ / "default.yaml");
  EXPECT_TRUE(contentOf(folder_ / "default.yaml") == contentOf(kMotions / "default.yaml"))
      << "default.yaml is another";
  EXPECT_TRUE(contentOf(folder_ / "default.bvh") == contentOf(kMotions / "default.bvh"))
      << "default.bvh is another";
}

TEST_F(BuildLibrary, ARecipeTakesWalksOfASpeedEngineWithTheStanceOfItsPerson) {
  AMBLE_NEEDS_CAPTURES();
  const std::string person = "accad_female1/Female1_";
  const EngineInFile made(
      fitSpeedEngine(engineRequestOf({person + "B03_Walk1.bvh", person + "A01_Stand.bvh"})));
  std::ofstream(folder_ / "r.yaml")
      << "skeleton: r.bvh\ncaptures: " << made.file().parent_path()
      << "\nlicence: the recipe's\ncredit: the recipe's\nmotions:\n"
         "  - {name: slow, kind: walk, clip: engine.yaml, speed: 0.7, mirror: both}\n"
         "  - {name: usual, kind: walk, clip: engine.yaml, speed: 1, credit: me}\n";
  writeMotionLibrary(buildMotionLibrary(folder_ / "r.yaml"), folder_ / "made.yaml");
  const MotionLibrary library = readMotionLibrary(folder_ / "made.yaml");
  ASSERT_EQ(library.motions.size(), 4u);
  const EngineData& engine = made.engine().data();
  for (int j = 0; j < library.skeleton.size(); ++j) {
    EXPECT_LT(library.stand().rotations[j].angularDistance(engine.stand.rotations[j]), 1e-5);
  }
  EXPECT_EQ(library.motions[0].source.clip, person + "A01_Stand.bvh");
  EXPECT_EQ(partText(library.motions[2].source), "engine.yaml at 0.7 m/s");
  EXPECT_TRUE(library.motions[2].source.mirrored);
  EXPECT_NEAR(library.motions[2].cycle.speed, 0.7, 1e-6);
  EXPECT_EQ(library.motions[3].source.licence, "free");
  EXPECT_EQ(library.motions[3].source.credit, "me");
}

TEST(BuiltLibrary, TheDefaultLibraryTurnsBothWaysAlike) {
  const MotionLibrary library = openMotionLibrary("default");
  double left = 0.0, right = 0.0;
  for (const Motion& motion : library.motions) {
    if (motion.kind != MotionKind::kWalk || !motion.turning) continue;
    (motion.cycle.turn_rate > 0.0 ? left : right) += motion.cycle.turn_rate;
  }
  EXPECT_GT(left, 0.0);
  EXPECT_NEAR(left, -right, 1e-9);  // every turn is there with its mirror image
}

}  // namespace
}  // namespace amble
