/// How fast a root path is walked on its ground: the pace of the slope under every step.
#pragma once

#include <functional>

#include "animation/steps/root_path.h"
#include "animation/steps/stance.h"
#include "animation/steps/step_settings.h"

namespace amble {

/// Share of the level's speed (slopePace) by arc [m], linear between points a quarter of a metre
/// apart; none where the ground is level all along. On treads the slope under a step is no slope
/// that soles stand on: stairs slow by their steps, not by this.
std::function<double(double)> paceAlong(const StepSettings& settings, const FootholdFinder& holds,
                                        const RootPath& path, const Stance& from, const Stance& to);

}  // namespace amble
