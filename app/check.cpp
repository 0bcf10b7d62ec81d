// amble check PATH...: every scenario found there, compared with what it expects.

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/progress.h"
#include "app/say.h"
#include "app/stop.h"
#include "base/error.h"
#include "base/keep_inputs.h"
#include "base/output_file.h"
#include "base/parallel.h"
#include "scenarios/check_junit.h"
#include "scenarios/check_scenarios.h"
#include "scenarios/find_scenarios.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::vector<std::string> paths;
  std::string junit;
  bool update = false, judge_times = false, json = false;
  int threads = 0;
  size_t memory = GuardLimits{}.memory;  // [bytes]
};

void printRow(const CheckRow& row, int width) {
  std::string text = fmt::format("{:<8} {:<{}}  {:<13}", verdictName(row.verdict), row.scenario,
                                 width, row.status);
  if (row.length > 0.0) {
    text += fmt::format(" {:6.2f} m {:7.3f} m {:6.1f} mm", row.length, row.clearance,
                        1000.0 * row.foot_skate);
  } else {
    text += fmt::format("{:29}", "");
  }
  text += row.status.empty() ? "" : fmt::format(" {:7.2f} s", row.planning_time);
  say(stdout, "{}{}\n", text, row.updated ? "  (updated)" : "");
  for (const std::string& note : row.notes) say(stdout, "{:9}{}\n", "", note);
  std::fflush(stdout);
}

Json rowJson(const CheckRow& row) {
  return {{"file", row.file.string()},
          {"scenario", row.scenario},
          {"verdict", verdictName(row.verdict)},
          {"notes", row.notes},
          {"status", row.status},
          {"length", row.length},
          {"clearance", row.clearance},
          {"foot_skate", row.foot_skate},
          {"planning_time", row.planning_time},
          {"total_time", row.total_time},
          {"updated", row.updated}};
}

void printSummary(const std::vector<CheckRow>& rows) {
  const auto count = [&](CheckVerdict verdict) {
    return std::count_if(rows.begin(), rows.end(),
                         [&](const CheckRow& row) { return row.verdict == verdict; });
  };
  const auto stopped = count(CheckVerdict::kStopped);
  say(stdout, "{} scenarios: {} as expected, {} differ, {} in error, {} skipped{}\n", rows.size(),
      count(CheckVerdict::kHolds), count(CheckVerdict::kDiffers), count(CheckVerdict::kError),
      count(CheckVerdict::kSkipped),
      stopped > 0 ? fmt::format(", {} stopped", stopped) : std::string());
}

int statusOf(const std::vector<CheckRow>& rows) {
  if (stopFlag()) return kExitStopped;
  for (const CheckRow& row : rows) {
    if (row.verdict != CheckVerdict::kError) continue;
    for (const std::string& note : row.notes) say(stderr, "{}\n", note);
    return kExitWrong;
  }
  return allHold(rows) ? kExitDone : kExitNone;
}

// The scenarios, and their scenes as far as these can be read: what else is wrong is a row's.
std::vector<std::filesystem::path> inputsOf(const std::vector<ScenarioFile>& files) {
  std::vector<std::filesystem::path> inputs;
  for (const ScenarioFile& file : files) {
    inputs.push_back(file.file);
    try {
      inputs.push_back(readScenario(file).scene);
    } catch (const InputError&) {
    }
  }
  return inputs;
}

int run(const Options& options) {
  const std::vector<std::filesystem::path> paths(options.paths.begin(), options.paths.end());
  const std::vector<ScenarioFile> files = findScenarios(paths);
  if (!options.junit.empty()) keepInputs(options.junit, inputsOf(files));
  size_t width = 8;
  for (const ScenarioFile& file : files) width = std::max(width, file.file.stem().string().size());
  Progress progress;
  std::string running;
  CheckOptions how;
  how.update = options.update;
  how.judge_times = options.judge_times;
  how.run.threads = options.threads;
  how.run.memory = options.memory;
  how.run.stop = &stopFlag();
  how.run.progress = [&](const SearchProgress& at) {
    const double done = at.total > 0 ? static_cast<double>(at.done) / at.total : -1.0;
    progress.update(fmt::format("{}: {}", running, at.phase), done);
  };
  how.started = [&](const ScenarioFile& file, int index, int count) {
    running = fmt::format("{} ({} of {})", file.file.stem().string(), index + 1, count);
  };
  how.finished = [&](const CheckRow& row) {
    progress.clear();
    if (!options.json) printRow(row, static_cast<int>(width));
  };
  const StoppableWork work;
  const std::vector<CheckRow> rows = checkScenarios(files, how);
  if (options.json) {
    Json all = Json::array();
    for (const CheckRow& row : rows) all.push_back(rowJson(row));
    std::cout << all.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  } else {
    printSummary(rows);
  }
  if (!options.junit.empty()) {
    writeFile(options.junit, [&](std::ostream& out) { writeJUnit(out, rows); });
  }
  return statusOf(rows);
}

}  // namespace

void addCheck(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<Options>();
  options->threads = usualThreads();
  CLI::App* command = app.add_subcommand(
      "check", "Run every scenario found at the paths and compare with its `expect`");
  command
      ->add_option("PATH", options->paths,
                   "Scenario files, and folders of them; - is one on standard input")
      ->required();
  command->add_option("--junit", options->junit, "Write the table as JUnit's XML too");
  command->add_flag("--update", options->update,
                    "Write the SHA-256 of each walk of a finished run into its `expect`");
  command->add_flag("--judge-times", options->judge_times, "Judge max_planning_time too");
  command->add_option("--threads", options->threads, "Threads; changes no result")
      ->check(wholeNumber(1, 64));
  addMemoryOption(*command, options->memory);
  command->add_flag("--json", options->json, "Print results for machines");
  addExamples(*command, {"amble check scenarios/narrow-gap-070.yaml",
                         "amble check scenarios/narrow-gap-070.yaml --junit check.xml"});
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace amble
