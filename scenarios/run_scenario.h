/// The run of a scenario: everything loaded, the walk planned, checked again as it will be
/// exported, measured.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "base/guard_limits.h"
#include "environments/collision/contact.h"
#include "planner/plan_walk.h"
#include "scenarios/report.h"

namespace amble {

class Planner;   // planner/legs/planner.h
struct Problem;  // problem.h

struct RunOptions {
  int threads = 1;                 ///< [1 to 64]; changes no result
  double frame_time = 1.0 / 60.0;  ///< of the animation [s, 1/240 to 1/24]
  double bvh_unit = 1.0;  ///< length of the BVH's unit: 1 for metres, 0.01 for centimetres [m]
  std::string names;      ///< of jointNamings(), that files name joints by; "": the library's own
  Checker checker = Checker::kFast;         ///< who is asked about contacts; changes no result
  size_t memory = GuardLimits{}.memory;     ///< that reading a mesh file may fill [bytes, > 0]
  std::filesystem::path roadmap = {};       ///< a kept one, to be asked first; "": none
  const std::atomic<bool>* stop = nullptr;  ///< Ctrl-C
  /// Called once, when all is read and before the search begins.
  std::function<void(const Problem&)> loaded;
  std::function<void(const SearchProgress&)> progress;  ///< called from the calling thread
};

struct RunResult {
  std::shared_ptr<const Problem> problem;  ///< none where loading it was stopped
  PlanOutcome outcome;
  Report report;
  std::vector<std::string>
      joint_names;  ///< as asked for, by joint; formats have rules of their own
  std::string bvh;  ///< the file's bytes, as they were checked; empty without a walk

  std::string bvhDigest() const;  ///< SHA-256 of `bvh`; empty without a walk
};

/// @throws InputError for bad input only; that there is no walk is a result, and so is that loading
/// was stopped, by `stop` or by the scenario's time limit.
/// @pre the scenario has no queries, or the first of them is meant
RunResult runScenario(const Scenario& scenario, const RunOptions& options = {});

/// The same of a problem that is read already, by a planner of its own scene, walker and settings
/// where there is one, which other runs may share: from nothing else.
/// @param inputs  file: SHA-256, for the report. Of the options those that loading needs are not
/// looked at. @throws InputError for a place where nobody can stand
RunResult runProblem(std::unique_ptr<const Problem> problem,
                     const std::map<std::string, std::string>& inputs, const Planner* planner,
                     const RunOptions& options);

/// Told of each query when it has been run; the result is the visitor's until it returns.
using QueryVisitor = std::function<void(const ScenarioQuery&, RunResult&)>;

/// The same for each of a scenario's queries, in order, on one roadmap: that of options.roadmap, or
/// one that is grown first until Planner::kFailures. What growing it took is in the first report.
/// Ends early, without a call for what was not run, where options.stop says so. @throws InputError
/// before any query is run
void runQueries(const Scenario& scenario, const RunOptions& options, const QueryVisitor& visit);

}  // namespace amble
