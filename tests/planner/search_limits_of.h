/// How long searches of the tests go on.
#pragma once

#include "planner/search_limits.h"

namespace amble {

inline SearchLimits limitsOf(std::uint64_t seed, int max_failures = 200, int threads = 1) {
  SearchLimits limits;
  limits.seed = seed;
  limits.max_failures = max_failures;
  limits.threads = threads;
  return limits;
}

}  // namespace amble
