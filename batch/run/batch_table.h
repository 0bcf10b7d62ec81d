/// The table of a merged batch.
#pragma once

#include <filesystem>
#include <vector>

#include "batch/labels/batch_statistics.h"
#include "batch/labels/walk_row.h"

namespace amble {

/// The rows of DIR/index.jsonl, in the job's order. @throws InputError where it is missing or wrong
std::vector<WalkRow> readBatchTable(const std::filesystem::path& folder);

/// Of all of it, with the labels of those walks that have some. @throws InputError
BatchStatistics batchStatistics(const std::filesystem::path& folder);

}  // namespace amble
