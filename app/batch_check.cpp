#include "app/batch_check.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/batch_job_options.h"
#include "app/result_formats.h"
#include "app/say.h"
#include "app/stop.h"
#include "base/text.h"
#include "batch/run/check_batch.h"

namespace amble {
namespace {

struct BatchCheckArguments {
  BatchJobOptions job;
  int sample = 20, seed = 1, threads = 1;
  bool json = false;
};

nlohmann::ordered_json checkedJson(const std::vector<CheckedWalk>& walks) {
  auto json = nlohmann::ordered_json::array();
  for (const CheckedWalk& walk : walks) {
    json.push_back({{"item", walk.item},
                    {"walk", walk.key},
                    {"scene", walk.scene},
                    {"contacts", walk.contacts},
                    {"first", walk.first},
                    {"clearance", walk.clearance},
                    {"wrong", walk.wrong}});
  }
  return json;
}

int runCheck(const BatchCheckArguments& options) {
  const BatchJob job = readBatchJob(options.job.job, formatNames());
  BatchOptions how = options.job.how();
  how.threads = options.threads;
  const StoppableWork work;
  const std::vector<CheckedWalk> walks = checkBatch(job, options.job.out, options.sample,
                                                    static_cast<std::uint64_t>(options.seed), how);
  const auto wrong = std::count_if(walks.begin(), walks.end(),
                                   [](const CheckedWalk& walk) { return !walk.holds(); });
  if (options.json) {
    std::cout << checkedJson(walks).dump(2, ' ', false,
                                         nlohmann::ordered_json::error_handler_t::replace)
              << '\n';
  } else {
    for (const CheckedWalk& walk : walks) {
      if (walk.holds()) continue;
      say(stdout, "{:>6} {} {}: {}\n", walk.item, walk.key, walk.scene,
          walk.wrong.empty() ? walk.first : walk.wrong);
    }
    say(stdout, "{} looked at, {} of them wrong\n",
        counted(static_cast<long long>(walks.size()), "walk"), wrong);
    const bool spoilt = std::any_of(walks.begin(), walks.end(),
                                    [](const CheckedWalk& walk) { return !walk.wrong.empty(); });
    if (spoilt)
      say(stdout, "A walk is made again when its folder is deleted and the batch is run again\n");
  }
  return wrong == 0 ? kExitDone : kExitNone;
}

}  // namespace

void addBatchCheck(CLI::App& batch, Command& chosen) {
  const auto options = std::make_shared<BatchCheckArguments>();
  CLI::App* command = batch.add_subcommand(
      "check", "Look at some walks again: their BVH against their scenes, as amble validate does");
  CLI::Option* job = addJobOptions(*command, options->job);
  command->add_option("--sample", options->sample, "How many walks")
      ->check(wholeNumber(1, 100000000))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Another one, other walks")
      ->check(wholeNumber(0, 2147483647))
      ->capture_default_str();
  addThreadsOption(*command, options->threads);
  command->add_flag("--json", options->json, "Print results for machines");
  addExitStatus(*command, "all hold", "one touches something or is not what its row says");
  command->callback([job, options, &chosen] {
    options->job.require(*job);
    chosen = onThreads(options->threads, [options] { return runCheck(*options); });
  });
}

}  // namespace amble
