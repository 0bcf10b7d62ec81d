/// All that is read off one clip: who stands when, the events of its feet, what kind of motion it
/// is, and how it walks.
#pragma once

#include "animation/analysis/classify_clip.h"
#include "animation/analysis/foot_plants.h"
#include "animation/analysis/gait_events.h"
#include "animation/analysis/gait_measures.h"

namespace amble {

/// Frames are the clip's; a file may have more before (good_frames.h).
struct ClipAnalysis {
  double frame_time = 0.0;  ///< [s]
  FootPlants plants;
  std::array<FootCurves, 2> curves;  ///< by Side; empty for a clip without frames
  GaitEvents events;
  ClipClass kind;
  GaitMeasures gait;

  int frames() const { return plants.frames; }
};

/// @param level  on a level floor, z = 0 (floor_fit.h): heights and lifts are over it
ClipAnalysis analyseClip(const Clip& level, const JointRoles& roles);

}  // namespace amble
