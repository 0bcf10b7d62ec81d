#include "scenarios/check_scenarios.h"

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <new>

#include "base/error.h"
#include "base/output_file.h"
#include "base/parallel.h"
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
  row.scenario = scenarioName(file.file);
  return row;
}

// Writes the digest into the file, unless its author changed it while it ran.
void updateDigest(const ScenarioFile& file, const std::string& digest) {
  const std::string name = file.file.string();
  if (readScenarioFile(file.file).text != file.text) {
    throw InputError(name, 0, "was changed while it ran", "a file that is left alone");
  }
  const std::string text = withDigest(file.text, name, digest);
  writeFile(file.file, [&](std::ostream& out) { out << text; });
}

// A finished, counted run becomes what is expected, in the files and here.
void update(const ScenarioFile& file, const std::string& query, const RunResult& result,
            Expectation& expect, CheckRow& row) {
  if (!result.report.stopped_by.empty()) {
    row.notes.push_back("ended by " + result.report.stopped_by + ", so nothing was updated; " +
                        "expected a run that finishes");
    return;
  }
  if (file.file == "-") throw InputError("-", 0, "cannot be updated", "a file");
  const std::string& digest = row.run.bvh_sha256;
  // A scenario has one digest, and its queries many walks.
  if (row.run.hasWalk() && query.empty() && expect.bvh_sha256 != digest) {
    updateDigest(file, digest);
    row.updated = true;
  }
  if (row.run.hasWalk() && query.empty()) expect.bvh_sha256 = digest;
  if (row.accepted && row.changes.empty() && row.accepted->picture.empty() == row.picture.empty())
    return;
  writeAccepted(acceptedFile(file.file, query), {row.run, row.picture});
  row.updated = true;
}

// What was accepted; a file that is none is in the way of a comparison, and not of an update.
std::optional<AcceptedRun> acceptedOf(const ScenarioFile& file, const std::string& query,
                                      bool update) {
  if (file.file == "-") return std::nullopt;
  try {
    return readAccepted(acceptedFile(file.file, query));
  } catch (const InputError&) {
    if (!update) throw;
  }
  return std::nullopt;
}

// What a run was like, against what is expected of it and what was accepted.
CheckRow judge(const ScenarioFile& file, const std::string& query, Expectation expect,
               const RunResult& result, const CheckOptions& options) {
  CheckRow row = rowOf(file);
  if (!query.empty()) row.scenario += "/" + query;
  if (result.report.stopped_by == "interrupt") {
    row.verdict = CheckVerdict::kStopped;
    return row;
  }
  row.run = figuresOf(result);
  row.why = result.report.why;
  if (options.picture) row.picture = options.picture(result);
  row.accepted = acceptedOf(file, query, options.update);
  if (row.accepted) row.changes = changesSince(row.accepted->figures, row.run);
  if (options.update) update(file, query, result, expect, row);
  if (!row.changes.empty()) expect.bvh_sha256.reset();  // they tell more than that it is another
  for (const std::string& note : differences(expect, result, options.judge_times)) {
    row.notes.push_back(note);
  }
  const bool accepted = row.changes.empty() || row.updated;
  if (!row.notes.empty() || !accepted) row.verdict = CheckVerdict::kDiffers;
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
  RunOptions how = options.run;
  if (options.progress)
    how.progress = [&](const SearchProgress& at) { options.progress(file, at); };
  if (scenario.queries.empty())
    return {judge(file, "", expect, runScenario(scenario, how), options)};
  std::vector<CheckRow> rows;
  runQueries(scenario, how, [&](const ScenarioQuery& query, const RunResult& result) {
    rows.push_back(judge(file, query.name, expect, result, options));
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

// Rows of scenarios that end in any order, told in that of the files.
class InOrder {
 public:
  InOrder(const std::vector<ScenarioFile>& files, const CheckOptions& options)
      : files_(files), options_(options), rows_(files.size()) {}

  // @return whether it shall be run
  bool begin(int i) {
    const std::lock_guard lock(mutex_);
    if (options_.run.stop != nullptr && options_.run.stop->load()) return false;
    if (options_.started) options_.started(files_[i], i, static_cast<int>(files_.size()));
    return true;
  }
  void end(int i, std::vector<CheckRow> rows) {
    const std::lock_guard lock(mutex_);
    rows_[i] = std::move(rows);
    for (; told_ < rows_.size() && rows_[told_]; ++told_) {
      for (CheckRow& row : *rows_[told_]) {
        if (options_.finished) options_.finished(row);
        all_.push_back(std::move(row));
      }
    }
  }
  std::vector<CheckRow> take() { return std::move(all_); }

 private:
  const std::vector<ScenarioFile>& files_;
  const CheckOptions& options_;
  std::mutex mutex_;
  std::vector<std::optional<std::vector<CheckRow>>> rows_;  // of those that have ended
  size_t told_ = 0;                                         // files whose rows were told
  std::vector<CheckRow> all_;
};

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
  InOrder order(files, options);
  // They are begun in order, so those that Ctrl-C leaves out are the last.
  parallelFor(static_cast<int>(files.size()), options.jobs, [&](int i, int) {
    if (!order.begin(i)) return;
    const Stopwatch watch;
    std::vector<CheckRow> rows = runGuardedFromFaults(files[i], options);
    for (CheckRow& row : rows) row.total_time = watch.seconds();
    order.end(i, std::move(rows));
  });
  return order.take();
}

bool allHold(const std::vector<CheckRow>& rows) {
  return std::all_of(rows.begin(), rows.end(), [](const CheckRow& row) {
    return row.verdict == CheckVerdict::kHolds || row.verdict == CheckVerdict::kSkipped;
  });
}

}  // namespace amble
