/// amble library add: a library from captures, or one with more of them.
#pragma once

#include <CLI/CLI.hpp>

#include "animation/library/motion_library.h"
#include "app/command.h"

namespace amble {

void addLibraryAdd(CLI::App& library, Command& chosen);

/// What `library add` and `build` say of what they wrote: how many motions, and why nobody walks
/// with it where nobody does.
void sayWritten(const MotionLibrary& library, const std::filesystem::path& file);

}  // namespace amble
