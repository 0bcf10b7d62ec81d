// amble edit CLIP -o OUT: stride, lift, slope, stairs, arrival of a captured walk; feet that stay.

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>

#include "animation/body/joint_names.h"
#include "animation/captures/bvh.h"
#include "app/command.h"
#include "app/edit_report.h"
#include "app/edited.h"
#include "app/motion_output.h"
#include "app/read_options.h"
#include "app/say.h"
#include "base/error.h"
#include "base/keep_inputs.h"
#include "base/output_file.h"
#include "base/rotation.h"
#include "viz/exchange/glb.h"
#include "viz/figure/captured_figure.h"

namespace amble {
namespace {

struct EditArguments {
  std::string in;
  MotionOutput out;
  ReadOptions read;
  std::string stride, lift, incline_deg, stairs, arrive;  // as they were written; empty: not asked
  bool foot_lock = false, json = false;
};

std::optional<EditAmount> amountOf(const std::string& text) {
  if (text.empty()) return std::nullopt;
  return EditAmount{readAmount(text).first, readAmount(text).second};
}

EditRequest requestOf(const EditArguments& options) {
  EditRequest request;
  request.stride = amountOf(options.stride);
  request.lift = amountOf(options.lift);
  if (!options.incline_deg.empty()) {
    const Ramp degrees = readRamp(options.incline_deg);
    request.incline = Ramp{degrees.from * kDegree, degrees.to * kDegree};
  }
  if (!options.stairs.empty()) {
    const auto [rise, going] = readTwoNumbers(options.stairs);
    request.stairs = StairSize{rise, going};
  }
  if (!options.arrive.empty()) {
    const auto [x, y] = readTwoNumbers(options.arrive);
    request.arrive = Eigen::Vector2d(x, y);
  }
  request.foot_lock = options.foot_lock;
  return request;
}

void write(const MotionOutput& output, Clip clip, const JointRoles& roles) {
  const std::filesystem::path file = output.file;
  if (!output.names.empty()) {
    clip.skeleton = renamed(clip.skeleton, jointNames(clip.skeleton, roles, output.names));
  }
  if (!output.isGlb()) {
    writeBvh(file, clip, {.metres_per_unit = output.bvhUnit()});
    return;
  }
  const Figure figure = capturedFigure(clip, roles);
  writeFile(file, [&](std::ostream& out) { writeGlb(out, clip, figure); });
}

int run(const EditArguments& options) {
  const std::filesystem::path out = options.out.file;
  options.out.requireFormat();
  keepInputs(out, options.read.filesOf(options.in));
  CapturedMotion motion = readMotion(options.in, options.read.forReader());
  const CapturedWalk walk = captureWalk(motion, options.in);
  const EditRequest request = requestOf(options);
  for (const std::string& warning : motion.warnings) say(stderr, "warning: {}\n", warning);
  const EditedWalk edited = editCapture(walk, request, options.in);
  if (!edited.refused.empty()) {
    say(stderr, "amble edit: there is no such walk: {}\n", edited.refused);
    return kExitNone;
  }
  write(options.out, edited.clip, walk.roles);
  const EditReport report = editReport(walk, request, edited);
  const bool on_output = options.out.file == "-";
  if (options.json) {
    const auto json = editJson(report, walk, request, edited, options.in, options.out.file);
    (on_output ? std::cerr : std::cout)
        << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
    return kExitDone;
  }
  std::FILE* const to = on_output ? stderr : stdout;
  say(to, "{}: {} frames of {:.7g} s, from {}\n", options.out.file, edited.clip.frames(),
      edited.clip.frame_time, options.in);
  for (const std::string& line : editLines(report, edited)) say(to, "  {}\n", line);
  return kExitDone;
}

void addEdits(CLI::App& command, EditArguments& options) {
  const std::string captured = "; 1.2x is as many times the captured one";
  auto* stride =
      command
          .add_option("--stride", options.stride, "Mean step length along the ground" + captured)
          ->check(amount(0.05, 2.0, "m"));
  command
      .add_option("--lift", options.lift,
                  "How high feet swing over the line between prints, in the mean" + captured)
      ->check(amount(0.005, 0.5, "m"));
  auto* incline = command.add_option("--incline", options.incline_deg, "Slope, up positive")
                      ->check(ramp(-20, 20, "degrees"));
  auto* stairs = command
                     .add_option("--stairs", options.stairs,
                                 "RISE,GO of stairs, a step each; a negative rise goes down")
                     ->check(twoNumbers({-0.25, 0.25}, {0.25, 0.6}, "m"))
                     ->excludes(incline)
                     ->excludes(stride);
  command
      .add_option("--arrive", options.arrive,
                  "X,Y where the root shall be in the last frame: the walk is turned about where "
                  "it begins, its stride scaled")
      ->check(twoNumbers({-1e4, 1e4}, {-1e4, 1e4}, "m"))
      ->excludes(stride)
      ->excludes(stairs);
  command.add_flag("--footlock", options.foot_lock,
                   "Hold planted feet; alone, those of any motion");
}

}  // namespace

void addEdit(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<EditArguments>();
  CLI::App* command = app.add_subcommand(
      "edit", "Change a captured walk: stride, lift, slope, stairs, arrival; hold planted feet");
  command->add_option("CLIP", options->in, "The capture; - is a BVH on standard input")
      ->type_name("FILE")
      ->required();
  addMotionOutput(*command, options->out);
  addEdits(*command, *options);
  addReadOptions(*command, options->read);
  command->add_flag("--json", options->json, "Print what was asked and achieved, for machines");
  addExamples(*command, {"amble edit walk.bvh -o longer.bvh --stride 1.2x --footlock",
                         "amble edit walk.bvh -o faster.bvh --stride 0.5..0.8 --lift 1.5x",
                         "amble edit walk.bvh -o stairs.bvh --stairs .17,.29 --footlock",
                         "amble edit walk.bvh -o there.bvh --arrive 4,1.5"});
  addExitStatus(*command, "the walk is there",
                "legs are too short for what is asked, or there is none such");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace amble
