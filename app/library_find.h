/// amble library find: clips and motions by what kind of motion they hold.
#pragma once

#include <CLI/CLI.hpp>

#include "app/command.h"

namespace amble {

void addLibraryFind(CLI::App& library, Command& chosen);

}  // namespace amble
