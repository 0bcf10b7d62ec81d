#include "animation/library/motion_library_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/error.h"
#include "base/rotation.h"
#include "test_paths.h"

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

/// A folder of the test's own, with the default library in it.
class MotionLibraryFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / (std::string("amble_") + test->name());
    std::filesystem::create_directories(folder_);
    std::filesystem::copy_file(kMotions / "default.bvh", folder_ / "default.bvh",
                               std::filesystem::copy_options::overwrite_existing);
    text_ = contentOf(kMotions / "default.yaml");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// Replaces the first `from` after the first `after`; remembers the line where it stands.
  void replace(const std::string& from, const std::string& to, const std::string& after = "") {
    const size_t at = text_.find(from, text_.find(after));
    ASSERT_NE(at, std::string::npos) << from;
    line_ = 1 + static_cast<int>(std::count(text_.begin(), text_.begin() + at, '\n'));
    text_.replace(at, from.size(), to);
  }

  /// The error that reading the text throws.
  InputError error() const {
    std::ofstream(folder_ / "library.yaml") << text_;
    try {
      readMotionLibrary(folder_ / "library.yaml");
    } catch (const InputError& error) {
      return error;
    }
    return InputError("none", 0, "nothing was refused");
  }

  void expectRefused(const std::string& part) const {
    const InputError refused = error();
    EXPECT_NE(std::string(refused.what()).find(part), std::string::npos) << refused.what();
    EXPECT_EQ(refused.line(), line_) << refused.what();
  }

  std::filesystem::path folder_;
  std::string text_;
  int line_ = 0;
};

TEST_F(MotionLibraryFile, RefusesUnknownKeysWithTheirLine) {
  replace("stature:", "statute:");
  expectRefused("statute");
  SetUp();
  replace("      closure:", "      closeness:");
  expectRefused("closeness");
  SetUp();
  replace("        lift_off:", "        lift:");
  expectRefused("lift");
}

// Libraries of before have the later two thirds of the coefficients.
TEST_F(MotionLibraryFile, WithToesThatRollLaterIsRead) {
  const auto read = [&] {
    std::ofstream(folder_ / "library.yaml") << text_;
    return readMotionLibrary(folder_ / "library.yaml").find("walk-slow")->cycle.feet[kLeft].toes;
  };
  auto toes = read();
  constexpr int kFewer = 16, kMore = FootCycle::kToeSplines - kFewer;
  const size_t list = text_.find("toes: [", text_.find("- name: walk-slow")) + 7;
  size_t kept = list;
  for (int k = 0; k < kMore; ++k) kept = text_.find(',', kept) + 1;
  text_.erase(list, kept - list);
  std::fill_n(toes.begin(), kMore, 0.0);
  EXPECT_EQ(read(), toes);
  EXPECT_GT(*std::max_element(toes.begin(), toes.end()), 0.1);
  line_ = 1 + static_cast<int>(std::count(text_.begin(), text_.begin() + list, '\n'));
  text_.erase(list, text_.find(',', list) + 1 - list);
  expectRefused("expected 24 roll of the toes");
}

TEST_F(MotionLibraryFile, RefusesFeetThatHangWhereTheyAreToStand) {
  const size_t drops = text_.find("foot_drops: [") + 13;
  text_.replace(drops, text_.find(',', drops) - drops, "70");
  line_ = 1 + static_cast<int>(std::count(text_.begin(), text_.begin() + drops, '\n'));
  expectRefused("expected -63 to 63 degrees");
}

TEST_F(MotionLibraryFile, RefusesASkeletonThatIsNotThere) {
  replace("skeleton: default.bvh", "skeleton: nobody.bvh");
  EXPECT_NE(std::string(error().what()).find("nobody.bvh"), std::string::npos) << error().what();
}

TEST_F(MotionLibraryFile, RefusesJointsAndRolesThatTheSkeletonDoesNotHave) {
  replace("left_foot: LeftFoot", "left_foot: LeftHoof");
  expectRefused("no joint LeftHoof");
  SetUp();
  replace("left_foot: LeftFoot", "left_hoof: LeftFoot");
  expectRefused("no role left_hoof");
  SetUp();
  replace("  left_toe: LeftToeBase\n", "");
  EXPECT_NE(std::string(error().what()).find("a leg's joint is missing"), std::string::npos);
}

TEST_F(MotionLibraryFile, RefusesChannelsThatDoNotFitTheSkeleton) {
  replace("        - [0, 0, 0, 0, 0, 0]\n", "", "alpha:");
  EXPECT_NE(std::string(error().what()).find("68 channels"), std::string::npos) << error().what();
  SetUp();
  replace("        - [0, 0, 0, 0, 0, 0]\n", "        - [0, 0, 0, 0, 0]\n");
  EXPECT_EQ(error().line(), line_) << error().what();
  SetUp();
  replace("        - [1, 0, 0, 0]\n", "", "rotations:");
  EXPECT_NE(std::string(error().what()).find("21 rotations"), std::string::npos) << error().what();
}

TEST_F(MotionLibraryFile, RefusesARotationThatIsNone) {
  replace("        - [1, 0, 0, 0]", "        - [1, 1, 0, 0]", "rotations:");
  expectRefused("not a rotation");
}

