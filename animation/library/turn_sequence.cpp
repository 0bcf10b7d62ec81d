#include "animation/library/turn_sequence.h"

#include <vector>

#include "animation/library/transition.h"

namespace amble {

void turnChannels(const TurnSequence& sequence, double clock, std::span<double> channels) {
  splineAt(sequence.spline, clock, channels);
}

// A cubic B-spline has two continuous derivatives: it is the one cubic spline through its values at
// its knots that has its slopes at the ends.
CubicSpline shareTurned(const TurnSequence& sequence) {
  const int pieces = sequence.pieces();
  std::vector<double> clocks, shares;
  for (int i = 0; i <= pieces; ++i) {
    const double clock = static_cast<double>(i) / pieces;
    double share = 0.0;
    splineAt(sequence.turned, clock, {&share, 1});
    clocks.push_back(clock);
    shares.push_back(share);
  }
  return CubicSpline(std::move(clocks), std::move(shares), 0.0, 0.0);
}

}  // namespace amble
