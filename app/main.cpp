// The program: reads the command line, runs one command, says what is wrong in one line.

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

int runProgram(int argc, char** argv) {
  CLI::App app{"Plans how a person walks through a 3D scene.", "amble"};
  app.set_version_flag("--version", version());
  app.require_subcommand(1);
  app.footer(
      "Exit status: 0 a walk was found, all hold; 1 none was found, something differs; "
      "2 the input or the use is wrong.");
  Command chosen;
  addPlan(app, chosen);
  addCheck(app, chosen);
  addValidate(app, chosen);
  addAnimate(app, chosen);
  addAnalyse(app, chosen);
  addLibrary(app, chosen);
  addConvert(app, chosen);
  addInspect(app, chosen);
  addRoadmap(app, chosen);
  addView(app, chosen);
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
}  // namespace amble

int main(int argc, char** argv) {
  amble::prepareStandardStreams();
  try {
    const int status = amble::runProgram(argc, argv);
    std::cout.flush();
    return std::cout ? status : amble::complain("-: cannot be written; expected an open output");
  } catch (const amble::InputError& error) {
    return amble::complain(error.what());
  } catch (const amble::Stopped& stopped) {
    amble::complain(fmt::format("amble: {}", stopped.what()));
    return stopped.byTime() ? amble::kExitNone : amble::kExitStopped;
  } catch (const std::bad_alloc&) {
    return amble::complain("amble: out of memory; expected a smaller input");
  } catch (const std::exception& error) {
    return amble::complain(fmt::format("amble: {}", error.what()));
  }
}
