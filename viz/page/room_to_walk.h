/// The map of where a body can be, as ground of a page.
#pragma once

#include "environments/map/clearance_map.h"
#include "viz/page/page.h"

namespace amble {

/// Places with room for the body as strips, by how much room there is to either side (PageSubject).
/// Empty where there are more places than kMostPlaces.
PageGround roomToWalk(const ClearanceMap& map);
inline constexpr int kMostPlaces = 300'000;  // 27 x 27 m

/// Reached ground as a page has it.
PageGround reachedGround(const ReachedRegion& reached);

}  // namespace amble
