/// One walk of a batch: planned, told in a row, written.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "batch/job/batch_items.h"
#include "batch/labels/walk_row.h"
#include "batch/labels/write_labels.h"
#include "batch/run/batch_walker.h"
#include "batch/run/run_batch.h"

namespace amble {

/// What a walk is made of. Borrowed.
struct WalkOrder {
  const BatchJob& job;
  const BatchItem& item;
  const std::string& key;
  const BatchSceneData& scene;
  const BatchLibraryData& library;
  const BatchDrawer* drawer;  ///< null where the way is not drawn, or the scene is wrong
  const BatchWalker* walker;  ///< null where scene or library are wrong
  const std::atomic<bool>* stop;
};

struct MadeWalk {
  WalkRow row;
  std::optional<RunResult> run;            ///< where there was something to plan
  std::optional<WalkLabels> labels;        ///< of a walk
  double planning = 0.0, labelling = 0.0;  ///< [s]
};

/// @throws Stopped where it was told to; what is wrong with its input is told by the row
MadeWalk makeWalk(const WalkOrder& order);

/// Writes it into a folder that is there.
void writeWalk(const BatchJob& job, MadeWalk& made, const std::filesystem::path& folder,
               const BatchOptions& options);

}  // namespace amble
