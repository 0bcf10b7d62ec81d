// amble animate: a walk without a scene, straight or on a circle, over level ground.

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <memory>

#include "animation/bvh.h"
#include "animation/error.h"
#include "animation/ground.h"
#include "animation/rotation.h"
#include "animation/walk_synthesizer.h"
#include "app/command.h"

namespace amble {
namespace {

constexpr double kArc = 30.0 * kDegree;  // of a circle, as one Bezier: off it by 1e-6 of its radius
constexpr double kRefit = 0.05;    // lengths that are tried where no whole number of steps fits [m]
constexpr double kMaxRefit = 1.0;  // more than a step: one of them must fit [m]

struct Options {
  double speed = 1.2;     // [m/s]
  double turn_deg = 0.0;  // [degrees/s], left positive
  double duration = 5.0;  // [s]
  double height = 0.0;    // [m]; 0: the library's
  double fps = 60.0;
  std::string library = "default";
  std::string bvh_units = "m";
  std::string out;
};

// `length` metres of a circle from the origin towards +x, or of a straight line.
RootPath circlePath(double length, double curvature) {
  const double turned = length * curvature;
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(turned) / kArc)));
  const double angle = turned / count;
  const auto at = [&](int i) -> Eigen::Vector2d {
    const double s = length * i / count, a = angle * i;
    if (std::abs(turned) < 1e-9) return {s, 0.0};
    return Eigen::Vector2d(std::sin(a), 1.0 - std::cos(a)) / curvature;
  };
  // A quarter's handles are 4/3 tan(angle / 4) radii long; here in chords.
  const double half = 0.5 * std::abs(angle);
  const double handle = half < 1e-9 ? 1.0 / 3.0 : 2.0 / 3.0 * std::tan(0.5 * half) / std::sin(half);
  std::vector<Bezier> curves;
  for (int i = 0; i < count; ++i) {
    curves.push_back(makeBezier(at(i), angle * i, at(i + 1), angle * (i + 1), handle));
  }
  return RootPath(std::move(curves));
}

// From standing to standing; lengths near the wanted one are tried until a whole number of steps
// fits.
WalkResult walkAlong(const WalkSynthesizer& synthesizer, double length, double curvature,
                     AnimationBuffer& out) {
  WalkResult result;
  for (double off = 0.0; off <= kMaxRefit; off = off > 0.0 ? -off : kRefit - off) {
    if (off < 0.0 && length + off < synthesizer.shortestWalk()) continue;
    const RootPath path = circlePath(length + off, curvature);
    const auto end = path.at(path.length());
    Stance from, to;
    to.position.head<2>() = end.position;
    to.heading = end.heading;
    result = synthesizer.walk(from, to, path, true, out);
    if (result.refused != WalkRule::kStepLength) break;
  }
  return result;
}

int run(const Options& options) {
  const MotionLibrary library = openMotionLibrary(options.library);
  const FlatGround ground;
  CharacterSettings settings;
  settings.height = options.height;
  settings.speed = options.speed;
  settings.frame_time = 1.0 / options.fps;
  const WalkSynthesizer synthesizer(library, ground, settings);
  const double fastest_deg = synthesizer.maxTurnRate() / kDegree;
  if (std::abs(options.turn_deg) > fastest_deg) {
    throw InputError(
        "--turn", 0, fmt::format("is {:g} degrees/s", options.turn_deg),
        fmt::format("-{0:.1f} to {0:.1f}, the fastest of the library's walks", fastest_deg));
  }
  AnimationBuffer walk;
  const double curvature = options.turn_deg * kDegree / options.speed;
  const double at_speed = options.speed * options.duration;
  double length = std::max(at_speed, synthesizer.shortestWalk());
  WalkResult result = walkAlong(synthesizer, length, curvature, walk);
  if (result.refused == WalkRule::kNone) {  // once more, less what starting and stopping took
    length += at_speed - options.speed * (walk.size() - 1) * walk.frame_time;
    length = std::max(length, synthesizer.shortestWalk());
    result = walkAlong(synthesizer, length, curvature, walk);
  }
  if (result.refused != WalkRule::kNone) {
    fmt::print(stderr, "amble animate: there is no such walk: {} refused\n",
               walkRuleName(result.refused));
    return kExitNone;
  }
  Clip clip{"walk", synthesizer.skeleton(), walk.frame_time, std::move(walk.poses), {}};
  writeBvh(std::filesystem::path(options.out), clip,
           {.metres_per_unit = options.bvh_units == "cm" ? 0.01 : 1.0});
  fmt::print(options.out == "-" ? stderr : stdout, "{}: {:.2f} s, {} frames, {} steps, {:.2f} m\n",
             options.out, clip.duration(), clip.frames(), result.steps,
             walk.states.empty() ? 0.0 : walk.states.back().arc);
  return kExitDone;
}

}  // namespace

void addAnimate(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("animate", "Make a walk without a scene, from standing to standing");
  command->add_option("-o,--output", options->out, "BVH file; - is standard output")->required();
  command->add_option("--speed", options->speed, "On the straight; less in turns")
      ->check(number(0.3, 2.0, "m/s"))
      ->capture_default_str();
  command->add_option("--turn", options->turn_deg, "Turn rate at that speed, left positive")
      ->check(number(-180, 180, "degrees/s"))
      ->capture_default_str();
  command->add_option("--duration", options->duration, "About how long; steps are whole")
      ->check(number(1, 600, "s"))
      ->capture_default_str();
  command->add_option("--height", options->height, "Stature; default: the library's own")
      ->check(number(0.5, 2.5, "m"));
  command->add_option("--library", options->library, "Motion library: default, or a file")
      ->capture_default_str();
  command->add_option("--fps", options->fps, "Frames a second")
      ->check(number(24, 240, "1/s"))
      ->capture_default_str();
  command->add_option("--bvh-units", options->bvh_units, "Unit of length in the BVH")
      ->check(CLI::IsMember({"m", "cm"}))
      ->capture_default_str();
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace amble
