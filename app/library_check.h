/// amble library check: a library's motions against what is measured of them.
#pragma once

#include <CLI/CLI.hpp>

#include "app/command.h"

namespace amble {

void addLibraryCheck(CLI::App& library, Command& chosen);

}  // namespace amble
