/// The run of a job, or of a shard of it: each walk that is not there yet is made.
///
/// What is there is known by content: scene with its meshes, library, settings, seed and version
/// name a walk's folder. So a run that was killed goes on where it was, and one of a changed job
/// makes what the change touches. A walk that is refused, or whose input is wrong, is a row like
/// others. The bytes of a walk depend on nothing but itself: not on shards, order or threads.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/output_file.h"
#include "batch/job/batch_items.h"
#include "scenarios/run_scenario.h"

namespace amble {

struct BatchProgress {
  int done = 0, total = 0;  ///< walks of the shard
  int made = 0;             ///< of those done, by this run
};

struct BatchOptions {
  Shard shard;
  bool pack = false;                     ///< whether merging packs the walks too
  int threads = 1;                       ///< walks made at a time [1 to 64]; changes no byte
  size_t memory = GuardLimits{}.memory;  ///< that reading a mesh file may fill [bytes, > 0]
  const std::atomic<bool>* stop = nullptr;
  /// Called from any thread, one at a time.
  std::function<void(const BatchProgress&)> progress;
  /// Adds files of formats other than those that are made here to a run's, and calls `write` while
  /// what they are made of is there.
  std::function<void(const RunResult&, std::vector<ResultFile>& files,
                     const std::function<void()>& write)>
      more;
};

struct BatchSummary {
  int total = 0, kept = 0, made = 0;  ///< walks of the shard; those there before; made now
  std::map<std::string, int> made_by_status;
  std::map<std::string, int> errors;  ///< how many that were made say so of their input
  std::vector<std::string> keys;  ///< of each walk of the shard (merge_batch.h); "": not come to
  bool stopped = false;           ///< told to stop: what was made by then is there
  double planning = 0.0;  ///< of what was made: roadmaps, search, refinement; of all threads [s]
  double seconds = 0.0;   ///< by the clock
  double loading = 0.0, labelling = 0.0,
         writing = 0.0;  ///< of all threads: scenes and walkers; labels; files [s]
};

/// @throws InputError where the folder cannot be written
BatchSummary runBatch(const BatchJob& job, const std::filesystem::path& folder,
                      const BatchOptions& options);

}  // namespace amble
