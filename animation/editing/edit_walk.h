/// A captured walk changed: stride, lift, slope, stairs, arrival, feet that stay where they stand
/// (Shanbhag's thesis, chapter 6; Shanbhag & Chandran).
///
/// What is asked for is done to the tracks of root and feet, one thing after another; then the legs
/// follow (walk_tracks.h). The upper body is played back as it was captured. "Stride" is both
/// texts' word for the length of a step, from one foot's print to the other's.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "animation/editing/captured_walk.h"
#include "animation/editing/stair_climb.h"
#include "animation/editing/walk_tracks.h"
#include "animation/ground/ground.h"
#include "base/ramp.h"

namespace amble {

/// Over the walk's way, from its begin to its end.
struct EditAmount {
  Ramp ramp;
  bool factor = true;  ///< times what was captured [1, > 0]; else as the mean shall be [m, > 0]

  /// Times what was captured, of which the mean is `captured` [m, > 0].
  Ramp factorOf(double captured) const {
    return factor ? ramp : Ramp{ramp.from / captured, ramp.to / captured};
  }
};

/// Bounds of what is asked for, as factors of what was captured: beyond, a captured walk is
/// another.
struct EditLimits {
  static constexpr double kShortest = 0.6, kLongest = 1.4;  ///< stride
  static constexpr double kLowest = 0.5, kHighest = 3.0;    ///< lift
};

struct EditRequest {
  /// Along the ground: on a slope a step is seen from above by the cosine shorter (eq. 6.8).
  std::optional<EditAmount> stride;
  std::optional<EditAmount> lift;
  std::optional<Ramp> incline;      ///< up positive [rad, -45 to 45 degrees]
  std::optional<StairSize> stairs;  ///< a tread for each step; then no stride, incline or arrival
  /// Where the root shall be in the last frame [m, World]: the walk is turned about where it
  /// begins, and its stride scaled (thesis, §6.1); then no stride.
  std::optional<Eigen::Vector2d> arrive;
  bool foot_lock = false;  ///< foot_lock.h

  bool changesWalk() const { return stride || lift || incline || stairs || arrive; }
};

/// Where slope or stairs lie.
struct EditedGround {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< height 0, where the walk begins [m, World]
  double heading = 0.0;                              ///< in which they go up or down [rad]
  Stairs stairs{.count = 0};                         ///< from there; count 0: none
};

struct EditedWalk {
  std::string refused;  ///< why there is none, or ""; then the rest is of no use
  Clip clip;
  std::unique_ptr<Ground> ground;  ///< that it walks on
  EditedGround place;
  TrackFit fit;
  double lock_moved = 0.0;  ///< how far a foot was moved at most to be held [m, >= 0]
  double stride = 1.0;      ///< factor that an arrival took [1, > 0]
};

/// @pre whyNoWalk(walk) is "" where the request changes the walk; factors within EditLimits
EditedWalk editWalk(const CapturedWalk& walk, const EditRequest& request);

}  // namespace amble
