#include "animation/library/library_style.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "animation/library/motion_library_reader.h"
#include "animation/library/motion_library_writer.h"
#include "animation/preparation/motion_library_add.h"
#include "animation/synthesis/gait_blend.h"
#include "base/error.h"
#include "base/rotation.h"
#include "tests/animation/captures.h"
#include "tests/animation/default_library.h"

namespace amble {
namespace {

struct Manner {
  const char* style;
  const char* clip;
};
constexpr Manner kManners[] = {{"old-man", "cmu_style_loops/137_33_EDIT_LOOP.bvh"},
                               {"sore-left-knee", "cmu_style_loops/142_12_EDIT_LOOP.bvh"},
                               {"depressed", "cmu_style_loops/142_05_EDIT_LOOP.bvh"},
                               {"happy", "cmu_style_loops/142_08_EDIT_LOOP.bvh"},
                               {"cmu-08", "cmu_mb2/08_04.bvh"}};

// The default library with five manners more, made once.
const MotionLibrary& manners() {
  static const MotionLibrary kLibrary = [] {
    MotionLibrary library = openMotionLibrary("default");
    for (const Manner& manner : kManners) {
      MotionRequest request;
      request.name = std::string("walk-") + manner.style;
      request.style = manner.style;
      request.turning = false;
      request.file = sharedFolder() / "mocap" / manner.clip;
      request.source = {manner.clip, {0, 0}, false, "CMU", "CMU"};
      addMotion(library, request);
    }
    return library;
  }();
  return kLibrary;
}

const WalkCycle& cycleOf(const MotionLibrary& library, const std::string& style) {
  return library.find("walk-" + style)->cycle;
}

TEST(LibraryStyle, AWalkInAStyleIsThatOfItsCaptureAlone) {
  AMBLE_NEEDS_CAPTURES();
  for (const Manner& manner : kManners) {
    const MotionLibrary library = inStyle(manners(), manner.style);
    const WalkCycle& cycle = cycleOf(library, manner.style);
    const GaitBlend blend(library, 1.0, cycle.speed);
    Eigen::VectorXd channels;
    for (const double phase : {0.0, 0.2, 0.45, 0.8}) {
      blend.evaluate(phase, 0.0, blend.law().stepLength(cycle.speed), channels);
      for (int row = 0; row < channels.size(); ++row) {
        double captured = 0.0;
        for (int k = 0; k <= cycle.series.harmonics(); ++k) {
          captured += cycle.series.alpha(row, k) * std::cos(2.0 * kPi * k * phase) +
                      cycle.series.beta(row, k) * std::sin(2.0 * kPi * k * phase);
        }
        EXPECT_NEAR(channels[row], captured, 1e-9) << manner.style << " channel " << row;
      }
    }
  }
}

// A sore left knee is bent less than the right one, and stays so.
TEST(LibraryStyle, AsymmetryIsKept) {
  AMBLE_NEEDS_CAPTURES();
  const MotionLibrary library = inStyle(manners(), "sore-left-knee");
  const GaitBlend blend(library, 1.0, cycleOf(library, "sore-left-knee").speed);
  Eigen::VectorXd channels;
  std::array<double, 2> swing = {0, 0};
  for (const Side side : {kLeft, kRight}) {
    double least = 1e9, most = -1e9;
    for (int i = 0; i < 50; ++i) {
      blend.evaluate(i / 50.0, 0.0, blend.law().stepLength(0.56), channels);
      const double knee = channels.segment<3>(3 + 3 * library.roles.legs[side].leg).norm();
      least = std::min(least, knee);
      most = std::max(most, knee);
    }
    swing[side] = most - least;
  }
  EXPECT_LT(swing[kLeft], 0.8 * swing[kRight]);
}

TEST(LibraryStyle, NoStyleIsAsIfTheStyledWalksWereNotThere) {
  AMBLE_NEEDS_CAPTURES();
  const GaitBlend with(inStyle(manners(), ""), 1.0), without(defaultLibrary(), 1.0);
  Eigen::VectorXd a, b;
  for (const double turn_rate : {0.0, 0.4}) {
    with.evaluate(0.3, turn_rate, 0.6, a);
    without.evaluate(0.3, turn_rate, 0.6, b);
    EXPECT_EQ((a - b).norm(), 0.0);
  }
  EXPECT_EQ(with.law().stepLength(1.0), without.law().stepLength(1.0));
}

TEST(LibraryStyle, OwnSpeedIsTheCapturesAndGrowsWithTheRootOfHeight) {
  AMBLE_NEEDS_CAPTURES();
  const MotionLibrary library = inStyle(manners(), "happy");
  const double speed = cycleOf(library, "happy").speed;
  EXPECT_DOUBLE_EQ(ownSpeed(library, 0.0), speed);
  EXPECT_NEAR(ownSpeed(library, 0.81 * library.stature), 0.9 * speed, 1e-12);
}

TEST(LibraryStyle, TurnsOnTheSpotAreTheStylesOwnOrThoseWithoutOne) {
  MotionLibrary library;
  for (const char* const style : {"", "old-man", "happy"}) {
    Motion motion;
    motion.style = style;
    motion.name = std::string("walk of ") + style;
    library.motions.push_back(motion);
    if (std::string(style) == "happy") continue;
    motion.name = std::string("turn of ") + style;
    motion.kind = MotionKind::kTurnOnSpot;
    library.motions.push_back(motion);
  }
  for (const auto& [style, turn] :
       {std::pair("", "turn of "), {"old-man", "turn of old-man"}, {"happy", "turn of "}}) {
    const MotionLibrary own = inStyle(library, style);
    ASSERT_EQ(own.motions.size(), 2u) << style;
    EXPECT_NE(own.find(turn), nullptr) << style;
  }
}

class StyledFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / (std::string("amble_") + test->name());
    std::filesystem::create_directories(folder_);
    library_ = defaultLibrary();
    for (Motion& motion : library_.motions) {
      if (motion.kind == MotionKind::kWalk && !motion.turning) motion.style = "o'man <\u00fc>";
    }
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path written() const {
    writeMotionLibrary(library_, folder_ / "l.yaml");
    return folder_ / "l.yaml";
  }

  std::filesystem::path folder_;
  MotionLibrary library_;
};

TEST_F(StyledFile, StylesAreReadAsTheyWereWritten) {
  const MotionLibrary read = readMotionLibrary(written());
  for (size_t i = 0; i < library_.motions.size(); ++i) {
    EXPECT_EQ(read.motions[i].style, library_.motions[i].style);
  }
  EXPECT_EQ(stylesOf(read), std::vector<std::string>{"o'man <\u00fc>"});
}

TEST_F(StyledFile, AStyleThatIsNotThereAndNoneWhereOneIsNeededNameThoseThatAre) {
  const std::string file = written().string();
  for (const char* const style : {"old-man", ""}) {
    try {
      openMotionLibrary(file, {}, style);
      FAIL() << style;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("o'man"), std::string::npos) << error.what();
    }
  }
  EXPECT_TRUE(whatItLacks(openMotionLibrary(file, {}, "o'man <\u00fc>")).problem.empty());
}

TEST_F(StyledFile, OnlyWhatIsWalkedByHasAStyle) {
  for (Motion& motion : library_.motions) {
    if (motion.kind == MotionKind::kPosture) motion.style = "stiff";
  }
  EXPECT_THROW(readMotionLibrary(written()), InputError);
}

}  // namespace
}  // namespace amble
