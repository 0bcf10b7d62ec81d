#include "app/batch_stats.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/say.h"
#include "base/output_file.h"
#include "base/text.h"
#include "batch/run/batch_table.h"

namespace amble {
namespace {

using StatsJson = nlohmann::ordered_json;

struct StatsArguments {
  std::string folder, plot;
  bool json = false;
};

StatsJson measuresJson(const BatchStatistics& all) {
  constexpr int kJsonBins = 24;
  StatsJson json = StatsJson::object();
  for (const Measure& measure : all.measures) {
    if (measure.values.empty()) continue;
    const Spread spread = spreadOf(measure);
    const Histogram bins = histogramOf(measure, kJsonBins);
    json[measure.name] = {
        {"unit", measure.unit},
        {"least", spread.least},
        {"tenth", spread.tenth},
        {"median", spread.median},
        {"mean", spread.mean},
        {"ninetieth", spread.ninetieth},
        {"most", spread.most},
        {"histogram", {{"from", bins.from}, {"width", bins.width}, {"counts", bins.counts}}}};
  }
  return json;
}

// To the millisecond: sums of many have no more.
StatsJson timesJson(const Times& times) {
  constexpr double kParts = 1e3;
  StatsJson json = StatsJson::object();
  for (const auto& [name, time] : times) json[name] = std::round(kParts * time) / kParts;
  return json;
}

void printStatsJson(const BatchStatistics& all) {
  const StatsJson json = {{"walks", all.walks},
                          {"solved", all.solved},
                          {"statuses", all.statuses},
                          {"refusals", all.refusals},
                          {"measures", measuresJson(all)},
                          {"scenes", all.scenes},
                          {"styles", all.styles},
                          {"actions", all.actions},
                          {"activities", timesJson(all.activities)},
                          {"motions", timesJson(all.motions)}};
  std::cout << json.dump(2, ' ', false, StatsJson::error_handler_t::replace) << '\n';
}

void printTimes(const char* title, const Times& times) {
  for (const auto& [name, time] : times) {
    say(stdout, "  {:<15} {:>7.1f}  {}\n", title, time, name);
    title = "";
  }
}

void printCounts(const char* title, const Counts& counts) {
  for (const auto& [name, count] : counts) {
    say(stdout, "  {:<15} {:>7}  {}\n", title, count, name.empty() ? std::string("none") : name);
    title = "";
  }
}

void printStats(const std::string& folder, const BatchStatistics& all) {
  say(stdout, "{}: {} of {} asked for\n", folder, counted(all.solved, "walk"), all.walks);
  if (all.solved > 0) {
    say(stdout, "  {:<15} {:>10} {:>10} {:>10} {:>10} {:>10}\n", "", "least", "tenth", "median",
        "ninetieth", "most");
  }
  for (const Measure& measure : all.measures) {
    if (measure.values.empty()) continue;
    const Spread spread = spreadOf(measure);
    say(stdout, "  {:<15} {:>10.4g} {:>10.4g} {:>10.4g} {:>10.4g} {:>10.4g} {}\n", measure.name,
        spread.least, spread.tenth, spread.median, spread.ninetieth, spread.most, measure.unit);
  }
  printCounts("refused by", all.refusals);
  printTimes("done [s]", all.activities);
  printTimes("motions [s]", all.motions);
  printCounts("scene", all.scenes);
  if (all.styles.size() > 1 || all.styles.count("") == 0) printCounts("style", all.styles);
  printCounts("action", all.actions);
}

int runStats(const StatsArguments& options) {
  const BatchStatistics all = batchStatistics(options.folder);
  if (!options.plot.empty()) {
    const std::string title = std::filesystem::path(options.folder).lexically_normal().string();
    writeFile(options.plot,
              [&](std::ostream& out) { writeStatisticsPlot(out, all, utf8Text(title)); });
  }
  if (options.json) {
    printStatsJson(all);
  } else {
    printStats(options.folder, all);
  }
  return kExitDone;
}

}  // namespace

void addBatchStats(CLI::App& batch, Command& chosen) {
  const auto options = std::make_shared<StatsArguments>();
  CLI::App* command = batch.add_subcommand(
      "stats",
      "What the walks are like: lengths, speeds, gaits, clearance, and why there are none");
  command->add_option("DIR", options->folder, "Folder of the walks, merged")
      ->type_name("DIR")
      ->required();
  command->add_option("--plot", options->plot, "Draw histograms and bars into this file (SVG)")
      ->type_name("FILE");
  command->add_flag("--json", options->json, "Print results for machines");
  addExamples(*command, {"amble batch stats rooms --plot rooms/stats.svg"});
  addExitStatus(*command, "there is a table");
  command->callback([options, &chosen] { chosen = [options] { return runStats(*options); }; });
}

}  // namespace amble
