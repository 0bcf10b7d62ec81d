/// Walks of a batch looked at again, as anybody's: their BVH files against their scenes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "batch/run/run_batch.h"

namespace amble {

struct CheckedWalk {
  int item = 0;
  std::string key, scene;
  int contacts = 0;        ///< spans in which a part touches something
  std::string first;       ///< of them: "left hand and table at 2.35 s"
  double clearance = 0.0;  ///< [m]
  std::string wrong;       ///< why it could not be looked at, or how its row differs; else ""

  bool holds() const { return contacts == 0 && wrong.empty(); }
};

/// A seeded sample of the walks that were found, in the job's order: all where there are fewer.
/// `amble validate`'s own check (validate_walk.h) of each.
/// @throws InputError where a walk of the job is missing, or none was to be a BVH; Stopped
std::vector<CheckedWalk> checkBatch(const BatchJob& job, const std::filesystem::path& folder,
                                    int sample, std::uint64_t seed, const BatchOptions& options);

}  // namespace amble
