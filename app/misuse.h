/// What is wrong with a command line, in one line for people.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace amble {

/// Names what was mistyped, command or option, and what is nearest to it.
/// @pre app has just thrown the error
std::string explainMisuse(const CLI::App& app, const CLI::ParseError& error);

/// An option that may be given several times, or takes a list with commas, takes one argument each
/// time: CLI11's own takes all that follow, the command's files with them.
void takeOneArgumentEach(CLI::App& app);

}  // namespace amble
