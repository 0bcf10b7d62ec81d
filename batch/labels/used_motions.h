/// Which captured motions a walk is made of, under which licences.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "batch/labels/frame_labels.h"

namespace amble {

struct UsedMotion {
  const Motion* motion = nullptr;
  double share = 0.0;  ///< of the walk's frames [0 to 1]; 0 of what shapes its begin and end
};

/// In the library's order: those of which something is in a frame, the actions that are laid over
/// them, and those by which walking begins and ends.
std::vector<UsedMotion> usedMotions(const RunResult& run, const FrameLabels& labels);

/// "LICENCE: CREDIT", once each.
std::set<std::string> creditsOf(const std::vector<UsedMotion>& motions);

}  // namespace amble
