// amble graph build|show|query|loop|play: cluster graphs of captures.

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "animation/graph/transition_search.h"
#include "app/clip_sources.h"
#include "app/graph_made.h"
#include "app/graph_play.h"
#include "app/graph_ways.h"
#include "app/graph_words.h"
#include "app/progress.h"
#include "app/read_options.h"
#include "app/say.h"
#include "base/error.h"
#include "base/keep_inputs.h"
#include "base/stopwatch.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

struct GraphBuildOptions {
  std::vector<std::string> clips;
  std::string out;
  GraphMaking making;
};

void print(const Json& data) {
  std::cout << data.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

std::string summary(const ClusterGraph& graph, const GraphCut& cut) {
  size_t edges = 0;
  for (const FrameCluster& cluster : cut.clusters) edges += cluster.next.size();
  return fmt::format("{}, {} frames at {:.6g} a second, {} at error {:g} m, {} edges",
                     counted(static_cast<long long>(graph.clips.size()), "clip"), graph.frames(),
                     1.0 / graph.frame_time,
                     counted(static_cast<long long>(cut.clusters.size()), "cluster"), cut.error,
                     edges);
}

int build(const GraphBuildOptions& options) {
  const std::vector<std::filesystem::path> files = findClips(options.clips);
  const Stopwatch watch;
  Progress progress;
  GraphMaking making = options.making;
  making.stage = [&](const std::string& stage) { progress.update(stage, -1.0); };
  std::vector<std::string> warnings;
  const KeptGraph kept = makeKeptGraph(files, options.out, making, warnings);
  progress.clear();
  for (const std::string& warning : warnings) say(stderr, "warning: {}\n", warning);
  writeGraph(kept, options.out);
  if (options.out != "-")
    say(stdout, "{}: {}, in {:.2f} s\n", options.out,
        summary(kept.graph, cutAt(kept.graph, kGraphError)), watch.seconds());
  return kExitDone;
}

Json clipsJson(const KeptGraph& kept) {
  Json clips = Json::array();
  for (size_t i = 0; i < kept.graph.clips.size(); ++i) {
    const GraphClip& clip = kept.graph.clips[i];
    Json files = Json::object();
    for (const GraphInput& input : kept.inputs[i]) files[input.path] = input.sha256;
    clips.push_back({{"name", clip.name},
                     {"files", files},
                     {"frames", clip.frames},
                     {"first", clip.inFile(clip.first)},
                     {"last", clip.inFile(clip.last())}});
  }
  return clips;
}

Json clustersJson(const ClusterGraph& graph, const GraphCut& cut) {
  Json clusters = Json::array();
  for (const FrameCluster& cluster : cut.clusters) {
    Json sequences = Json::array();
    for (const int s : cluster.sequences) {
      const FrameSequence& sequence = cut.sequences[s];
      const GraphClip& clip = graph.clips[sequence.clip];
      sequences.push_back({{"clip", clip.name},
                           {"first", clip.inFile(sequence.first)},
                           {"last", clip.inFile(sequence.last)},
                           {"alignment", clip.inFile(sequence.alignment)}});
    }
    clusters.push_back({{"state", kSupportNames[static_cast<int>(cluster.state)]},
                        {"frames", cluster.frames},
                        {"spread", cluster.spread},
                        {"sequences", sequences},
                        {"next", cluster.next}});
  }
  return clusters;
}

int showJson(const KeptGraph& kept, const GraphCut& cut, const std::string& changed) {
  print({{"frames", kept.graph.frames()},
         {"frame_time", kept.graph.frame_time},
         {"error", cut.error},
         {"changed", changed},
         {"clips", clipsJson(kept)},
         {"clusters", clustersJson(kept.graph, cut)}});
  return kExitDone;
}

// Of one state: its clusters, and those that hold more than one sequence.
void sayStates(const GraphCut& cut) {
  for (int state = 0; state < kSupportStates; ++state) {
    int frames = 0, clusters = 0, shared = 0;
    for (const FrameCluster& cluster : cut.clusters) {
      if (static_cast<int>(cluster.state) != state) continue;
      frames += cluster.frames;
      ++clusters;
      shared += cluster.sequences.size() > 1 ? 1 : 0;
    }
    if (frames > 0)
      say(stdout, "  {:<3} {:>6} frames in {:>5} clusters, {} of them with places to leave\n",
          kSupportNames[state], frames, clusters, shared);
  }
}

void sayClips(const KeptGraph& kept) {
  for (size_t i = 0; i < kept.graph.clips.size(); ++i) {
    const GraphClip& clip = kept.graph.clips[i];
    say(stdout, "  {:<32} frames {} to {}, {}\n", utf8Text(clip.name), clip.inFile(clip.first),
        clip.inFile(clip.last()), utf8Text(kept.inputs[i][0].path));
  }
}

int show(const std::string& file, double error, bool json) {
  const KeptGraph kept = readGraph(file);
  const std::string changed = whatChanged(kept, file);
  const GraphCut cut = cutAt(kept.graph, error);
  if (json) return showJson(kept, cut, changed);
  say(stdout, "{}: {}\n", file, summary(kept.graph, cut));
  sayStates(cut);
  sayClips(kept);
  if (!changed.empty()) say(stderr, "warning: {}: stale, these have changed: {}\n", file, changed);
  return kExitDone;
}

struct QueryOptions {
  std::string graph, from, to;
  double error = kGraphError;  // [m]
  double stay = 0.5;           // [s]
  bool json = false;
};

std::string jumpsText(const ClusterGraph& graph, const GraphWay& way) {
  if (way.jumps.empty()) return "the clip goes there itself";
  std::vector<std::string> parts;
  for (const FrameJump& jump : way.jumps)
    parts.push_back(frameName(graph, jump.leave) + " to " + frameName(graph, jump.enter));
  return joined(parts, ", then ") + fmt::format(", error {:.3f} m, {:.2f} s more played",
                                                std::sqrt(way.error), way.wait * graph.frame_time);
}

int query(const QueryOptions& options) {
  const KeptGraph kept = readFreshGraph(options.graph);
  const ClusterGraph& graph = kept.graph;
  const GraphWays ways = waysBetween(kept, options.from, options.to, {options.error, options.stay});
  if (options.json) {
    print(ways.data);
  } else {
    for (const NamedWay& way : ways.all)
      say(stdout, "{:<18} {}\n", way.title, jumpsText(graph, way.way));
  }
  if (ways.all.empty()) {
    say(stderr,
        "amble graph query: no way from {} to {} at error {:g} m; they differ by {:.3f} m\n",
        options.from, options.to, options.error, ways.difference);
    return kExitNone;
  }
  if (!options.json)
    say(stdout, "to play: amble graph play {} {} -o FILE.bvh\n", options.graph,
        rangesText(graph, rangesOf(graph, ways.all.front().way, ways.from, ways.to)));
  return kExitDone;
}

void addErrorOption(CLI::App& command, double& error) {
  command.add_option("--error", error, "Frames that differ by less are alike")
      ->check(number(0, 100, "m"))
      ->capture_default_str();
}

void addGraphBuild(CLI::App& graph, Command& chosen) {
  const auto options = std::make_shared<GraphBuildOptions>();
  CLI::App* command = graph.add_subcommand(
      "build", "Find which frames of some clips are alike, and keep that as a graph");
  command->add_option("CLIPS", options->clips, "Captures, and folders of them")
      ->type_name("FILE")
      ->required();
  command->add_option("-o,--output", options->out, "File of the graph; - is standard output")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("--fps", options->making.fps,
                   "Frames a second that are compared; default: 30, or those of the slowest clip")
      ->check(number(1, 1000, "1/s"));
  addThreadsOption(*command, options->making.threads);
  addReadOptions(*command, options->making.read);
  addExamples(*command, {"amble graph build Walk1.bvh WalkToRun.bvh -o walks.graph",
                         "amble graph build captures/ -o all.graph"});
  command->callback([options, &chosen] {
    chosen = onThreads(options->making.threads, [options] { return build(*options); });
  });
}

void addGraphShow(CLI::App& graph, Command& chosen) {
  struct Arguments {
    std::string file;
    double error = kGraphError;
    bool json = false;
  };
  const auto options = std::make_shared<Arguments>();
  CLI::App* command =
      graph.add_subcommand("show", "Say what a graph holds: clips, clusters, sequences, edges");
  command->add_option("GRAPH", options->file, "As `amble graph build` writes it")
      ->type_name("FILE")
      ->required();
  addErrorOption(*command, options->error);
  command->add_flag("--json", options->json, "Print results for machines");
  command->callback([options, &chosen] {
    chosen = [options] { return show(options->file, options->error, options->json); };
  });
}

void addGraphQuery(CLI::App& graph, Command& chosen) {
  const auto options = std::make_shared<QueryOptions>();
  CLI::App* command = graph.add_subcommand("query", "Find ways from a frame of a clip to another");
  command->add_option("GRAPH", options->graph, "As `amble graph build` writes it")
      ->type_name("FILE")
      ->required();
  command->add_option("--from", options->from, "Where it begins, a frame of the clip's file")
      ->type_name("CLIP:FRAME")
      ->required();
  command->add_option("--to", options->to, "Where it is to come, or to a frame before and play on")
      ->type_name("CLIP:FRAME")
      ->required();
  addErrorOption(*command, options->error);
  command->add_option("--stay", options->stay, "A clip on the way plays for at least so long")
      ->check(number(0, 1000, "s"))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print results for machines");
  addExamples(*command, {"amble graph query walks.graph --from Walk1:60 --to WalkToRun:120"});
  addExitStatus(*command, "there is a way", "there is none");
  command->callback([options, &chosen] { chosen = [options] { return query(*options); }; });
}

}  // namespace

void addGraph(CLI::App& app, Command& chosen) {
  CLI::App* graph = app.add_subcommand(
      "graph", "Cluster graphs of captures: join clips, loop them, put them into another order");
  graph->require_subcommand(1);
  addGraphBuild(*graph, chosen);
  addGraphShow(*graph, chosen);
  addGraphQuery(*graph, chosen);
  addGraphLoop(*graph, chosen);
  addGraphPlay(*graph, chosen);
}

}  // namespace amble
