/// A walk or run made by a speed engine, straight ahead: speed may change from frame to frame
/// (Glardon 2004, §4.2).
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "animation/body/clip.h"
#include "animation/library/speed_engine.h"

namespace amble {

struct EngineWalkRequest {
  std::function<double(double)> speed;  ///< wanted at a time [s] from the begin [m/s, >= 0]
  double duration = 5.0;                ///< [s, > 0]
  double frame_time = 1.0 / 60.0;       ///< [s, > 0]
  double scale = 1.0;                   ///< of the walker to the captured person [> 0]
  double phase = 0.0;                   ///< of the first frame [cycles]
};

struct EngineWalk {
  Clip clip;                   ///< from the origin along x, over level ground at z = 0
  std::vector<double> speeds;  ///< a value a frame: what is walked, clamped [m/s]
  std::vector<double> phases;  ///< [cycles, from the first frame's on]
  /// By Side, a value a frame: by the captured timing; the first foot that swings in a walk that
  /// speeds up from below those captured is lifted later, the last one in a walk that slows down
  /// below them is put down sooner.
  std::array<std::vector<bool>, 2> planted;
  double length = 0.0;  ///< walked along the path [m]
};

/// The phase of the first frame with which a walk that ends at a stand does so a fifth of a cycle
/// after one foot has passed the other: there his legs stand as in standing, and the last swing has
/// come down. 0 for other walks [cycles].
double phaseToStand(const SpeedEngine& engine, const EngineWalkRequest& request);

/// Whether who walks so fast stands.
bool isStanding(double speed);

/// The phase goes on by the cadence of the speed (eq. 5), the root by the speed and by its own way
/// within the cycle. Feet slide as far as captured swings of the legs miss the law's stride, and go
/// into the floor where legs that swing are shrunk: editing/foot_lock.h and editing/sole_contact.h
/// hold them by `planted`.
EngineWalk engineWalk(const SpeedEngine& engine, const EngineWalkRequest& request);

}  // namespace amble
