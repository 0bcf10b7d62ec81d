/// What is ground to a walker of some stature.
#pragma once

#include "environments/ground/ground_settings.h"

namespace amble {

/// Room for head and feet by the stature [m, > 0].
GroundSettings walkerGround(double stature, const GroundLimits& limits);

}  // namespace amble
