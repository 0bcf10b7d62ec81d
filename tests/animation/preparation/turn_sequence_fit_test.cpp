#include "animation/preparation/turn_sequence_fit.h"

#include <gtest/gtest.h>

#include "animation/analysis/foot_plants.h"
#include "animation/body/pelvis.h"
#include "animation/clips/mirror_clip.h"
#include "base/error.h"
#include "tests/animation/moved_clip.h"
#include "tests/animation/turning_library.h"

namespace amble {
namespace {

const char* const kHalf = "cmu_mb2/01_01.bvh";
const char* const kQuarters = "cmu_mb2/06_10.bvh";
const char* const kAbout = "accad_female1/Female1_B15_WalkTurnAround180.bvh";

/// On the default library's skeleton.
Clip clipOf(const std::string& name) {
  MotionLibrary library = defaultLibrary();
  const auto file = sharedFolder() / "mocap" / name;
  return clipForLibrary(library, readForLibrary(file, {}), file.string());
}

SpotTurnFit fitFor(std::optional<std::pair<int, int>> frames = {}) {
  return {defaultLibrary().feet(), &defaultLibrary().stand(), "clip.bvh", frames};
}

TurnSequence fitOf(const Clip& clip, std::array<int, 2>& frames,
                   std::optional<std::pair<int, int>> within = {}) {
  return fitTurnOnSpot(clip, defaultLibrary().roles, fitFor(within), frames);
}

void expectNobodyTurns(const Clip& clip, std::optional<std::pair<int, int>> within = {}) {
  std::array<int, 2> frames = {0, 0};
  try {
    fitOf(clip, frames, within);
    FAIL() << "nothing was refused";
  } catch (const InputError& error) {
    EXPECT_EQ(error.file(), "clip.bvh");
    EXPECT_NE(std::string(error.what()).find("turns on the spot; expected a turn by 30 degrees"),
              std::string::npos)
        << error.what();
  }
}

TEST(TurnOnSpotFit, WhoWalksRunsStandsOrTwistsOnFeetThatStayTurnsNot) {
  AMBLE_NEEDS_CAPTURES();
  for (const char* const name :
       {"accad_female1/Female1_A01_Stand.bvh", "accad_female1/Female1_B01_StandToWalk.bvh",
        "accad_female1/Female1_B03_Walk1.bvh", "accad_female1/Female1_C11_RunTurnLeft90.bvh",
        "cmu_mb2/02_05.bvh"}) {
    SCOPED_TRACE(name);
    expectNobodyTurns(clipOf(name));
  }
  expectNobodyTurns(clipOf(kQuarters), {{360, 420}});  // between two turns
}

TEST(TurnOnSpotFit, FramesThatTheClipDoesNotHaveAreRefused) {
  AMBLE_NEEDS_CAPTURES();
  const Clip clip = clipOf(kAbout);
  std::array<int, 2> frames = {0, 0};
  for (const std::pair<int, int>& within :
       {std::pair{-1, 50}, {0, clip.frames()}, {50, 50}, {60, 50}}) {
    EXPECT_THROW(fitOf(clip, frames, within), InputError);
  }
}

TEST(TurnOnSpotFit, TheAngleIsThePelvisBetweenItsFramesAndFeetStepThere) {
  AMBLE_NEEDS_CAPTURES();
  for (const char* const name : {kHalf, kQuarters, kAbout}) {
    const Clip clip = clipOf(name);
    std::array<int, 2> frames = {0, 0};
    const TurnSequence turn = fitOf(clip, frames);
    const std::vector<double> headings = pelvisHeadings(clip, defaultLibrary().roles);
    EXPECT_EQ(turn.angle, headings[frames[1]] - headings[frames[0]]) << name;
    EXPECT_NEAR(turn.duration, (frames[1] - frames[0]) * clip.frame_time, 1e-12) << name;
    const std::vector<Eigen::Vector3d> path = pelvisPath(clip, defaultLibrary().roles);
    const FootPlants plants = detectPlants(clip, defaultLibrary().roles);
    int landed = 0;
    for (const auto& side : plants.plants)
      for (const FootPlant& plant : side)
        landed += plant.first > frames[0] && plant.first <= frames[1] ? 1 : 0;
    EXPECT_EQ(turn.steps, landed) << name;
    EXPECT_GT(turn.twist, 30.0 * kDegree) << name << ": people pivot";
  }
}

// A person who was asked for quarter turns made four, each from standing to standing.
TEST(TurnOnSpotFit, EachOfFourQuarterTurnsIsFoundWithinItsFrames) {
  AMBLE_NEEDS_CAPTURES();
  const Clip clip = clipOf(kQuarters);
  for (const std::pair<int, int>& within :
       {std::pair{224, 380}, {400, 550}, {600, 750}, {760, 940}}) {
    std::array<int, 2> frames = {0, 0};
    const TurnSequence turn = fitOf(clip, frames, within);
    EXPECT_NEAR(turn.angle, 0.5 * kPi, 20.0 * kDegree) << within.first;
    EXPECT_GE(frames[0], within.first);
    EXPECT_LE(frames[1], within.second);
  }
}

TEST(TurnOnSpotFit, WithinItsOwnFramesTheSameTurnIsFound) {
  AMBLE_NEEDS_CAPTURES();
  const Clip clip = clipOf(kHalf);
  std::array<int, 2> frames = {0, 0}, again = {0, 0};
  const TurnSequence turn = fitOf(clip, frames);
  const TurnSequence other = fitOf(clip, again, {{frames[0], frames[1]}});
  EXPECT_EQ(again, frames);
  EXPECT_EQ(other.spline, turn.spline);
  EXPECT_EQ(other.turned, turn.turned);
}

TEST(TurnOnSpotFit, IsTheSameWhereverTheCaptureStandsAndFaces) {
  AMBLE_NEEDS_CAPTURES();
  const Clip clip = clipOf(kAbout);
  std::array<int, 2> frames = {0, 0}, again = {0, 0};
  const TurnSequence turn = fitOf(clip, frames);
  const TurnSequence other = fitOf(moved(clip, aboutZ(2.5), {3.0, -7.0, 0.0}), again);
  EXPECT_EQ(again, frames);
  EXPECT_NEAR(other.angle, turn.angle, 1e-9);
  EXPECT_LT((other.spline - turn.spline).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT((other.turned - turn.turned).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(TurnOnSpotFit, InAMirrorItTurnsTheOtherWayWithTheOtherFoot) {
  AMBLE_NEEDS_CAPTURES();
  for (const char* const name : {kHalf, kAbout}) {
    const Clip clip = clipOf(name);
    std::array<int, 2> frames = {0, 0}, again = {0, 0};
    const TurnSequence turn = fitOf(clip, frames);
    const TurnSequence other = fitOf(mirrorClip(clip, defaultLibrary().roles), again);
    EXPECT_EQ(again, frames) << name;
    EXPECT_NEAR(other.angle, -turn.angle, 1e-6) << name;
    EXPECT_EQ(other.first, amble::other(turn.first)) << name;
    EXPECT_EQ(other.steps, turn.steps) << name;
    EXPECT_LT((other.turned - turn.turned).cwiseAbs().maxCoeff(), 1e-6) << name;
    EXPECT_LT((other.spline.row(2) - turn.spline.row(2)).cwiseAbs().maxCoeff(), 1e-3) << name;
  }
}

// Smoothed by the spline, and come to rest at its ends.
TEST(TurnOnSpotFit, InItsMiddleTheBodyIsTheCapturedOneAgainstItsPelvis) {
  AMBLE_NEEDS_CAPTURES();
  const std::vector<Eigen::Quaterniond>& reference = defaultLibrary().stand().rotations;
  for (const char* const name : {kHalf, kAbout}) {
    const Clip clip = clipOf(name);
    std::array<int, 2> frames = {0, 0};
    const TurnSequence turn = fitOf(clip, frames);
    const std::vector<double> headings = pelvisHeadings(clip, defaultLibrary().roles);
    std::vector<double> channels(turn.spline.rows());
    const CubicSpline share = shareTurned(turn);
    for (int i = frames[0]; i <= frames[1]; ++i) {
      const double clock = static_cast<double>(i - frames[0]) / (frames[1] - frames[0]);
      const double turned = (headings[i] - headings[frames[0]]) / turn.angle;
      const double from_middle = std::abs(clock - 0.5);
      if (from_middle > 0.4) continue;
      EXPECT_NEAR(share.at(clock), turned, 0.01) << name << ", frame " << i;
      if (from_middle > 0.2) continue;
      turnChannels(turn, clock, channels);
      double squares = 0.0;
      int joints = 0;
      for (int j = 0; j < clip.skeleton.size(); ++j) {
        const Eigen::Quaterniond made =
            reference[j] * expRotation(Eigen::Vector3d(&channels[3 + 3 * j]));
        const auto& legs = defaultLibrary().roles.legs;
        if (clip.skeleton.isAncestor(legs[kLeft].up_leg, j) ||
            clip.skeleton.isAncestor(legs[kRight].up_leg, j)) {
          EXPECT_LT(made.angularDistance(reference[j]), 1e-9) << "legs are the steps'";
          continue;
        }
        Eigen::Quaterniond captured = clip.poses.rotations(i)[j];
        if (j == 0) captured = aboutZ(-headings[i]) * captured;
        squares += std::pow(made.angularDistance(captured), 2);
        ++joints;
      }
      EXPECT_LT(std::sqrt(squares / joints), 2.0 * kDegree) << name << ", frame " << i;
    }
  }
}

TEST(TurnOnSpotFit, ThePelvisIsAsHighAsStandingAtItsHighestAndNoHigher) {
  AMBLE_NEEDS_CAPTURES();
  for (const char* const name : {kHalf, kQuarters, kAbout}) {
    std::array<int, 2> frames = {0, 0};
    const TurnSequence turn = fitOf(clipOf(name), frames);
    const double stand = defaultLibrary().stand().root_height;
    std::vector<double> channels(turn.spline.rows());
    for (int i = 0; i <= 200; ++i) {
      turnChannels(turn, i / 200.0, channels);
      EXPECT_LT(channels[2], stand + 0.003) << name;
      EXPECT_GT(channels[2], stand - 0.06) << name;
      EXPECT_EQ(channels[0], 0.0);
      EXPECT_EQ(channels[1], 0.0);
    }
  }
}

}  // namespace
}  // namespace amble
