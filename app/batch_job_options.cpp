#include "app/batch_job_options.h"

#include "app/command.h"
#include "app/stop.h"

namespace amble {

BatchOptions BatchJobOptions::how() const {
  BatchOptions options;
  options.memory = memory;
  options.pack = pack;
  options.stop = &stopFlag();
  return options;
}

void BatchJobOptions::require(const CLI::Option& job_option) const {
  if (job_option.count() == 0) throw CLI::RequiredError("JOB");
  if (out.empty()) throw CLI::RequiredError("--output");
}

void addPackOption(CLI::App& command, BatchJobOptions& options) {
  command.add_flag("--pack", options.pack,
                   "Write the walks to packs/*.npz too, 50 each, when all are there");
}

CLI::Option* addJobOptions(CLI::App& command, BatchJobOptions& options) {
  CLI::Option* job = command.add_option("JOB", options.job, "Job file (YAML)")->type_name("FILE");
  command.add_option("-o,--output", options.out, "Folder of the walks")->type_name("DIR");
  addMemoryOption(command, options.memory);
  return job;
}

}  // namespace amble
