/// A capture as grafting sees it: its frames as they are in the file, who stands when, and what it
/// is at each (Shanbhag's thesis, §5.1.5: "homogeneous" clips of locomotive motion).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "animation/analysis/classify_clip.h"
#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

struct LocomotiveClip {
  std::string file;  ///< for messages
  Clip clip;         ///< every frame, untouched
  int first = 0;     ///< first and last frame that are motion (good_frames.h)
  int last = 0;
  JointRoles roles;
  FootPlants plants;  ///< in frames of `clip`
  ClipClass kind;     ///< the same; frames before its motion begins are unknown
};

/// Frames of one type, both included.
struct MotionStretch {
  MotionType type = MotionType::kUnknown;
  int first = 0, last = 0;

  int frames() const { return last - first + 1; }
};

/// Analyses a level copy of its motion (good_frames.h, level_capture.h).
/// @throws InputError for a clip without frames
LocomotiveClip locomotiveClip(Clip clip, const JointRoles& roles, const std::string& file);

/// The longest stretch of one stand, walk, run or jump; of `within`, of these frames. Of type
/// kUnknown where there is none.
MotionStretch stretchOf(const LocomotiveClip& clip);
MotionStretch stretchOf(const LocomotiveClip& clip, std::pair<int, int> within);

/// The plants of frames [first, last], counted from `first`.
FootPlants plantsWithin(const FootPlants& plants, int first, int last);

}  // namespace amble
