/// The walks of a job in few large files: NPZ shards with an index.
///
///     DIR/packs/00000.npz ...    kWalksInPack walks each, in the job's order
///     DIR/packs/index.csv        item,walk,pack
///
/// A pack holds every file of its walks' folders: `WALK/labels.json` as it is, and for an NPZ each
/// of its arrays, so that numpy.load("00000.npz")["WALK/positions"] is one.
#pragma once

#include <string>
#include <vector>

#include "batch/run/batch_folder.h"

namespace amble {

/// Few enough to be made in memory, and to be read as one.
inline constexpr int kWalksInPack = 50;

/// Writes them, and takes away packs of a longer job. @param keys  of the job's items, in its order
/// @throws InputError
void packBatch(const BatchFolder& batch, const std::vector<std::string>& keys);

}  // namespace amble
