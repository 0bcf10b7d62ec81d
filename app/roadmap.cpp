// amble roadmap build|show: roadmaps that are kept for many queries.

#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/progress.h"
#include "app/say.h"
#include "app/stop.h"
#include "base/error.h"
#include "base/keep_inputs.h"
#include "base/stopwatch.h"
#include "base/strict_yaml.h"
#include "base/text.h"
#include "planner/roadmap/roadmap_file.h"
#include "scenarios/kept_roadmaps.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

struct BuildOptions {
  std::string input, out;
  int seed = -1;  // -1: the scenario's
  int max_failures = Planner::kFailures;
  int threads = 1;
  double time_limit = 0.0;  // [s]; 0: the scenario's
  double fps = 60.0;
  size_t memory = GuardLimits{}.memory;  // [bytes]
};

Scenario readAsked(const BuildOptions& options) {
  const ScenarioFile file = {options.input, readWholeFile(options.input, kAnyYaml)};
  const YamlNode root = parseYaml(file.text, options.input);
  const bool is_scene = root.isMap() && root.has("objects") && !root.has("scene");
  Scenario scenario = is_scene ? sceneAlone(options.input) : readScenario(file);
  if (options.seed >= 0) scenario.planner.seed = static_cast<std::uint64_t>(options.seed);
  scenario.planner.max_failures = options.max_failures;
  if (options.time_limit > 0.0) scenario.planner.time_limit = options.time_limit;
  return scenario;
}

std::string summary(const KeptRoadmap& roadmap) {
  return fmt::format("{} guards, {} connectors, {} edges in {} from {} samples, {:.1f} % covered",
                     roadmap.count(NodeKind::kGuard), roadmap.count(NodeKind::kConnector),
                     roadmap.edges.size(), counted(roadmap.pieces(), "piece"), roadmap.samples,
                     100.0 * roadmap.coverage);
}

int build(const BuildOptions& options) {
  const Scenario scenario = readAsked(options);
  keepInputs(options.out, {options.input, scenario.scene});
  Progress progress;
  const StoppableWork work;
  const StopRequest stop{&stopFlag(), deadlineIn(scenario.planner.time_limit)};
  const Problem problem(scenario, 1.0 / options.fps, {options.memory, stop});
  keepInputs(options.out, problem.inputs());
  PlanRequest request = problem.request();
  request.limits.threads = options.threads;
  request.limits.stop = stop.flag;
  request.limits.deadline = deadlineIn(scenario.planner.time_limit);
  request.limits.progress = [&](const SearchProgress& at) {
    progress.update(fmt::format("{} guards, {} connectors", at.guards, at.connectors),
                    static_cast<double>(at.done) / static_cast<double>(at.total));
  };
  const Stopwatch watch;
  KeptRoadmap roadmap = Planner::grow(request);
  progress.clear();
  if (request.limits.stopped()) {
    say(stderr, "amble roadmap build: {}; nothing was written to {}\n",
        stop.flagged() ? "stopped" : "the time limit passed before the roadmap was whole",
        options.out);
    return stop.flagged() ? kExitStopped : kExitNone;
  }
  roadmap.source = roadmapSource(problem);
  writeRoadmap(roadmap, options.out);
  if (options.out != "-")
    say(stdout, "{}: {}, in {:.2f} s\n", options.out, summary(roadmap), watch.seconds());
  return kExitDone;
}

Eigen::AlignedBox3d extentOf(const KeptRoadmap& roadmap) {
  Eigen::AlignedBox3d box;
  for (const KeptRoadmap::Node& node : roadmap.nodes) box.extend(node.stance.position);
  return box;
}

Json toJson(const KeptRoadmap& roadmap) {
  Json source = Json::object();
  for (const auto& [name, values] : roadmap.source.parts())
    source[name] = {{"sha256", digestOf(*values)}, {"values", *values}};
  Json nodes = Json::array(), edges = Json::array();
  for (const KeptRoadmap::Node& node : roadmap.nodes) {
    const Eigen::Vector3d& p = node.stance.position;
    nodes.push_back({{"kind", node.kind == NodeKind::kGuard ? "guard" : "connector"},
                     {"at", {p.x(), p.y(), p.z()}},
                     {"heading", node.stance.heading / kDegree}});
  }
  for (const KeptRoadmap::Edge& edge : roadmap.edges)
    edges.push_back({{"from", edge.from}, {"to", edge.to}, {"cost", edge.cost}});
  return {{"guards", roadmap.count(NodeKind::kGuard)},
          {"connectors", roadmap.count(NodeKind::kConnector)},
          {"pieces", roadmap.pieces()},
          {"samples", roadmap.samples},
          {"coverage", roadmap.coverage},
          {"seed", roadmap.seed},
          {"max_failures", roadmap.max_failures},
          {"source", source},
          {"nodes", nodes},
          {"edges", edges}};
}

