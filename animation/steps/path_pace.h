/// How fast a root path is walked: the pace of the slope under every step, and of its ends.
#pragma once

#include <functional>

#include "animation/steps/root_path.h"
#include "animation/steps/stance.h"
#include "animation/steps/step_settings.h"

namespace amble {

/// Share of the plan's speed by arc [m]: the slope's (slopePace), at a walking end times that
/// stance's own pace; linear between points a quarter of a metre apart. None where it is 1 all
/// along. On treads the slope under a step is no slope
/// that soles stand on: stairs slow by their steps, not by this.
std::function<double(double)> paceAlong(const StepSettings& settings, const FootholdFinder& holds,
                                        const RootPath& path, const Stance& from, const Stance& to);

}  // namespace amble
