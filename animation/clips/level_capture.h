/// A capture made ready to be measured and cut: its motion only, in metres, on a level floor.
#pragma once

#include <filesystem>

#include "animation/captures/motion_reader.h"
#include "animation/clips/floor_fit.h"

namespace amble {

struct LevelCapture {
  CapturedMotion motion;  ///< `clip` is level: standing feet are flat on z = 0
  int first_frame = 0;    ///< of the file that is frame 0 of the clip (good_frames.h)
  FloorFit floor;         ///< as it was
};

/// @throws InputError as readMotion does, and for a file without a frame.
LevelCapture readLevelCapture(const std::filesystem::path& file,
                              const MotionReadOptions& options = {});

/// A clip, level on its fitted floor, or where that is in doubt (floor_fit.h) only lifted onto it;
/// a noisy one (capture_checks.h) is steadied before. @param floor  if not null, what was fitted
Clip levelled(const Clip& clip, const JointRoles& roles, FloorFit* floor = nullptr);
/// The same, but only turned and lifted as a whole: noise stays, and tilt across the way of who
/// walks straight on (TiltAcross::kIgnored), so that what is level already stays where it is.
Clip levelledAsCaptured(const Clip& clip, const JointRoles& roles, FloorFit* floor = nullptr);

}  // namespace amble
