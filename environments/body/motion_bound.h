/// How far body parts can move between two frames, where a player moves the root linearly and turns
/// each joint by slerp.
///
/// Two bounds for a point of a part's axis, of which the smaller counts. (1) It moves by no more
/// than the root does plus, for each joint above it, the joint's angle times its reach (DESIGN.md,
/// section 3): link by link, the length of each times all angles above it. (2) With every joint
/// turning at a constant rate, a point o_1 + R_1 (o_2 + R_2 (...)) has a second derivative of at
/// most A = sum over links k of |o_k| (theta_1 + ... + theta_k)^2 in units of the interval, so it
/// leaves the straight line between its two ends by no more than A / 8. The first is tight for an
/// arm that swings, the second for a planted foot, over which hip, knee and ankle undo one another.
#pragma once

#include <algorithm>

namespace amble {

/// Of one part over one interval.
struct PartMotion {
  double path = 0.0;  ///< length of the way of any point of its axis, at most [m]
  /// How far such a point may be from the straight line between its two ends [m].
  double bend = 0.0;

  /// The same for each half of the interval.
  PartMotion halved() const { return {0.5 * path, 0.25 * bend}; }
  /// How far a point of the axis may be from where it is at the nearer end of the interval [m]: at
  /// t <= 1/2 it is at most t c + A t (1 - t) / 2 from its first place, c the distance between its
  /// ends.
  /// @param chord  the larger distance that an end of the axis has moved [m]
  double near(double chord) const { return std::min(0.5 * path, 0.5 * chord + bend) + kRounding; }

  static constexpr double kRounding = 1e-9;  ///< [m]
};

}  // namespace amble
