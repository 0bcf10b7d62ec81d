#include "scenarios/find_scenarios.h"

#include <algorithm>
#include <optional>
#include <system_error>

#include "base/data_directory.h"
#include "base/error.h"
#include "base/strict_yaml.h"
#include "environments/scene/scene.h"

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

// The file, if it is a scenario: of a folder's files those that are none or too large are somebody
// else's. One that cannot be read may be a scenario, which must be heard of.
std::optional<ScenarioFile> asScenario(const fs::path& file) {
  std::error_code unknown;
  const auto size = fs::file_size(file, unknown);
  if (!unknown && size > kMaxScenario) return std::nullopt;
  try {
    ScenarioFile read = readScenarioFile(file);
    if (isScenario(read)) return read;
  } catch (const InputError& error) {
    return ScenarioFile{file, "", error.problem()};
  }
  return std::nullopt;
}

// A file, or what cannot be told from one: a link that leads back to itself, a closed folder's.
// Links that lead nowhere are none: editors mark files with them.
bool mayBeFile(const fs::directory_entry& entry) {
  std::error_code error;
  const bool file = entry.is_regular_file(error);
  return file || (error && error != std::errc::no_such_file_or_directory);
}

std::vector<ScenarioFile> scenariosBelow(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied)) {
    if (isYaml(entry.path()) && mayBeFile(entry)) files.push_back(entry.path());
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
    std::error_code error;
    if (path != "-" && !fs::exists(path, error)) {
      throw InputError(path.string(), 0, "is not there", "a scenario, or a folder that holds some");
    }
    if (fs::is_directory(path, error)) {
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

std::string scenarioName(const fs::path& file) {
  return file == "-" ? "scenario" : file.stem().string();
}

std::vector<ScenarioFile> scenariosNamed(const std::vector<ScenarioFile>& files,
                                         const std::vector<std::string>& patterns) {
  if (patterns.empty()) return files;
  std::vector<std::string> names;
  for (const ScenarioFile& file : files) names.push_back(scenarioName(file.file));
  std::vector<bool> wanted(files.size());
  for (const std::string& pattern : patterns) {
    bool matched = false;
    for (size_t i = 0; i < files.size(); ++i) {
      if (!matchesPattern(pattern, names[i])) continue;
      matched = wanted[i] = true;
    }
    if (matched) continue;
    const std::string meant = nearestWord(pattern, names);
    throw InputError(pattern, 0, "matches no scenario's name",
                     meant.empty() ? "a name, or a pattern with * and ?" : "'" + meant + "'");
  }
  std::vector<ScenarioFile> named;
  for (size_t i = 0; i < files.size(); ++i)
    if (wanted[i]) named.push_back(files[i]);
  return named;
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
