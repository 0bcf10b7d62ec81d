#include "app/graph_play.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <set>

#include "animation/body/joint_names.h"
#include "animation/captures/bvh.h"
#include "animation/graph/transition_search.h"
#include "app/graph_words.h"
#include "app/motion_output.h"
#include "app/played_graph.h"
#include "app/say.h"
#include "base/error.h"
#include "base/keep_inputs.h"
#include "base/output_file.h"
#include "base/parallel.h"
#include "viz/exchange/glb.h"
#include "viz/figure/captured_figure.h"

namespace amble {
namespace {

struct PlayOptions {
  std::string graph;
  MotionOutput out;
  GraphPlaying how;
};

void writePlayed(const MotionOutput& out, Clip clip, const JointRoles& roles) {
  const std::filesystem::path file = out.file;
  if (!out.names.empty())
    clip.skeleton = renamed(clip.skeleton, jointNames(clip.skeleton, roles, out.names));
  if (!out.isGlb()) {
    writeBvh(file, clip, {.metres_per_unit = out.bvhUnit()});
    return;
  }
  const Figure figure = capturedFigure(clip, roles);
  writeFile(file, [&](std::ostream& stream) { writeGlb(stream, clip, figure); });
}

constexpr const char* kCaseWords[] = {"", "as before", "as after", "as the nearer", "slips"};

std::string feetText(const JoinReport& join) {
  std::vector<std::string> parts;
  for (const FootHold& foot : join.feet)
    parts.push_back(fmt::format("{} {} {:.0f} mm", foot.side == kLeft ? "left" : "right",
                                kCaseWords[static_cast<int>(foot.which)], 1000.0 * foot.slip));
  return parts.empty() ? "no foot stands" : joined(parts);
}

std::string rootText(const JoinReport& join) {
  return join.first == join.last ? "a cut"
                                 : fmt::format("root at most {:.2f} of its sources", join.glide);
}

// Frames that the graph does not take for alike, and a motion whose end is still mixed: each once.
void warnOf(const ClusterGraph& graph, const JoinedClip& motion,
            const std::vector<std::pair<int, int>>& meetings) {
  std::set<std::pair<int, int>> told;
  for (const auto& [leave, enter] : meetings) {
    if (graph.states[leave] == graph.states[enter] || !told.insert({leave, enter}).second) continue;
    say(stderr, "warning: {} stands {}, {} stands {}: feet will not fit\n", frameName(graph, leave),
        kSupportNames[static_cast<int>(graph.states[leave])], frameName(graph, enter),
        kSupportNames[static_cast<int>(graph.states[enter])]);
  }
  if (motion.joins.empty()) return;
  const JoinReport& last = motion.joins.back();
  if (last.last - last.meeting < last.meeting - last.first) {
    say(stderr,
        "warning: the motion ends within its last blend, before it is all of {}'s clip; a later "
        "last frame or a shorter --blend lets it come to that\n",
        frameName(graph, meetings.back().second));
  }
}

// What each join did.
void report(const PlayOptions& options, const ClusterGraph& graph, const PlayedGraph& played,
            const std::vector<std::pair<int, int>>& meetings) {
  const JoinedClip& motion = played.motion;
  std::FILE* const out = options.out.file == "-" ? stderr : stdout;
  say(out, "{}: {} frames of {:.7g} s, {}\n", options.out.file, motion.clip.frames(),
      motion.clip.frame_time, counted(static_cast<long long>(motion.joins.size()), "join"));
  constexpr size_t kMostTold = 20;
  for (size_t i = 0; i < std::min(kMostTold, motion.joins.size()); ++i) {
    const JoinReport& join = motion.joins[i];
    const auto& [leave, enter] = meetings[i];
    say(out, "  {} to {}  frames {} to {}, error {:.3f} m, {}; {}\n", frameName(graph, leave),
        frameName(graph, enter), join.first, join.last, std::sqrt(graph.error(leave, enter)),
        rootText(join), feetText(join));
  }
  if (motion.joins.size() > kMostTold) say(out, "  {} more\n", motion.joins.size() - kMostTold);
  if (played.lock) {
    say(out, "  then feet that stand are held, what slips too, by {:.0f} mm at most\n",
        1000.0 * played.lock->farthest);
  }
  warnOf(graph, motion, meetings);
}

int playRanges(const KeptGraph& kept, const PlayOptions& options,
               const std::vector<NamedRange>& ranges) {
  const std::filesystem::path out = options.out.file;
  options.out.requireFormat();
  std::vector<std::filesystem::path> inputs = {options.graph};
  for (const auto& files : kept.inputs)
    for (const GraphInput& input : files) inputs.push_back(inputFile(options.graph, input));
  keepInputs(out, inputs);
  std::vector<std::pair<int, int>> meetings;
  for (size_t i = 1; i < ranges.size(); ++i) {
    const auto frame = [&](int clip, int in_file) {
      return kept.graph.clips[clip].fromFile(in_file);
    };
    meetings.emplace_back(frame(ranges[i - 1].clip, ranges[i - 1].last),
                          frame(ranges[i].clip, ranges[i].first));
  }
  const PlayedGraph played = playGraph(kept, options.graph, ranges, options.how);
  writePlayed(options.out, played.motion.clip, played.roles);
  report(options, kept.graph, played, meetings);
  return kExitDone;
}

void addPlaying(CLI::App& command, PlayOptions& options) {
  command.add_option("--blend", options.how.blend, "Time over which two clips are mixed at a join")
      ->check(number(0, 10, "s"))
      ->capture_default_str();
  command.add_option("--fps", options.how.fps, "Frames a second; default: the graph's")
      ->check(number(1, 1000, "1/s"));
  command.add_flag("--footlock", options.how.foot_lock,
                   "Hold planted feet where they stand, what slips at joins too");
}

struct LoopArguments {
  PlayOptions play;
  std::string clip;
  int count = 2;
  double error = kGraphError, shortest = 0.4;  // [m], [s]
  int at = -1;                                 // frame of the file; -1: the most alike
};

int listLoops(const KeptGraph& kept, const std::vector<FrameLoop>& loops) {
  constexpr size_t kMostTold = 20;
  for (size_t i = 0; i < std::min(kMostTold, loops.size()); ++i) {
    const FrameLoop& loop = loops[i];
    say(stdout, "{} back to {}  {:.2f} s, error {:.3f} m\n", frameName(kept.graph, loop.leave),
        frameName(kept.graph, loop.enter), (loop.leave - loop.enter) * kept.graph.frame_time,
        std::sqrt(loop.error));
  }
  if (loops.size() > kMostTold) say(stdout, "{} more\n", loops.size() - kMostTold);
  return kExitDone;
}

int loop(const LoopArguments& options) {
  const KeptGraph kept = readFreshGraph(options.play.graph);
  const int clip = clipNamed(kept, options.clip, "CLIP");
  LoopWishes wishes{options.error, options.shortest, {}};
  if (options.at >= 0) wishes.left_near = options.at;
  const std::vector<FrameLoop> loops = loopsIn(kept, clip, wishes);
  if (loops.empty()) {
    say(stderr, "amble graph loop: {} comes to no place again at error {:g} m\n", options.clip,
        options.error);
    return kExitNone;
  }
  if (options.play.out.file.empty()) return listLoops(kept, loops);
  return playRanges(kept, options.play, rangesOfLoop(kept, loops[0], options.count));
}

}  // namespace

void addGraphLoop(CLI::App& graph, Command& chosen) {
  const auto options = std::make_shared<LoopArguments>();
  CLI::App* command = graph.add_subcommand(
      "loop", "List the loops in a clip, or play it through one of them some times");
  command->add_option("GRAPH", options->play.graph, "As `amble graph build` writes it")
      ->type_name("FILE")
      ->required();
  command->add_option("CLIP", options->clip, "A clip of the graph, as `amble graph show` lists it")
      ->type_name("CLIP")
      ->required();
  addMotionOutput(*command, options->play.out);
  command->get_option("--output")
      ->required(false)
      ->description(
          "FILE.bvh, or FILE.glb with a body; - is a BVH on standard output; without, loops are "
          "listed");
  command->add_option("--count", options->count, "Times that the loop is gone through")
      ->check(wholeNumber(1, 10000))
      ->capture_default_str();
  command
      ->add_option("--at", options->at,
                   "The loop that is left nearest to this frame; default: the smoothest")
      ->check(wholeNumber(0, 1000000000))
      ->type_name("FRAME");
  command->add_option("--shortest", options->shortest, "Loops take at least so long")
      ->check(number(0, 1000, "s"))
      ->capture_default_str();
  command->add_option("--error", options->error, "Frames that differ by less are alike")
      ->check(number(0, 100, "m"))
      ->capture_default_str();
  addPlaying(*command, options->play);
  addExamples(*command, {"amble graph loop walks.graph Walk1",
                         "amble graph loop walks.graph Walk1 --count 8 -o long.bvh"});
  addExitStatus(*command, "loops were listed or played", "the clip has none");
  command->callback([options, &chosen] { chosen = [options] { return loop(*options); }; });
}

void addGraphPlay(CLI::App& graph, Command& chosen) {
  struct Arguments {
    PlayOptions play;
    std::string ranges;
  };
  const auto options = std::make_shared<Arguments>();
  CLI::App* command =
      graph.add_subcommand("play", "Join parts of clips, one after another, into one motion");
  command->add_option("GRAPH", options->play.graph, "As `amble graph build` writes it")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("RANGES", options->ranges,
                   "CLIP:A-B,CLIP:C-D,...: frames of the clips' files; B meets C")
      ->type_name("RANGES")
      ->required();
  addMotionOutput(*command, options->play.out);
  addPlaying(*command, options->play);
  addExamples(*command,
              {"amble graph query walks.graph --from Walk1:60 --to WalkToRun:120",
               "amble graph play walks.graph Walk1:60-147,WalkToRun:69-120 -o out/speedup.bvh"});
  command->callback([options, &chosen] {
    chosen = [options] {
      const KeptGraph kept = readFreshGraph(options->play.graph);
      return playRanges(kept, options->play, rangesNamed(kept, options->ranges, "RANGES"));
    };
  });
}

}  // namespace amble
