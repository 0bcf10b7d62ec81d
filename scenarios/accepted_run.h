/// The last run of a scenario that somebody accepted: what `amble check` compares with, beside what
/// the scenario expects of itself. `expect` says what a walk must hold, this how it was.
///
/// accepted/NAME.json beside the scenario, and its picture accepted/NAME.png; of a scenario with
/// queries accepted/NAME/QUERY.json for each. Small, and meant to lie under version control.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "scenarios/run_scenario.h"

namespace amble {

/// What is compared of a run. Without a walk there are status and planning time only.
struct RunFigures {
  std::string status;          ///< "solved", ...; empty where it was not run
  double length = 0.0;         ///< [m, >= 0]
  double duration = 0.0;       ///< [s, >= 0]
  double clearance = 0.0;      ///< [m, >= 0]
  double foot_skate = 0.0;     ///< largest [m, >= 0]
  double planning_time = 0.0;  ///< roadmap, search and refinement [s, >= 0]
  std::string bvh_sha256;      ///< empty without a walk

  bool hasWalk() const { return !bvh_sha256.empty(); }
};
RunFigures figuresOf(const RunResult& result);

/// How a figure is shown.
struct RunFigure {
  const char* name;
  double RunFigures::*value;
  const char* unit;  ///< that it is shown in
  double scale;      ///< units in a metre or second [> 0]
  int decimals;      ///< that are shown [>= 0]
  bool of_walk;      ///< else of the run: by the clock, and never judged

  std::string text(const RunFigures& figures) const;  ///< "6.32", without its unit
  /// "+0.22 m", of times by the clock "+12 %"; "" where what is shown is the same.
  std::string change(const RunFigures& before, const RunFigures& now) const;
};
inline constexpr std::array<RunFigure, 5> kFigures = {
    {{"length", &RunFigures::length, "m", 1.0, 2, true},
     {"duration", &RunFigures::duration, "s", 1.0, 2, true},
     {"clearance", &RunFigures::clearance, "m", 1.0, 3, true},
     {"foot skate", &RunFigures::foot_skate, "mm", 1000.0, 1, true},
     {"planning", &RunFigures::planning_time, "s", 1.0, 2, false}}};

struct AcceptedRun {
  RunFigures figures;
  std::string picture;  ///< the bytes of a PNG; empty where there is none
};

/// Where it lies. @param query  ""  of a scenario without queries
std::filesystem::path acceptedFile(const std::filesystem::path& scenario, const std::string& query);

/// None where there is no such file. @throws InputError with file and line for one that is none
std::optional<AcceptedRun> readAccepted(const std::filesystem::path& file);
/// Makes its folder if need be. @throws InputError where it cannot be written
void writeAccepted(const std::filesystem::path& file, const AcceptedRun& run);

/// In what a run is other than the accepted one, whatever its time: one line, "" where in nothing.
std::string changesSince(const RunFigures& accepted, const RunFigures& now);

}  // namespace amble
