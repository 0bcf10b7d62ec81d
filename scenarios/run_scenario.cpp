#include "scenarios/run_scenario.h"

#include "animation/captures/bvh.h"
#include "base/sha256.h"
#include "base/stopwatch.h"
#include "base/strict_yaml.h"
#include "base/version.h"
#include "planner/obstruction.h"
#include "scenarios/export_walk.h"
#include "scenarios/input_digests.h"
#include "scenarios/measure_walk.h"

namespace amble {
namespace {

void requireKnownPlanner(const Scenario& scenario) {
  std::vector<std::string> names;
  std::string list;
  for (const PlannerInfo& planner : listPlanners()) {
    if (planner.name == scenario.planner.name) return;
    names.push_back(planner.name);
    list += (list.empty() ? "" : ", ") + planner.name;
  }
  const std::string meant = nearestWord(scenario.planner.name, names);
  scenario.source.fail("planner.name", "there is no planner '" + scenario.planner.name + "'",
                       meant.empty() ? "one of " + list : "'" + meant + "'");
}

PlanRequest requestOf(const Problem& problem, const RunOptions& options) {
  const Scenario& scenario = problem.scenario;
  PlanRequest request;
  request.synthesizer = &problem.synthesizer;
  request.world = &problem.world;
  request.ground = &problem.ground;
  request.bounds = problem.bounds();
  request.start = {problem.stand(scenario.start, "start"), scenario.start.heading,
                   scenario.walk.from_standing};
  request.goal = {problem.stand(scenario.goal, "goal"), scenario.goal.heading,
                  scenario.walk.to_standing};
  for (size_t i = 0; i < scenario.via.size(); ++i) {
    request.via.push_back(problem.stand(scenario.via[i], "via[" + std::to_string(i) + "]"));
  }
  request.comfort = scenario.walk.comfort;
  request.planner = scenario.planner.name;
  request.limits.seed = scenario.planner.seed;
  request.limits.max_failures = scenario.planner.max_failures;
  request.limits.threads = options.threads;
  request.limits.stop = options.stop;
  request.limits.progress = options.progress;
  return request;
}

// What most often stood in the way, and of how many refusals it is.
std::string whyNot(const PlanOutcome& outcome) {
  if (!outcome.why) return outcome.stopped ? "it was stopped" : "nothing was tried";
  std::string text = describe(*outcome.why);
  long long all = 0;
  for (const auto& [rule, count] : outcome.refusals) all += count;
  if (all > 1 && !outcome.proved) {
    text += " (" + std::to_string(outcome.why->count) + " of " + std::to_string(all) + " refusals)";
  }
  return text;
}

// Reads all that the scenario names into result.problem; where that is stopped, says so instead.
void load(const Scenario& scenario, const RunOptions& options, RunResult& result) {
  const Stopwatch watch;
  const LoadLimits limits{options.memory, {options.stop, deadlineIn(scenario.planner.time_limit)}};
  Report& report = result.report;
  try {
    result.problem =
        std::make_unique<const Problem>(scenario, options.frame_time, limits, options.checker);
    report.inputs = inputDigests(*result.problem);
    report.times.loading = result.problem->times;
  } catch (const Stopped& stopped) {
    report.stopped_by = stopped.byTime() ? "time_limit" : "interrupt";
    report.why = stopped.what();
  }
  report.times.load = watch.seconds();
}

void reportSearch(const RunResult& result, Report& report) {
  const PlanOutcome& outcome = result.outcome;
  report.status = outcome.status;
  if (outcome.time_limit_hit) report.stopped_by = "time_limit";
  if (outcome.stopped) report.stopped_by = "interrupt";
  report.roadmap = {outcome.guards, outcome.connectors, outcome.edges, outcome.samples,
                    outcome.coverage};
  for (const auto& [rule, count] : outcome.refusals)
    report.refusals[std::string(walkRuleName(rule))] += count;
  report.poses_checked = outcome.poses_checked;
  report.times.roadmap = outcome.times.roadmap;
  report.times.search = outcome.times.search;
  report.times.refine = outcome.times.refine;
  if (outcome.status == PlanStatus::kSolved) return;
  report.why = whyNot(outcome);
  report.obstruction = outcome.why;
  report.proved = outcome.proved;
}

// The frames of the file are those of the planner to the file's last digit; they are checked as
// they stand there.
void exportAndCheck(const RunOptions& options, RunResult& result) {
  const Problem& problem = *result.problem;
  const AnimationBuffer& walk = result.outcome.walk.buffer;
  Report& report = result.report;
  ExportedWalk exported =
      exportWalk(problem.scenario.name, problem.synthesizer.skeleton(), walk, options.bvh_unit);
  const auto scratch = problem.world.makeScratch();
  report.poses_checked += walk.size();
  if (const auto contact = problem.world.check(exported.poses, walk.soles, false, *scratch)) {
    report.status = PlanStatus::kNoWalk;
    report.why = "contact: " + problem.body.parts.at(contact->part).name + " and " +
                 objectName(problem.scene.objects.at(contact->object)) +
                 ", once written with a BVH's digits";
    return;
  }
  result.bvh = std::move(exported.bvh);
  measureWalk(problem, result.outcome.walk, exported.poses, *scratch, report);
}

}  // namespace

std::string RunResult::bvhDigest() const { return bvh.empty() ? "" : sha256(bvh); }

RunResult runScenario(const Scenario& scenario, const RunOptions& options) {
  requireKnownPlanner(scenario);
  RunResult result;
  Report& report = result.report;
  report.scenario = scenario.name;
  report.seed = scenario.planner.seed;
  report.planner = scenario.planner.name;
  report.version = version();
  report.bvh_unit = options.bvh_unit;
  load(scenario, options, result);
  if (!result.problem) return result;
  PlanRequest request = requestOf(*result.problem, options);
  if (options.loaded) options.loaded(*result.problem);

  request.limits.deadline = deadlineIn(scenario.planner.time_limit);
  result.outcome = planWalk(request);
  reportSearch(result, report);
  report.stature = result.problem->synthesizer.stature();
  report.body = result.problem->body.parts;
  report.joint_names = bvhJointNames(result.problem->synthesizer.skeleton());
  if (report.status == PlanStatus::kSolved) exportAndCheck(options, result);
  return result;
}

}  // namespace amble
