/// amble graph loop and play: motions out of a cluster graph.
#pragma once

#include "app/command.h"

namespace amble {

void addGraphLoop(CLI::App& graph, Command& chosen);
void addGraphPlay(CLI::App& graph, Command& chosen);

}  // namespace amble
