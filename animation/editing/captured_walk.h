/// A capture that is to be edited: on a level floor, and what is found in it (Shanbhag's thesis,
/// §6.2.2, preprocessing).
#pragma once

#include <string>

#include "animation/analysis/clip_analysis.h"
#include "animation/captures/motion_reader.h"

namespace amble {

struct CapturedWalk {
  Clip clip;  ///< level, its standing feet on z = 0; bones of constant length
  JointRoles roles;
  ClipAnalysis analysis;
  int first_frame = 0;  ///< of the file that is frame 0 of the clip (good_frames.h)
};

/// What is no motion at its begin is cut off and the floor is levelled; bones are as long as the
/// skeleton has them. Joints turn as they were captured, noise and all. Warnings go to the
/// motion's.
/// @throws InputError naming `file` for a motion without a frame
CapturedWalk captureWalk(CapturedMotion& motion, const std::string& file);
/// The same of a clip that is level already.
CapturedWalk captureWalk(Clip level, const JointRoles& roles);

/// Why a walk's edit does not apply; "" where it does. A walk has two steps in it at least, and
/// runs, jumps or does what nobody can tell for no more than a quarter of its time.
std::string whyNoWalk(const CapturedWalk& walk);

}  // namespace amble
