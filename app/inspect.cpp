// amble inspect FILE...: what is in a scene, clip, mesh, library or scenario; sizes, units,
// warnings.

#include <algorithm>
#include <cctype>
#include <memory>

#include "animation/strict_yaml.h"
#include "app/command.h"
#include "app/findings.h"

namespace amble {
namespace {

Findings inspectYaml(const std::filesystem::path& file) {
  const YamlNode root = readYaml(file);
  if (root.isMap()) {
    if (root.has("scene") || root.has("start")) return inspectScenario(file);
    if (root.has("motions")) return inspectLibrary(file);
    if (root.has("objects")) return inspectScene(file);
  }
  root.fail("no kind of file that Amble knows",
            "'objects:' of a scene, 'scene:' of a scenario or 'motions:' of a library");
}

Findings inspectFile(const std::filesystem::path& file) {
  std::string kind = file.extension().string();
  std::transform(kind.begin(), kind.end(), kind.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (kind == ".yaml" || kind == ".yml") return inspectYaml(file);
  if (kind == ".bvh" || file == "-") return inspectClip(file);
  for (const char* mesh : {".obj", ".gltf", ".glb", ".ply", ".stl", ".dae", ".fbx", ".ifc"}) {
    if (kind == mesh) return inspectMesh(file);
  }
  throw InputError(file.string(), 0, "no kind of file that Amble knows",
                   ".yaml, .bvh, .obj, .gltf, .glb, .ply, .stl, .dae, .fbx or .ifc");
}

}  // namespace

void addInspect(CLI::App& app, Command& chosen) {
  struct Options {
    std::vector<std::string> files;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "inspect", "Say what is in a scene, clip, mesh, library or scenario: sizes, units, warnings");
  command
      ->add_option("FILE", options->files, "YAML, BVH or mesh files; - is a BVH on standard input")
      ->required();
  command->add_flag("--json", options->json, "Print results for machines");
  command->callback([options, &chosen] {
    chosen = [options] {
      std::vector<Findings> all;
      for (const std::string& file : options->files) all.push_back(inspectFile(file));
      printFindings(all, options->json);
      return kExitDone;
    };
  });
}

}  // namespace amble
