/// What the commands share: one file a command, each of which adds itself to the program.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/exit_status.h"
#include "base/ramp.h"

namespace amble {

/// The command that was chosen, to be run when the command line has been read.
using Command = std::function<int()>;

void addPlan(CLI::App& app, Command& chosen);
void addCheck(CLI::App& app, Command& chosen);
void addValidate(CLI::App& app, Command& chosen);
void addAnimate(CLI::App& app, Command& chosen);
void addAnalyse(CLI::App& app, Command& chosen);
void addLibrary(CLI::App& app, Command& chosen);
void addEdit(CLI::App& app, Command& chosen);
void addConvert(CLI::App& app, Command& chosen);
void addGraft(CLI::App& app, Command& chosen);
void addInspect(CLI::App& app, Command& chosen);
void addRoadmap(CLI::App& app, Command& chosen);
void addGraph(CLI::App& app, Command& chosen);
void addView(CLI::App& app, Command& chosen);
void addBatch(CLI::App& app, Command& chosen);
void addHelp(CLI::App& app, Command& chosen);        ///< after those that it helps with
void addCompletion(CLI::App& app, Command& chosen);  ///< after those that it completes

/// Accepts a finite decimal number within a range, ends included; CLI11's own lets `nan` through.
CLI::Validator number(double min, double max, const std::string& unit = "");
/// Accepts a Ramp as text whose ends are within a range.
CLI::Validator ramp(double min, double max, const std::string& unit);
Ramp readRamp(const std::string& text);  ///< @pre ramp() has accepted it
/// Accepts what ramp() does, and factors with an `x` behind each number.
CLI::Validator amount(double min, double max, const std::string& unit);
/// The numbers, and whether they are factors. @pre amount() has accepted it
std::pair<Ramp, bool> readAmount(const std::string& text);
/// Accepts two numbers with a comma between them, each within its range.
CLI::Validator twoNumbers(const Ramp& first, const Ramp& second, const std::string& unit);
std::pair<double, double> readTwoNumbers(const std::string& text);  ///< @pre accepted
/// Accepts one of the names, and tells of another which is nearest to it.
CLI::Validator choice(const std::vector<std::string>& names);
/// Shows how the command is used, behind its options.
void addExamples(CLI::App& command, const std::vector<std::string>& lines);
/// Says behind them what the command ends with. @param none  when it is kExitNone; "" for never
void addExitStatus(CLI::App& command, const std::string& done, const std::string& none = "");
/// `--threads N`. @param threads  is set to it; before, to as many as the machine runs
void addThreadsOption(CLI::App& command, int& threads,
                      const std::string& what = "Threads; changes no result");
/// The command, on no more threads than these.
Command onThreads(int threads, const Command& command);
/// `--memory MB`, for commands that read meshes or captures. @param bytes  is set to it
void addMemoryOption(CLI::App& command, size_t& bytes);
/// Accepts a whole number within a range, ends included.
CLI::Validator wholeNumber(long min, long max);

}  // namespace amble
