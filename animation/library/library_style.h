/// In whose manner to walk: the walks of one style among a library's.
///
/// What makes a person's gait theirs cancels where walks of several are averaged. Walks that have a
/// `style:` (a person's name, or `old-man`) are blended with those of that style only, and are no
/// part of a walk of which none is asked for.
#pragma once

#include <string>
#include <vector>

#include "animation/library/motion_library.h"

namespace amble {

/// Of the straight walks, in order of their names; "" is not among them.
std::vector<std::string> stylesOf(const MotionLibrary& library);

/// The library for somebody who walks so: of walks those of this style, "" being the ones without
/// any; of starts, of stops and of turns on the spot the style's own, or those without one;
/// all that is no walk's. Turns of the walk are the style's own, or none: a turn of somebody else's
/// would take the manner out of every curve.
MotionLibrary inStyle(MotionLibrary library, const std::string& style);

/// Mean speed of the straight walks as they were captured, for somebody of such a height (0: the
/// captured subject's), by Froude's law, within kSlowestWalk and kFastestWalk [m/s].
/// @pre there is one
double ownSpeed(const MotionLibrary& library, double height);
inline constexpr double kSlowestWalk = 0.3, kFastestWalk = 2.0;  ///< that may be asked for [m/s]

}  // namespace amble
