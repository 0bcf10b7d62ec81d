/// Regression: scenarios run and compared with what they expect of themselves.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "scenarios/run_scenario.h"

namespace amble {

enum class CheckVerdict {
  kHolds,
  kDiffers,  ///< something is not as expected
  kSkipped,  ///< its data is not here
  kError,    ///< its files are wrong
};
std::string verdictName(CheckVerdict verdict);  ///< "ok", "differs", "skipped", "error"

/// One scenario's line of the table.
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
  bool update = false;       ///< write the walk's SHA-256 into `expect` instead of comparing it
  bool judge_times = false;  ///< max_planning_time is judged, not only reported
  /// Called before and after each scenario.
  std::function<void(const std::filesystem::path& file, int index, int count)> started;
  std::function<void(const CheckRow& row)> finished;
};

/// Scenarios at the paths: files as they are, folders with all below them, by name.
/// @throws InputError for a path that is not there, a file that is no scenario, or where nothing is
/// found.
std::vector<std::filesystem::path> findScenarios(const std::vector<std::filesystem::path>& paths);

/// Runs every one. Bad input of one makes its row an error and does not stop the others; Ctrl-C
/// (options.run.stop) does.
/// @throws InputError as findScenarios
std::vector<CheckRow> checkScenarios(const std::vector<std::filesystem::path>& paths,
                                     const CheckOptions& options);

/// Neither differs nor error.
bool allHold(const std::vector<CheckRow>& rows);

/// What a result is not as expected, one text each.
std::vector<std::string> differences(const Expectation& expect, const RunResult& result,
                                     bool judge_times);

/// What a scenario needs that lies outside of Amble's own folders and is not there (a mesh of the
/// shared captures' folder), or an empty text.
std::string missingData(const Scenario& scenario);

/// The text of a scenario with `expect: bvh_sha256:` set, and nothing else changed. @throws
/// InputError where that cannot be done
std::string withDigest(const std::string& text, const std::string& file, const std::string& digest);

/// JUnit's XML, as continuous integration reads it.
void writeJUnit(std::ostream& out, const std::vector<CheckRow>& rows);

}  // namespace amble
