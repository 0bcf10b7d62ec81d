#include "scenarios/run_scenario.h"

#include "animation/body/joint_names.h"
#include "animation/captures/bvh.h"
#include "base/sha256.h"
#include "base/stopwatch.h"
#include "base/strict_yaml.h"
#include "base/version.h"
#include "planner/why/obstruction_text.h"
#include "scenarios/export_walk.h"
#include "scenarios/input_digests.h"
#include "scenarios/kept_roadmaps.h"
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

// What stood in the way, of which end if it is one.
std::string whyNot(const PlanOutcome& outcome) {
  if (!outcome.why) return outcome.stopped ? "it was stopped" : "nothing was tried";
  const std::string text = describe(*outcome.why);
  if (outcome.status == PlanStatus::kStartBlocked) return "the start is blocked: " + text;
  if (outcome.status == PlanStatus::kGoalBlocked) return "the goal is blocked: " + text;
  return text;
}

// Reads all that the scenario names; null where that is stopped, which the report says.
std::unique_ptr<Problem> load(const Scenario& scenario, const RunOptions& options, Report& report) {
  const Stopwatch watch;
  std::unique_ptr<Problem> problem;
  const LoadLimits limits{options.memory, {options.stop, deadlineIn(scenario.planner.time_limit)}};
  try {
    problem = std::make_unique<Problem>(scenario, options.frame_time, limits, options.checker);
    report.inputs = inputDigests(*problem, options.roadmap);
    report.times.loading = problem->times;
  } catch (const Stopped& stopped) {
    report.stopped_by = stopped.byTime() ? "time_limit" : "interrupt";
    report.why = stopped.what();
  }
  report.times.load = watch.seconds();
  return problem;
}

double areaOf(const ReachedRegion& region) {
  double length = 0.0;
  for (const ReachedRegion::Strip& strip : region.strips)
    length += strip.to.x() - strip.from.x() + region.breadth;
  return length * region.breadth;
}

void reportSearch(const RunResult& result, Report& report) {
  const PlanOutcome& outcome = result.outcome;
  report.status = outcome.status;
  if (outcome.time_limit_hit) report.stopped_by = "time_limit";
  if (outcome.stopped) report.stopped_by = "interrupt";
  report.roadmap = {outcome.guards,   outcome.connectors,
                    outcome.edges,    outcome.samples,
                    outcome.coverage, static_cast<int>(outcome.roadmap.refused.size())};
  for (const auto& [rule, count] : outcome.refusals)
    report.refusals[std::string(walkRuleName(rule))] += count;
  report.poses_checked = outcome.poses_checked;
  report.times.roadmap += outcome.times.roadmap;
  report.times.search = outcome.times.search;
  report.times.refine = outcome.times.refine;
  if (outcome.status == PlanStatus::kSolved) return;
  report.why = whyNot(outcome);
  report.obstruction = outcome.why;
  report.proved = outcome.proved;
  if (outcome.reached)
    report.reached = {areaOf(*outcome.reached), outcome.reached->near, outcome.reached->far};
}

