// amble library engine build|show: walking engines of one person, from captures at many speeds.

#include "app/library_engine.h"

#include <fmt/format.h>

#include <memory>

#include "animation/library/library_parts_writer.h"
#include "animation/library/speed_engine_reader.h"
#include "animation/library/speed_engine_writer.h"
#include "animation/preparation/speed_engine_fit.h"
#include "app/clip_sources.h"
#include "app/findings.h"
#include "app/read_options.h"
#include "app/say.h"
#include "base/error.h"
#include "base/keep_inputs.h"

namespace amble {
namespace {

struct BuildArguments {
  std::vector<std::string> clips;
  std::string out, licence = "unknown", credit = "unknown";
  double variance = 0.8;
  ReadOptions read;
};

EngineRequest requestOf(const BuildArguments& options) {
  EngineRequest request;
  request.variance = options.variance;
  for (const std::filesystem::path& clip : findClips(options.clips)) {
    request.captures.push_back({clip, options.read.forReader(), clip.filename().string(),
                                options.licence.empty() ? "unknown" : options.licence,
                                options.credit.empty() ? "unknown" : options.credit});
  }
  return request;
}

int build(const BuildArguments& options) {
  const std::filesystem::path out = options.out;
  if (out.extension() != ".yaml" && out.extension() != ".yml") {
    throw InputError(options.out, 0, "is no name of an engine", "NAME.yaml");
  }
  const EngineRequest request = requestOf(options);
  for (const EngineCapture& capture : request.captures) {
    keepInputs(out, options.read.filesOf(capture.file));
  }
  std::vector<std::string> warnings;
  EngineData engine = fitSpeedEngine(request, &warnings);
  engine.skeleton_file = skeletonNameBeside(out);
  writeSpeedEngine(engine, out);
  for (const std::string& warning : warnings) say(stderr, "warning: {}\n", warning);
  printFindings({inspectEngine(out)}, false);
  return kExitDone;
}

void addEngineBuild(CLI::App& engine, Command& chosen) {
  const auto options = std::make_shared<BuildArguments>();
  CLI::App* command = engine.add_subcommand(
      "build", "Fit an engine to captures of one person: walks at many speeds, runs, standing");
  command
      ->add_option("CLIP", options->clips,
                   "Captures, and folders of them: BVH, AMC, FBX, glTF, Collada")
      ->type_name("FILE")
      ->required();
  command->add_option("-o,--output", options->out, "Engine file (YAML)")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("--variance", options->variance,
                   "Share of the cycles' variance that the principal components keep at least")
      ->check(number(0, 1))
      ->capture_default_str();
  command->add_option("--licence", options->licence, "Of the captures")->capture_default_str();
  command->add_option("--credit", options->credit, "Of the captures")->capture_default_str();
  addReadOptions(*command, options->read);
  addExamples(*command, {"amble library engine build captures/07_*.bvh -o anna.yaml"});
  addExitStatus(*command, "the engine is there");
  command->callback([options, &chosen] { chosen = [options] { return build(*options); }; });
}

void addEngineShow(CLI::App& engine, Command& chosen) {
  struct Options {
    std::string file;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = engine.add_subcommand(
      "show", "Say what an engine was fitted to, how well, and how fast it goes");
  command->add_option("ENGINE", options->file, "Engine file")->type_name("FILE")->required();
  command->add_flag("--json", options->json, "Print results for machines");
  command->callback([options, &chosen] {
    chosen = [options] {
      printFindings({inspectEngine(options->file)}, options->json);
      return kExitDone;
    };
  });
}

}  // namespace

void addLibraryEngine(CLI::App& library, Command& chosen) {
  CLI::App* engine = library.add_subcommand(
      "engine", "Build or show walking engines, which walk at any speed of one person");
  engine->require_subcommand(1);
  addEngineBuild(*engine, chosen);
  addEngineShow(*engine, chosen);
}

}  // namespace amble