TEST_F(MotionLibraryFile, RefusesAWalkThatIsCalledStraightAndTurns) {
  replace("turning: turn", "turning: straight");
  expectRefused("degrees/s is called straight");
  SetUp();
  replace("turning: straight", "turning: turn");
  expectRefused("degrees/s is called a turn");
}

TEST_F(MotionLibraryFile, RefusesAWalkThatIsNotAlwaysValid) {
  for (const char* valid : {"at_start", "{from: 0, to: 2}", "{clearance_above: 0.3}", "never"}) {
    SetUp();
    replace("valid: always", std::string("valid: ") + valid, "- name: walk-slow");
    expectRefused("a walk that is not always valid");
  }
  SetUp();
  replace("valid: always", "valid: at_start", "- name: start");
  EXPECT_STREQ(error().what(), InputError("none", 0, "nothing was refused").what());
}

TEST_F(MotionLibraryFile, RefusesTwoMotionsOfOneName) {
  replace("- name: walk-slow-mirrored", "- name: walk-slow");
  expectRefused("walk-slow is there twice");
}

TEST_F(MotionLibraryFile, RefusesNumbersOutOfRange) {
  replace("period: 1.2", "period: 71.2");
  expectRefused("period [s]");
  SetUp();
  replace("harmonics: 5", "harmonics: 13");
  expectRefused("harmonics");
}

TEST_F(MotionLibraryFile, WithoutItsPostureOrAStraightWalkIsReadButCannotWalk) {
  const std::string whole = text_;
  replace("- name: stand", "- name: sit");
  text_.erase(text_.find("  - name: start\n"));  // captured starts and stops are from and to it
  std::ofstream(folder_ / "library.yaml") << text_;
  EXPECT_EQ(whatItLacks(readMotionLibrary(folder_ / "library.yaml")).problem, "no posture `stand`");
  EXPECT_THROW(openMotionLibrary("library.yaml", folder_), InputError);
  text_ = whole;
  const size_t first = text_.find("  - name: walk-slow\n");
  const size_t turns = text_.find("  - name: turn-right-slow\n");
  ASSERT_LT(first, turns);
  text_.erase(first, turns - first);
  std::ofstream(folder_ / "library.yaml") << text_;
  EXPECT_EQ(whatItLacks(readMotionLibrary(folder_ / "library.yaml")).problem, "no straight walk");
  EXPECT_THROW(openMotionLibrary("library.yaml", folder_), InputError);
}

TEST_F(MotionLibraryFile, RefusesAMovementOfALeg) {
  replace("joints: [left_arm, right_arm]", "joints: [left_arm, right_leg]");
  expectRefused("moves a leg");
}

TEST(MotionLibrary, ALibraryIsFoundRelativeToWhereItIsNamed) {
  EXPECT_EQ(openMotionLibrary("default.yaml", kMotions).motions.size(),
            openMotionLibrary("default").motions.size());
  EXPECT_THROW(openMotionLibrary("nothing.yaml", kMotions), InputError);
}

/// A turn on the spot of three inner coefficients, in place of the last motion.
class TurnInALibrary : public MotionLibraryFile {
 protected:
  void SetUp() override {
    MotionLibraryFile::SetUp();
    text_.resize(text_.rfind("  - name:"));
    text_ +=
        "  - name: about\n    kind: turn_on_spot\n    valid: always\n    joints: all\n"
        "    source: {clip: a, frames: [0, 9], licence: b, credit: c}\n    turn:\n"
        "      angle: 170\n      duration: 2\n      first: left\n      steps: 3\n"
        "      twist: 40\n      turned: [0.2, 0.5, 0.8]\n      spline:\n";
    for (int i = 0; i < 69; ++i) text_ += "        - [0, 0, 0]\n";
  }
};

TEST_F(TurnInALibrary, IsRead) { EXPECT_EQ(error().file(), "none"); }

TEST_F(TurnInALibrary, RefusesWhatIsOutOfItsRangeWithItsLine) {
  const std::pair<const char*, const char*> kWrong[] = {
      {"angle: 170", "angle: 721"},     {"angle: 170", "angle: -9"},
      {"duration: 2", "duration: 0.1"}, {"first: left", "first: both"},
      {"steps: 3", "steps: 0"},         {"steps: 3", "steps: 2.5"},
      {"twist: 40", "twist: 181"},      {"turned: [0.2, 0.5, 0.8]", "turned: [0.2, 4, 0.8]"},
      {"twist: 40", "twisted: 40"},     {"        - [0, 0, 0]\n", "        - [0, 0]\n"},
  };
  for (const auto& [right, wrong] : kWrong) {
    SetUp();
    replace(right, wrong, "name: about");
    EXPECT_EQ(error().line(), line_) << wrong << ": " << error().what();
  }
}

TEST_F(TurnInALibrary, RefusesWhatIsMissing) {
  replace("        - [0, 0, 0]\n", "", "name: about");
  EXPECT_NE(std::string(error().what()).find("68 channels"), std::string::npos) << error().what();
  SetUp();
  replace("      duration: 2\n", "", "name: about");
  EXPECT_NE(std::string(error().what()).find("duration"), std::string::npos) << error().what();
  SetUp();
  replace("name: stand\n", "name: stood\n");
  EXPECT_NE(std::string(error().what()).find("`stand` before"), std::string::npos);
}

}  // namespace
}  // namespace amble
