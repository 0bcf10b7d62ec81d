/// amble batch merge JOB.yaml -o DIR: one table of what the shards made.
#pragma once

#include <CLI/CLI.hpp>

#include "app/command.h"

namespace amble {

void addBatchMerge(CLI::App& batch, Command& chosen);

}  // namespace amble
