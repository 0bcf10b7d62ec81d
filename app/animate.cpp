// amble animate: a walk without a scene, straight or on a circle, over level ground, slopes or
// stairs.

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "animation/body/joint_names.h"
#include "animation/captures/bvh.h"
#include "animation/ground/ground.h"
#include "animation/library/motion_library_reader.h"
#include "animation/quality/step_measures.h"
#include "animation/quality/walk_quality.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "app/animate_engine.h"
#include "app/animated.h"
#include "app/command.h"
#include "app/motion_output.h"
#include "app/say.h"
#include "app/unit_text.h"
#include "base/error.h"
#include "base/keep_inputs.h"
#include "base/output_file.h"
#include "base/rotation.h"
#include "scenarios/walker_body.h"
#include "viz/exchange/glb.h"

namespace amble {
namespace {

struct AnimateArguments {
  std::string speed;      // as it was written [m/s]; empty: 1.2, or the style's own
  std::string engine;     // file, or "": walks of the library
  double turn_deg = 0.0;  // [degrees/s], left positive
  double duration = 5.0;  // [s]
  double height = 0.0;    // [m]; 0: the library's
  double fps = 60.0;
  std::string library = "default", style;
  MotionOutput out;
  std::string stride, lift, incline_deg, stairs;  // as they were written; empty: not asked
  std::vector<std::string> actions;
  bool quality = false;
};

constexpr double kFastestRun = 12.0;  // that anybody asks for [m/s]

DemoRequest requestOf(const AnimateArguments& options) {
  DemoRequest request;
  request.duration = options.duration;
  request.turn_rate = options.turn_deg * kDegree;
  if (!options.stride.empty()) request.stride = readRamp(options.stride);
  if (!options.lift.empty()) request.lift = readRamp(options.lift);
  if (!options.stairs.empty()) request.stairs = readTwoNumbers(options.stairs);
  if (!options.incline_deg.empty()) {
    const Ramp degrees = readRamp(options.incline_deg);
    request.incline = Ramp{degrees.from * kDegree, degrees.to * kDegree};
  }
  return request;
}

// Every measure beside its bar. @return whether all hold
bool printQuality(const WalkSynthesizer& synthesizer, const Clip& clip, const AnimationBuffer& walk,
                  const Ground& ground, const QualityAnchors& anchors, std::FILE* out) {
  bool all = true;
  const JointRoles& roles = synthesizer.roles();
  std::vector<QualityLine> lines = judgeWalk(clip, roles, walk, ground, anchors);
  const std::vector<QualityLine> steps =
      judgeSteps(measureWalkSteps(clip.skeleton, roles, synthesizer.feet(), walk, ground));
  lines.insert(lines.end(), steps.begin(), steps.end());
  for (const QualityLine& line : lines) {
    say(out, "  {:<5} {:<24} {:10.4g} {:10.4g}{}\n", line.holds() ? "ok" : "ABOVE", line.measure,
        line.value, line.bar, unitText(line.unit));
    all = all && line.holds();
  }
  return all;
}

void write(const MotionOutput& output, const MotionLibrary& library,
           const WalkSynthesizer& synthesizer, const Ground& ground, const AnimationBuffer& walk) {
  const std::filesystem::path file = output.file;
  const std::vector<std::string> names =
      jointNames(synthesizer.skeleton(), synthesizer.roles(), output.names);
  const Skeleton skeleton = renamed(synthesizer.skeleton(), names);
  if (!output.isGlb()) {
    writeBvh(file, Clip{"walk", skeleton, walk.frame_time, walk.poses, {}},
             {.metres_per_unit = output.bvhUnit()});
    return;
  }
  const Body body = walkerBody(synthesizer, library);
  WalkView view;
  view.title = "walk";
  view.ground = &ground;
  view.skeleton = &skeleton;
  view.body = &body;
  view.animation = &walk;
  writeFile(file, [&](std::ostream& out) { writeGlb(out, view, makeFigure(skeleton, body)); });
}

// Walks of a library hold one speed on the straight.
std::optional<double> speedOf(const AnimateArguments& options) {
  if (options.speed.empty()) return std::nullopt;
  const Ramp speed = readRamp(options.speed);
  if (speed.from == speed.to) return speed.from;
  throw InputError("amble animate: --speed", 0, "is '" + options.speed + "'",
                   "one speed; --engine takes ramps");
}

int runEngine(const AnimateArguments& options) {
  const std::string usual = options.speed.empty() ? "1.2" : options.speed;
  return animateEngine({options.engine, readRamp(usual), options.duration, options.height,
                        options.fps, options.out});
}

int run(const AnimateArguments& options) {
  const std::filesystem::path file = motionLibraryFile(options.library);
  keepInputs(options.out.file, {file});
  const AnimatedWalk made = animateWalk({.library = options.library,
                                         .style = options.style,
                                         .speed = speedOf(options),
                                         .height = options.height,
                                         .fps = options.fps,
                                         .actions = options.actions,
                                         .walk = requestOf(options)});
  keepInputs(options.out.file, {made.library->file.parent_path() / made.library->skeleton_file});
  if (!made.refused.empty()) {
    say(stderr, "amble animate: there is no such walk: {}\n", made.refused);
    return kExitNone;
  }
  const WalkSynthesizer& synthesizer = *made.synthesizer;
  const AnimationBuffer& walk = made.walk;
  const Clip clip{"walk", synthesizer.skeleton(), walk.frame_time, walk.poses, {}};
  write(options.out, *made.library, synthesizer, *made.ground, walk);
  std::FILE* const out = options.out.file == "-" ? stderr : stdout;
  say(out, "{}: {:.2f} s, {} frames, {} steps, {:.2f} m\n", options.out.file, clip.duration(),
      clip.frames(), made.result.steps, walk.states.empty() ? 0.0 : walk.states.back().arc);
  if (!options.quality) return kExitDone;
  const QualityAnchors anchors = anchorsOf(
      *made.library, synthesizer.stature() / made.library->stature, synthesizer.settings().speed);
  return printQuality(synthesizer, clip, walk, *made.ground, anchors, out) ? kExitDone : kExitNone;
}

// How to walk.
void addWalkOptions(CLI::App& command, AnimateArguments& options) {
  command
      .add_option("--speed", options.speed,
                  "On the straight, 0.3 to 2; less in turns; default: 1.2, or the --style's own. "
                  "Of an engine any, and a ramp over the time of the walk")
      ->check(ramp(0, kFastestRun, "m/s"));
  command
      .add_option("--style", options.style,
                  "In whose manner, of those that the library has (amble library show)")
      ->type_name("NAME");
  command.add_option("--turn", options.turn_deg, "Turn rate at that speed, left positive")
      ->check(number(-180, 180, "degrees/s"))
      ->capture_default_str();
  command.add_option("--duration", options.duration, "About how long: steps are whole")
      ->check(number(1, 600, "s"))
      ->capture_default_str();
  command.add_option("--stride", options.stride, "Step length along the ground")
      ->check(ramp(0.05, 2.0, "m"));
  command.add_option("--lift", options.lift, "How high feet swing over the line between prints")
      ->check(ramp(0.005, 0.5, "m"));
  auto* incline = command.add_option("--incline", options.incline_deg, "Slope, up positive")
                      ->check(ramp(-45, 45, "degrees"));
  command
      .add_option("--stairs", options.stairs,
                  "RISE,GO of a flight of stairs; a negative rise goes down")
      ->check(twoNumbers({-0.5, 0.5}, {0.15, 1.5}, "m"))
      ->excludes(incline)
      ->excludes("--stride")
      ->excludes("--turn");
  command.add_option("--height", options.height, "Stature; default: the library's own")
      ->check(number(0.5, 2.5, "m"));
  command
      .add_option("--action", options.actions,
                  "A movement (goes with the steps) or posture (is held) of the library, over the "
                  "whole walk; given again, the later over the earlier")
      ->type_name("NAME");
}

}  // namespace

void addAnimate(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<AnimateArguments>();
  CLI::App* command =
      app.add_subcommand("animate", "Make a walk without a scene, from standing to standing");
  addMotionOutput(*command, options->out);
  addWalkOptions(*command, *options);
  command->add_option("--library", options->library, "Motion library: default, or a file")
      ->type_name("FILE")
      ->capture_default_str();
  auto* engine = command
                     ->add_option("--engine", options->engine,
                                  "Walk or run straight ahead with a speed engine instead (amble "
                                  "library engine build): starts and stops are ramps from and to 0")
                     ->type_name("FILE");
  for (const char* option :
       {"--turn", "--stride", "--lift", "--incline", "--stairs", "--action", "--library"}) {
    engine->excludes(option);
  }
  command->add_option("--fps", options->fps, "Frames a second")
      ->check(number(24, 240, "1/s"))
      ->capture_default_str();
  command->add_flag("--quality", options->quality, "Print what the walk measures beside its bars")
      ->excludes(engine);
  addExamples(*command, {"amble animate --speed 1.2 --turn 20 --duration 5 -o turn.bvh",
                         "amble animate --stairs .17,.29 --duration 8 -o stairs.bvh",
                         "amble animate --stride 0.5..0.8 --lift 0.15 -o stride.bvh",
                         "amble animate --engine anna.yaml --speed 0.4..1.8 -o faster.bvh"});
  addExitStatus(*command, "the walk is there",
                "there is none such, or a bar of --quality does not hold");
  command->callback([options, &chosen] {
    chosen = [options] {
      options->out.requireFormat();
      return options->engine.empty() ? run(*options) : runEngine(*options);
    };
  });
}

}  // namespace amble
