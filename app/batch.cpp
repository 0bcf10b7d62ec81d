// amble batch JOB.yaml -o DIR: many walks, in shards, resumable.

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/batch_check.h"
#include "app/batch_job_options.h"
#include "app/batch_merge.h"
#include "app/batch_stats.h"
#include "app/batch_status.h"
#include "app/command.h"
#include "app/output_folder.h"
#include "app/progress.h"
#include "app/result_formats.h"
#include "app/say.h"
#include "app/stop.h"
#include "app/view_of.h"
#include "base/text.h"
#include "batch/run/merge_batch.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kInputWrong = "error";  // the status of such a row

struct BatchArguments {
  BatchJobOptions job;
  std::string shard = "1/1";
  int threads = 1;
  bool json = false;
};

std::optional<Shard> readShard(const std::string& text) {
  const auto parts = splitAt(text, "/");
  if (!parts) return std::nullopt;
  const auto index = wholeNumberOf(parts->first), count = wholeNumberOf(parts->second);
  constexpr long long kMost = 1'000'000;
  if (!index || !count || *count < 1 || *count > kMost || *index < 1 || *index > *count)
    return std::nullopt;
  return Shard{static_cast<int>(*index), static_cast<int>(*count)};
}

CLI::Validator shardForm() {
  return {[](const std::string& text) {
            return readShard(text)
                       ? std::string()
                       : "'" + text + "' is no shard; expected I/N, I from 1 to N, as 3/7";
          },
          ""};
}

// What `amble plan` writes and a batch does not make itself.
void addFormats(const BatchJob& job, const RunResult& result, std::vector<ResultFile>& files,
                const std::function<void()>& write) {
  const WalkView view = viewOf(result);
  const ResultSubject subject{.result = result, .view = view, .threads = 1, .command = ""};
  for (const ResultFormat& format : resultFormats()) {
    const bool asked =
        std::find(job.formats.begin(), job.formats.end(), format.name) != job.formats.end();
    if (format.add && asked && (view.hasBody() || !format.of_walk)) format.add(subject, files);
  }
  write();
}

Json summaryJson(const BatchSummary& made) {
  return {{"walks", made.total},         {"kept", made.kept},
          {"made", made.made},           {"made_by_status", made.made_by_status},
          {"stopped", made.stopped},     {"seconds", made.seconds},
          {"planning", made.planning},   {"loading", made.loading},
          {"labelling", made.labelling}, {"writing", made.writing}};
}

// What is wrong with the input: rows have it all, and nobody looks for it there first.
void printErrors(const std::map<std::string, int>& errors) {
  constexpr size_t kMost = 5;
  size_t told = 0;
  for (const auto& [reason, count] : errors) {
    if (told++ == kMost) break;
    say(stdout, "    {} x {}\n", count, reason);
  }
  if (errors.size() > kMost) say(stdout, "    and {} more\n", errors.size() - kMost);
}

void printSummary(const BatchSummary& made, const std::string& folder) {
  say(stdout, "{}, {} made, {} there before\n", counted(made.total, "walk"), made.made, made.kept);
  for (const auto& [status, count] : made.made_by_status) {
    say(stdout, "  {:<14} {}\n", status, count);
    if (status == kInputWrong) printErrors(made.errors);
  }
  if (made.made > 0) {
    say(stdout,
        "  time           {:.1f} s, {:.2f} walks a second; of all threads: planning {:.1f}, "
        "loading {:.1f}, labelling {:.1f}, writing {:.1f}\n",
        made.seconds, made.made / made.seconds, made.planning, made.loading, made.labelling,
        made.writing);
  }
  if (made.stopped) {
    say(stdout, "  stopped        {} are missing; the same command goes on\n",
        made.total - made.made - made.kept);
  }
  say(stdout, "  written to     {}\n", folder);
}

int run(const BatchArguments& options) {
  const BatchJob job = readBatchJob(options.job.job, formatNames());
  checkPrograms(job.formats);
  checkOutputFolder(options.job.out);
  BatchOptions how = options.job.how();
  how.shard = *readShard(options.shard);
  how.threads = options.threads;
  how.more = [&](const RunResult& result, std::vector<ResultFile>& files,
                 const std::function<void()>& write) { addFormats(job, result, files, write); };
  Progress progress;
  how.progress = [&](const BatchProgress& at) {
    progress.update(fmt::format("{} of {} walks", at.done, at.total),
                    static_cast<double>(at.done) / at.total);
  };
  const StoppableWork work;
  const BatchSummary made = runBatch(job, options.job.out, how);
  progress.clear();
  if (options.json) {
    std::cout << summaryJson(made).dump(2) << '\n';
  } else {
    printSummary(made, options.job.out);
  }
  if (made.stopped) return kExitStopped;
  if (how.shard.count > 1) return kExitDone;
  const MergeSummary merged = mergeBatch(job, options.job.out, how, made.keys);
  if (merged.swept > 0 && !options.json) {
    say(stdout, "  taken away     {} of another job or input\n", counted(merged.swept, "walk"));
  }
  return kExitDone;
}

}  // namespace

void addBatch(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<BatchArguments>();
  CLI::App* command =
      app.add_subcommand("batch", "Plan many walks with labels, in shards; what is there is kept");
  CLI::Option* job = addJobOptions(*command, options->job);
  command->add_option("--shard", options->shard, "The I-th of N parts of the job")
      ->type_name("I/N")
      ->check(shardForm())
      ->capture_default_str();
  addThreadsOption(*command, options->threads, "Walks planned at a time; changes no result");
  addPackOption(*command, options->job);
  command->add_flag("--json", options->json, "Print results for machines");
  addBatchMerge(*command, chosen);
  addBatchStats(*command, chosen);
  addBatchStatus(*command, chosen);
  addBatchCheck(*command, chosen);
  // After the subcommands, which would have these words in their help too.
  addExamples(*command, {"amble batch examples/batch/doors.yaml -o doors",
                         "amble batch examples/batch/doors.yaml -o doors --shard 2/3",
                         "amble batch merge examples/batch/doors.yaml -o doors"});
  addExitStatus(*command, "all walks of the job or the shard are there, or why they are not");
  command->callback([command, job, options, &chosen] {
    if (!command->get_subcommands().empty()) return;
    options->job.require(*job);
    chosen = onThreads(options->threads, [options] { return run(*options); });
  });
}

}  // namespace amble
