// amble inspect FILE...: what is in a scene, clip, mesh, library or scenario; sizes, units,
// warnings.

#include <algorithm>
#include <iterator>
#include <memory>

#include "animation/captures/capture_file.h"
#include "app/command.h"
#include "app/findings.h"
#include "app/own_files.h"
#include "app/read_options.h"
#include "app/stop.h"
#include "base/strict_yaml.h"

namespace amble {
namespace {

Findings inspectYaml(const std::filesystem::path& file, const LoadLimits& limits) {
  const std::string text = readWholeFile(file, kAnyYaml);
  const YamlNode root = parseYaml(text, file.string());
  switch (const OwnFile kind = ownFileOf(root)) {
    case OwnFile::kScenario:
      return inspectScenario({file, text}, limits);
    case OwnFile::kLibrary:
      return inspectLibrary(file);
    case OwnFile::kEngine:
      return inspectEngine(file);
    case OwnFile::kScene:
      return inspectScene(file, limits);
    default:
      root.fail((kind == OwnFile::kNone ? "" : "is ") + describeOwnFile(kind),
                "'objects:' of a scene, 'scene:' of a scenario or 'motions:' of a library");
  }
}

Findings inspectFile(const std::filesystem::path& file, const MotionReadOptions& options,
                     const LoadLimits& limits) {
  const std::string kind = lowerEnding(file);
  if (kind == ".yaml" || kind == ".yml") return inspectYaml(file, limits);
  const char* const meshes[] = {".obj", ".gltf", ".glb", ".ply", ".stl", ".dae", ".fbx", ".ifc"};
  const bool mesh = std::find(std::begin(meshes), std::end(meshes), kind) != std::end(meshes);
  // Some formats hold meshes, motion or both.
  if (isMotionFile(file)) {
    std::optional<Findings> clip = inspectClip(file, options);
    if (clip || !mesh) return clip.value();
  }
  if (mesh) return inspectMesh(file, options, limits);
  if (kind == ".asf") {
    throw InputError(file.string(), 0, "is a skeleton without motion",
                     "the .amc file of a motion of it");
  }
  const OwnFile own = ownFileAt(file);
  throw InputError(file.string(), 0, (own == OwnFile::kNone ? "" : "is ") + describeOwnFile(own),
                   ".yaml, .bvh, .amc, .obj, .gltf, .glb, .vrma, .ply, .stl, .dae, .fbx or .ifc");
}

}  // namespace

void addInspect(CLI::App& app, Command& chosen) {
  struct Options {
    std::vector<std::string> files;
    ReadOptions read;
    LoadLimits limits;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "inspect", "Say what is in a scene, clip, mesh, library or scenario: sizes, units, warnings");
  command
      ->add_option("FILE", options->files,
                   "YAML, captures or mesh files; - is a BVH on standard input")
      ->type_name("FILE")
      ->required();
  addReadOptions(*command, options->read);
  command->add_flag("--json", options->json, "Print results for machines");
  addExamples(*command, {"amble inspect scenarios/living-room.yaml",
                         "amble inspect environments/scenes/living-room/scene.yaml --json"});
  command->callback([options, &chosen] {
    chosen = [options] {
      options->limits.stop.flag = &stopFlag();
      options->limits.memory = options->read.memory;
      std::vector<Findings> all;
      for (const std::string& file : options->files) {
        all.push_back(inspectFile(file, options->read.forReader(), options->limits));
      }
      printFindings(all, options->json);
      return kExitDone;
    };
  });
}

}  // namespace amble
