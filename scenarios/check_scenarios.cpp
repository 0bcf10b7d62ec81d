#include "scenarios/check_scenarios.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "base/data_directory.h"
#include "base/error.h"
#include "base/output_file.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

std::string decimals(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string over(const char* what, double value, double bar, const char* unit) {
  return std::string(what) + " is " + decimals(value) + " " + unit + "; expected at most " +
         decimals(bar);
}

std::string readText(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

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

CheckRow runOne(const fs::path& file, const CheckOptions& options) {
  CheckRow row;
  row.file = file;
  row.scenario = file.stem().string();
  const Scenario scenario = readScenario(file);
  if (const std::string missing = missingData(scenario); !missing.empty()) {
    row.verdict = CheckVerdict::kSkipped;
    row.notes.push_back("'" + missing + "' is not there");
    return row;
  }
  const RunResult result = runScenario(scenario, options.run);
  const Report& report = result.report;
  row.status = statusName(report.status);
  row.length = report.length;
  row.clearance = report.clearance.min;
  row.foot_skate = report.foot_skate_max;
  row.planning_time = report.times.planning();
  Expectation expect = scenario.expect.value_or(Expectation{});
  if (options.update && report.status == PlanStatus::kSolved) {
    const std::string digest = result.bvhDigest();
    if (expect.bvh_sha256 != digest) {
      const std::string text = withDigest(readText(file), file.string(), digest);
      writeFile(file, [&](std::ostream& out) { out << text; });
      row.updated = true;
    }
    expect.bvh_sha256 = digest;
  }
  row.notes = differences(expect, result, options.judge_times);
  if (!row.notes.empty()) row.verdict = CheckVerdict::kDiffers;
  return row;
}

std::string xmlText(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '&':
        escaped += "&amp;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return escaped;
}

std::string joined(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += (text.empty() ? "" : "; ") + note;
  return text;
}

std::string seconds(double time) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3f", time);
  return text;
}

}  // namespace

std::string verdictName(CheckVerdict verdict) {
  switch (verdict) {
    case CheckVerdict::kHolds:
      return "ok";
    case CheckVerdict::kDiffers:
      return "differs";
    case CheckVerdict::kSkipped:
      return "skipped";
    case CheckVerdict::kError:
      return "error";
  }
  return "";
}

std::vector<fs::path> findScenarios(const std::vector<fs::path>& paths) {
  std::vector<fs::path> found;
  for (const fs::path& path : paths) {
    if (!fs::exists(path)) {
      throw InputError(path.string(), 0, "is not there", "a scenario, or a folder that holds some");
    }
    if (!fs::is_directory(path)) {
      if (!isScenario(path)) {
        throw InputError(path.string(), 0, "is no scenario", "YAML with 'scene:' and 'start:'");
      }
      found.push_back(path);
      continue;
    }
    std::vector<fs::path> here;
    for (const auto& entry :
         fs::recursive_directory_iterator(path, fs::directory_options::skip_permission_denied)) {
      if (entry.is_regular_file() && isYaml(entry.path()) && isScenario(entry.path())) {
        here.push_back(entry.path());
      }
    }
    if (here.empty()) throw InputError(path.string(), 0, "holds no scenario", "at least one");
    std::sort(here.begin(), here.end());
    found.insert(found.end(), here.begin(), here.end());
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

std::vector<std::string> differences(const Expectation& expect, const RunResult& result,
                                     bool judge_times) {
  const Report& report = result.report;
  std::vector<std::string> notes;
  if (expect.status && *expect.status != report.status) {
    notes.push_back("status is " + statusName(report.status) + "; expected " +
                    statusName(*expect.status) +
                    (report.why.empty() ? "" : " (" + report.why + ")"));
  }
  if (judge_times && expect.max_planning_time &&
      report.times.planning() > *expect.max_planning_time) {
    notes.push_back(over("planning time", report.times.planning(), *expect.max_planning_time, "s"));
  }
  if (report.status != PlanStatus::kSolved) {
    if (expect.bvh_sha256 && !expect.status) notes.push_back("there is no walk; expected one");
    return notes;
  }
  if (expect.max_length && report.length > *expect.max_length) {
    notes.push_back(over("length", report.length, *expect.max_length, "m"));
  }
  if (expect.min_clearance && report.clearance.min < *expect.min_clearance) {
    notes.push_back("clearance is " + decimals(report.clearance.min) + " m; expected at least " +
                    decimals(*expect.min_clearance));
  }
  if (expect.max_foot_skate && report.foot_skate_max > *expect.max_foot_skate) {
    notes.push_back(over("foot skate", report.foot_skate_max, *expect.max_foot_skate, "m"));
  }
  if (expect.bvh_sha256 && *expect.bvh_sha256 != result.bvhDigest()) {
    notes.push_back("SHA-256 of walk.bvh is " + result.bvhDigest() + "; expected " +
                    *expect.bvh_sha256);
  }
  return notes;
}

std::vector<CheckRow> checkScenarios(const std::vector<fs::path>& paths,
                                     const CheckOptions& options) {
  const std::vector<fs::path> files = findScenarios(paths);
  std::vector<CheckRow> rows;
  for (size_t i = 0; i < files.size(); ++i) {
    if (options.run.stop != nullptr && options.run.stop->load()) break;
    if (options.started) {
      options.started(files[i], static_cast<int>(i), static_cast<int>(files.size()));
    }
    const auto begin = std::chrono::steady_clock::now();
    CheckRow row;
    try {
      row = runOne(files[i], options);
    } catch (const InputError& error) {
      row.file = files[i];
      row.scenario = files[i].stem().string();
      row.verdict = CheckVerdict::kError;
      row.notes = {error.what()};
    }
    row.total_time =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    rows.push_back(row);
    if (options.finished) options.finished(rows.back());
  }
  return rows;
}

bool allHold(const std::vector<CheckRow>& rows) {
  return std::all_of(rows.begin(), rows.end(), [](const CheckRow& row) {
    return row.verdict == CheckVerdict::kHolds || row.verdict == CheckVerdict::kSkipped;
  });
}

void writeJUnit(std::ostream& out, const std::vector<CheckRow>& rows) {
  const auto count = [&](CheckVerdict verdict) {
    return std::count_if(rows.begin(), rows.end(),
                         [&](const CheckRow& row) { return row.verdict == verdict; });
  };
  double time = 0.0;
  for (const CheckRow& row : rows) time += row.total_time;
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
      << "  <testsuite name=\"amble check\" tests=\"" << rows.size() << "\" failures=\""
      << count(CheckVerdict::kDiffers) << "\" errors=\"" << count(CheckVerdict::kError)
      << "\" skipped=\"" << count(CheckVerdict::kSkipped) << "\" time=\"" << seconds(time)
      << "\">\n";
  for (const CheckRow& row : rows) {
    out << "    <testcase classname=\"" << xmlText(row.file.parent_path().generic_string())
        << "\" name=\"" << xmlText(row.scenario) << "\" time=\"" << seconds(row.total_time) << "\"";
    if (row.verdict == CheckVerdict::kHolds) {
      out << "/>\n";
      continue;
    }
    const char* element = row.verdict == CheckVerdict::kDiffers   ? "failure"
                          : row.verdict == CheckVerdict::kSkipped ? "skipped"
                                                                  : "error";
    out << ">\n      <" << element << " message=\"" << xmlText(joined(row.notes))
        << "\"/>\n    </testcase>\n";
  }
  out << "  </testsuite>\n</testsuites>\n";
}

}  // namespace amble
