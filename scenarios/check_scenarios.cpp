#include "scenarios/check_scenarios.h"

#include <algorithm>
#include <cstdio>
#include <new>

#include "base/error.h"
#include "base/output_file.h"
#include "base/stop_request.h"
#include "base/stopwatch.h"
#include "scenarios/find_scenarios.h"
#include "scenarios/update_expectation.h"

namespace amble {
namespace {

std::string decimals(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string over(const char* what, double value, double bar, const char* unit) {
  return std::string(what) + " is " + decimals(value) + " " + unit + "; expected at most " +
         decimals(bar);
}

CheckRow rowOf(const ScenarioFile& file) {
  CheckRow row;
  row.file = file.file;
  row.scenario = file.file == "-" ? "scenario" : file.file.stem().string();
  return row;
}

// Writes the digest into the file, unless its author changed it while it ran.
void updateDigest(const ScenarioFile& file, const std::string& digest) {
  const std::string name = file.file.string();
  if (file.file == "-") throw InputError(name, 0, "cannot be updated", "a file");
  if (readScenarioFile(file.file).text != file.text) {
    throw InputError(name, 0, "was changed while it ran", "a file that is left alone");
  }
  const std::string text = withDigest(file.text, name, digest);
  writeFile(file.file, [&](std::ostream& out) { out << text; });
}

// The digest of a finished, counted run becomes what is expected, in the file and here.
void update(const ScenarioFile& file, const RunResult& result, Expectation& expect, CheckRow& row) {
  const Report& report = result.report;
  if (!report.stopped_by.empty()) {
    row.notes.push_back("ended by " + report.stopped_by + ", so nothing was updated; expected a " +
                        "run that finishes");
    return;
  }
  if (report.status != PlanStatus::kSolved) return;
  const std::string digest = result.bvhDigest();
  if (expect.bvh_sha256 != digest) {
    updateDigest(file, digest);
    row.updated = true;
  }
  expect.bvh_sha256 = digest;
}

// What a run was like, against what is expected of it.
CheckRow judge(const ScenarioFile& file, Expectation expect, const RunResult& result,
               const CheckOptions& options) {
  CheckRow row = rowOf(file);
  const Report& report = result.report;
  if (report.stopped_by == "interrupt") {
    row.verdict = CheckVerdict::kStopped;
    return row;
  }
  row.status = statusName(report.status);
  row.length = report.length;
  row.clearance = report.clearance.min;
  row.foot_skate = report.foot_skate_max;
  row.planning_time = report.times.planning();
  if (options.update) update(file, result, expect, row);
  for (const std::string& note : differences(expect, result, options.judge_times)) {
    row.notes.push_back(note);
  }
  if (!row.notes.empty()) row.verdict = CheckVerdict::kDiffers;
  return row;
}

// A row; one for each query, where there are queries.
std::vector<CheckRow> runOne(const ScenarioFile& file, const CheckOptions& options) {
  const Scenario scenario = readScenario(file);
  if (const std::string missing = missingData(scenario); !missing.empty()) {
    CheckRow row = rowOf(file);
    row.verdict = CheckVerdict::kSkipped;
    row.notes.push_back("'" + missing + "' is not there");
    return {row};
  }
  const Expectation expect = scenario.expect.value_or(Expectation{});
  if (scenario.queries.empty())
    return {judge(file, expect, runScenario(scenario, options.run), options)};
  CheckOptions as_they_are = options;
  as_they_are.update = false;  // a scenario has one digest, and its queries many walks
  std::vector<CheckRow> rows;
  runQueries(scenario, options.run, [&](const ScenarioQuery& query, const RunResult& result) {
    rows.push_back(judge(file, expect, result, as_they_are));
    rows.back().scenario += "/" + query.name;
  });
  return rows;
}

// One that fails is one row: the others have nothing to do with it.
std::vector<CheckRow> runGuardedFromFaults(const ScenarioFile& file, const CheckOptions& options) {
  CheckRow row = rowOf(file);
  row.verdict = CheckVerdict::kError;
  const std::string name = file.file.string();
  try {
    return runOne(file, options);
  } catch (const InputError& error) {
    row.notes = {error.what()};
  } catch (const std::bad_alloc&) {
    row.notes = {InputError(name, 0, "out of memory", "a smaller scene").what()};
  } catch (const std::exception& error) {
    row.notes = {InputError(name, 0, error.what()).what()};
  }
  return {row};
}

}  // namespace

std::string verdictName(CheckVerdict verdict) {
  switch (verdict) {
    case CheckVerdict::kHolds:
      return "ok";
    case CheckVerdict::kDiffers:
      return "differs";
    case CheckVerdict::kSkipped:
      return "skipped";
    case CheckVerdict::kStopped:
      return "stopped";
    case CheckVerdict::kError:
      return "error";
  }
  return "";
}

std::vector<std::string> differences(const Expectation& expect, const RunResult& result,
                                     bool judge_times) {
  const Report& report = result.report;
  std::vector<std::string> notes;
  if (expect.status && *expect.status != report.status) {
    notes.push_back("status is " + statusName(report.status) + "; expected " +
                    statusName(*expect.status) +
                    (report.why.empty() ? "" : " (" + report.why + ")"));
  }
  if (judge_times && expect.max_planning_time &&
      report.times.planning() > *expect.max_planning_time) {
    notes.push_back(over("planning time", report.times.planning(), *expect.max_planning_time, "s"));
  }
  if (report.status != PlanStatus::kSolved) {
    if (expect.bvh_sha256 && !expect.status) notes.push_back("there is no walk; expected one");
    return notes;
  }
  if (expect.max_length && report.length > *expect.max_length) {
    notes.push_back(over("length", report.length, *expect.max_length, "m"));
  }
  if (expect.min_clearance && report.clearance.min < *expect.min_clearance) {
    notes.push_back("clearance is " + decimals(report.clearance.min) + " m; expected at least " +
                    decimals(*expect.min_clearance));
  }
  if (expect.max_foot_skate && report.foot_skate_max > *expect.max_foot_skate) {
    notes.push_back(over("foot skate", report.foot_skate_max, *expect.max_foot_skate, "m"));
  }
  if (expect.bvh_sha256 && *expect.bvh_sha256 != result.bvhDigest()) {
    notes.push_back("SHA-256 of walk.bvh is " + result.bvhDigest() + "; expected " +
                    *expect.bvh_sha256);
  }
  return notes;
}

std::vector<CheckRow> checkScenarios(const std::vector<ScenarioFile>& files,
                                     const CheckOptions& options) {
  std::vector<CheckRow> rows;
  for (size_t i = 0; i < files.size(); ++i) {
    if (options.run.stop != nullptr && options.run.stop->load()) break;
    if (options.started) {
      options.started(files[i], static_cast<int>(i), static_cast<int>(files.size()));
    }
    const Stopwatch watch;
    for (CheckRow& row : runGuardedFromFaults(files[i], options)) {
      row.total_time = watch.seconds();
      if (options.finished) options.finished(row);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

bool allHold(const std::vector<CheckRow>& rows) {
  return std::all_of(rows.begin(), rows.end(), [](const CheckRow& row) {
    return row.verdict == CheckVerdict::kHolds || row.verdict == CheckVerdict::kSkipped;
  });
}

}  // namespace amble
