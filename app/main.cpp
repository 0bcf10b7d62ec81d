#include <CLI/CLI.hpp>
#include <cstdio>

#include "animation/error.h"
#include "animation/version.h"

int main(int argc, char** argv) {
  CLI::App app{"Plans how a person walks through a 3D scene."};
  app.set_version_flag("--version", amble::version());
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  return 0;
}
