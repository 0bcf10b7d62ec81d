/// Regression: scenarios run and compared with what they expect of themselves.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scenarios/run_scenario.h"

namespace amble {

enum class CheckVerdict {
  kHolds,
  kDiffers,  ///< something is not as expected
  kSkipped,  ///< its data is not here
  kStopped,  ///< Ctrl-C ended it: nothing is known of it
  kError,    ///< its files are wrong, or it failed
};
std::string verdictName(CheckVerdict verdict);  ///< "ok", "differs", "skipped", "stopped", "error"

/// One scenario's line of the table, or that of one of its queries: "rooms/kitchen".
struct CheckRow {
  std::filesystem::path file;
  std::string scenario;
  CheckVerdict verdict = CheckVerdict::kHolds;
  /// What differs, why it was skipped, or the error: one text each.
  std::vector<std::string> notes;
  std::string status;          ///< "solved", ...; empty where it was not run
  double length = 0.0;         ///< [m]; this and the next two with a walk only
  double clearance = 0.0;      ///< [m]
  double foot_skate = 0.0;     ///< largest [m]
  double planning_time = 0.0;  ///< roadmap, search and refinement [s]
  double total_time = 0.0;     ///< [s]
  bool updated = false;        ///< its file was given a new bvh_sha256
};

struct CheckOptions {
  RunOptions run;
  /// Write the walk's SHA-256 into `expect` instead of comparing it: of finished, counted runs
  /// only. What Ctrl-C or the time limit ended was found by chance, and changes no file.
  bool update = false;
  bool judge_times = false;  ///< max_planning_time is judged, not only reported
  /// Called before and after each scenario.
  std::function<void(const ScenarioFile& file, int index, int count)> started;
  std::function<void(const CheckRow& row)> finished;
};

/// Runs every one. Whatever is wrong with one makes its row an error and does not stop the others;
/// Ctrl-C (options.run.stop) does.
std::vector<CheckRow> checkScenarios(const std::vector<ScenarioFile>& files,
                                     const CheckOptions& options);

/// None differs, is in error or was stopped.
bool allHold(const std::vector<CheckRow>& rows);

/// What a result is not as expected, one text each.
std::vector<std::string> differences(const Expectation& expect, const RunResult& result,
                                     bool judge_times);

}  // namespace amble
