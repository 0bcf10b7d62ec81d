/// What a run leaves behind: walk.bvh, report.json and whatever else the caller draws, whole or not
/// at all.
#pragma once

#include <filesystem>
#include <vector>

#include "base/output_file.h"
#include "scenarios/run_scenario.h"

namespace amble {

struct WriteOptions {
  bool bvh = true;               ///< walk.bvh, where there is a walk
  bool json = true;              ///< report.json
  std::vector<ResultFile> more;  ///< pictures and the like: paths relative to the folder
};

/// Makes the folder if need be and writes the files, the report last: `times.export` holds what the
/// others took. Either all are there afterwards or the folder is as it was. Without a walk the
/// walk.* files of an earlier run are removed, since they would be taken for this one's.
/// @throws InputError naming the folder or the file that cannot be written.
void writeResults(RunResult& result, const std::filesystem::path& folder,
                  const WriteOptions& options = {});

}  // namespace amble
