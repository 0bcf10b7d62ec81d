#include "app/batch_merge.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/batch_job_options.h"
#include "app/result_formats.h"
#include "app/say.h"
#include "app/stop.h"
#include "base/text.h"
#include "batch/run/merge_batch.h"

namespace amble {
namespace {

struct MergeArguments {
  BatchJobOptions job;
  bool json = false;
};

int runMerge(const MergeArguments& options) {
  const BatchJob job = readBatchJob(options.job.job, formatNames());
  const StoppableWork work;
  const MergeSummary merged = mergeBatch(job, options.job.out, options.job.how());
  if (options.json) {
    const nlohmann::ordered_json json = {{"walks", merged.total},
                                         {"missing", merged.missing},
                                         {"swept", merged.swept},
                                         {"by_status", merged.by_status}};
    std::cout << json.dump(2) << '\n';
  } else if (merged.missing == 0) {
    say(stdout, "{}, {} that are of another job or input taken away\n",
        counted(merged.total, "walk"), merged.swept);
    for (const auto& [status, count] : merged.by_status)
      say(stdout, "  {:<14} {}\n", status, count);
  }
  if (merged.missing == 0) return kExitDone;
  say(stderr, "amble batch: {} of {} are missing; nothing was merged\n", merged.missing,
      counted(merged.total, "walk"));
  return kExitNone;
}

}  // namespace

void addBatchMerge(CLI::App& batch, Command& chosen) {
  const auto options = std::make_shared<MergeArguments>();
  CLI::App* command = batch.add_subcommand(
      "merge", "Write the table of all walks of a job, and take away what is of no walk of it");
  CLI::Option* job = addJobOptions(*command, options->job);
  addPackOption(*command, options->job);
  command->add_flag("--json", options->json, "Print results for machines");
  addExitStatus(*command, "all walks are there", "some are missing");
  command->callback([job, options, &chosen] {
    options->job.require(*job);
    chosen = [options] { return runMerge(*options); };
  });
}

}  // namespace amble
