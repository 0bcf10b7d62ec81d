#include "scenarios/find_scenarios.h"

#include <algorithm>
#include <optional>

#include "base/data_directory.h"
#include "base/error.h"
#include "base/strict_yaml.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

bool isYaml(const fs::path& file) {
  return file.extension() == ".yaml" || file.extension() == ".yml";
}

// The first folder on the way to a file that is not there.
fs::path firstMissing(const fs::path& file) {
  fs::path way;
  for (const fs::path& part : fs::absolute(file).lexically_normal()) {
    way /= part;
    if (!fs::exists(way)) return way;
  }
  return {};
}

bool isBelow(const fs::path& file, const fs::path& folder) {
  const fs::path way = fs::absolute(file).lexically_normal().lexically_relative(
      fs::absolute(folder).lexically_normal());
  return !way.empty() && *way.begin() != "..";
}

// The file, if it is a scenario: of a folder's files those that cannot be read or are too large are
// somebody else's.
std::optional<ScenarioFile> asScenario(const fs::path& file) {
  try {
    ScenarioFile read = readScenarioFile(file);
    if (isScenario(read)) return read;
  } catch (const InputError&) {
  }
  return std::nullopt;
}

std::vector<ScenarioFile> scenariosBelow(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied)) {
    if (entry.is_regular_file() && isYaml(entry.path())) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<ScenarioFile> found;
  for (const fs::path& file : files) {
    if (auto scenario = asScenario(file)) found.push_back(std::move(*scenario));
  }
  if (found.empty()) throw InputError(folder.string(), 0, "holds no scenario", "at least one");
  return found;
}

}  // namespace

std::vector<ScenarioFile> findScenarios(const std::vector<fs::path>& paths) {
  std::vector<ScenarioFile> found;
  for (const fs::path& path : paths) {
    if (path != "-" && !fs::exists(path)) {
      throw InputError(path.string(), 0, "is not there", "a scenario, or a folder that holds some");
    }
    if (fs::is_directory(path)) {
      for (ScenarioFile& file : scenariosBelow(path)) found.push_back(std::move(file));
      continue;
    }
    found.push_back(readScenarioFile(path));
    if (!isScenario(found.back())) {
      throw InputError(path.string(), 0, "is no scenario", "YAML with 'scene:' and 'start:'");
    }
  }
  return found;
}

std::string missingData(const Scenario& scenario) {
  const fs::path own = dataDirectory();
  if (!fs::exists(scenario.scene)) return "";  // a slip, which readers tell
  const YamlNode root = readYaml(scenario.scene);
  if (!root.isMap() || !root.has("objects") || !root.at("objects").isSequence()) return "";
  for (const YamlNode& object : root.at("objects").items()) {
    if (!object.isMap() || !object.has("mesh")) continue;
    const fs::path mesh = object.at("mesh").asPath();
    const fs::path missing = firstMissing(mesh);
    if (missing.empty() || isBelow(mesh, own) ||
        isBelow(mesh, fs::current_path() / scenario.scene.parent_path())) {
      continue;
    }
    return mesh.string();
  }
  return "";
}

}  // namespace amble
