#include "animation/analysis/classify_clip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "animation/captures/bvh.h"
#include "tests/animation/captures.h"
#include "tests/animation/puppet.h"

namespace amble {
namespace {

/// "B79 L47": 79 frames of B, 47 of L.
std::vector<Support> tokens(const std::string& text) {
  std::vector<Support> result;
  for (size_t i = 0; i < text.size();) {
    const Support token = static_cast<Support>(text[i++]);
    size_t digits = 0;
    const int count = std::stoi(text.substr(i), &digits);
    result.insert(result.end(), count, token);
    i += digits + 1;
  }
  return result;
}

/// "walk 1-245, jump 246-294", frames from 1 as the thesis counts them.
std::string said(const ClipClass& found) {
  std::string text;
  for (const MotionSegment& segment : found.segments) {
    if (!text.empty()) text += ", ";
    text += std::string(motionTypeName(segment.type)) + " " + std::to_string(segment.first + 1) +
            "-" + std::to_string(segment.last + 1);
  }
  return text;
}

FootPlants plantsFrom(const std::vector<Support>& tokens) {
  std::array<std::vector<bool>, 2> planted;
  for (const Support token : tokens) {
    planted[kLeft].push_back(token == Support::kLeft || token == Support::kBoth);
    planted[kRight].push_back(token == Support::kRight || token == Support::kBoth);
  }
  return plantsOf(planted);
}

TEST(ClassifyClip, NoFramesAreOfNoType) {
  const ClipClass found = classifyTokens({});
  EXPECT_EQ(found.type, MotionType::kUnknown);
  EXPECT_TRUE(found.segments.empty());
  EXPECT_TRUE(classifyClip({}, 0.01).frames.empty());
}

TEST(ClassifyClip, TheThesisTableC1GivesItsTableC2) {
  const std::vector<Support> c1 = tokens("B79 L47 B39 R36 B44 N30 B19");
  for (const ClipClass& found : {classifyTokens(c1), classifyClip(plantsFrom(c1), 1.0 / 60.0)}) {
    EXPECT_EQ(said(found), "walk 1-245, jump 246-294");
    EXPECT_EQ(std::lround(100.0 * found.shareOf(MotionType::kWalk)), 83);
    EXPECT_EQ(std::lround(100.0 * found.shareOf(MotionType::kJump)), 17);
    EXPECT_EQ(found.type, MotionType::kOther);
    EXPECT_EQ(found.largest(), MotionType::kWalk);
  }
}

TEST(ClassifyClip, EveryProductionOfTheGrammarIsItsType) {
  const std::map<std::string, MotionType> productions = {
      {"B10", MotionType::kStand},
      {"B9 L30 B9 R30 B9 L30", MotionType::kWalk},
      {"B9 R30 B9 L30", MotionType::kWalk},
      {"L30 B9 R30 B9", MotionType::kWalk},
      {"R30 B9 L30 B9", MotionType::kWalk},
      {"L20 N9 R20 N9", MotionType::kRun},
      {"R20 N9 L20 N9 R20", MotionType::kRun},
      {"B20 N30 B20 N30 B20", MotionType::kJump},
      {"L20 N30 L20 N30 L20", MotionType::kJump},
      {"R20 N30 R20", MotionType::kJump},
  };
  for (const auto& [text, type] : productions) {
    EXPECT_EQ(classifyTokens(tokens(text)).type, type) << text;
  }
}

TEST(ClassifyClip, WhatTheSilentMachineMakesOfTheRestIsSaid) {
  EXPECT_EQ(said(classifyTokens(tokens("L30 B9 R30 B9 L20 N9 R20 N9 L20"))),
            "walk 1-98, run 99-156");
  EXPECT_EQ(said(classifyTokens(tokens("L20 N9 R20 N9 L20 B9 R30 B9"))), "run 1-78, walk 79-126");
  // The look-ahead: a run that lands on the same foot hops from that step on.
  EXPECT_EQ(said(classifyTokens(tokens("L20 N9 R20 N9 R20 N9 R20"))), "run 1-29, jump 30-107");
  EXPECT_EQ(said(classifyTokens(tokens("L30 R30 L30"))), "walk 1-90");
  EXPECT_EQ(said(classifyTokens(tokens("B20 N30 L20"))), "jump 1-50, unknown 51-70");
  EXPECT_EQ(said(classifyTokens(tokens("N30"))), "unknown 1-30");
  EXPECT_EQ(said(classifyTokens(tokens("L30"))), "unknown 1-30");
}

TEST(ClassifyClip, LeftAndRightAreTreatedAlike) {
  for (const char* text : {"B9 L30 B9 R30 N20 R9 N3 L8 B2", "L20 N9 L20 N9 R20 N4 B9 N3 R5"}) {
    std::vector<Support> given = tokens(text), mirrored = given;
    for (Support& token : mirrored) {
      if (token == Support::kLeft) {
        token = Support::kRight;
      } else if (token == Support::kRight) {
        token = Support::kLeft;
      }
    }
    EXPECT_EQ(said(classifyTokens(given)), said(classifyTokens(mirrored))) << text;
  }
}

TEST(ClassifyClip, SharesAddUpToOneAndSegmentsToTheClip) {
  const ClipClass found = classifyTokens(tokens("N3 L30 B9 R30 N9 L30 N9 R20 B80 N20 B9 N4"));
  double sum = 0.0;
  for (const double share : found.share) sum += share;
  EXPECT_NEAR(sum, 1.0, 1e-12);
  int next = 0;
  for (const MotionSegment& segment : found.segments) {
    EXPECT_EQ(segment.first, next);
    next = segment.last + 1;
  }
  EXPECT_EQ(next, static_cast<int>(found.frames.size()));
}

TEST(ClassifyClip, AFlickerOfFlightInAWalkIsNone) {
  const std::vector<Support> walk = tokens("B20 L40 B10 R40 N6 L40 B10 R40 B10");
  EXPECT_EQ(said(classifyClip(plantsFrom(walk), 0.01)), "walk 1-216");
  EXPECT_NE(said(classifyTokens(walk)), "walk 1-216");
}

TEST(ClassifyClip, AShortFlightAtEveryStepIsARun) {
  const std::vector<Support> run = tokens("L25 N5 R25 N5 L25 N5 R25");
  EXPECT_EQ(classifyClip(plantsFrom(run), 0.01).type, MotionType::kRun);
}

TEST(ClassifyClip, FeetThatLandAlmostTogetherJump) {
  const std::vector<Support> jump = tokens("B50 L4 N40 R6 B50");
  EXPECT_EQ(classifyClip(plantsFrom(jump), 0.01).type, MotionType::kJump);
}

TEST(ClassifyClip, BothFeetDownForLongIsStandingWhateverComesAfter) {
  const std::vector<Support> start = tokens("B300 L40 B10 R40 B10");
  EXPECT_EQ(said(classifyClip(plantsFrom(start), 0.01)), "stand 1-300, walk 301-400");
}

TEST(ClassifyClip, ADrawnWalkIsAWalkAndADrawnRunARun) {
  const auto type = [](const Puppet& puppet) {
    return classifyClip(puppet.plants(), 1.0 / puppet.rate).type;
  };
  EXPECT_EQ(type({}), MotionType::kWalk);
  EXPECT_EQ(type({.speed = 3.0, .period = 0.7, .stance = 0.38}), MotionType::kRun);
  EXPECT_EQ(type({.speed = 1.0, .period = 0.8, .stance = 0.6, .right_phase = 0.0}),
            MotionType::kJump);
}

/// The plain kinds of the manifest, as the thesis calls them.
const std::map<std::string, MotionType>& plainKinds() {
  static const std::map<std::string, MotionType> kKinds = {
      {"walk", MotionType::kWalk},      {"walk_slow", MotionType::kWalk},
      {"walk_fast", MotionType::kWalk}, {"walk_loop", MotionType::kWalk},
      {"run", MotionType::kRun},        {"run_loop", MotionType::kRun},
      {"jump", MotionType::kJump},      {"stand", MotionType::kStand}};
  return kKinds;
}

/// Kinds that hold more than one type, by what they are called.
bool mixed(const std::string& kind) {
  return kind == "run_jump_walk" || kind == "transition_stand_run" ||
         kind == "transition_walk_run" || kind == "transition_walk_skip" || kind == "walk_leap";
}

ClipClass classOf(const Capture& capture) {
  const Clip clip = readBvh(capture.file, {.metres_per_unit = capture.metres_per_unit});
  return classifyClip(detectPlants(clip, guessJointRoles(clip.skeleton, capture.path)),
                      clip.frame_time);
}

TEST(ClassifyClipOfCaptures, PlainClipsAreOfTheirKindAndMixedOnesNotHomogeneous) {
  AMBLE_NEEDS_CAPTURES();
  for (const Capture& capture : captures()) {
    const auto plain = plainKinds().find(capture.kind);
    if (plain == plainKinds().end() && !mixed(capture.kind)) continue;
    const ClipClass found = classOf(capture);
    if (plain == plainKinds().end()) {
      EXPECT_EQ(found.type, MotionType::kOther) << capture.path;
      continue;
    }
    EXPECT_EQ(found.largest(), plain->second) << capture.path << ": " << said(found);
    if (found.type != plain->second) {
      std::cout << "  not homogeneous: " << capture.path << " (" << capture.kind
                << "): " << said(found) << "\n";
    }
  }
}

}  // namespace
}  // namespace amble
