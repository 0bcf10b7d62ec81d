/// How far a batch is, whoever works at it: told by what is in its folder.
#pragma once

#include <filesystem>

#include "batch/run/run_batch.h"

namespace amble {

struct BatchStatus {
  int total = 0, there = 0;  ///< walks of the job; those that are there
  /// Of the last kRateOf that came, by the clock of their files [1/s]; 0 where it is not known.
  double rate = 0.0;
};
inline constexpr int kRateOf = 50;

/// @throws InputError; Stopped
BatchStatus batchStatus(const BatchJob& job, const std::filesystem::path& folder,
                        const LoadLimits& limits);

}  // namespace amble
