/// Frames of a clip as they are named on the command line.
#pragma once

#include <string>
#include <utility>

#include "animation/body/clip.h"

namespace amble {

/// First and last frame of "A:B", `between` being the colon: frames as 10:200, or seconds as
/// 0.5s:2s, as the nearest frame; either may be left out, and is the clip's first or last.
/// @param option  for messages: "amble convert: --trim"
/// @throws InputError where the text is none, the clip has no such frames, or they are not in order
std::pair<int, int> readFrameRange(const std::string& option, const std::string& text, char between,
                                   const Clip& clip);

/// What that reads, for help and messages.
std::string frameRangeForm(char between);

}  // namespace amble
