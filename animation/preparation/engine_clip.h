/// Walks of a speed engine as if they had been captured: what motion libraries take of an engine,
/// by the way that captures take. Plans hold the feet of such walks, turn them and put them on
/// stairs as those of any library.
#pragma once

#include <string>

#include "animation/analysis/foot_plants.h"
#include "animation/clips/level_capture.h"
#include "animation/library/speed_engine.h"

namespace amble {

/// Straight ahead along x over level ground, at one speed: a few cycles, each the same frames.
struct WalkOfEngine {
  LevelCapture capture;
  /// By the captured timing: an engine's feet slide, and when they stand is not seen from that.
  FootPlants plants;
  /// Of the clip that is nearest in speed: engines smooth, and are no measure of what people do.
  CaptureQuality quality;
  Motion stand;                 ///< the engine's standing posture, as a library has it
  std::string licence, credit;  ///< of all walks that the engine was fitted to
};

/// Plans walk no slower [m/s].
inline constexpr double kSlowestOfEngine = 0.3;

/// @param speed  of a person as large as the captured one, kSlowestOfEngine to
/// SpeedEngine::fastestWalk() [m/s] @param file  the engine's, for messages
/// @throws InputError where the engine has no such walk: it only runs; it runs or nearly does at
/// that speed; nobody was captured so fast.
WalkOfEngine walkOfEngine(const SpeedEngine& engine, double speed, const std::string& file);

}  // namespace amble
