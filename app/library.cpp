// amble library build|show|add|check|find|engine: prepared motion libraries from captures.

#include <fmt/format.h>

#include <memory>

#include "animation/library/motion_library_reader.h"
#include "animation/library/motion_library_writer.h"
#include "animation/preparation/motion_library_build.h"
#include "app/command.h"
#include "app/findings.h"
#include "app/library_add.h"
#include "app/library_addition.h"
#include "app/library_check.h"
#include "app/library_engine.h"
#include "app/library_find.h"
#include "base/error.h"
#include "base/keep_inputs.h"

namespace amble {
namespace {

// NAME.yaml for NAME.recipe.yaml.
std::filesystem::path besideRecipe(const std::filesystem::path& recipe) {
  const std::filesystem::path name = recipe.stem();
  if (name.extension() != ".recipe") {
    throw InputError(recipe.string(), 0, "does not say what to call the library",
                     "a recipe called NAME.recipe.yaml, or -o FILE");
  }
  return recipe.parent_path() / (name.stem().string() + ".yaml");
}

void addBuild(CLI::App& library, Command& chosen) {
  struct Options {
    std::string recipe, captures, out;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = library.add_subcommand(
      "build", "Prepare the motions that a recipe names from their captures");
  command->add_option("RECIPE", options->recipe, "What to take from which clip (YAML)")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("--captures", options->captures,
                   "Folder of the clips; default: the recipe's `captures:`")
      ->type_name("DIR");
  command
      ->add_option("-o,--output", options->out,
                   "Library file; default: the recipe's name without `.recipe`")
      ->type_name("FILE");
  command->callback([options, &chosen] {
    chosen = [options] {
      const std::filesystem::path out = options->out.empty() ? besideRecipe(options->recipe)
                                                             : std::filesystem::path(options->out);
      requireLibraryName(out);
      keepInputs(out, {options->recipe});
      const MotionLibrary built = buildMotionLibrary(options->recipe, options->captures);
      writeMotionLibrary(built, out);
      sayWritten(built, out);
      return kExitDone;
    };
  });
}

void addShow(CLI::App& library, Command& chosen) {
  struct Options {
    std::string name = "default";
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      library.add_subcommand("show", "Say what motions a library holds, and from where");
  command->add_option("LIBRARY", options->name, "default, or a file")
      ->type_name("FILE")
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print results for machines");
  command->callback([options, &chosen] {
    chosen = [options] {
      printFindings({inspectLibrary(motionLibraryFile(options->name))}, options->json);
      return kExitDone;
    };
  });
}

}  // namespace

void addLibrary(CLI::App& app, Command& chosen) {
  CLI::App* library = app.add_subcommand("library", "Build or show prepared motion libraries");
  library->require_subcommand(1);
  addBuild(*library, chosen);
  addShow(*library, chosen);
  addLibraryAdd(*library, chosen);
  addLibraryCheck(*library, chosen);
  addLibraryFind(*library, chosen);
  addLibraryEngine(*library, chosen);
}

}  // namespace amble
