/// What a planned walk measures, as its file has it: how it meets its goal, how near it comes to
/// things, what its feet do, how it stands to the bars of quality.
#pragma once

#include "planner/plan_request.h"
#include "scenarios/problem.h"
#include "scenarios/report.h"

namespace amble {

/// Fills in all of the report that is of the walk.
/// @param poses  the frames of the file, read back
void measureWalk(const Problem& problem, const Walk& walk, const PoseArray& poses,
                 CollisionScratch& scratch, Report& report);

}  // namespace amble
