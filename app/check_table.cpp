#include "app/check_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/say.h"
#include "base/error.h"
#include "scenarios/find_scenarios.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFigureWidth = 11;  // [characters]

std::string cell(const std::string& text) { return fmt::format("{:>{}}", text, kFigureWidth); }

// " (+12 %)"; times by the clock are never the same, so little of it is left out.
std::string timeChange(const CheckRow& row) {
  constexpr double kNoticed = 0.1;  // [s]
  if (!row.accepted || row.run.status.empty()) return "";
  const RunFigures& before = row.accepted->figures;
  if (std::abs(row.run.planning_time - before.planning_time) < kNoticed) return "";
  const std::string change = kFigures.back().change(before, row.run);
  return change.empty() ? "" : fmt::format(" ({})", change);
}

std::string figuresLine(const RunFigures& figures) {
  std::string line;
  for (const RunFigure& figure : kFigures) {
    const bool shown = !figure.of_walk || figures.hasWalk();
    line += cell(shown ? fmt::format("{} {}", figure.text(figures), figure.unit) : "");
  }
  return line;
}

Json figuresJson(const RunFigures& figures) {
  return {{"status", figures.status},
          {"length", figures.length},
          {"duration", figures.duration},
          {"clearance", figures.clearance},
          {"foot_skate", figures.foot_skate},
          {"planning_time", figures.planning_time},
          {"bvh_sha256", figures.hasWalk() ? Json(figures.bvh_sha256) : Json(nullptr)}};
}

Json rowJson(const CheckRow& row) {
  Json json = {{"file", row.file.string()},
               {"scenario", row.scenario},
               {"verdict", verdictName(row.verdict)},
               {"notes", row.notes}};
  json.update(figuresJson(row.run));
  if (!row.why.empty()) json["why"] = row.why;
  json["accepted"] = row.accepted ? figuresJson(row.accepted->figures) : Json(nullptr);
  json["changes"] = row.changes.empty() ? Json(nullptr) : Json(row.changes);
  json["total_time"] = row.total_time;
  json["updated"] = row.updated;
  return json;
}

}  // namespace

CheckTable::CheckTable(const std::vector<ScenarioFile>& files) {
  size_t width = width_;
  for (const ScenarioFile& file : files) {
    const std::string name = scenarioName(file.file);
    width = std::max(width, name.size());
    try {
      for (const ScenarioQuery& query : readScenario(file).queries)
        width = std::max(width, name.size() + 1 + query.name.size());
    } catch (const InputError&) {  // its row will tell
    }
  }
  width_ = static_cast<int>(width);
}

void CheckTable::printHead() const {
  std::string figures;
  for (const RunFigure& figure : kFigures) figures += cell(figure.name);
  say(stdout, "{:<8} {:<{}}  {:<13}{}\n", "", "scenario", width_, "status", figures);
}

void CheckTable::printRow(const CheckRow& row) const {
  const std::string figures = row.run.status.empty() ? "" : figuresLine(row.run);
  say(stdout, "{:<8} {:<{}}  {:<13}{}{}{}\n", verdictName(row.verdict), row.scenario, width_,
      row.run.status, figures, timeChange(row), row.updated ? "  (updated)" : "");
  if (!row.changes.empty()) printChanges(row);
  for (const std::string& note : row.notes) say(stdout, "{:9}{}\n", "", note);
  std::fflush(stdout);
}

void CheckTable::printChanges(const CheckRow& row) const {
  const RunFigures& before = row.accepted->figures;
  std::string line;
  for (const RunFigure& figure : kFigures) {
    if (!figure.of_walk) continue;
    line += cell(before.hasWalk() && row.run.hasWalk() ? figure.change(before, row.run) : "");
  }
  line.erase(line.find_last_not_of(' ') + 1);
  const std::string status = before.status != row.run.status ? "was " + before.status : "";
  if (line.empty() && status.empty()) {
    say(stdout, "{:9}{}\n", "", row.changes);
  } else {
    say(stdout, "{:9}{:<{}}  {:<13}{}\n", "", "  since accepted", width_, status, line);
  }
}

void printCheckSummary(const std::vector<CheckRow>& rows) {
  const auto count = [&](CheckVerdict verdict) {
    return std::count_if(rows.begin(), rows.end(),
                         [&](const CheckRow& row) { return row.verdict == verdict; });
  };
  const auto stopped = count(CheckVerdict::kStopped);
  const auto changed = std::count_if(rows.begin(), rows.end(),
                                     [](const CheckRow& row) { return !row.changes.empty(); });
  say(stdout, "{} scenarios: {} as expected, {} differ, {} in error, {} skipped{}{}\n", rows.size(),
      count(CheckVerdict::kHolds), count(CheckVerdict::kDiffers), count(CheckVerdict::kError),
      count(CheckVerdict::kSkipped), stopped > 0 ? fmt::format(", {} stopped", stopped) : "",
      changed > 0 ? fmt::format("; {} not as accepted", changed) : "");
}

Json checkJson(const std::vector<CheckRow>& rows) {
  Json all = Json::array();
  for (const CheckRow& row : rows) all.push_back(rowJson(row));
  return all;
}

}  // namespace amble
