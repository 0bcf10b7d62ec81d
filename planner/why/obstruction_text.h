/// What stood in the way, in words.
#pragma once

#include <string>
#include <string_view>

#include "planner/plan_request.h"

namespace amble {

/// One line for people: what is missing where, how much there is and what would do, rounded to the
/// centimetre that would.
std::string describe(const Obstruction& why);

std::string_view lackName(Obstruction::Lack lack);  ///< "gap", "headroom", ...; "unknown"

}  // namespace amble
