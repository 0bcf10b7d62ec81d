#include "app/result_folder.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "animation/captures/motion_reader.h"
#include "base/data_directory.h"
#include "base/error.h"
#include "base/sha256.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

// File and SHA-256 of every input, as the report has them.
std::map<std::string, std::string> inputsOf(const fs::path& report) {
  std::ifstream in(report);
  const auto json = nlohmann::json::parse(in, nullptr, false);
  const auto found = json.is_object() ? json.find("inputs") : json.end();
  if (!json.is_object() || found == json.end() || !found->is_object())
    throw InputError(report.string(), 0, "is no report", "what amble plan has written");
  std::map<std::string, std::string> inputs;
  for (const auto& [file, digest] : found->items())
    if (digest.is_string()) inputs[file] = digest;
  return inputs;
}

std::vector<fs::path> foldersToTry(const fs::path& result) {
  std::vector<fs::path> folders = {".", "scenarios", dataDirectory() / "scenarios"};
  fs::path above = fs::absolute(result).lexically_normal();
  if (!above.has_filename()) above = above.parent_path();
  for (int i = 0; i < 4 && above.has_relative_path(); ++i, above = above.parent_path()) {
    folders.push_back(above);
    folders.push_back(above / "scenarios");
  }
  return folders;
}

bool isIt(const fs::path& file, const std::string& digest) {
  std::error_code unknown;
  return fs::is_regular_file(file, unknown) && sha256OfFile(file) == digest;
}

// Whether the file begins its list of objects somewhere, as a scene does and no scenario or
// library.
bool hasObjects(const fs::path& file) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("objects:")) return true;
  return false;
}

bool holdsMotion(const fs::path& folder) {
  std::error_code unknown;
  for (const auto& entry : fs::recursive_directory_iterator(folder, unknown))
    if (entry.is_regular_file(unknown) && isMotionFile(entry.path())) return true;
  return false;
}

}  // namespace

bool isResultFolder(const fs::path& folder) {
  std::error_code unknown;
  return fs::is_regular_file(folder / "walk.bvh", unknown) &&
         fs::is_regular_file(folder / "report.json", unknown);
}

std::optional<fs::path> pageOfResult(const fs::path& folder) {
  std::error_code unknown;
  const fs::path page = folder / "walk.html";
  if (!fs::is_regular_file(page, unknown) || !fs::is_regular_file(folder / "report.json", unknown))
    return std::nullopt;
  return page;
}

std::optional<fs::path> onlyResultIn(const fs::path& folder) {
  std::error_code unknown;
  std::optional<fs::path> only;
  for (const auto& entry : fs::directory_iterator(folder, unknown)) {
    const bool is_folder = entry.is_directory(unknown);
    if (is_folder && (isResultFolder(entry.path()) || pageOfResult(entry.path()))) {
      if (only) return std::nullopt;
      only = entry.path();
    } else if (is_folder ? holdsMotion(entry.path()) : isMotionFile(entry.path())) {
      return std::nullopt;
    }
  }
  return only;
}

fs::path sceneOfResult(const fs::path& folder) {
  const fs::path report = folder / "report.json";
  const auto inputs = inputsOf(report);
  for (const fs::path& base : foldersToTry(folder)) {
    for (const auto& [name, digest] : inputs) {
      const fs::path file = base / name;
      if ((file.extension() == ".yaml" || file.extension() == ".yml") && isIt(file, digest) &&
          hasObjects(file))
        return file.lexically_normal();
    }
  }
  throw InputError(report.string(), 0, "its scene is found nowhere", "--scene FILE");
}

}  // namespace amble
