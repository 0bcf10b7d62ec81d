#include "animation/preparation/motion_library_build.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "animation/library/motion_library_reader.h"
#include "animation/library/motion_library_writer.h"
#include "base/error.h"
#include "test_paths.h"
#include "tests/animation/captures.h"

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
