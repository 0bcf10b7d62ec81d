/// Whether a walk that is there is all there: a folder that has lost a file is made again.
#pragma once

#include <string>
#include <vector>

#include "batch/job/batch_job.h"
#include "batch/labels/walk_row.h"
#include "batch/run/batch_folder.h"

namespace amble {

/// The files of a walk's folder, by the job's formats and what came of it: row, BVH, report and
/// labels. Of other formats, which programs add (BatchOptions::more), none is told.
std::vector<std::string> filesOfWalk(const BatchJob& job, const WalkRow& row);

/// Whether it has a row, and all files that go with that. Of a row that cannot be read nothing is
/// known: it is for who reads it to say so. Cost: some tens of microseconds.
bool isWhole(const BatchJob& job, const BatchFolder& batch, const std::string& key);

}  // namespace amble
