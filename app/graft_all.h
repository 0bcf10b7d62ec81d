/// amble graft all DIR: every pair of a folder's clips that the rules permit.
#pragma once

#include <string>
#include <vector>

#include "app/command.h"

namespace amble {

void addGraftAll(CLI::App& graft, Command& chosen);
/// --chains. @param chains  is set to it
void addChainsOption(CLI::App& command, std::vector<std::string>& chains);

}  // namespace amble