// The frames of the file are those of the planner to the file's last digit; they are checked as
// they stand there.
void exportAndCheck(const RunOptions& options, RunResult& result) {
  const Problem& problem = *result.problem;
  const AnimationBuffer& walk = result.outcome.walk.buffer;
  Report& report = result.report;
  ExportedWalk exported =
      exportWalk(problem.scenario.name, renamed(problem.synthesizer.skeleton(), result.joint_names),
                 walk, options.bvh_unit);
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

// After the search: all that is told of it, and of its walk.
void finish(const RunOptions& options, RunResult& result) {
  Report& report = result.report;
  result.bvh.clear();
  reportSearch(result, report);
  report.stature = result.problem->synthesizer.stature();
  report.body = result.problem->body.parts;
  const WalkSynthesizer& walker = result.problem->synthesizer;
  result.joint_names = jointNames(walker.skeleton(), walker.roles(), options.names);
  report.joint_names = bvhJointNames(renamed(walker.skeleton(), result.joint_names));
  if (report.status == PlanStatus::kSolved) exportAndCheck(options, result);
}

PlanRequest requestOf(const Problem& problem, const RunOptions& options) {
  PlanRequest request = problem.request();
  request.limits.threads = options.threads;
  request.limits.stop = options.stop;
  request.limits.progress = options.progress;
  return request;
}

PlanRequest withEnds(PlanRequest request, const PlanQuery& query) {
  request.start = query.start;
  request.goal = query.goal;
  request.via = query.via;
  return request;
}

PlanOutcome planWith(const Planner& planner, const PlanQuery& query, const SearchLimits& limits) {
  PlanOutcome outcome = planner.plan(query, limits);
  if (outcome.roadmap.nodes.empty()) outcome.roadmap = planner.picture();
  return outcome;
}

Report reportFor(const Scenario& scenario, const RunOptions& options) {
  Report report;
  report.scenario = scenario.name;
  report.seed = scenario.planner.seed;
  report.planner = scenario.planner.name;
  report.version = version();
  report.bvh_unit = options.bvh_unit;
  return report;
}

// What all queries share: a roadmap from a file, or grown now. Before it every place is looked at,
// so that a wrong one is told before any work.
std::optional<Planner> plannerOfQueries(Problem& problem, const RunOptions& options,
                                        Report& common) {
  for (size_t i = 0; i < problem.scenario.queries.size(); ++i) {
    problem.ask(i);
    problem.query();
  }
  if (options.loaded) options.loaded(problem);
  PlanRequest request = requestOf(problem, options);
  if (!options.roadmap.empty()) return Planner(request, openRoadmap(options.roadmap, problem));
  const Stopwatch watch;
  SearchLimits& limits = request.limits;
  limits.deadline = deadlineIn(problem.scenario.planner.time_limit);
  limits.max_failures = Planner::kFailures;
  KeptRoadmap roadmap = Planner::grow(request);
  if (limits.timeIsUp()) common.stopped_by = "time_limit";
  limits = requestOf(problem, options).limits;
  common.times.roadmap = watch.seconds();
  return Planner(request, std::move(roadmap));
}

}  // namespace

std::string RunResult::bvhDigest() const { return bvh.empty() ? "" : sha256(bvh); }

RunResult runScenario(const Scenario& scenario, const RunOptions& options) {
  requireKnownPlanner(scenario);
  RunResult result;
  result.report = reportFor(scenario, options);
  result.problem = load(scenario, options, result.report);
  if (!result.problem) return result;
  const PlanQuery query = result.problem->query();
  PlanRequest request = requestOf(*result.problem, options);
  std::optional<Planner> planner;
  if (!options.roadmap.empty())
    planner.emplace(request, openRoadmap(options.roadmap, *result.problem));
  if (options.loaded) options.loaded(*result.problem);
  request.limits.deadline = deadlineIn(scenario.planner.time_limit);
  result.outcome = planner ? planWith(*planner, query, request.limits)
                           : planWalk(withEnds(std::move(request), query));
  finish(options, result);
  return result;
}

RunResult runProblem(std::unique_ptr<const Problem> problem,
                     const std::map<std::string, std::string>& inputs, const Planner* planner,
                     const RunOptions& options) {
  RunResult result;
  result.report = reportFor(problem->scenario, options);
  result.report.inputs = inputs;
  result.problem = std::move(problem);
  const Problem& asked = *result.problem;
  const PlanQuery query = asked.query();
  PlanRequest request = requestOf(asked, options);
  request.limits.deadline = deadlineIn(asked.scenario.planner.time_limit);
  result.outcome = planner ? planWith(*planner, query, request.limits)
                           : planWalk(withEnds(std::move(request), query));
  finish(options, result);
  return result;
}

void runQueries(const Scenario& scenario, const RunOptions& options, const QueryVisitor& visit) {
  requireKnownPlanner(scenario);
  RunResult result;
  Report common = reportFor(scenario, options);
  std::unique_ptr<Problem> loaded = load(scenario, options, common);
  Problem* const problem = loaded.get();
  result.problem = std::move(loaded);
  const auto planner = problem ? plannerOfQueries(*problem, options, common) : std::nullopt;
  for (size_t i = 0; i < scenario.queries.size(); ++i) {
    if (options.stop && options.stop->load()) return;
    result.report = common;
    result.report.scenario += "/" + scenario.queries[i].name;
    if (planner) {
      problem->ask(i);
      SearchLimits limits = planner->limits();
      limits.deadline = deadlineIn(scenario.planner.time_limit);
      result.outcome = planWith(*planner, problem->query(), limits);
      finish(options, result);
    }
    visit(scenario.queries[i], result);
    common.times.roadmap = 0.0;  // it was made once, for the first
  }
}

}  // namespace amble
