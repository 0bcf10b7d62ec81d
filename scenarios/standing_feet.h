/// What the feet of any clip do on the ground of a scene: when they are planted, how they slide,
/// how far they hang over it.
#pragma once

#include "animation/analysis/foot_plants.h"
#include "animation/ground/ground.h"
#include "scenarios/foot_measures.h"
#include "scenarios/walk_findings.h"

namespace amble {

/// Plants as detectPlants finds them on one level floor, on ground of any shape: each joint's
/// height is taken from the ground below it. @param floor  is below what has no ground below it [m]
FootPlants plantsOver(const Clip& clip, const JointRoles& roles, const Ground& ground,
                      double floor);

/// Ground that is farther below a sole is not looked for [m].
inline constexpr double kMostHover = 1.0;

/// 15 % of each plant, or of a usual one where it is shorter, is left out at both ends
/// (QUALITY.md): when exactly a foot lands is not known. Where a foot leaves the ground within a
/// plant for longer than kShortestGap it is put down anew, and each stay slides for itself.
StandingFeet measureStandingFeet(const SoleTracks& soles, const FootPlants& plants,
                                 double frame_time);

/// From one plant to the next, of whichever foot.
StepHeights measureStepHeights(const SoleTracks& soles, const FootPlants& plants,
                               const Ground& ground);

/// As plants are told apart (PlantOptions::shortest_gap) [s].
inline constexpr double kShortestGap = 0.08;

}  // namespace amble
