#include "animation/editing/captured_walk.h"

#include <fmt/format.h>

#include <cmath>

#include "animation/clips/good_frames.h"
#include "animation/clips/level_capture.h"
#include "base/error.h"

namespace amble {
namespace {

constexpr double kOtherThanWalk = 0.25;  // of the frames: a hop on the way is walked over
constexpr int kFewestSteps = 2;          // from which a stride is known

}  // namespace

CapturedWalk captureWalk(Clip level, const JointRoles& roles) {
  CapturedWalk walk{std::move(level), roles, {}, 0};
  walk.clip.joint_positions.clear();
  walk.analysis = analyseClip(walk.clip, roles);
  return walk;
}

CapturedWalk captureWalk(CapturedMotion& motion, const std::string& file) {
  if (motion.clip.frames() == 0) throw InputError(file, 0, "holds no frames", "a motion");
  motion.clip.joint_positions.clear();
  const GoodFrames good = goodFrames(motion.clip);
  FloorFit floor;
  CapturedWalk walk = captureWalk(
      levelledAsCaptured(trimmed(motion.clip, good.first, good.last), motion.roles, &floor),
      motion.roles);
  walk.first_frame = good.first;
  const std::string doubt = doubtOf(floor);
  if (!doubt.empty()) motion.warnings.push_back("the floor " + doubt);
  return walk;
}

std::string whyNoWalk(const CapturedWalk& walk) {
  const ClipClass& kind = walk.analysis.kind;
  const auto percent = [&](MotionType type) { return std::lround(100.0 * kind.shareOf(type)); };
  for (const MotionType type : {MotionType::kRun, MotionType::kJump, MotionType::kUnknown}) {
    if (kind.shareOf(type) <= kOtherThanWalk) continue;
    const std::string what = type == MotionType::kUnknown
                                 ? "shows feet that neither stand nor step"
                                 : fmt::format("is a {}", motionTypeName(type));
    return fmt::format("{} for {} % of its time", what, percent(type));
  }
  const size_t steps = walk.analysis.gait.steps.size();
  if (steps >= kFewestSteps) return "";
  if (percent(MotionType::kStand) > 50) {
    return fmt::format("stands for {} % of its time", percent(MotionType::kStand));
  }
  return fmt::format("shows {} whole step{}", steps, steps == 1 ? "" : "s");
}

}  // namespace amble
