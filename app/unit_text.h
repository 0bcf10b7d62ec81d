/// Units behind numbers.
#pragma once

#include <string>

namespace amble {

/// " m/s" for "m/s"; nothing for "1", the unit of what has none.
inline std::string unitText(const std::string& unit) { return unit == "1" ? "" : " " + unit; }

}  // namespace amble
