// amble convert IN -o OUT.bvh|OUT.glb: a capture of any format as BVH or GLB, cut, resampled or
// mirrored.

#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "animation/body/joint_names.h"
#include "animation/captures/bvh.h"
#include "animation/captures/node_animation.h"
#include "animation/clips/good_frames.h"
#include "animation/clips/mirror_clip.h"
#include "animation/clips/resample_clip.h"
#include "app/command.h"
#include "app/frame_range.h"
#include "app/motion_output.h"
#include "app/read_options.h"
#include "app/say.h"
#include "base/error.h"
#include "base/keep_inputs.h"
#include "base/output_file.h"
#include "viz/exchange/glb.h"
#include "viz/figure/captured_figure.h"

namespace amble {
namespace {

struct ConvertArguments {
  std::string in;
  MotionOutput out;
  ReadOptions read;
  double fps = 0.0;  // [1/s]; 0: the file's
  std::string trim;  // A:B
  bool mirror = false;
};

Clip trimmedClip(const Clip& clip, const std::string& range) {
  const auto [first, last] = readFrameRange("amble convert: --trim", range, ':', clip);
  return trimmed(clip, first, last);
}

Clip resampledClip(const Clip& clip, double fps) {
  const double poses = clip.duration() * fps * clip.skeleton.size();
  if (poses > static_cast<double>(kMaxSampledPoses)) {
    throw InputError("amble convert: --fps", 0,
                     fmt::format("{:g} frames a second of so long a clip", fps),
                     "at most 10 million poses of joints");
  }
  return resampleClip(clip, 1.0 / fps);
}

void report(const ConvertArguments& options, const CapturedMotion& motion, const Clip& written) {
  std::FILE* const out = options.out.file == "-" ? stderr : stdout;
  Findings findings;
  addReadings(motion, findings);
  say(out, "{}: {} frames of {:.7g} s, {} joints, from {}\n", options.out.file, written.frames(),
      written.frame_time, written.skeleton.size(), options.in);
  for (const auto& [label, value] : findings.facts) say(out, "  {:<10}  {}\n", label, value);
  for (const std::string& warning : findings.warnings) say(stderr, "warning: {}\n", warning);
}

void write(const ConvertArguments& options, const Clip& clip, const JointRoles& roles) {
  const std::filesystem::path out = options.out.file;
  if (!options.out.isGlb()) {
    writeBvh(out, clip, {.metres_per_unit = options.out.bvhUnit()});
    return;
  }
  const Figure figure = capturedFigure(clip, roles);
  writeFile(out, [&](std::ostream& stream) { writeGlb(stream, clip, figure); });
}

int run(const ConvertArguments& options) {
  const std::filesystem::path out = options.out.file;
  options.out.requireFormat();
  keepInputs(out, options.read.filesOf(options.in));
  MotionReadOptions how = options.read.forReader();
  how.person = options.mirror;
  CapturedMotion motion = readMotion(options.in, how);
  if (motion.clip.frames() == 0) throw InputError(options.in, 0, "holds no frames", "a motion");
  Clip clip = options.trim.empty() ? motion.clip : trimmedClip(motion.clip, options.trim);
  if (options.fps > 0.0) clip = resampledClip(clip, options.fps);
  if (options.mirror) clip = mirrorClip(clip, motion.roles);
  if (!options.out.names.empty())
    clip.skeleton =
        renamed(clip.skeleton, jointNames(clip.skeleton, motion.roles, options.out.names));
  if (!clip.joint_positions.empty() && !options.out.isGlb()) {
    motion.warnings.push_back("joints other than the root move; in the BVH they are fixed");
    clip.joint_positions.clear();
  }
  write(options, clip, motion.roles);
  report(options, motion, clip);
  return kExitDone;
}

}  // namespace

void addConvert(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<ConvertArguments>();
  CLI::App* command = app.add_subcommand(
      "convert", "Write a capture of any format as BVH or GLB: BVH, AMC, FBX, glTF, VRMA, DAE");
  command->add_option("IN", options->in, "The capture; - is a BVH on standard input")
      ->type_name("FILE")
      ->required();
  addMotionOutput(*command, options->out);
  addReadOptions(*command, options->read);
  command->add_option("--fps", options->fps, "Frames a second; default: the file's")
      ->check(number(1, kMostFrames, "1/s"));
  command
      ->add_option("--trim", options->trim,
                   "A part of the file, first to last: " + frameRangeForm(':'))
      ->type_name("A:B");
  command->add_flag("--mirror", options->mirror, "Left is right");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace amble
