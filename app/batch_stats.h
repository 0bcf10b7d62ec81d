/// amble batch stats DIR: what the walks of a batch are like.
#pragma once

#include <CLI/CLI.hpp>

#include "app/command.h"

namespace amble {

void addBatchStats(CLI::App& batch, Command& chosen);

}  // namespace amble
