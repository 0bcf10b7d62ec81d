/// What the commands share: one file a command, each of which adds itself to the program.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace amble {

/// Exit status, as grep's (DESIGN.md, section 4).
inline constexpr int kExitDone = 0;       ///< a walk was found; all hold
inline constexpr int kExitNone = 1;       ///< none was found; something differs
inline constexpr int kExitWrong = 2;      ///< the input or the use is wrong
inline constexpr int kExitStopped = 130;  ///< Ctrl-C, as shells count it

/// The command that was chosen, to be run when the command line has been read.
using Command = std::function<int()>;

void addPlan(CLI::App& app, Command& chosen);
void addCheck(CLI::App& app, Command& chosen);
void addValidate(CLI::App& app, Command& chosen);
void addAnimate(CLI::App& app, Command& chosen);
void addAnalyse(CLI::App& app, Command& chosen);
void addLibrary(CLI::App& app, Command& chosen);
void addInspect(CLI::App& app, Command& chosen);

/// Accepts a finite decimal number within a range, ends included; CLI11's own lets `nan` through.
CLI::Validator number(double min, double max, const std::string& unit = "");
/// Accepts a whole number within a range, ends included.
CLI::Validator wholeNumber(long min, long max);

}  // namespace amble
