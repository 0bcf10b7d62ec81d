/// A motion library made from a recipe: what `amble library build` does.
#pragma once

#include <filesystem>

#include "animation/library/motion_library.h"
#include "base/stop_request.h"

namespace amble {

/// Reads a recipe and its captures, and prepares every motion. `captures` is the folder that clip
/// paths are relative to; where it is empty, the recipe's own `captures:`.
/// @param stop  looked at between motions. @throws InputError; Stopped
MotionLibrary buildMotionLibrary(const std::filesystem::path& recipe,
                                 const std::filesystem::path& captures = {},
                                 const StopRequest& stop = {});

}  // namespace amble
