/// A captured walk edited, within what captured walks can be edited to.
#pragma once

#include <string>

#include "animation/editing/edit_walk.h"

namespace amble {

/// @param file  that the walk is from. @throws InputError for a motion that is no walk, and for
/// what is beyond EditLimits: it names the option of `amble edit`
EditedWalk editCapture(const CapturedWalk& walk, const EditRequest& request,
                       const std::string& file);

}  // namespace amble
