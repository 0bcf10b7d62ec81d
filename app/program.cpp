// Reads the command line, runs one command, says what is wrong in one line.
#include "app/program.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <new>

#include "app/command.h"
#include "app/misuse.h"
#include "app/say.h"
#include "app/standard_streams.h"
#include "app/stop.h"
#include "base/error.h"
#include "base/stop_request.h"
#include "base/version.h"

namespace amble {
namespace {

int complain(const std::string& line) {
  std::cout.flush();
  say(stderr, "{}\n", line);
  return kExitWrong;
}

constexpr const char* kNoOutput = "-: cannot be written; expected an open output";

// What a person wants first, in an order in which each may use what the one before made.
constexpr const char* kDescription =
    "Plans how a person walks through a 3D scene.\n\n"
    "Examples:\n"
    "  amble plan scenarios/living-room.yaml -o out     # a walk: out/walk.html to look at it\n"
    "  amble validate out/walk.bvh --scene environments/scenes/living-room/scene.yaml\n"
    "  amble animate --speed 1.4 --turn 20 -o turn.bvh  # one without a scene\n"
    "  amble analyse turn.bvh                           # steps, speed, turn rate of any capture\n"
    "  amble inspect scenarios/living-room.yaml         # what is in a file\n"
    "  amble check scenarios/narrow-gap-070.yaml        # as it was expected, and accepted?\n"
    "  amble help plan                                  # or: amble plan --help\n";

void addCommands(CLI::App& app, Command& chosen) {
  addPlan(app, chosen);
  addCheck(app, chosen);
  addValidate(app, chosen);
  addAnimate(app, chosen);
  addAnalyse(app, chosen);
  addLibrary(app, chosen);
  addEdit(app, chosen);
  addConvert(app, chosen);
  addGraft(app, chosen);
  addInspect(app, chosen);
  addRoadmap(app, chosen);
  addGraph(app, chosen);
  addView(app, chosen);
  addBatch(app, chosen);
  addHelp(app, chosen);
  addCompletion(app, chosen);
}

// What each ends with is behind its help; most have nothing to add.
void addUsualExitStatus(CLI::App& app) {
  if (app.get_footer().find("Exit status:") == std::string::npos) addExitStatus(app, "done");
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    addUsualExitStatus(*command);
}

int runCommand(int argc, char** argv) {
  CLI::App app{kDescription, "amble"};
  app.set_help_flag("-h,--help", "Print this and exit");
  app.set_version_flag("--version", version(), "Print the version and exit");
  app.require_subcommand(1);
  Command chosen;
  addCommands(app, chosen);
  addExitStatus(app, "a walk was found, all hold", "none was found, something differs");
  addUsualExitStatus(app);
  takeOneArgumentEach(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wanted) {  // --help, --version
    return app.exit(wanted);
  } catch (const CLI::ParseError& error) {
    return complain(explainMisuse(app, error));
  }
  stopOnSignals();
  return chosen();
}

}  // namespace

int runProgram(int argc, char** argv) {
  prepareStandardStreams();
  try {
    const int status = runCommand(argc, argv);
    std::cout.flush();
    return std::cout ? status : complain(kNoOutput);
  } catch (const InputError& error) {
    return complain(error.what());
  } catch (const Stopped& stopped) {
    complain(fmt::format("amble: {}", stopped.what()));
    return stopped.byTime() ? kExitNone : kExitStopped;
  } catch (const std::bad_alloc&) {
    return complain("amble: out of memory; expected a smaller input");
  } catch (const std::exception& error) {
    return complain(std::ferror(stdout) != 0 ? kNoOutput : fmt::format("amble: {}", error.what()));
  }
}

}  // namespace amble
