/// The path of a swinging foot from print to print: the captured one, lifted (Shanbhag & Chandran
/// §3.3.2) and, where something lies in between, shaped to clear it.
///
/// The papers add a climb to the swing linearly (§3.3.3), which takes the foot through the nosing
/// of a stair; ours goes along the line between its prints and over that as high as it must.
#pragma once

#include <array>

#include "animation/body/foot_shape.h"
#include "animation/ground/ground.h"
#include "animation/library/walk_cycle.h"
#include "animation/steps/foot_state.h"

namespace amble {

/// Share of the way from print to print that is done at tau [0, 1].
double swingAlong(const SwingShape& shape, const FootCycle& cycle, double tau);
/// Height of the sole over the line from print to print [m].
double swingHeight(const SwingShape& shape, const FootCycle& cycle, double tau);
/// How to swing over what is there. Const: threads share it.
class SwingClearance {
 public:
  /// Between sole and what it passes over, and ahead of the tip of the toes: twice what QUALITY.md
  /// asks for is left, since frames and cells are coarse [m].
  static constexpr double kOver = 0.025, kAhead = 0.015;

  /// @param highest  extra lift that is tried at most [m, > 0]
  SwingClearance(const Ground& ground, const std::array<FootShape, 2>& feet, double highest)
      : ground_(ground), feet_(feet), highest_(highest) {}

  /// Changes `shape` so that the foot clears everything between the prints; leaves it where it does
  /// already. What goes on far above the highest lift is a wall, and for the collision check.
  /// @return false where no lift does.
  bool clear(const FootPlace& from, const FootPlace& to, Side side, const FootCycle& cycle,
             SwingShape& shape) const;

 private:
  struct Strip;
  Strip strip(const FootPlace& from, const FootPlace& to, Side side) const;
  static constexpr int kSamples = 32;  // of a swing
  using Needs = std::array<double, kSamples>;
  Needs needs(const Strip& strip, const FootCycle& cycle, const SwingShape& shape) const;
  bool isFree(const FootPlace& from, const FootPlace& to, const FootShape& foot) const;

  const Ground& ground_;
  const std::array<FootShape, 2>& feet_;
  double highest_;
};

}  // namespace amble
