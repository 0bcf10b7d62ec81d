/// The page of a plan: its walk, or why there is none.
#pragma once

#include "scenarios/run_scenario.h"
#include "viz/page/page.h"

namespace amble {

/// What the page of a run shows. @pre both outlive it
PageSubject walkPage(const RunResult& result, const WalkView& view);

}  // namespace amble
