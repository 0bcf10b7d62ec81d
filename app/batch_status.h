/// amble batch status JOB.yaml -o DIR: how far it is, and how fast.
#pragma once

#include "app/command.h"

namespace amble {

void addBatchStatus(CLI::App& batch, Command& chosen);

}  // namespace amble
