/// What two_link.h says, of four legs at once (lanes.h).
#pragma once

#include "base/lanes.h"

namespace amble {
namespace {

// TwoLink.
struct LegLanes {
  Point hip, knee, ankle, flexion_axis;
};
// TwoLinkSolution; `solved` is -1 where there is one.
struct LegTurns {
  Turn thigh, shank;
  Lanes cosine;  // of the flexion
  LaneBits solved;
};

// Sine of the flexion about the axis below which the plane of hip, knee and ankle is more and more
// noise, and the axis takes over: 10 degrees.
constexpr double kNearlyStraight = 0.17;

// Unit normal of the leg's plane, at right angles to the thigh, on the flexion axis' side. What is
// added keeps its share along the axis above zero however the leg is bent, sideways and backwards
// too, so that the knee never changes sides at once.
inline Point planeNormal(const Point& axis, const Point& thigh, const Point& shank) {
  const Point normal = cross(thigh, shank);
  const Point across = unit(axis - dot(axis, thigh) * thigh);
  const Lanes straight = larger(Lanes{}, 1.0 - dot(normal, across) / kNearlyStraight);
  return unit(normal + (kNearlyStraight * straight * straight) * across);
}

// The shortest turn of one unit vector to another. @pre they are not opposite
inline Turn shortestTurn(const Point& from, const Point& to) {
  const Lanes s = root(2.0 * (1.0 + dot(from, to)));
  const Point axis = (1.0 / s) * cross(from, to);
  return {axis.x, axis.y, axis.z, 0.5 * s};
}

inline LegTurns solveLegs(const LegLanes& leg, const Point& target) {
  const Point thigh_link = leg.knee - leg.hip, shank_link = leg.ankle - leg.knee,
              reach = target - leg.hip;
  const Lanes a = length(thigh_link), b = length(shank_link), distance = length(reach);
  const Point thigh = (1.0 / a) * thigh_link, shank = (1.0 / b) * shank_link;
  const Point normal = planeNormal(leg.flexion_axis, thigh, shank);
  // The flexion that puts the ankle at the right distance, then the leg as a whole towards the
  // target.
  const Lanes cosine = lesser(
      larger((distance * distance - a * a - b * b) / (2.0 * a * b), Lanes{} - 1.0), Lanes{} + 1.0);
  const Lanes sine = root(1.0 - cosine * cosine);
  const Point bent = cosine * thigh + sine * cross(normal, thigh);
  LegTurns turns;
  turns.thigh = shortestTurn(unit(a * thigh + b * bent), (1.0 / distance) * reach);
  turns.shank = product(turns.thigh, shortestTurn(shank, bent));
  turns.cosine = cosine;
  turns.solved = (distance <= a + b) & (distance >= larger(a - b, b - a)) & (distance > 0.0);
  return turns;
}

}  // namespace
}  // namespace amble
