// amble graft BASE UPPER -o OUT: chains of one clip on another, in step; amble graft all DIR: every
// pair of a folder's clips that goes.

#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "animation/body/joint_names.h"
#include "animation/captures/bvh.h"
#include "animation/clips/good_frames.h"
#include "app/command.h"
#include "app/frame_range.h"
#include "app/graft_all.h"
#include "app/graft_report.h"
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

struct GraftArguments {
  std::string base, upper;
  MotionOutput out;
  ReadOptions read;
  std::vector<std::string> chains = {"left_arm", "right_arm"};
  std::string range, action;
  int alternative = 0;
  double ease = -1.0;  // [s]; negative: not given
  bool cut = false, as_it_falls = false, json = false;
};

GraftWishes wishesOf(const GraftArguments& options, const Clip& base, const Clip& upper) {
  GraftWishes wishes;
  wishes.chains = options.chains;
  wishes.alternative = options.alternative;
  if (options.ease >= 0.0) wishes.ease = options.ease;
  if (options.cut) wishes.ease = 0.0;
  if (!options.range.empty())
    wishes.range = readFrameRange("amble graft: --range", options.range, '-', base);
  if (!options.action.empty())
    wishes.action = readFrameRange("amble graft: --action", options.action, '-', upper);
  return wishes;
}

void write(const GraftArguments& options, Clip clip, const JointRoles& roles) {
  if (!options.out.names.empty())
    clip.skeleton = renamed(clip.skeleton, jointNames(clip.skeleton, roles, options.out.names));
  const std::filesystem::path out = options.out.file;
  if (!options.out.isGlb()) {
    clip.joint_positions.clear();
    writeBvh(out, clip, {.metres_per_unit = options.out.bvhUnit()});
    return;
  }
  const Figure figure = capturedFigure(clip, roles);
  writeFile(out, [&](std::ostream& stream) { writeGlb(stream, clip, figure); });
}

// The frames that are grafted; what is measured is measured on them.
void cutTo(Graft& graft) {
  graft.clip = trimmed(graft.clip, graft.first, graft.last);
  graft.acceleration = largestAcceleration(jointPeaks(graft.clip.poses, graft.clip.frame_time,
                                                      graft.joints, 0, graft.clip.frames() - 1));
}

void requireUse(const GraftArguments& options) {
  const std::filesystem::path out = options.out.file;
  if (options.base.empty() || options.upper.empty()) {
    throw InputError("amble graft", 0, "two clips are needed", "BASE UPPER -o OUT, or all DIR");
  }
  if (out.empty()) throw InputError("amble graft: --output", 0, "is missing", "-o FILE");
  if (out == "-" && options.json) {
    throw InputError("amble graft: --json", 0, "prints where the motion goes", "-o FILE");
  }
  options.out.requireFormat();
  if (options.base == "-" && options.upper == "-") {
    throw InputError("-", 0, "is given twice", "one clip on standard input");
  }
}

int run(const GraftArguments& options) {
  requireUse(options);
  std::vector<std::filesystem::path> inputs = options.read.filesOf(options.base);
  for (const auto& file : options.read.filesOf(options.upper)) inputs.push_back(file);
  keepInputs(options.out.file, inputs);
  const GraftSource base = readGraftSource(options.base, options.read.forReader());
  const GraftSource upper = readGraftSource(options.upper, options.read.forReader());
  const GraftWishes wishes = wishesOf(options, base.clip.clip, upper.clip.clip);
  Grafted grafted = graftOn(base, upper, wishes, !options.as_it_falls);
  if (!grafted.plan.refusal.empty()) {
    throw InputError(options.upper, 0, grafted.plan.refusal, "two clips that the rules permit");
  }
  if (!grafted.refusal.empty()) {
    say(stderr, "{}: {}; --as-it-falls writes it all the same\n", options.upper, grafted.refusal);
    return kExitNone;
  }
  if (options.cut) cutTo(grafted.graft);
  Findings findings = describeGraft(options.out.file, base, upper, grafted, wishes);
  if (!base.clip.clip.joint_positions.empty() && !options.out.isGlb()) {
    findings.warnings.push_back("joints other than the root move; in the BVH they are fixed");
  }
  write(options, grafted.graft.clip, base.clip.roles);
  if (options.out.file != "-") printFindings({findings}, options.json);
  return kExitDone;
}

void addPairOptions(CLI::App& command, GraftArguments& options) {
  command
      .add_option("--range", options.range,
                  "Where in BASE: " + frameRangeForm('-') +
                      "; default: its longest stretch of one "
                      "type")
      ->type_name("A-B");
  command
      .add_option("--action", options.action,
                  "What of UPPER, as --range; default: its longest stretch of one type")
      ->type_name("A-B");
  command
      .add_option("--alternative", options.alternative,
                  "Which way plants are matched: 0 is the best, others are steps aside")
      ->check(wholeNumber(0, 10000))
      ->capture_default_str();
  command
      .add_option("--ease", options.ease,
                  "Time to pass over at the ends [s]; default: as long as the joints need")
      ->check(number(0.0, 10.0, "s"));
  command
      .add_flag("--cut", options.cut,
                "Write the frames that are grafted and no others; nothing passes over")
      ->excludes("--ease");
  command.add_flag("--as-it-falls", options.as_it_falls,
                   "Leave arms in the body where they get into it, and only warn");
  command.add_flag("--json", options.json, "Print results for machines");
}

}  // namespace

void addGraft(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<GraftArguments>();
  CLI::App* command = app.add_subcommand(
      "graft", "Put chains of one clip (its arms, say) on the body of another, in step with it");
  command->add_option("BASE", options->base, "The clip whose root and legs stay")
      ->type_name("FILE");
  command->add_option("UPPER", options->upper, "The clip whose chains are taken")
      ->type_name("FILE");
  command
      ->add_option("-o,--output", options->out.file,
                   "FILE.bvh, or FILE.glb with a body; - is a BVH on standard output")
      ->type_name("FILE");
  command->add_option("--bvh-units", options->out.bvh_units, "Unit of length in the BVH")
      ->check(choice({"m", "cm"}))
      ->capture_default_str();
  addNamesOption(*command, options->out.names);
  addChainsOption(*command, options->chains);
  addPairOptions(*command, *options);
  addReadOptions(*command, options->read);
  addExamples(*command, {"amble graft walk.bvh run.bvh -o arms.bvh",
                         "amble graft walk.bvh talk.bvh --chains upper --action 4s-9s -o talk.bvh",
                         "amble graft all captures -o grafts"});
  addExitStatus(*command, "a graft was written", "its arms would stay in the body");
  addGraftAll(*command, chosen);
  command->callback([command, options, &chosen] {
    if (command->get_subcommands().empty()) chosen = [options] { return run(*options); };
  });
}

}  // namespace amble
