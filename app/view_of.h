/// What the pictures show of a run.
#pragma once

#include "scenarios/run_scenario.h"
#include "viz/walk_view.h"

namespace amble {

/// @pre result outlives the view.
WalkView viewOf(const RunResult& result);

}  // namespace amble
