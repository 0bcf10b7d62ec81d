#include "app/library_add.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "animation/preparation/motion_library_add.h"
#include "app/read_options.h"
#include "base/rotation.h"

namespace amble {
namespace {

struct Options {
  std::string library;
  std::vector<std::string> clips;
  std::string name, kind = "walk", turning, licence = "unknown", credit = "unknown";
  std::vector<std::string> chains;
  std::vector<int> frames;
  bool no_mirror = false;
  ReadOptions read;
};

// What is made of one clip: the motion, and the walk's mirror image.
std::vector<MotionRequest> requestsOf(const std::filesystem::path& clip, const Options& options) {
  MotionRequest request;
  request.name = options.name.empty() ? clip.stem().string() : options.name;
  const auto& kinds = motionKindNames();
  request.kind =
      static_cast<MotionKind>(std::find(kinds.begin(), kinds.end(), options.kind) - kinds.begin());
  if (!options.turning.empty()) request.turning = options.turning == "turn";
  request.chains = options.chains;
  request.file = clip;
  request.read = options.read.forReader();
  request.source.clip = clip.filename().string();
  request.source.licence = options.licence;
  request.source.credit = options.credit;
  if (options.frames.size() == 2) request.frames = {options.frames[0], options.frames[1]};
  std::vector<MotionRequest> requests = {request};
  if (request.kind == MotionKind::kWalk && !options.no_mirror) {
    request.name += "-mirrored";
    request.source.mirrored = true;
    requests.push_back(request);
  }
  return requests;
}

void sayAdded(const Motion& motion) {
  const std::string& kind = motionKindNames()[static_cast<size_t>(motion.kind)];
  if (motion.kind != MotionKind::kWalk) {
    fmt::print(stderr, "  {}: {}, frames {} to {}\n", motion.name, kind, motion.source.frames[0],
               motion.source.frames[1]);
    return;
  }
  const WalkCycle& cycle = motion.cycle;
  fmt::print(stderr,
             "  {}: {} walk, {:.2f} m/s, {:+.0f} degrees/s, mean of {} cycles in frames {} to {}, "
             "closed to {:.0f} mm, {} harmonics leave out {:.2f} degrees\n",
             motion.name, motion.turning ? "turning" : "straight", cycle.speed,
             cycle.turn_rate / kDegree, cycle.cycles, motion.source.frames[0],
             motion.source.frames[1], 1000.0 * cycle.closure, cycle.series.harmonics(),
             cycle.residual / kDegree);
}

int run(const Options& options) {
  const std::filesystem::path file = options.library;
  MotionLibrary library;
  if (std::filesystem::exists(file)) {
    library = readMotionLibrary(file);
  } else {
    library.file = file;
    library.skeleton_file = file.stem().string() + ".bvh";
  }
  for (const std::string& clip : options.clips) {
    for (const MotionRequest& request : requestsOf(clip, options)) {
      addMotion(library, request);
      sayAdded(library.motions.back());
    }
  }
  writeMotionLibrary(library, file);
  fmt::print(stderr, "{}: {} motions\n", file.string(), library.motions.size());
  return kExitDone;
}

}  // namespace

void addLibraryAdd(CLI::App& library, Command& chosen) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = library.add_subcommand(
      "add", "Add motions of captures to a library; where there is none it is made");
  command->add_option("LIBRARY", options->library, "Library file (YAML)")->required();
  command->add_option("CLIP", options->clips, "Captures: BVH, AMC, FBX, glTF, Collada")->required();
  command->add_option("--name", options->name, "Of the motion; default: the clip's");
  command->add_option("--kind", options->kind, "What it is")
      ->check(CLI::IsMember(motionKindNames()))
      ->capture_default_str();
  command->add_option("--turning", options->turning, "Of a walk; default: as it is found")
      ->check(CLI::IsMember({"straight", "turn"}));
  command->add_option("--joints", options->chains, "Chains that a movement or posture moves: all")
      ->delimiter(',')
      ->check(CLI::IsMember({"left_arm", "right_arm", "trunk", "head", "left_leg", "right_leg"}));
  command->add_option("--frames", options->frames, "First and last frame to look at; default: all")
      ->expected(2);
  command->add_flag("--no-mirror", options->no_mirror, "Leave out a walk's mirror image");
  command->add_option("--licence", options->licence, "Of the capture")->capture_default_str();
  command->add_option("--credit", options->credit, "Of the capture")->capture_default_str();
  addReadOptions(*command, options->read);
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace amble
