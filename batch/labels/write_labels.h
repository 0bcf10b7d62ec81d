/// The labels of a walk as files: labels.json and labels.npz (docs/batch.md).
///
/// labels.npz holds the arrays of walk.npz (viz/exchange/walk_npz.h) and, of F frames, B parts of
/// the body, M motions and E gait events:
///
///     part_names      B texts          object_names   texts, of the scene
///     clearance       F x B float      [m]            nearest   F x B int, of object_names or -1
///     contact         F x B bool       activity       F int, of activity_names
///     activity_names  texts            motion_names   M texts
///     motion_shares   F x M float      event_frames, event_sides, event_strikes   E each
#pragma once

#include <ostream>
#include <string>

#include "batch/labels/cameras.h"
#include "batch/labels/frame_labels.h"
#include "batch/labels/passages.h"
#include "batch/labels/used_motions.h"

namespace amble {

struct WalkLabels {
  FrameLabels frames;
  PassedThings passed;
  std::string caption;
  std::vector<CameraView> cameras;
  std::vector<UsedMotion> motions;
};

/// @param all  false: caption and motions only. @pre the run is solved, and outlives the labels
WalkLabels labelWalk(const RunResult& run, bool all);

/// @pre all was labelled
void writeLabelsJson(std::ostream& out, const RunResult& run, const WalkLabels& labels);
void writeLabelsNpz(std::ostream& out, const RunResult& run, const WalkLabels& labels);

}  // namespace amble
