/// Where a footprint lies beside the root path.
#pragma once

namespace amble {

/// Seen from the point of the root path beside it: forward and to the left of where even steps on
/// the path have it [m], and its heading [rad, left positive].
struct PrintPlace {
  double forward = 0.0, left = 0.0, toe_out = 0.0;
};

}  // namespace amble
