#include "app/batch_status.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/batch_job_options.h"
#include "app/result_formats.h"
#include "app/say.h"
#include "app/stop.h"
#include "base/text.h"
#include "batch/run/batch_status.h"

namespace amble {
namespace {

constexpr int kBarWidth = 40;  // characters

struct StatusArguments {
  BatchJobOptions job;
  bool json = false;
};

// "3 h 20 min", "4 min", "12 s".
std::string durationText(double seconds) {
  const auto whole = static_cast<long long>(seconds);
  if (whole >= 3600) return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
  return whole >= 60 ? fmt::format("{} min", whole / 60) : fmt::format("{} s", whole);
}

void printStatus(const BatchStatus& status) {
  const int full = status.total > 0 ? kBarWidth * status.there / status.total : kBarWidth;
  say(stdout, "[{:#<{}}{:.<{}}] {} of {}\n", "", full, "", kBarWidth - full, status.there,
      counted(status.total, "walk"));
  if (status.rate <= 0.0) return;
  const int left = status.total - status.there;
  say(stdout, "{:.3g} walks a second, {} left\n", status.rate, durationText(left / status.rate));
}

int runStatus(const StatusArguments& options) {
  const BatchJob job = readBatchJob(options.job.job, formatNames());
  const BatchOptions how = options.job.how();
  const StoppableWork work;
  const BatchStatus status = batchStatus(job, options.job.out, {how.memory, {how.stop, {}}});
  if (options.json) {
    const nlohmann::ordered_json json = {
        {"walks", status.total}, {"there", status.there}, {"rate", status.rate}};
    std::cout << json.dump(2) << '\n';
  } else {
    printStatus(status);
  }
  return status.there == status.total ? kExitDone : kExitNone;
}

}  // namespace

void addBatchStatus(CLI::App& batch, Command& chosen) {
  const auto options = std::make_shared<StatusArguments>();
  CLI::App* command = batch.add_subcommand("status", "How many walks of a job are there");
  CLI::Option* job = addJobOptions(*command, options->job);
  command->add_flag("--json", options->json, "Print results for machines");
  addExitStatus(*command, "all walks are there", "some are missing");
  command->callback([job, options, &chosen] {
    options->job.require(*job);
    chosen = [options] { return runStatus(*options); };
  });
}

}  // namespace amble
