/// What a foot is about: where it stands or between which prints it swings, how far it is, and how
/// it rolls.
#pragma once

#include <Eigen/Core>

namespace amble {

/// Where a foot stands: middle of the sole's length on the ground [m, World], heading [rad] and the
/// normal of the plane that the sole lies in [unit, z > 0].
struct FootPlace {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double heading = 0.0;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
};

/// Rise per metre of the plane that a foot stands in, along a direction in plan [1, up positive].
inline double tiltAlong(const FootPlace& place, const Eigen::Vector2d& direction) {
  return -place.normal.head<2>().dot(direction) / place.normal.z();
}

/// How much higher `b` is than where the slope under both leads from `a`: a step up or down [m].
inline double stepHeight(const FootPlace& a, const FootPlace& b) {
  const Eigen::Vector2d line = (b.position - a.position).head<2>();
  const double slope = 0.5 * (tiltAlong(a, line) + tiltAlong(b, line));
  return b.position.z() - a.position.z() - slope;
}

/// How a swing departs from the captured one, to clear what lies between its prints.
struct SwingShape {
  double lift = 1.0;   ///< times the captured height [> 0]
  double extra = 0.0;  ///< height added to that [m, >= 0]
  double rise = 0.5;   ///< shares of the swing over which it is added, and taken away [> 0, < 1]
  double fall = 0.5;
  /// Shares of the swing, at its begin and at its end, in which the foot goes up and down only
  /// [>= 0, together < 0.6].
  double delay = 0.0, early = 0.0;
};

/// Which swing a foot follows (SwingCycles): a captured walk's, start's or stop's, or that of a
/// small step in which a turn on the spot is made.
enum class SwingKind { kWalk, kFirst, kLast, kSpot };

/// What a foot is about in a frame.
struct FootState {
  FootPlace from;  ///< where it stands, or stood last
  FootPlace to;    ///< where it goes while it swings; else `from`
  /// 0 to 1: planted, from strike to lift-off; above 1 to 2: swinging, from lift-off to strike.
  double at = 0.0;
  /// How much of the captured heel strike is kept: 0 lands flat, -1 on the ball [-1, 1].
  double strike_roll = 1.0;
  double lift_roll = 1.0;  ///< how much of the captured rise of the heel is kept [0, 1]
  SwingShape swing;        ///< of the swing that the foot is in
  SwingKind kind = SwingKind::kWalk;
  double turn_rate = 0.0;  ///< of a walk's swing [rad/s], left positive
  double slower = 0.0;     ///< the same: by how much than the plan's (WalkDepartures) [m/s, >= 0]

  bool planted() const { return at <= 1.0; }
};

/// Whether both follow the same captured cycle (SwingCycles::of).
inline bool followsSame(const FootState& a, const FootState& b) {
  return a.kind == b.kind && a.turn_rate == b.turn_rate && a.slower == b.slower;
}

}  // namespace amble
