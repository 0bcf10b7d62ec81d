/// The page of a plan: its walk, or why there is none.
#pragma once

#include <deque>

#include "scenarios/run_scenario.h"
#include "viz/page/page.h"

namespace amble {

struct WalkPage {
  PageSubject subject;
  std::deque<PoseArray> poses;  ///< of takes that are not the walk; they stay where they are
};

/// What the page of a run shows: the walk, or the attempt that the obstruction stopped; edges of
/// the roadmap and attempts, played once more, as many as a page has room for. @pre both outlive it
WalkPage walkPage(const RunResult& result, const WalkView& view);

}  // namespace amble
