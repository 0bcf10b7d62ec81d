/// Which of Amble's own files one is, told by its keys or by how it begins: for commands that take
/// some of them and are given another.
#pragma once

#include <filesystem>
#include <string>

namespace amble {

class YamlNode;  // strict_yaml.h

enum class OwnFile {
  kNone,  ///< another's
  kScene,
  kScenario,
  kLibrary,
  kEngine,
  kBatchJob,
  kGraph,
  kRoadmap
};

/// By the keys of a YAML file.
OwnFile ownFileOf(const YamlNode& root);
/// By its first bytes: a cluster graph or a kept roadmap.
OwnFile ownFileAt(const std::filesystem::path& file);

/// "a scenario, which `amble plan` takes".
std::string describeOwnFile(OwnFile kind);

}  // namespace amble
