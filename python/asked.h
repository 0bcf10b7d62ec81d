/// What a call of Python asks for beside the scenario.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>

#include "scenarios/run_scenario.h"

namespace amble {

struct Asked {
  std::optional<std::string> planner;  ///< this and the next two in place of the scenario's
  std::optional<int> seed;
  std::optional<double> time_limit;  ///< [s, > 0]
  double fps = 60.0;                 ///< [1/s, 24 to 240]
  std::string names;                 ///< of joints (RunOptions::names)
  std::string command;               ///< that repeats the run
  std::filesystem::path roadmap;
  int threads = 1;
};

/// @param text  of the scenario, for one that is in no file; it is called `file` then
/// @throws InputError
Scenario scenarioOf(const std::filesystem::path& file, const std::optional<std::string>& text,
                    const Asked& asked);
RunOptions optionsOf(const Asked& asked, const std::atomic<bool>& stop);

}  // namespace amble
