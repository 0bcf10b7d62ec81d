/// What steering answered, by the pair of places that it was asked about: each directed pair is
/// steered once.
#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "planner/steering/steering.h"

namespace amble {

/// A place that edges are asked between, by number. Whoever makes a place gives it a number of its
/// own, and what is there never changes: places are compared by number, never by their doubles.
using PlaceId = std::int64_t;

/// Not for threads to share.
class EdgeMemory {
 public:
  /// What is known of the way from one place to another, or null.
  const SteerResult* find(PlaceId from, PlaceId to) const {
    const auto found = known_.find({from, to});
    return found == known_.end() ? nullptr : &found->second;
  }

  /// The same; where nothing is known, ask() is called and its answer kept.
  template <typename Ask>
  const SteerResult& answer(PlaceId from, PlaceId to, Ask ask) {
    if (const SteerResult* known = find(from, to)) return *known;
    return known_.emplace(std::make_pair(from, to), ask()).first->second;
  }

  void learn(PlaceId from, PlaceId to, SteerResult result) {
    known_.insert_or_assign({from, to}, std::move(result));
  }
  void clear() { known_.clear(); }

 private:
  std::map<std::pair<PlaceId, PlaceId>, SteerResult> known_;  // from, to
};

}  // namespace amble
