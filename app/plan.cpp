// amble plan SCENARIO.yaml: one walk, with its report and pictures.

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <utility>

#include "app/command.h"
#include "app/motion_output.h"
#include "app/output_folder.h"
#include "app/progress.h"
#include "app/result_formats.h"
#include "app/say.h"
#include "app/shell_word.h"
#include "app/stop.h"
#include "app/unit_text.h"
#include "app/write_formats.h"
#include "base/error.h"
#include "base/keep_inputs.h"
#include "base/text.h"
#include "environments/ground/ground_warnings.h"
#include "scenarios/problem.h"
#include "scenarios/run_scenario.h"
#include "scenarios/write_results.h"

namespace amble {
namespace {

struct PlanArguments {
  std::string scenario, out, planner, roadmap;
  int seed = -1;  // -1: the scenario's
  int threads = 1;
  double time_limit = 0.0;  // [s]; 0: the scenario's
  double fps = 60.0;
  size_t memory = GuardLimits{}.memory;  // [bytes]
  std::string names, bvh_units = "m", checker = "fast";
  std::vector<std::string> formats = usualFormats();
  std::vector<std::string> views;  // empty: all, where the format is asked for
  std::string film = "corner";
  bool no_scene = false;
  bool formats_given = false, json = false, list_planners = false;
};

Scenario readAsked(const PlanArguments& options) {
  Scenario scenario = readScenario(options.scenario);
  if (!options.planner.empty()) {
    scenario.planner.name = options.planner;
    scenario.source.lines.erase("planner.name");
  }
  if (options.seed >= 0) scenario.planner.seed = static_cast<std::uint64_t>(options.seed);
  if (options.time_limit > 0.0) scenario.planner.time_limit = options.time_limit;
  return scenario;
}

// Into a folder of the scenario's name below out/, unless one is named, queries below it. That they
// can be made is seen before the planning, not after it.
std::filesystem::path chooseFolder(const PlanArguments& options, const Scenario& scenario) {
  const std::filesystem::path folder = options.out.empty()
                                           ? std::filesystem::path("out") / scenario.name
                                           : std::filesystem::path(options.out);
  checkOutputFolder(folder);
  for (const ScenarioQuery& query : scenario.queries) checkOutputFolder(folder / query.name);
  return folder;
}

// That gives the same walk again: what changes it, and where it is written.
std::string commandOf(const PlanArguments& options, const Report& report) {
  const PlanArguments usual;
  std::string command =
      fmt::format("amble plan {} --seed {}", shellWord(options.scenario), report.seed);
  const auto add = [&](const char* option, const std::string& value) {
    command += fmt::format(" {} {}", option, shellWord(value));
  };
  if (!options.planner.empty()) add("--planner", options.planner);
  if (!options.roadmap.empty()) add("--roadmap", options.roadmap);
  if (options.time_limit > 0.0) add("--time-limit", shortNumber(options.time_limit));
  if (options.fps != usual.fps) add("--fps", shortNumber(options.fps, 9));
  if (options.bvh_units != usual.bvh_units) add("--bvh-units", options.bvh_units);
  if (options.checker != usual.checker) add("--checker", options.checker);
  if (!options.out.empty()) add("-o", options.out);
  return command;
}

// What was asked for by name and is not there.
void sayWhatIsMissing(const PlanArguments& options, const ResultWishes& wishes,
                      const Report& report) {
  if (report.status == PlanStatus::kSolved || !options.formats_given) return;
  std::vector<std::string> missing;
  for (const ResultFormat& format : resultFormats()) {
    if (format.of_walk && isWanted(wishes, format.name))
      missing.insert(missing.end(), format.files.begin(), format.files.end());
  }
  if (missing.empty()) return;
  say(stderr, "amble plan: without a walk there is no {}\n", fmt::join(missing, ", "));
}

void printResult(const Report& report, const std::filesystem::path& folder) {
  say(stdout, "{}: {}\n", report.scenario, statusName(report.status));
  if (report.status == PlanStatus::kSolved) {
    say(stdout, "  walk       {:.2f} m, {:.2f} s, {} frames, {} steps\n", report.length,
        report.duration, report.frames, report.steps.size());
    if (!report.clearance.object.empty()) {
      say(stdout, "  clearance  {:.3f} m, {} and {} at {:.2f} s\n", report.clearance.min,
          report.clearance.part, report.clearance.object, report.clearance.time);
    }
    say(stdout, "  foot skate {:.1f} mm at most\n", 1000.0 * report.foot_skate_max);
    for (const QualityLine& line : report.quality) {
      if (line.holds()) continue;
      say(stdout, "  quality    {} is {:.4g}{}, over its bar of {:.4g}\n", line.measure, line.value,
          unitText(line.unit), line.bar);
    }
  } else {
    say(stdout, "  why        {}\n", report.why);
  }
  say(stdout, "  roadmap    {} guards, {} connectors, {} edges from {} samples{}\n",
      report.roadmap.guards, report.roadmap.connectors, report.roadmap.edges,
      report.roadmap.samples,
      report.roadmap.coverage > 0.0
          ? fmt::format(", {:.1f} % covered", 100.0 * report.roadmap.coverage)
          : std::string());
  const RunTimes& times = report.times;
  say(stdout, "  time       {:.2f} s: load {:.2f}, roadmap {:.2f}, search {:.2f}, refine {:.2f}\n",
      times.load + times.roadmap + times.search + times.refine, times.load, times.roadmap,
      times.search, times.refine);
  if (!report.stopped_by.empty()) say(stdout, "  ended by   {}\n", report.stopped_by);
  say(stdout, "  written to {}\n", folder.string());
}

int printPlanners() {
  for (const PlannerInfo& planner : listPlanners()) {
    say(stdout, "{:<12} {}\n", planner.name, planner.explanation);
  }
  return kExitDone;
}

// A line of the table of queries; its times are those of this query alone.
void printRow(const std::string& query, const Report& report) {
  say(stdout, "{:<20} {:<13}", query, statusName(report.status));
  if (report.status != PlanStatus::kSolved) {
    say(stdout, " {}\n", report.why);
    return;
  }
  say(stdout, " {:6.2f} m {:6.2f} s {:7.3f} m {:7.1f} ms {:8.1f} ms\n", report.length,
      report.duration, report.clearance.min, 1000.0 * report.times.search,
      1000.0 * report.times.refine);
}

// Writes one result. @return the exit status that it stands for
int conclude(const PlanArguments& options, RunResult& result, const std::filesystem::path& folder) {
  const Report& report = result.report;
  if (report.stopped_by == "interrupt" && report.status != PlanStatus::kSolved) {
    say(stderr, "amble plan: stopped; nothing was written to {}\n", folder.string());
    return kExitStopped;
  }
  const ResultWishes wishes{.formats = options.formats,
                            .views = options.views,
                            .threads = options.threads,
                            .command = commandOf(options, report),
                            .scene_in_glb = !options.no_scene,
                            .film_follows = options.film == "follow"};
  writeFormats(result, folder, wishes);
  sayWhatIsMissing(options, wishes, report);
  return report.status == PlanStatus::kSolved ? kExitDone : kExitNone;
}

// Each query into a folder of its own, with one table, or one list of reports.
int runAll(const PlanArguments& options, const Scenario& scenario, const RunOptions& how,
           const std::filesystem::path& folder, Progress& progress) {
  int status = kExitDone;
  std::string separator = "[\n";
  if (!options.json) {
    say(stdout, "{:<20} {:<13} {:>8} {:>8} {:>9} {:>10} {:>11}\n", "query", "status", "length",
        "time", "clearance", "search", "refine");
  }
  const StoppableWork work;
  runQueries(scenario, how, [&](const ScenarioQuery& query, RunResult& result) {
    progress.clear();
    const int one = conclude(options, result, folder / query.name);
    status = std::max(status, one);
    if (one == kExitStopped) return;
    if (options.json) {
      std::cout << std::exchange(separator, ",\n");
      writeJson(std::cout, result.report);
    } else {
      printRow(query.name, result.report);
    }
  });
  progress.clear();
  if (options.json) std::cout << (separator == "[\n" ? "[]\n" : "]\n");
  if (stopFlag()) return kExitStopped;
  if (!options.json) say(stdout, "written to {}\n", folder.string());
  return status;
}

int runOne(const PlanArguments& options, const Scenario& scenario, const RunOptions& how,
           const std::filesystem::path& folder, Progress& progress) {
  const StoppableWork work;
  RunResult result = runScenario(scenario, how);
  progress.clear();
  const int status = conclude(options, result, folder);
  if (status == kExitStopped) return status;
  if (options.json) {
    writeJson(std::cout, result.report);
  } else {
    printResult(result.report, folder);
  }
  return status;
}

// What is written, and where, by run or query.
std::vector<std::filesystem::path> outputsOf(const Scenario& scenario,
                                             const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> folders, files;
  for (const ScenarioQuery& query : scenario.queries) folders.push_back(folder / query.name);
  if (folders.empty()) folders.push_back(folder);
  for (const std::filesystem::path& one : folders)
    for (const std::filesystem::path& name : resultFileNames()) files.push_back(one / name);
  return files;
}

RunOptions runOptions(const PlanArguments& options) {
  RunOptions how;
  how.threads = options.threads;
  how.frame_time = 1.0 / options.fps;
  how.names = options.names;
  how.bvh_unit = options.bvh_units == "cm" ? 0.01 : 1.0;
  how.memory = options.memory;
  how.checker = options.checker == "fcl" ? Checker::kFcl : Checker::kFast;
  how.roadmap = options.roadmap;
  how.stop = &stopFlag();
  return how;
}

int run(const PlanArguments& options) {
  if (options.list_planners) return printPlanners();
  checkPrograms(options.formats);
  const Scenario scenario = readAsked(options);
  const std::filesystem::path folder = chooseFolder(options, scenario);
  const auto keep =
      [outputs = outputsOf(scenario, folder)](const std::vector<std::filesystem::path>& inputs) {
        for (const std::filesystem::path& output : outputs) keepInputs(output, inputs);
      };
  std::vector<std::filesystem::path> named = {scenario.source.file, scenario.scene};
  if (!options.roadmap.empty()) named.emplace_back(options.roadmap);
  keep(named);
  Progress progress;
  RunOptions how = runOptions(options);
  how.loaded = [&](const Problem& problem) {
    keep(problem.inputs());
    for (const std::string& warning : sceneWarnings(problem.scene, problem.ground))
      say(stderr, "{}: warning: {}\n", scenario.scene.string(), warning);
  };
  how.progress = [&](const SearchProgress& at) {
    const double done =
        at.total > 0 ? static_cast<double>(at.done) / static_cast<double>(at.total) : -1.0;
    progress.update(fmt::format("{}, {} guards, {} connectors", at.phase, at.guards, at.connectors),
                    done);
  };
  return scenario.queries.empty() ? runOne(options, scenario, how, folder, progress)
                                  : runAll(options, scenario, how, folder, progress);
}

// As choices are shown; which of them it is, the run tells, for scenarios name planners too.
std::string plannersText() {
  std::vector<std::string> names;
  for (const PlannerInfo& planner : listPlanners()) names.push_back(planner.name);
  return fmt::format("NAME:{{{}}}", fmt::join(names, ","));
}

// What is written of it. @pre options outlive the command
void addResultOptions(CLI::App& command, PlanArguments& options) {
  command.add_option("--fps", options.fps, "Frames a second")
      ->check(number(24, 240, "1/s"))
      ->capture_default_str();
  command.add_option("--bvh-units", options.bvh_units, "Unit of length in the BVH")
      ->check(choice({"m", "cm"}))
      ->capture_default_str();
  addNamesOption(command, options.names);
  command.add_option("--formats", options.formats, formatsHelp())
      ->delimiter(',')
      ->each([&options](const std::string&) { options.formats_given = true; })
      ->check(choice(formatNames()))
      ->default_str(fmt::format("{}", fmt::join(options.formats, ",")));
  command
      .add_option("--views", options.views,
                  "Also pictures from these points of view: walk-top.png, ... (--formats views "
                  "writes all)")
      ->delimiter(',')
      ->check(choice(viewNames()));
  command.add_flag("--no-scene", options.no_scene, "walk.glb and walk.sdf without the scene");
  command
      .add_option("--film", options.film,
                  "Where the eye of walk.mp4 is: in a corner, or going along with the walker")
      ->check(choice({"corner", "follow"}))
      ->capture_default_str();
}

}  // namespace

void addPlan(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<PlanArguments>();
  CLI::App* command = app.add_subcommand("plan", "Plan one walk and write it with its report");
  CLI::Option* scenario =
      command
          ->add_option("SCENARIO", options->scenario, "Scenario file (YAML); - is standard input")
          ->type_name("FILE");
  command->add_option("-o,--output", options->out, "Folder for the results; default: out/NAME")
      ->type_name("DIR");
  command->add_option("--planner", options->planner, "Instead of the scenario's")
      ->type_name(plannersText());
  command
      ->add_option("--roadmap", options->roadmap,
                   "A kept roadmap, which is asked first (amble roadmap build)")
      ->type_name("FILE");
  command->add_option("--seed", options->seed, "Instead of the scenario's")
      ->check(wholeNumber(0, 2147483647));
  addThreadsOption(*command, options->threads);
  command->add_option("--time-limit", options->time_limit, "Instead of the scenario's")
      ->check(number(0.001, 86400, "s"));
  addResultOptions(*command, *options);
  command
      ->add_option("--checker", options->checker,
                   "Who is asked about contacts: our own trees, or FCL, with which they agree")
      ->check(choice({"fast", "fcl"}))
      ->capture_default_str();
  addMemoryOption(*command, options->memory);
  command->add_flag("--json", options->json, "Print the report");
  command->add_flag("--list-planners", options->list_planners, "Explain each planner");
  addExamples(*command,
              {"amble plan scenarios/living-room.yaml -o out",
               "amble plan --formats bvh,json scenarios/living-room.yaml -o out --fps 30"});
  addExitStatus(*command, "a walk was found", "none was found");
  command->callback([options, scenario, &chosen] {
    if (scenario->count() == 0 && !options->list_planners) throw CLI::RequiredError("SCENARIO");
    chosen = onThreads(options->threads, [options] { return run(*options); });
  });
}

}  // namespace amble
