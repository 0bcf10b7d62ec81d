/// What the shards of a job made, put together: its table, and nothing that is not of it.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "batch/labels/walk_row.h"
#include "batch/run/batch_folder.h"
#include "batch/run/run_batch.h"

namespace amble {

struct MergeSummary {
  int total = 0, missing = 0;  ///< walks of the job; those that no run has made yet
  int swept = 0;               ///< that were of no walk of the job, or of an older input
  std::map<std::string, int> by_status;
};

/// Writes index.csv and index.jsonl, a row a walk in the job's order, CREDITS.md and, where it is
/// asked for, packs (pack_batch.h); takes away walks that are not the job's. Where some are missing
/// nothing is written and nothing taken away.
/// @param keys  of the job's items, as a run of all of it has found them; none: they are found
/// @throws InputError; Stopped
MergeSummary mergeBatch(const BatchJob& job, const std::filesystem::path& folder,
                        const BatchOptions& options, std::vector<std::string> keys = {});

/// Of a walk that is there. @throws InputError
WalkRow readRowOf(const BatchFolder& batch, const std::string& key);

/// The key of every item, in the job's order: what a run would make of the inputs as they are now.
/// @throws Stopped
std::vector<std::string> keysOfItems(const BatchJob& job, const std::vector<BatchItem>& items,
                                     const LoadLimits& limits);

}  // namespace amble
