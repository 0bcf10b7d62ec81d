/// Regression: scenarios run and compared with what they expect of themselves.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scenarios/accepted_run.h"
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
  RunFigures run;
  std::string why;                      ///< without a walk: what stood in the way
  std::string picture;                  ///< of the run: the bytes of a PNG; empty without one
  std::optional<AcceptedRun> accepted;  ///< before this run
  std::string changes;                  ///< in what it is not the accepted one; "" in nothing
  bool updated = false;                 ///< it was accepted, and files were written
  double total_time = 0.0;              ///< of the scenario, with its loading [s]
};

struct CheckOptions {
  RunOptions run;
  int jobs = 1;  ///< scenarios that are run at once, each on run.threads; changes no row [1 to 64]
  /// Accept what is found: write the walk's SHA-256 into `expect` instead of comparing it, and the
  /// run's figures and picture beside the scenario. Of finished, counted runs only: what Ctrl-C or
  /// the time limit ended was found by chance, and changes no file.
  bool update = false;
  bool judge_times = false;  ///< max_planning_time is judged, not only reported
  /// Makes a run's picture (a PNG). Called from several threads.
  std::function<std::string(const RunResult&)> picture;
  /// Called before and after each scenario, one call at a time: `finished` in the order of the
  /// files.
  std::function<void(const ScenarioFile& file, int index, int count)> started;
  std::function<void(const CheckRow& row)> finished;
  /// Called from the scenario's thread.
  std::function<void(const ScenarioFile& file, const SearchProgress&)> progress;
};

/// Runs every one. Whatever is wrong with one makes its row an error and does not stop the others;
/// Ctrl-C (options.run.stop) does. A run that is other than the accepted one differs, by its time
/// alone not.
std::vector<CheckRow> checkScenarios(const std::vector<ScenarioFile>& files,
                                     const CheckOptions& options);

/// None differs, is in error or was stopped.
bool allHold(const std::vector<CheckRow>& rows);

/// What a result is not as expected, one text each.
std::vector<std::string> differences(const Expectation& expect, const RunResult& result,
                                     bool judge_times);

}  // namespace amble
