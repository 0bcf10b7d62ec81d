// amble check PATH...: every scenario found there, compared with what it expects and with its last
// accepted run.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/check_table.h"
#include "app/command.h"
#include "app/output_folder.h"
#include "app/progress.h"
#include "app/say.h"
#include "app/stop.h"
#include "app/view_of.h"
#include "base/error.h"
#include "base/keep_inputs.h"
#include "base/output_file.h"
#include "base/parallel.h"
#include "scenarios/check_junit.h"
#include "scenarios/check_scenarios.h"
#include "scenarios/find_scenarios.h"
#include "scenarios/problem.h"
#include "viz/pictures/render.h"
#include "viz/regression/check_page.h"

namespace amble {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct CheckArguments {
  std::vector<std::string> paths, filters;
  std::string junit, out;
  bool update = false, judge_times = false, json = false, list = false;
  int jobs = 1;
  int threads = 0;                       // 0: the machine's, shared by the jobs
  size_t memory = GuardLimits{}.memory;  // [bytes]

  fs::path page() const { return out.empty() ? fs::path() : fs::path(out) / "index.html"; }
};

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
std::vector<fs::path> inputsOf(const std::vector<ScenarioFile>& files) {
  std::vector<fs::path> inputs;
  for (const ScenarioFile& file : files) {
    inputs.push_back(file.file);
    try {
      inputs.push_back(readScenario(file).scene);
    } catch (const InputError&) {
    }
  }
  return inputs;
}

int list(const std::vector<ScenarioFile>& files, bool as_json) {
  Json all = Json::array();
  for (const ScenarioFile& file : files) {
    const std::string name = scenarioName(file.file);
    if (as_json) {
      all.push_back({{"scenario", name}, {"file", file.file.string()}});
    } else {
      say(stdout, "{}  {}\n", name, file.file.string());
    }
  }
  if (as_json) std::cout << all.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  return kExitDone;
}

// As a card of the page shows it; large enough to look into. Always from the same corner, so that
// before and after can be laid over one another.
std::string pictureOf(const RunResult& result) {
  constexpr int kWidth = 640, kHeight = 400;  // [pixels]
  if (result.problem == nullptr) return "";
  std::ostringstream png;
  writePng(png, renderWalk(viewOf(result), {.width = kWidth, .height = kHeight, .corner = 0}));
  return png.str();
}

CheckOptions howToRun(const CheckArguments& options) {
  CheckOptions how;
  how.jobs = options.jobs;
  how.update = options.update;
  how.judge_times = options.judge_times;
  how.run.threads =
      options.threads > 0 ? options.threads : std::max(1, usualThreads() / options.jobs);
  how.run.memory = options.memory;
  how.run.stop = &stopFlag();
  if (options.update || !options.out.empty()) how.picture = pictureOf;
  return how;
}

std::vector<CheckRow> runAll(const CheckArguments& options,
                             const std::vector<ScenarioFile>& files) {
  Progress progress;
  std::mutex mutex;
  std::string which;  // of how many
  const CheckTable table(files);
  CheckOptions how = howToRun(options);
  how.started = [&](const ScenarioFile&, int index, int count) {
    const std::lock_guard lock(mutex);
    which = fmt::format("({} of {})", index + 1, count);
  };
  how.progress = [&](const ScenarioFile& file, const SearchProgress& at) {
    const std::lock_guard lock(mutex);
    const double done = at.total > 0 ? static_cast<double>(at.done) / at.total : -1.0;
    progress.update(fmt::format("{} {}: {}", scenarioName(file.file), which, at.phase), done);
  };
  how.finished = [&](const CheckRow& row) {
    progress.clear();
    if (!options.json) table.printRow(row);
  };
  if (!options.json) table.printHead();
  const StoppableWork work;
  return checkScenarios(files, how);
}

void writePage(const fs::path& page, const std::vector<CheckRow>& rows) {
  std::error_code error;
  fs::create_directories(page.parent_path(), error);
  writeFile(page, [&](std::ostream& out) { writeCheckPage(out, rows); });
}

int run(const CheckArguments& options) {
  const std::vector<fs::path> paths(options.paths.begin(), options.paths.end());
  const std::vector<ScenarioFile> files = scenariosNamed(findScenarios(paths), options.filters);
  if (options.list) return list(files, options.json);
  for (const fs::path& output : {fs::path(options.junit), options.page()})
    if (!output.empty()) keepInputs(output, inputsOf(files));
  if (!options.out.empty()) checkOutputFolder(options.out);
  const std::vector<CheckRow> rows = runAll(options, files);
  if (options.json) {
    std::cout << checkJson(rows).dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  } else {
    printCheckSummary(rows);
  }
  if (!options.junit.empty())
    writeFile(options.junit, [&](std::ostream& out) { writeJUnit(out, rows); });
  if (!options.out.empty()) writePage(options.page(), rows);
  return statusOf(rows);
}

void addRunOptions(CLI::App& command, CheckArguments& options) {
  command.add_flag("--update", options.update,
                   "Accept what is found: the SHA-256 of each walk of a finished run into its "
                   "`expect`, its figures and picture into accepted/ beside the scenario");
  command.add_flag("--judge-times", options.judge_times, "Judge max_planning_time too");
  command
      .add_option("-j,--jobs", options.jobs, "Scenarios that are run at once; changes no result")
      ->check(wholeNumber(1, kMostThreads))
      ->capture_default_str();
  command
      .add_option("--threads", options.threads,
                  "Threads of each; changes no result; default: the machine's, shared by the jobs")
      ->check(wholeNumber(1, kMostThreads));
  addMemoryOption(command, options.memory);
}

}  // namespace

void addCheck(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<CheckArguments>();
  CLI::App* command = app.add_subcommand(
      "check",
      "Run every scenario found at the paths; compare with its `expect` and its last accepted run");
  command
      ->add_option("PATH", options->paths,
                   "Scenario files, and folders of them; - is one on standard input")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("--filter", options->filters,
                   "Only scenarios of such names: a pattern with * and ?, or several with commas")
      ->type_name("NAME")
      ->delimiter(',');
  command->add_flag("--list", options->list, "Say which they are, and run none");
  command
      ->add_option("-o,--output", options->out,
                   "Folder for index.html: all on one page, with pictures; what is not as it "
                   "was accepted, before and after")
      ->type_name("DIR");
  command->add_option("--junit", options->junit, "Write the table as JUnit's XML too")
      ->type_name("FILE");
  addRunOptions(*command, *options);
  command->add_flag("--json", options->json, "Print results for machines");
  addExamples(*command,
              {"amble check scenarios/narrow-gap-070.yaml",
               "amble check scenarios/narrow-gap-070.yaml --junit check.xml",
               "amble check scenarios --filter narrow-gap-070,narrow-gap-080 -j 2 -o out/check"});
  addExitStatus(*command, "all hold", "something differs");
  command->callback([options, &chosen] {
    const int threads = options->threads > 0 ? options->threads * options->jobs : usualThreads();
    chosen = onThreads(threads, [options] { return run(*options); });
  });
}

}  // namespace amble
