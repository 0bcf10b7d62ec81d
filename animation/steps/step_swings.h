/// How the feet of a walk swing from print to print: lifted as asked and as high as what lies in
/// between needs, put down by what they land on (Shanbhag & Chandran §3.3.2 and §3.3.3).
#pragma once

#include <array>
#include <vector>

#include "animation/steps/foot_target.h"
#include "animation/steps/footsteps.h"
#include "animation/steps/gait_parameters.h"
#include "animation/steps/swing_cycles.h"
#include "animation/steps/swing_path.h"

namespace amble {

/// Whose swings. Refers to what outlives it.
struct SwingFeet {
  const std::array<FootShape, 2>& shapes;  ///< by Side
  const SwingCycles& cycles;
  std::array<double, 2> captured_lift;  ///< by Side [m, > 0]
  double scale = 1.0;                   ///< of the character to the captured subject [> 0]
};

/// What is asked of one foot [m]. Captured feet swing a little differently, and in slower walks
/// than the plan's otherwise: near the captured lift they go on doing so, and the captured lift
/// gives the captured walk back. @param slower  FootState::slower [m/s, >= 0]
double askedLift(const SwingFeet& feet, double lift, Side side, double slower = 0.0);

/// What a step to `to`, from the other foot's print, is.
GaitParameters gaitOf(const FootPlace& from, const FootPlace& to, double lift);

/// Shapes every swing of `steps`, whose prints are on their ground, and says of every step what it
/// is (`gait`, of placings 1 to the last).
/// @param length  of the root path, that wishes are asked by [m]; @param to_standing  whether the
/// last foot is put down beside the other
/// @return whether the feet clear what lies between all prints
bool shapeSwings(const SwingFeet& feet, const SwingClearance& clearance, const GaitWishes& wishes,
                 double length, bool to_standing, Footsteps& steps,
                 std::vector<GaitParameters>& gait);

}  // namespace amble
