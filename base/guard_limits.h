/// What reading a file may take of the machine, where another's parser does it (guarded_run.h).
#pragma once

#include <cstddef>
#include <functional>

namespace amble {

struct GuardLimits {
  size_t memory = size_t{768} << 20;   ///< beyond what the process has already [bytes]
  int cpu_time = 60;                   ///< [s, > 0]
  std::function<bool()> stopped = {};  ///< asked ten times a second; true ends the work
};

/// What is expected, for messages, where there is not enough memory.
inline constexpr const char* kMoreMemory = "a smaller file, or `--memory MB` that lets it";

}  // namespace amble
