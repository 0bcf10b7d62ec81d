#include "app/own_files.h"

#include <fstream>
#include <string_view>
#include <system_error>

#include "base/strict_yaml.h"

namespace amble {

OwnFile ownFileOf(const YamlNode& root) {
  if (!root.isMap()) return OwnFile::kNone;
  if (root.has("scenes")) return OwnFile::kBatchJob;
  if (root.has("scene") || root.has("start") || root.has("queries")) return OwnFile::kScenario;
  if (root.has("motions")) return OwnFile::kLibrary;
  if (root.has("mean_posture")) return OwnFile::kEngine;
  return root.has("objects") ? OwnFile::kScene : OwnFile::kNone;
}

OwnFile ownFileAt(const std::filesystem::path& file) {
  constexpr std::string_view kGraph = "amble graph ", kRoadmap = "amble roadmap ";
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return OwnFile::kNone;
  std::string begin(kRoadmap.size(), '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if (begin.starts_with(kGraph)) return OwnFile::kGraph;
  return begin == kRoadmap ? OwnFile::kRoadmap : OwnFile::kNone;
}

std::string describeOwnFile(OwnFile kind) {
  switch (kind) {
    case OwnFile::kNone:
      return "no kind of file that Amble knows";
    case OwnFile::kScene:
      return "a scene, which scenarios name";
    case OwnFile::kScenario:
      return "a scenario, which `amble plan` takes";
    case OwnFile::kLibrary:
      return "a motion library, which `amble view` shows";
    case OwnFile::kEngine:
      return "a speed engine, which `amble animate --engine` takes";
    case OwnFile::kBatchJob:
      return "a job of many walks, which `amble batch` takes";
    case OwnFile::kGraph:
      return "a cluster graph, which `amble view` and `amble graph` take";
    case OwnFile::kRoadmap:
      return "a kept roadmap, which `amble plan --roadmap` takes";
  }
  return "";
}

}  // namespace amble
