/// Captures made small enough for a page that opens quickly.
#pragma once

#include <string>
#include <vector>

#include "viz/page/clip_page.h"

namespace amble {

/// Numbers of a page's poses and curves together beyond which frames are left out [bytes].
inline constexpr size_t kMostOfPoses = size_t{12} << 20;
/// No clip is thinned below so many frames a second.
inline constexpr double kFewestFrames = 24.0;

/// Leaves every second, third, ... frame of the fastest clips out until they fit in `most`, and
/// then says of which, for people. Plants, events and curves of the feet stay
/// whole.
std::vector<std::string> thinClips(std::vector<ShownClip>& clips, size_t most = kMostOfPoses);

/// Whether their poses are small enough to be written with all their digits.
bool fitExactly(const std::vector<ShownClip>& clips);

}  // namespace amble
