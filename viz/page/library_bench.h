/// A motion library on the workbench: its motions to be played, its cycles as curves against the
/// captures that they were made from, and the law of its steps.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "animation/library/motion_library.h"
#include "viz/page/bench.h"

namespace amble {

/// A motion, with the captured cycles that it is the average of.
struct BenchMotion {
  const Motion* motion = nullptr;       ///< never null
  std::vector<FourierSeries> captured;  ///< of a walk or a movement; none where `lacking` says why
  std::string lacking;
};

/// Motions that can be played are first: those of the bench's clips, in their order.
struct BenchLibrary {
  const MotionLibrary* library = nullptr;  ///< never null
  std::vector<BenchMotion> motions;
  /// Two cycles of each walk; of a movement those of the walk that it is laid over; each pose held
  /// for a second; starts and stops as they were captured, where the capture is there.
  std::vector<ShownClip> clips;
};

/// @param captures  the folder that its sources are looked for in; empty: none is
/// @pre the library outlives it
BenchLibrary benchOfLibrary(const MotionLibrary& library, const std::filesystem::path& captures);

/// Everything but the clips' own curves.
std::string benchLibraryJson(const BenchLibrary& bench, const NumbersText& numbers);

/// What a clip of the library measures, as `amble analyse` would call it: a JSON object.
std::string motionAnalysisJson(const Motion& motion, const ShownClip& clip);

}  // namespace amble
