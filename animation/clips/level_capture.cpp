#include "animation/clips/level_capture.h"

#include "animation/body/foot_shape.h"
#include "animation/captures/capture_checks.h"
#include "animation/clips/good_frames.h"
#include "animation/clips/steady_clip.h"
#include "base/error.h"

namespace amble {
namespace {

constexpr double kAnkleOfStature = 0.039;  // for rigs without a toe: Drillis & Contini (1966)

/// The clip on its floor, which is fitted to what is `seen` of it.
Clip onFloor(const Clip& clip, const Clip& seen, const JointRoles& roles, TiltAcross across,
             FloorFit* floor) {
  const FloorFit fit = fitFloor(seen, roles, across);
  if (floor != nullptr) *floor = fit;
  const double stature = statureOf(clip.skeleton, roles);
  const bool toes = roles.legs[kLeft].toe >= 0 && roles.legs[kRight].toe >= 0;
  const double ankle = toes ? makeFootShape(clip.skeleton, roles, kLeft, stature).ankle_height
                            : kAnkleOfStature * stature;
  return levelClip(clip, doubtOf(fit).empty() ? fit : levelPlane(fit), ankle);
}

}  // namespace

Clip levelled(const Clip& clip, const JointRoles& roles, FloorFit* floor) {
  if (jointJitter(clip) <= kNoisy) return onFloor(clip, clip, roles, TiltAcross::kHeld, floor);
  const Clip steady = steadied(clip);
  return onFloor(steady, steady, roles, TiltAcross::kHeld, floor);
}

Clip levelledAsCaptured(const Clip& clip, const JointRoles& roles, FloorFit* floor) {
  const bool noisy = jointJitter(clip) > kNoisy;
  return onFloor(clip, noisy ? steadied(clip) : clip, roles, TiltAcross::kIgnored, floor);
}

LevelCapture readLevelCapture(const std::filesystem::path& file, const MotionReadOptions& options) {
  LevelCapture capture;
  capture.motion = readMotion(file, options);
  Clip& clip = capture.motion.clip;
  if (clip.frames() == 0) throw InputError(file.string(), 0, "holds no frames", "a motion");
  const GoodFrames good = goodFrames(clip);
  capture.first_frame = good.first;
  clip = levelled(trimmed(clip, good.first, good.last), capture.motion.roles, &capture.floor);
  const std::string doubt = doubtOf(capture.floor);
  if (!doubt.empty()) capture.motion.warnings.push_back("the floor " + doubt);
  return capture;
}

}  // namespace amble
