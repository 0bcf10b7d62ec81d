#include "app/library_add.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>

#include "animation/body/reference_pose.h"
#include "animation/library/library_parts_writer.h"
#include "animation/library/motion_library_writer.h"
#include "animation/preparation/engine_clip.h"
#include "animation/preparation/prepare_again.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "app/library_addition.h"
#include "app/read_options.h"
#include "app/say.h"
#include "base/error.h"
#include "base/rotation.h"
#include "environments/body/body.h"
#include "environments/collision/sunk_parts.h"

namespace amble {
namespace {

struct LibraryAddArguments {
  std::string library;
  std::vector<std::string> clips;
  std::string name, kind = "walk", turning, style, licence = "unknown", credit = "unknown";
  std::vector<std::string> chains;
  std::vector<int> frames;
  std::vector<double> speeds;
  std::vector<std::string> captures;
  bool no_mirror = false, mirror = false;
  ReadOptions read;
};

LibraryAddition additionOf(const LibraryAddArguments& options) {
  LibraryAddition how;
  how.name = options.name;
  const auto& kinds = motionKindNames();
  how.kind =
      static_cast<MotionKind>(std::find(kinds.begin(), kinds.end(), options.kind) - kinds.begin());
  if (!options.turning.empty()) how.turning = options.turning == "turn";
  how.style = options.style;
  how.chains = options.chains;
  if (options.frames.size() == 2) how.frames = {options.frames[0], options.frames[1]};
  how.speeds = options.speeds;
  how.mirror = options.style.empty() ? !options.no_mirror : options.mirror;
  how.licence = options.licence;
  how.credit = options.credit;
  how.read = options.read.forReader();
  return how;
}

void sayAdded(const Motion& motion) {
  const std::string& kind = motionKindNames()[static_cast<size_t>(motion.kind)];
  if (motion.kind == MotionKind::kTurnOnSpot) {
    const TurnSequence& turn = motion.turn;
    say(stderr,
        "  {}: {}, {:+.0f} degrees in {:.2f} s and {} steps, the {} foot first, feet turn by up to "
        "{:.0f} degrees against the pelvis, frames {} to {}\n",
        motion.name, kind, turn.angle / kDegree, turn.duration, turn.steps,
        turn.first == kLeft ? "left" : "right", turn.twist / kDegree, motion.source.frames[0],
        motion.source.frames[1]);
    return;
  }
  if (motion.kind != MotionKind::kWalk) {
    say(stderr, "  {}: {}, frames {} to {}\n", motion.name, kind, motion.source.frames[0],
        motion.source.frames[1]);
    return;
  }
  const WalkCycle& cycle = motion.cycle;
  const MotionSource& source = motion.source;
  say(stderr,
      "  {}: {} walk, {:.2f} m/s, {:+.0f} degrees/s, {}, closed to {:.0f} mm, {} harmonics leave "
      "out {:.2f} degrees\n",
      motion.name, motion.turning ? "turning" : "straight", cycle.speed, cycle.turn_rate / kDegree,
      source.speed ? partText(source)
                   : fmt::format("mean of {} cycles in frames {} to {}", cycle.cycles,
                                 source.frames[0], source.frames[1]),
      1000.0 * cycle.closure, cycle.series.harmonics(), cycle.residual / kDegree);
}

// What an option that says nothing of this kind is told.
void requireOf(const LibraryAddArguments& options, const std::string& option, bool meant,
               const std::string& kinds) {
  if (meant) return;
  throw InputError("amble library add: " + option, 0, "is of no " + options.kind,
                   "--kind " + kinds);
}

void requireMeaning(const LibraryAddArguments& options) {
  const MotionKind kind = additionOf(options).kind;
  if (!options.style.empty())
    requireOf(options, "--style", hasStyle(kind), "walk, start, stop or turn_on_spot");
  if (!options.turning.empty()) requireOf(options, "--turning", kind == MotionKind::kWalk, "walk");
  if (!options.chains.empty())
    requireOf(options, "--joints", hasChains(kind), "movement, posture or blocking");
  if (!options.captures.empty() && !(kind == MotionKind::kPosture && options.name == "stand")) {
    throw InputError("amble library add: --captures", 0, "is of a posture called stand",
                     "--kind posture --name stand");
  }
  if (!options.mirror) return;
  requireOf(options, "--mirror", isForBothSides(kind), "walk or turn_on_spot");
  if (!options.style.empty()) return;
  throw InputError("amble library add: --mirror", 0, "is of walks in a style",
                   "--style NAME; walks and turns without one have a mirror image anyway");
}

// Whether all else was made again: a `stand` of the person's own takes the place of a borrowed one.
bool addOrReplace(MotionLibrary& library, const MotionRequest& request,
                  const LibraryAddArguments& options, std::vector<std::string>& warnings) {
  if (!isStand(request) || !hasBorrowedStand(library)) {
    addMotion(library, request, &warnings);
    return false;
  }
  LibraryCaptures captures;
  captures.folders.assign(options.captures.begin(), options.captures.end());
  if (captures.folders.empty()) captures.folders = {request.file.parent_path()};
  captures.read = request.read;
  replaceStand(library, request, captures, &warnings);
  return true;
}

int run(const LibraryAddArguments& options) {
  requireMeaning(options);
  const std::filesystem::path file = options.library;
  MotionLibrary library = libraryAt(file);
  const LibraryAddition how = additionOf(options);
  int added = 0;
  try {
    for (const std::string& clip : options.clips) {
      for (const MotionRequest& request : requestsOf(clip, how)) {
        std::vector<std::string> warnings;
        const bool again = addOrReplace(library, request, options, warnings);
        if (!request.source.mirrored) {  // whose capture is the same
          for (const std::string& warning : warnings) say(stderr, "warning: {}\n", warning);
        }
        sayAdded(*library.find(request.name));
        if (again) say(stderr, "  the others are made again, with this stand\n");
        ++added;
      }
    }
  } catch (const InputError&) {
    if (added > 0) say(stderr, "{}: nothing is written\n", file.string());
    throw;
  }
  library.skeleton_file = skeletonNameFor(library.skeleton, library.skeleton_file, file);
  writeMotionLibrary(library, file);
  sayWritten(library, file);
  return kExitDone;
}

// Standing on level ground: what of the body is in it.
std::string sunkText(const MotionLibrary& library) {
  const FlatGround ground;
  const WalkSynthesizer synthesizer(library, ground, {});
  AnimationBuffer stood;
  synthesizer.stand({}, stood);
  const Body body = makeBody(synthesizer.skeleton(), synthesizer.roles(), synthesizer.stature(),
                             soleHeights(synthesizer.feet()),
                             {.upright = referenceOf(synthesizer.skeleton(), synthesizer.roles(),
                                                     library.stand().rotations)});
  std::string text;
  for (const SunkPart& part : sunkParts(body, synthesizer.skeleton(), stood.poses[0])) {
    text += fmt::format("{}{} by {:.0f} mm", text.empty() ? "" : ", ", part.name,
                        std::ceil(1000.0 * part.depth));
  }
  return text;
}

}  // namespace

void sayWritten(const MotionLibrary& library, const std::filesystem::path& file) {
  say(stderr, "{}: {} motions\n", file.string(), library.motions.size());
  if (const MotionLack lack = whatItLacks(library); !lack.problem.empty()) {
    say(stderr, "warning: {}: {}: nobody walks with it yet; add {}\n", file.string(), lack.problem,
        lack.expected);
    return;
  }
  if (const std::string sunk = sunkText(library); !sunk.empty()) {
    say(stderr, "warning: {}: standing, its body is in the floor: {}; no walk will begin\n",
        file.string(), sunk);
  }
}

void addLibraryAdd(CLI::App& library, Command& chosen) {
  const auto options = std::make_shared<LibraryAddArguments>();
  CLI::App* command = library.add_subcommand(
      "add", "Add motions of captures to a library; where there is none it is made");
  command->add_option("LIBRARY", options->library, "Library file (YAML)")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("CLIP", options->clips,
                   "Captures: BVH, AMC, FBX, glTF, Collada; or, with --speed, speed engines")
      ->type_name("FILE")
      ->required();
  command->add_option("--name", options->name, "Of the motion; default: the clip's")
      ->type_name("NAME");
  command->add_option("--kind", options->kind, "What it is")
      ->check(choice(motionKindNames()))
      ->capture_default_str();
  command->add_option("--turning", options->turning, "Of a walk; default: as it is found")
      ->check(choice({"straight", "turn"}));
  command->add_option("--joints", options->chains, "Chains that a movement or posture moves: all")
      ->delimiter(',')
      ->check(choice(chainNames()));
  command->add_option("--frames", options->frames, "First and last frame to look at; default: all")
      ->expected(2);
  command
      ->add_option("--speed", options->speeds,
                   "Of a speed engine: a walk at each of these speeds, as plans use it, which know "
                   "no engines [m/s]")
      ->delimiter(',')
      ->check(number(kSlowestOfEngine, 5));
  command
      ->add_option("--captures", options->captures,
                   "Of a posture called stand, in the place of a borrowed one: folders of the "
                   "clips that the library was made of; default: that of CLIP")
      ->type_name("DIR");
  command
      ->add_option("--style", options->style,
                   "In whose manner it walks: a person's name, or old-man; it is blended with none "
                   "but its like")
      ->type_name("NAME");
  command->add_flag("--mirror", options->mirror,
                    "Add the mirror image of a walk or turn on the spot in a style too");
  command
      ->add_flag("--no-mirror", options->no_mirror,
                 "Leave out the mirror image of a walk or turn on the spot")
      ->excludes("--mirror");
  command->add_option("--licence", options->licence, "Of the capture")->capture_default_str();
  command->add_option("--credit", options->credit, "Of the capture")->capture_default_str();
  addReadOptions(*command, options->read);
  addExamples(*command, {"amble library add mine.yaml captures/walk.bvh",
                         "amble library add mine.yaml anna.yaml --speed 0.6,0.8,1"});
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace amble
