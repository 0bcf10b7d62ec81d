// amble animate: a walk without a scene, straight or on a circle, over level ground.

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "animation/bvh.h"
#include "animation/error.h"
#include "animation/ground.h"
#include "animation/rotation.h"
#include "animation/walk_quality.h"
#include "animation/walk_synthesizer.h"
#include "app/command.h"

namespace amble {
namespace {

constexpr double kArc = 30.0 * kDegree;  // of a circle, as one Bezier: off it by 1e-6 of its radius
// Lengths that are tried for a duration: as far as one walks at full speed in it, and somewhat
// more, down to what is left when starting and stopping take this long.
constexpr double kLonger = 0.3;        // [m]
constexpr double kStartAndStop = 1.6;  // [s]
constexpr double kLengthStep = 0.05;   // a fifteenth of a step [m]

struct Options {
  double speed = 1.2;     // [m/s]
  double turn_deg = 0.0;  // [degrees/s], left positive
  double duration = 5.0;  // [s]
  double height = 0.0;    // [m]; 0: the library's
  double fps = 60.0;
  std::string library = "default";
  std::string bvh_units = "m";
  std::string out;
  bool quality = false;
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

// Walks `length` metres, from standing to standing.
WalkResult walkAlong(const WalkSynthesizer& synthesizer, double length, double curvature,
                     AnimationBuffer& out) {
  const RootPath path = circlePath(length, curvature);
  const auto end = path.at(path.length());
  Stance from, to;
  to.position.head<2>() = end.position;
  to.heading = end.heading;
  return synthesizer.walk(from, to, path, true, out);
}

// The walk whose duration is nearest to the wanted one: steps are whole, and legs must reach, so
// not every length is one that can be walked.
WalkResult walkFor(const WalkSynthesizer& synthesizer, double duration, double curvature,
                   AnimationBuffer& best) {
  const double speed = synthesizer.settings().speed;
  const double longest = std::max(speed * duration + kLonger, synthesizer.shortestWalk());
  const double shortest = std::max(synthesizer.shortestWalk(), speed * (duration - kStartAndStop));
  WalkResult result{WalkRule::kStepLength, 0, kLeft};
  double nearest = std::numeric_limits<double>::infinity();
  AnimationBuffer walk;
  for (double length = longest; length >= shortest || length == longest; length -= kLengthStep) {
    const WalkResult tried = walkAlong(synthesizer, length, curvature, walk);
    if (tried.refused != WalkRule::kNone) {
      if (result.refused != WalkRule::kNone) result = tried;
      continue;
    }
    const double off = std::abs((walk.size() - 1) * walk.frame_time - duration);
    if (off >= nearest) continue;
    nearest = off;
    result = tried;
    std::swap(best, walk);
  }
  return result;
}

// Every measure beside its bar. @return whether all hold
bool printQuality(const Clip& clip, const JointRoles& roles, const AnimationBuffer& walk,
                  const Ground& ground, std::FILE* out) {
  bool all = true;
  for (const QualityLine& line : judgeWalk(clip, roles, walk, ground)) {
    fmt::print(out, "  {:<5} {:<24} {:10.4g} {:10.4g} {}\n", line.holds() ? "ok" : "ABOVE",
               line.measure, line.value, line.bar, line.unit);
    all = all && line.holds();
  }
  return all;
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
  const WalkResult result = walkFor(synthesizer, options.duration, curvature, walk);
  if (result.refused != WalkRule::kNone) {
    fmt::print(stderr, "amble animate: there is no such walk: {} refused\n",
               walkRuleName(result.refused));
    return kExitNone;
  }
  const Clip clip{"walk", synthesizer.skeleton(), walk.frame_time, walk.poses, {}};
  writeBvh(std::filesystem::path(options.out), clip,
           {.metres_per_unit = options.bvh_units == "cm" ? 0.01 : 1.0});
  std::FILE* const out = options.out == "-" ? stderr : stdout;
  fmt::print(out, "{}: {:.2f} s, {} frames, {} steps, {:.2f} m\n", options.out, clip.duration(),
             clip.frames(), result.steps, walk.states.empty() ? 0.0 : walk.states.back().arc);
  if (!options.quality) return kExitDone;
  return printQuality(clip, synthesizer.roles(), walk, ground, out) ? kExitDone : kExitNone;
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
  command->add_option("--duration", options->duration, "About how long: steps are whole")
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
  command->add_flag("--quality", options->quality,
                    "Print what the walk measures beside its bars; 1 where one does not hold");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace amble
