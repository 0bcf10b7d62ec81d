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
  double spent = 0.0;            ///< on making those already [s, >= 0]
  /// Every name that any run may write there: a result is one set, of one run, so what another left
  /// under them goes when this one's is written.
  std::vector<std::filesystem::path> names = {"walk.bvh", "report.json"};
};

/// Makes the folder if need be and writes the files, the report last: `times.export` holds what the
/// others took. Either all are there afterwards, and none of another run, or the folder is as it
/// was.
/// @throws InputError naming the folder or the file that cannot be written.
void writeResults(RunResult& result, const std::filesystem::path& folder,
                  const WriteOptions& options = {});

}  // namespace amble
