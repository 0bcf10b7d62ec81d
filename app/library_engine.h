/// amble library engine build|show.
#pragma once

#include <CLI/CLI.hpp>

#include "app/command.h"

namespace amble {

void addLibraryEngine(CLI::App& library, Command& chosen);

}  // namespace amble
