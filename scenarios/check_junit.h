/// The table of a check as JUnit's XML, which continuous integration reads.
#pragma once

#include <ostream>
#include <vector>

#include "scenarios/check_scenarios.h"

namespace amble {

/// One test case a scenario. What was stopped counts as skipped. Names are of any bytes; what is no
/// UTF-8, or no character of XML, becomes U+FFFD.
void writeJUnit(std::ostream& out, const std::vector<CheckRow>& rows);

}  // namespace amble
