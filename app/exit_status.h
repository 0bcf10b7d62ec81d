/// What the program ends with.
#pragma once

namespace amble {

/// Exit status, as grep's (DESIGN.md, section 4).
inline constexpr int kExitDone = 0;       ///< a walk was found; all hold
inline constexpr int kExitNone = 1;       ///< none was found; something differs
inline constexpr int kExitWrong = 2;      ///< the input or the use is wrong
inline constexpr int kExitStopped = 130;  ///< Ctrl-C, as shells count it

}  // namespace amble
