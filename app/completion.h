/// What shells complete after `amble`: commands, options, their values, files.
#pragma once

#include <ostream>

#include "app/command_words.h"

namespace amble {

/// Scripts of their own: nothing is asked of the program while somebody types.
void writeBashCompletion(std::ostream& out, const CommandWords& program);
void writeZshCompletion(std::ostream& out, const CommandWords& program);
void writeFishCompletion(std::ostream& out, const CommandWords& program);

}  // namespace amble
