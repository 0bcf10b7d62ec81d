#include "animation/preparation/transition_fit.h"

#include <gtest/gtest.h>

#include "animation/clips/level_capture.h"
#include "animation/library/motion_library_reader.h"
#include "base/error.h"
#include "tests/animation/captures.h"

namespace amble {
namespace {

TEST(Transition, StartsAndStopsOfCapturesAreWithinWhatPeopleDo) {
  const MotionLibrary library = openMotionLibrary("default");
  for (const char* const name : {"start", "stop"}) {
    const Motion* motion = library.find(name);
    ASSERT_NE(motion, nullptr) << name;
    EXPECT_GT(motion->transition.first_speed, 0.3 * motion->transition.speed);
    EXPECT_LE(motion->transition.first_speed, 1.1 * motion->transition.speed);
    EXPECT_GT(motion->transition.acceleration, 0.4);
    EXPECT_LT(motion->transition.acceleration, 2.0);
  }
}

/// The clip played backwards: its start is a stop.
Clip backwards(const Clip& clip) {
  Clip result = clip;
  result.poses.clear();
  for (int i = clip.frames() - 1; i >= 0; --i) result.poses.append(clip.poses, i, 1);
  return result;
}

TEST(Transition, AStopIsAStartSeenBackwards) {
  AMBLE_NEEDS_CAPTURES();
  const LevelCapture capture =
      readLevelCapture(sharedFolder() / "mocap/accad_female1/Female1_B01_StandToWalk.bvh");
  std::array<int, 2> forward = {0, 0}, back = {0, 0};
  const Clip& clip = capture.motion.clip;
  const Transition start = fitTransition(clip, capture.motion.roles, true, "start", forward);
  const Transition stop = fitTransition(backwards(clip), capture.motion.roles, false, "stop", back);
  EXPECT_NEAR(stop.speed, start.speed, 1e-9);
  EXPECT_NEAR(stop.acceleration, start.acceleration, 1e-9);
  EXPECT_EQ(back[0], clip.frames() - 1 - forward[1]);
  EXPECT_EQ(back[1], clip.frames() - 1 - forward[0]);
}

TEST(Transition, AWalkThatNeverStandsHasNone) {
  AMBLE_NEEDS_CAPTURES();
  const LevelCapture capture =
      readLevelCapture(sharedFolder() / "mocap/accad_female1/Female1_B03_Walk1.bvh");
  std::array<int, 2> frames = {0, 0};
  EXPECT_THROW(fitTransition(capture.motion.clip, capture.motion.roles, true, "walk", frames),
               InputError);
}

}  // namespace
}  // namespace amble
