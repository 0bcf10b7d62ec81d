/// Names and paths as a shell reads them.
#pragma once

#include <string>
#include <string_view>

namespace amble {

/// As a word of a POSIX shell's command: within '...' where it holds anything that a shell reads.
std::string shellWord(std::string_view text);

}  // namespace amble
