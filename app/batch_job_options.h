/// What all commands of batches are told: the job, and where its walks are.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "batch/run/run_batch.h"

namespace amble {

struct BatchJobOptions {
  std::string job, out;
  bool pack = false;
  size_t memory = GuardLimits{}.memory;  // [bytes]

  /// With memory and the flag of Ctrl-C.
  BatchOptions how() const;
  /// @throws CLI::RequiredError where the job or the folder is missing
  void require(const CLI::Option& job_option) const;
};

/// --pack, of commands that merge.
void addPackOption(CLI::App& command, BatchJobOptions& options);

/// JOB, --output and --memory. @return that of the job
CLI::Option* addJobOptions(CLI::App& command, BatchJobOptions& options);

}  // namespace amble
