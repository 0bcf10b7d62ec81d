/// The manual page amble.1, in the macros of man(7).
#pragma once

#include <ostream>

#include "app/command_words.h"

namespace amble {

/// The same program gives the same bytes: the page has a version, and no date.
void writeManPage(std::ostream& out, const CommandWords& program);

}  // namespace amble
