// A project of somebody else: makes two seconds of a walk with the library that comes with Amble,
// writes it and reads it back. What is installed can all be included: the other source does that.
#include <cmath>
#include <cstdio>

#include "animation/captures/bvh.h"
#include "animation/ground/ground.h"
#include "animation/library/motion_library_reader.h"
#include "animation/steps/root_path.h"
#include "animation/synthesis/walk_synthesizer.h"

int main() {
  const amble::MotionLibrary library = amble::openMotionLibrary("default");
  const amble::FlatGround ground;
  const amble::WalkSynthesizer synthesizer(library, ground, {});
  const double length = 2.0 * synthesizer.settings().speed;
  const amble::RootPath path({amble::makeBezier({0.0, 0.0}, 0.0, {length, 0.0}, 0.0)});
  amble::Stance from, to;
  to.position.x() = length;
  amble::AnimationBuffer walk;
  if (synthesizer.walk(from, to, path, true, walk).refused != amble::WalkRule::kNone) return 1;

  const amble::Clip clip{"walk", synthesizer.skeleton(), walk.frame_time, walk.poses, {}};
  amble::writeBvh("walk.bvh", clip, {});
  const amble::Clip read = amble::readBvh("walk.bvh", {});
  const double walked = read.poses.p_WR(read.frames() - 1).x() - read.poses.p_WR(0).x();
  std::printf("%zu motions; %.2f s, %.3f m\n", library.motions.size(), read.duration(), walked);
  return read.frames() == clip.frames() && std::abs(walked - length) < 0.05 ? 0 : 1;
}
