/// What a walk costs beside its time: climbing, lifting and jolts, as the time of a level walk that
/// costs as much.
///
/// Walking at its best speed costs 2.5 J/kg a metre, and 19.6 J/kg more a metre of height won
/// (Minetti, Moia, Roi, Susta and Ferretti 2002, "Energy cost of walking and running at extreme
/// uphill and downhill slopes", the linear terms of their regression). A foot that is lifted higher
/// than the captured walk's takes its leg along, 0.161 of the body's mass (Winter 1990), at
/// muscles' efficiency of a quarter: 6.3 J/kg a metre. Going down is charged nothing: it costs less
/// than level walking on slopes that people walk. What slows a walk is in its time. Hips that fall
/// and rise at once, as where a leg is too short right after a stance, look like a stumble: such
/// a walk costs as much as a longer one.
#pragma once

#include <span>

#include "animation/synthesis/animation_buffer.h"

namespace amble {

/// @param captured_lift  GaitParameters::lift of the captured walk [m]
/// @param speed  on the straight [m/s, > 0]
/// @return [s, >= 0]; 0 on level ground with nothing to step over
double effortOf(const AnimationBuffer& walk, double captured_lift, double speed);
/// The same of a walk that is planned but not animated, from its steps: without jolts.
double effortOf(std::span<const GaitParameters> steps, double captured_lift, double speed);

}  // namespace amble
