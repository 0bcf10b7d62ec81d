#include "app/library_check.h"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "animation/library/motion_library_reader.h"
#include "animation/preparation/prepare_again.h"
#include "app/read_options.h"
#include "app/say.h"
#include "base/rotation.h"

namespace amble {
namespace {

struct LibraryCheckArguments {
  std::string library = "default";
  std::vector<std::string> captures;
  ReadOptions read;
};

std::string facts(const Motion& motion) {
  if (motion.kind != MotionKind::kWalk && motion.kind != MotionKind::kMovement) return "";
  return fmt::format(
      "{:.2f} m/s {:+.0f} degrees/s, closes to {:.0f} mm, leaves out {:.2f} degrees, "
      "feet slide {:.0f} mm",
      motion.cycle.speed, motion.cycle.turn_rate / kDegree, 1000.0 * motion.cycle.closure,
      motion.cycle.residual / kDegree, 1000.0 * motion.cycle.slide);
}

int run(const LibraryCheckArguments& options) {
  const MotionLibrary library = readMotionLibrary(motionLibraryFile(options.library));
  LibraryCaptures captures;
  captures.folders.assign(options.captures.begin(), options.captures.end());
  captures.read = options.read.forReader();
  int wrong = 0;
  for (const Motion& motion : library.motions) {
    const std::string problem =
        options.captures.empty() ? "" : problemOf(library, motion, captures);
    if (!problem.empty()) ++wrong;
    say(stdout, "{:<6} {:<26} {:<12} {}\n", problem.empty() ? "ok" : "WRONG", motion.name,
        motionKindNames()[static_cast<size_t>(motion.kind)],
        problem.empty() ? facts(motion) : problem);
  }
  if (const MotionLack lack = whatItLacks(library); !lack.problem.empty()) {
    ++wrong;
    say(stdout, "WRONG  {}; expected {}\n", lack.problem, lack.expected);
  }
  say(stdout, "{} motions, {} wrong{}\n", library.motions.size(), wrong,
      options.captures.empty() ? "; captures were not read: give --captures DIR" : "");
  return wrong == 0 ? kExitDone : kExitNone;
}

}  // namespace

void addLibraryCheck(CLI::App& library, Command& chosen) {
  const auto options = std::make_shared<LibraryCheckArguments>();
  CLI::App* command =
      library.add_subcommand("check", "Check a library, and its motions against their captures");
  command->add_option("LIBRARY", options->library, "default, or a file")
      ->type_name("FILE")
      ->capture_default_str();
  command
      ->add_option("--captures", options->captures,
                   "Folders of the clips: prepare every motion again and compare")
      ->type_name("DIR");
  addReadOptions(*command, options->read);
  addExamples(*command, {"amble library check default"});
  addExitStatus(*command, "all hold", "some do not");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace amble
