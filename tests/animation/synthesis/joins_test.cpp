// Where captured starts, stops and turns are joined to the walk, no joint is jerked.

#include <gtest/gtest.h>

#include <algorithm>

#include "animation/preparation/motion_library_add.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "tests/animation/default_library.h"
#include "tests/animation/planted_clip.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

/// Largest angular acceleration of a joint in what walks, starts and turns were captured, at 30 Hz
/// [rad/s²]. Captures begin and end with a jump.
double capturedAcceleration() {
  constexpr int kJump = 10;  // frames
  double most = 0.0;
  for (const char* name : {"B01_StandToWalk", "B03_Walk1", "B09_WalkTurnLeft90"}) {
    const auto file =
        sharedFolder() / "mocap" / ("accad_female1/Female1_" + std::string(name) + ".bvh");
    MotionLibrary library = defaultLibrary();
    const Clip clip = clipForLibrary(library, readForLibrary(file, {}), file.string());
    most = std::max(most, jointAcceleration(clip, kJump, clip.frames() - kJump));
  }
  return most;
}

TEST(Joins, AreNoMoreSuddenThanTheCaptures) {
  AMBLE_NEEDS_CAPTURES();
  const double captured = capturedAcceleration();
  const FlatGround ground;
  CharacterSettings settings;
  settings.frame_time = 1.0 / 30.0;
  AnimationBuffer buffer;
  int transitions = 0;
  for (const double speed : {1.0, 1.2, 1.3}) {
    settings.speed = speed;
    const WalkSynthesizer walker(defaultLibrary(), ground, settings);
    for (double length = 4.0; length < 6.0; length += 0.35) {
      for (const double angle : {0.0, 1.2, -1.2}) {
        const RootPath path =
            angle == 0.0 ? straightPath(length) : circlePath(length / angle, angle);
        ASSERT_EQ(
            walker.walk(stanceAt(path, false, true), stanceAt(path, true, true), path, true, buffer)
                .refused,
            WalkRule::kNone);
        for (const FrameState& state : buffer.states)
          transitions += state.start.there || state.stop.there ? 1 : 0;
        Clip walk;
        walk.skeleton = walker.skeleton();
        walk.frame_time = settings.frame_time;
        walk.poses = buffer.poses;
        EXPECT_LE(jointAcceleration(walk, 0, walk.frames()), 1.05 * captured)
            << speed << " m/s, " << length << " m, " << angle;
      }
    }
  }
  EXPECT_GT(transitions, 0);
}

}  // namespace
}  // namespace amble