int show(const std::string& file, bool json) {
  const KeptRoadmap roadmap = readRoadmap(file);
  if (json) {
    std::cout << toJson(roadmap).dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    return kExitDone;
  }
  say(stdout, "{}: {}\n", file, summary(roadmap));
  say(stdout, "  grown      by seed {} until {} failures in a row\n", roadmap.seed,
      roadmap.max_failures);
  if (!roadmap.nodes.empty()) {
    const Eigen::AlignedBox3d box = extentOf(roadmap);
    say(stdout, "  extent     x {:.2f} to {:.2f}, y {:.2f} to {:.2f}, z {:.2f} to {:.2f} m\n",
        box.min().x(), box.max().x(), box.min().y(), box.max().y(), box.min().z(), box.max().z());
  }
  constexpr size_t kMostTold = 6;
  for (const auto& [name, values] : roadmap.source.parts()) {
    std::vector<std::string> told;
    for (const auto& [key, value] : *values)
      told.push_back(value.size() == 64 ? key : fmt::format("{} {}", key, value));
    const size_t left = told.size() - std::min(told.size(), kMostTold);
    told.resize(told.size() - left);
    if (left > 0) told.push_back(fmt::format("{} more", left));
    say(stdout, "  {:<10} {}, SHA-256 {:.12}\n", name, utf8Text(withoutControls(joined(told))),
        digestOf(*values));
  }
  return kExitDone;
}

void addRoadmapBuild(CLI::App& roadmap, Command& chosen) {
  const auto options = std::make_shared<BuildOptions>();
  CLI::App* command = roadmap.add_subcommand(
      "build", "Make a roadmap of a scene, without start and goal, and keep it");
  command
      ->add_option("SCENE", options->input, "Scenario, or a scene for the default character (YAML)")
      ->type_name("FILE")
      ->required();
  command->add_option("-o,--output", options->out, "File of the roadmap")
      ->type_name("FILE")
      ->required();
  command->add_option("--seed", options->seed, "Instead of the scenario's")
      ->check(wholeNumber(0, 2147483647));
  command
      ->add_option("--m", options->max_failures,
                   "Failures in a row to add a guard that end it: the visibility PRM's M")
      ->check(wholeNumber(1, 1000000))
      ->capture_default_str();
  addThreadsOption(*command, options->threads);
  command->add_option("--time-limit", options->time_limit, "Instead of the scenario's")
      ->check(number(0.001, 86400, "s"));
  command->add_option("--fps", options->fps, "Frames a second of the walks")
      ->check(number(24, 240, "1/s"))
      ->capture_default_str();
  addMemoryOption(*command, options->memory);
  addExamples(*command, {"amble roadmap build scenarios/narrow-gap-070.yaml -o gap.roadmap",
                         "amble plan scenarios/narrow-gap-070.yaml --roadmap gap.roadmap"});
  addExitStatus(*command, "it was made", "its time was up before that");
  command->callback([options, &chosen] {
    chosen = onThreads(options->threads, [options] { return build(*options); });
  });
}

void addRoadmapShow(CLI::App& roadmap, Command& chosen) {
  struct Options {
    std::string file;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      roadmap.add_subcommand("show", "Say what a roadmap holds, and what it was made of");
  command
      ->add_option("FILE", options->file, "As `amble roadmap build` writes it; - is standard input")
      ->type_name("FILE")
      ->required();
  command->add_flag("--json", options->json, "Print results for machines");
  command->callback(
      [options, &chosen] { chosen = [options] { return show(options->file, options->json); }; });
}

}  // namespace

void addRoadmap(CLI::App& app, Command& chosen) {
  CLI::App* roadmap =
      app.add_subcommand("roadmap", "Build or show roadmaps that are kept for many queries");
  roadmap->require_subcommand(1);
  addRoadmapBuild(*roadmap, chosen);
  addRoadmapShow(*roadmap, chosen);
}

}  // namespace amble
