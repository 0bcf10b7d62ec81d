/// Which files are scenarios, and whether what they need is there.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenarios/scenario.h"

namespace amble {

/// Scenarios at the paths, each read once: files as they are, folders with all below them, by name,
/// and with those YAML files that cannot be read.
/// @throws InputError for a path that is not there, a file that is no scenario, or where nothing is
/// found.
std::vector<ScenarioFile> findScenarios(const std::vector<std::filesystem::path>& paths);

/// The file's name without folder and ending; "scenario" for standard input.
std::string scenarioName(const std::filesystem::path& file);

/// Those whose name one of the patterns matches, by matchesPattern; all of them where there are no
/// patterns. @throws InputError for a pattern that matches none
std::vector<ScenarioFile> scenariosNamed(const std::vector<ScenarioFile>& files,
                                         const std::vector<std::string>& patterns);

/// What a scenario needs that lies outside of Amble's own folders and is not there (a mesh of the
/// shared captures' folder), or an empty text.
std::string missingData(const Scenario& scenario);

}  // namespace amble
