/// amble batch check JOB.yaml -o DIR: a sample of the walks, validated as anybody's.
#pragma once

#include "app/command.h"

namespace amble {

void addBatchCheck(CLI::App& batch, Command& chosen);

}  // namespace amble
