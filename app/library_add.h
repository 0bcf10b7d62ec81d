/// amble library add: a library from captures, or one with more of them.
#pragma once

#include <CLI/CLI.hpp>

#include "app/command.h"

namespace amble {

void addLibraryAdd(CLI::App& library, Command& chosen);

}  // namespace amble
