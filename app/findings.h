/// What `amble inspect` and `amble analyse` found in a file, for people and for machines.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "animation/captures/motion_reader.h"
#include "environments/scene/scene.h"
#include "scenarios/scenario.h"

namespace amble {

struct Findings {
  std::string file;
  std::string kind;                                        ///< "scene", "clip", ...
  std::vector<std::pair<std::string, std::string>> facts;  ///< label and value, for people
  std::vector<std::string> warnings;                       ///< what is right but likely not meant
  nlohmann::ordered_json data = nlohmann::ordered_json::object();  ///< for machines
};

/// To standard output: as text, or as one JSON list.
void printFindings(const std::vector<Findings>& all, bool json);

Findings inspectScene(const std::filesystem::path& file, const LoadLimits& limits);
/// @param axes  its unit and vertical axis, as far as the file leaves them open
Findings inspectMesh(const std::filesystem::path& file, const MotionReadOptions& axes,
                     const LoadLimits& limits);
/// Nothing where a file that may hold meshes or motion holds no motion.
std::optional<Findings> inspectClip(const std::filesystem::path& file,
                                    const MotionReadOptions& options);
Findings inspectLibrary(const std::filesystem::path& file);
Findings inspectEngine(const std::filesystem::path& file);
Findings inspectScenario(const ScenarioFile& file, const LoadLimits& limits);

}  // namespace amble
