#include "animation/preparation/cycle_finder.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "animation/clips/mirror_clip.h"
#include "base/error.h"
#include "base/rotation.h"
#include "tests/animation/level_walk.h"

namespace amble {
namespace {

std::string refusal(const LevelWalk& walk, const CycleOptions& options) {
  try {
    findStretches(walk.track, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(CycleFinder, StretchesOfASteadyWalkAreAlike) {
  AMBLE_NEEDS_CAPTURES();
  const LevelWalk walk("accad_female1/Female1_B03_Walk1.bvh");
  const auto stretches = findStretches(walk.track, {"walk", false, 0, {}});
  ASSERT_GE(stretches.size(), 6u);
  const Stretch& best = stretches.front();
  for (const Stretch& s : stretches) {
    EXPECT_LT(s.begin, s.middle);
    EXPECT_LT(s.middle, s.end);
    EXPECT_GE(s.closure, best.closure);
    EXPECT_NEAR(s.speed, best.speed, 0.08 * best.speed);
    EXPECT_NEAR(s.end - s.begin, best.end - best.begin, 0.1 * (best.end - best.begin));
    EXPECT_LT(s.aside, 0.5);
  }
}

// Of the mirror image: in it the other foot leads.
TEST(CycleFinder, InAMirrorTheSameCyclesAreFoundWithTheOtherFootInFront) {
  AMBLE_NEEDS_CAPTURES();
  const LevelWalk walk("accad_female1/Female1_B03_Walk1.bvh");
  const JointRoles& roles = walk.roles;
  const Clip image = mirrorClip(walk.clip, roles);
  const GaitTrack track(image, roles, walk.feet);
  const auto inOrder = [](std::vector<Stretch> cycles) {
    std::sort(cycles.begin(), cycles.end(),
              [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
    return cycles;
  };
  const auto here = inOrder(wholeCycles(walk.track, {"walk", false, 0, {}}));
  const auto there = inOrder(wholeCycles(track, {"walk", false, 0, {}}));
  ASSERT_EQ(there.size(), here.size());
  for (size_t i = 0; i < here.size(); ++i) {
    // The rig is not quite its own mirror image: an event may be seen a frame off.
    EXPECT_NEAR(there[i].begin, here[i].begin, 1.5);
    EXPECT_NEAR(there[i].end, here[i].end, 1.5);
    EXPECT_EQ(there[i].leading, other(here[i].leading));
    EXPECT_NEAR(there[i].turn, -here[i].turn, 0.02);
    EXPECT_NEAR(there[i].speed, here[i].speed, 0.03);
  }
}

TEST(CycleFinder, AllThatIsFoundAreWholeCycles) {
  AMBLE_NEEDS_CAPTURES();
  const LevelWalk walk("cmu_mb2/08_03.bvh");
  const CycleOptions options{"walk", false, 0, {}};
  const auto whole = wholeCycles(walk.track, options);
  for (const Stretch& s : findStretches(walk.track, options)) {
    bool among = false;
    for (const Stretch& w : whole) among = among || (w.begin == s.begin && w.end == s.end);
    EXPECT_TRUE(among);
  }
}

TEST(CycleFinder, OnlyFramesThatAreAskedForAreLookedAt) {
  AMBLE_NEEDS_CAPTURES();
  const LevelWalk walk("accad_female1/Female1_B03_Walk1.bvh");
  for (const Stretch& s : findStretches(walk.track, {"walk", false, 0, std::pair{60, 140}})) {
    EXPECT_GE(s.begin, 60.0);
    EXPECT_LE(s.end, 140.0);
  }
  EXPECT_NE(refusal(walk, {"walk", false, 0, std::pair{60, 80}}).find("no whole cycle"),
            std::string::npos);
}

TEST(CycleFinder, WhatIsNoWalkAheadIsRefusedWithTheReason) {
  AMBLE_NEEDS_CAPTURES();
  const LevelWalk back("accad_female1/Female1_B05_WalkBackwards.bvh");
  EXPECT_NE(refusal(back, {"back", false, 0, {}}).find("back: walks backwards"), std::string::npos);
}

TEST(CycleFinder, ATurnThatIsCalledStraightIsRefusedUnlessPartOfItIsStraight) {
  AMBLE_NEEDS_CAPTURES();
  const LevelWalk turn("accad_female1/Female1_B09_WalkTurnLeft90.bvh");
  for (const Stretch& s : findStretches(turn.track, {"turn", true, 0, {}})) {
    EXPECT_GT(s.turn / ((s.end - s.begin) * turn.track.clip().frame_time), kStraightTurnRate);
  }
}

}  // namespace
}  // namespace amble
