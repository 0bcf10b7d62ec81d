#include "scenarios/accepted_run.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <system_error>

#include "base/error.h"
#include "base/files.h"
#include "base/output_file.h"
#include "base/strict_yaml.h"
#include "base/text.h"
#include "base/version.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

constexpr FileKind kAcceptedRun = {"an accepted run (JSON)", size_t{64} << 10};
constexpr FileKind kPicture = {"a picture (PNG)", size_t{16} << 20};
constexpr double kNanometre = 1e-9;  // figures are kept to that, of a metre or a second

double rounded(double value) {
  constexpr double kPerMetre = 1e9;
  return std::round(value * kPerMetre) / kPerMetre;
}

// By their names in the file.
constexpr std::pair<const char*, double RunFigures::*> kWalkKeys[] = {
    {"length", &RunFigures::length},
    {"duration", &RunFigures::duration},
    {"clearance", &RunFigures::clearance},
    {"foot_skate", &RunFigures::foot_skate}};

RunFigures readFigures(const fs::path& file) {
  const YamlNode root = readYaml(file, kAcceptedRun);  // JSON is YAML
  root.requireKeys({"status", "length", "duration", "clearance", "foot_skate", "bvh_sha256",
                    "planning_time", "version"});
  RunFigures figures;
  figures.status = root.at("status").asString();
  figures.planning_time = root.at("planning_time").asDouble(0.0, YamlNode::kInfinity, "time [s]");
  if (!root.has("bvh_sha256")) return figures;
  figures.bvh_sha256 = root.at("bvh_sha256").asString();
  for (const auto& [key, value] : kWalkKeys) figures.*value = root.at(key).asDouble();
  return figures;
}

fs::path pictureOf(const fs::path& file) { return fs::path(file).replace_extension(".png"); }

void makeFolderOf(const fs::path& file) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) {
    throw InputError(file.parent_path().string(), 0, "cannot be made: " + error.message(),
                     "a folder that can be written");
  }
}

}  // namespace

RunFigures figuresOf(const RunResult& result) {
  const Report& report = result.report;
  return {statusName(report.status), report.length,         report.duration,
          report.clearance.min,      report.foot_skate_max, report.times.planning(),
          result.bvhDigest()};
}

std::string RunFigure::text(const RunFigures& figures) const {
  const double shown = scale * (figures.*value);
  return std::isfinite(shown) ? fixedNumber(shown, decimals) : "-";
}

std::string RunFigure::change(const RunFigures& before, const RunFigures& now) const {
  if (text(before) == text(now)) return "";
  const auto withSign = [](std::string number) {
    return number.starts_with('-') ? number : "+" + number;
  };
  const double old = before.*value, difference = now.*value - old;
  if (of_walk) return withSign(fixedNumber(scale * difference, decimals)) + " " + unit;
  return old > 0.0 ? withSign(fixedNumber(100.0 * difference / old, 0)) + " %" : "";
}

fs::path acceptedFile(const fs::path& scenario, const std::string& query) {
  // a.yaml and a.yml are two.
  const std::string name =
      (scenario.extension() == ".yaml" ? scenario.stem() : scenario.filename()).string();
  const fs::path folder = scenario.parent_path() / "accepted";
  return query.empty() ? folder / (name + ".json") : folder / name / (query + ".json");
}

std::optional<AcceptedRun> readAccepted(const fs::path& file) {
  std::error_code unknown;
  if (!fs::exists(file, unknown)) return std::nullopt;
  AcceptedRun run{readFigures(file), ""};
  if (fs::exists(pictureOf(file), unknown)) run.picture = readWholeFile(pictureOf(file), kPicture);
  return run;
}

void writeAccepted(const fs::path& file, const AcceptedRun& run) {
  const RunFigures& figures = run.figures;
  nlohmann::ordered_json json = {{"status", figures.status}};
  if (figures.hasWalk()) {
    for (const auto& [key, value] : kWalkKeys) json[key] = rounded(figures.*value);
    json["bvh_sha256"] = figures.bvh_sha256;
  }
  json["planning_time"] = rounded(figures.planning_time);
  json["version"] = version();
  makeFolderOf(file);
  std::vector<ResultFile> files;
  std::vector<fs::path> obsolete;
  if (run.picture.empty()) {
    obsolete.push_back(pictureOf(file));
  } else {
    files.push_back({pictureOf(file), [&](std::ostream& out) { out << run.picture; }});
  }
  files.push_back({file, [&](std::ostream& out) { out << json.dump(2) << '\n'; }});
  writeFiles(files, obsolete);
}

std::string changesSince(const RunFigures& accepted, const RunFigures& now) {
  if (now.status != accepted.status)
    return "status is " + now.status + "; accepted was " + accepted.status;
  std::vector<std::string> changes;
  bool differs = now.bvh_sha256 != accepted.bvh_sha256;
  for (const RunFigure& figure : kFigures) {
    if (!figure.of_walk) continue;
    differs |= std::abs(now.*figure.value - accepted.*figure.value) > kNanometre;
    const std::string before = figure.text(accepted), after = figure.text(now);
    if (before == after) continue;
    changes.push_back(std::string(figure.name) + " " + before + " -> " + after + " " + figure.unit);
  }
  if (!differs) return "";
  return "walk is not the accepted one: " +
         (changes.empty() ? "its figures are the same" : joined(changes));
}

}  // namespace amble
