/// How tall the people of motion libraries may be.
#pragma once

namespace amble {

/// From a child that just walks to nobody: what is beyond is a file's unit that is wrong [m].
inline constexpr double kShortestStature = 0.3, kTallestStature = 3.0;

}  // namespace amble
