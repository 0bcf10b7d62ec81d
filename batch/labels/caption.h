/// A walk in a sentence or two, of what was planned and passed: "A person of 1.62 m walks 8.3 m
/// through two doors, climbs 12 steps, ..."
#pragma once

#include <string>

#include "batch/labels/passages.h"

namespace amble {

/// English, in the present tense; the same for the same walk. @pre the run is solved
std::string captionOf(const RunResult& run, const PassedThings& passed);

}  // namespace amble
