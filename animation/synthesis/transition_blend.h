/// Captured starts and stops of a library (Pettré §4.3), ready for a character: which is taken, and
/// how it is joined to the walk.
///
/// Of several the one is taken whose walk is nearest in speed, but no faster, and whose foot steps
/// beside standing; slower walks than all of them begin and end by the formula.
/// It is joined to the cycle where the two bodies are most alike, seen from the root, in place and
/// in speed; the blend begins half of its time before. Since both are told on the same path, the
/// mean of the two glides no more than they do.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "animation/library/motion_library.h"
#include "animation/steps/start_and_stop.h"
#include "animation/steps/swing_cycles.h"

namespace amble {

/// Channels of the walk at a moment of a transition's clock, which it is to be joined to.
using WalkAt = std::function<void(double clock, Side side, bool start, std::span<double> channels)>;

class TransitionBlend {
 public:
  struct Joined {
    const Motion* motion = nullptr;           ///< of the library
    TransitionSequence sequence;              ///< scaled
    double blend_from = 0.0, blend_to = 0.0;  ///< on the clock [steps]

    /// How much of it there is at a moment of the clock: 1 at first, 0 from blend_to on [0, 1].
    double share(double clock) const;
    /// Mixes the sequence into channels[stride * i], of a walk with steps so long there [m].
    void mix(double clock, double step_length, std::span<double> scratch, double* channels,
             int stride) const;
  };

  TransitionBlend() = default;
  /// @param speed  the walk's [m/s]; @param walk_at  as it is before transitions are blended in
  TransitionBlend(const MotionLibrary& library, double scale, double speed, const WalkAt& walk_at);

  /// The start in which `side` steps first, the stop in which it steps last; null where none is
  /// captured.
  const Joined* start(Side side) const { return of(0, side); }
  const Joined* stop(Side side) const { return of(1, side); }
  /// Of each side, for the steps.
  std::array<EndSwing, 2> firstSwings() const { return swings(0); }
  std::array<EndSwing, 2> lastSwings() const { return swings(1); }
  /// Longest sway of the starts and of the stops [steps].
  double startSway() const { return sway(0); }
  double stopSway() const { return sway(1); }
  /// Adds first and last swings.
  void addSwings(SwingCycles& cycles) const;

  /// Length of the blend: shorter, and trunks jerk; longer, and little is left of the start
  /// [steps].
  static constexpr double kBlend = 0.8;
  /// Velocities count as the way of so long [s].
  static constexpr double kVelocityTime = 0.1;

 private:
  const Joined* of(int stop, Side side) const {
    const std::optional<Joined>& joined = joined_[stop][side];
    return joined ? &*joined : nullptr;
  }
  std::array<EndSwing, 2> swings(int stop) const;
  double sway(int stop) const;

  std::array<std::array<std::optional<Joined>, 2>, 2> joined_;  // starts, stops; by Side
};

}  // namespace amble
