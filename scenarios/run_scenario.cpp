#include "scenarios/run_scenario.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "base/error.h"
#include "base/rotation.h"
#include "base/sha256.h"
#include "base/version.h"
#include "scenarios/export_walk.h"
#include "scenarios/foot_measures.h"

namespace amble {
namespace {

using Clock = std::chrono::steady_clock;

// How far clearances are looked for: what is farther is nowhere near [m].
constexpr double kClearanceLimit = 2.0;

double secondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

void requireKnownPlanner(const Scenario& scenario) {
  std::vector<std::string> names;
  std::string list;
  for (const PlannerInfo& planner : listPlanners()) {
    if (planner.name == scenario.planner.name) return;
    names.push_back(planner.name);
    list += (list.empty() ? "" : ", ") + planner.name;
  }
  const std::string meant = nearestWord(scenario.planner.name, names);
  throw InputError(scenario.file.string(), scenario.planner.name_line,
                   "there is no planner '" + scenario.planner.name + "'",
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
  request.planner = scenario.planner.name;
  request.limits.seed = scenario.planner.seed;
  request.limits.max_failures = scenario.planner.max_failures;
  request.limits.threads = options.threads;
  request.limits.stop = options.stop;
  request.limits.progress = options.progress;
  return request;
}

// The rule, the body part, the object and the gap that most often stood in the way.
std::string whyNot(const PlanOutcome& outcome) {
  if (!outcome.why) return outcome.stopped ? "it was stopped" : "nothing was tried";
  const Obstruction& why = *outcome.why;
  std::string text = why.rule;
  if (!why.object.empty()) {
    char gap[64];
    std::snprintf(gap, sizeof gap, ", %.3f m apart", why.gap);
    text += ": " + why.part + " and " + why.object + (why.gap > 0.0 ? gap : "");
  }
  long long all = 0;
  for (const auto& [rule, count] : outcome.refusals) all += count;
  if (all > 1) {
    text += " (" + std::to_string(why.count) + " of " + std::to_string(all) + " refusals)";
  }
  return text;
}

std::map<std::string, std::string> digestInputs(const Problem& problem) {
  namespace fs = std::filesystem;
  const Scenario& scenario = problem.scenario;
  const fs::path folder =
      fs::absolute(fs::current_path() / scenario.file.parent_path()).lexically_normal();
  std::map<std::string, std::string> inputs;
  const auto add = [&](const fs::path& file) {
    const fs::path relative = fs::absolute(file).lexically_normal().lexically_relative(folder);
    inputs[relative.generic_string()] = sha256OfFile(file);
  };
  if (!scenario.sha256.empty()) inputs[scenario.file.filename().string()] = scenario.sha256;
  for (const fs::path& file : problem.scene.inputs) add(file);
  add(problem.library.file);
  add(problem.library.file.parent_path() / problem.library.skeleton_file);
  return inputs;
}

void reportSearch(const RunResult& result, Report& report) {
  const PlanOutcome& outcome = result.outcome;
  const Scenario& scenario = result.problem->scenario;
  report.status = outcome.status;
  report.scenario = scenario.name;
  report.seed = scenario.planner.seed;
  report.planner = scenario.planner.name;
  if (outcome.time_limit_hit) report.stopped_by = "time_limit";
  if (outcome.stopped) report.stopped_by = "interrupt";
  report.roadmap = {outcome.guards, outcome.connectors, outcome.edges, outcome.samples,
                    outcome.coverage};
  report.refusals = outcome.refusals;
  report.poses_checked = outcome.poses_checked;
  report.times.roadmap = outcome.times.roadmap;
  report.times.search = outcome.times.search;
  report.times.refine = outcome.times.refine;
  if (outcome.status != PlanStatus::kSolved) report.why = whyNot(outcome);
}

// The goal asks for a pose: that of standing there. Where the walk goes on it asks for a stance.
void reportGoalError(const Problem& problem, const Walk& walk, const PoseArray& poses,
                     Report& report) {
  const Scenario& scenario = problem.scenario;
  const Stance& last = walk.stances.back();
  const int frame = poses.size() - 1;
  Eigen::Vector2d position = last.position.head<2>();
  double error = scenario.goal.heading ? last.heading - *scenario.goal.heading : 0.0;
  AnimationBuffer asked;
  Stance goal = last;
  if (scenario.goal.heading) goal.heading = *scenario.goal.heading;
  if (scenario.walk.to_standing &&
      problem.synthesizer.stand(goal, asked).refused == WalkRule::kNone) {
    position = poses.p_WR(frame).head<2>();
    const Eigen::Matrix3d turn =
        (poses.rotations(frame)[0] * asked.poses.rotations(0)[0].conjugate()).toRotationMatrix();
    if (scenario.goal.heading) error = std::atan2(turn(1, 0) - turn(0, 1), turn(0, 0) + turn(1, 1));
  }
  report.goal_position_error = (position - scenario.goal.at).norm();
  report.goal_heading_error = std::abs(wrapAngle(error));
}

void reportClearance(const Problem& problem, const AnimationBuffer& walk, const PoseArray& poses,
                     CollisionScratch& scratch, Report& report) {
  const Clearance near = problem.world.clearance(poses, walk.states, kClearanceLimit, scratch);
  report.clearance.min = near.object < 0 ? kClearanceLimit : near.distance;
  if (near.object < 0) return;
  report.clearance.part = problem.body.parts.at(near.part).name;
  report.clearance.object = objectName(problem.scene.objects.at(near.object));
  report.clearance.time = near.frame * walk.frame_time;
}

void reportFeet(const Problem& problem, const AnimationBuffer& walk, const PoseArray& poses,
                Report& report) {
  const SoleTracks soles(problem.synthesizer.skeleton(), problem.body, poses, problem.ground);
  report.steps = measureSteps(walk, soles);
  double sum = 0.0;
  for (const StepReport& step : report.steps) {
    sum += step.slide;
    report.foot_skate_max = std::max(report.foot_skate_max, step.slide);
  }
  if (!report.steps.empty()) {
    report.foot_skate_mean = sum / static_cast<double>(report.steps.size());
  }
  report.ground_penetration = soles.penetration();
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
  if (const auto contact = problem.world.check(exported.poses, walk.states, false, *scratch)) {
    report.status = PlanStatus::kNoWalk;
    report.why = "contact: " + problem.body.parts.at(contact->part).name + " and " +
                 objectName(problem.scene.objects.at(contact->object)) +
                 ", once written with a BVH's digits";
    return;
  }
  result.bvh = std::move(exported.bvh);
  report.length = result.outcome.walk.path.length();
  report.frames = walk.size();
  report.frame_time = walk.frame_time;
  report.duration = (walk.size() - 1) * walk.frame_time;
  reportGoalError(problem, result.outcome.walk, exported.poses, report);
  reportClearance(problem, walk, exported.poses, *scratch, report);
  reportFeet(problem, walk, exported.poses, report);
  const Clip clip = {
      problem.scenario.name, problem.synthesizer.skeleton(), walk.frame_time, exported.poses, {}};
  const QualityAnchors anchors =
      anchorsOf(problem.library, problem.synthesizer.stature() / problem.library.stature,
                problem.synthesizer.settings().speed);
  report.quality = judgeWalk(clip, problem.synthesizer.roles(), walk, problem.ground, anchors);
}

}  // namespace

std::string RunResult::bvhDigest() const { return bvh.empty() ? "" : sha256(bvh); }

Clip walkClip(const RunResult& result) {
  const AnimationBuffer& walk = result.outcome.walk.buffer;
  return {result.problem->scenario.name,
          result.problem->synthesizer.skeleton(),
          walk.frame_time,
          walk.poses,
          {}};
}

RunResult runScenario(const Scenario& scenario, const RunOptions& options) {
  requireKnownPlanner(scenario);
  RunResult result;
  auto begin = Clock::now();
  result.problem = std::make_unique<const Problem>(scenario, options.frame_time);
  PlanRequest request = requestOf(*result.problem, options);
  result.report.times.load = secondsSince(begin);

  begin = Clock::now();
  request.limits.deadline = begin + std::chrono::duration_cast<Clock::duration>(
                                        std::chrono::duration<double>(scenario.planner.time_limit));
  result.outcome = planWalk(request);
  Report& report = result.report;
  reportSearch(result, report);
  report.version = version();
  report.bvh_unit = options.bvh_unit;
  report.stature = result.problem->synthesizer.stature();
  report.body = result.problem->body.parts;
  report.joint_names = bvhJointNames(result.problem->synthesizer.skeleton());
  report.inputs = digestInputs(*result.problem);
  if (report.status == PlanStatus::kSolved) exportAndCheck(options, result);
  return result;
}

}  // namespace amble
