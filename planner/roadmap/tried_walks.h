/// Walks between two places that a roadmap tries before it samples: over the passages that steering
/// knows, and straight through a narrow place.
///
/// They depend on the two places only, not on the roadmap: all that are to be tried are shared out
/// among the threads. What is returned, and in which order, is the same for any number of them.
#pragma once

#include <optional>
#include <vector>

#include "planner/search_limits.h"
#include "planner/steering/steering.h"

namespace amble {

/// What steering said of the walks between two standing stances, where it was asked.
struct TriedWalk {
  StancePair ends;
  std::optional<SteerResult> there, back;  ///< from the first to the second, and back

  bool isThere() const { return (there && there->edge) || (back && back->edge); }
};

/// For each passage, and each direction over it, walks until one is found: where steps fall on a
/// flight depends on how far before it a walk begins, and a few such places are tried. Fewer where
/// limits.stopped(). @param scratches  one for each of limits.threads
std::vector<TriedWalk> tryPassages(const Steering& steering,
                                   const std::vector<StancePair>& passages,
                                   const SearchLimits& limits,
                                   const std::vector<SteeringScratchPtr>& scratches);

/// Straight through a narrow place until one is found: where arms swing wide there depends on how
/// far before it, and how far beyond, one stands; and they do not swing alike.
struct TriedCrossing {
  enum class Outcome {
    kWalked,   ///< the last of `tried` is a walk
    kRefused,  ///< so many were tried that hardly another will do
    kUnknown,  ///< there was not room to try as many, or limits.stopped()
  };
  Outcome outcome = Outcome::kUnknown;
  std::vector<TriedWalk> tried;
};
TriedCrossing tryCrossing(const Steering& steering, const WayGuide::Narrow& narrow,
                          const SearchLimits& limits,
                          const std::vector<SteeringScratchPtr>& scratches);

}  // namespace amble
