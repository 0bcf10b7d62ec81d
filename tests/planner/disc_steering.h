/// Steering for tests of roadmaps: a disc that walks straight lines between boxes, and through
/// doors one way only.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <atomic>
#include <cmath>
#include <map>
#include <vector>

#include "base/rotation.h"
#include "planner/steering/steering.h"

namespace amble {

/// A line from a to b that may be crossed from its right to its left only.
struct OneWayDoor {
  Eigen::Vector2d a, b;
};

class DiscSteering : public Steering {
 public:
  double radius = 0.2;
  std::vector<Eigen::AlignedBox2d> boxes;
  std::vector<OneWayDoor> doors;
  mutable std::atomic<long long> asked{0};
  /// How often each directed pair of places was asked about, where `counts` says so (from one
  /// thread).
  bool counts = false;
  mutable std::map<std::array<double, 6>, int> pairs;

  SteeringScratchPtr makeScratch() const override { return std::make_unique<SteeringScratch>(); }
  double topSpeed() const override { return 1.0; }
  bool place(Stance&) const override { return true; }

  std::optional<SteeringFailure> stand(Stance& stance, SteeringScratch&) const override {
    return blockedAt(stance.position.head<2>());
  }

  /// 1 m/s; half a second at each end that stands; a walking end is met within 50 degrees of the
  /// line.
  SteerResult steer(const Waypoint& from, const Waypoint& to, SteeringScratch&) const override {
    ++asked;
    if (counts) ++pairs[pairOf(from.stance, to.stance)];
    SteerResult result;
    result.poses = 1;
    const Eigen::Vector2d a = from.stance.position.head<2>(), b = to.stance.position.head<2>();
    const double heading = std::atan2((b - a).y(), (b - a).x());
    for (const Waypoint* end : {&from, &to}) {
      if (end->stance.standing || std::abs(wrapAngle(end->stance.heading - heading)) < 50 * kDegree)
        continue;
      result.failure = {WalkRule::kTurnRate};
      return result;
    }
    if (const auto failure = blockedBetween(a, b)) {
      result.failure = *failure;
      return result;
    }
    WalkEdge edge;
    edge.from = from.stance;
    edge.to = to.stance;
    if (from.any_heading) edge.from.heading = heading;
    if (to.any_heading) edge.to.heading = heading;
    edge.length = (b - a).norm();
    edge.path = RootPath({makeBezier(a, heading, b, heading, 1.0 / 3.0)});
    edge.duration = edge.length + 0.5 * from.stance.standing + 0.5 * to.stance.standing;
    result.edge = edge;
    return result;
  }

  static std::array<double, 6> pairOf(const Stance& a, const Stance& b) {
    return {a.position.x(), a.position.y(), a.heading, b.position.x(), b.position.y(), b.heading};
  }

  std::optional<SteeringFailure> blockedAt(const Eigen::Vector2d& p) const {
    for (size_t i = 0; i < boxes.size(); ++i) {
      if (boxes[i].exteriorDistance(p) < radius) return contact(static_cast<int>(i));
    }
    return std::nullopt;
  }

  std::optional<SteeringFailure> blockedBetween(const Eigen::Vector2d& a,
                                                const Eigen::Vector2d& b) const {
    const int count = 1 + static_cast<int>((b - a).norm() / 0.01);
    for (int i = 0; i <= count; ++i) {
      if (const auto failure = blockedAt(a + (b - a) * i / count)) return failure;
    }
    for (size_t i = 0; i < doors.size(); ++i) {
      const Eigen::Vector2d door = doors[i].b - doors[i].a;
      const double side_a = cross(door, a - doors[i].a), side_b = cross(door, b - doors[i].a);
      const bool meets = cross(b - a, doors[i].a - a) * cross(b - a, doors[i].b - a) <= 0.0;
      if (meets && side_a > 0.0 && side_b <= 0.0) return contact(100 + static_cast<int>(i));
    }
    return std::nullopt;
  }

 private:
  static double cross(const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
    return u.x() * v.y() - u.y() * v.x();
  }
  static SteeringFailure contact(int object) { return {WalkRule::kContact, 0, object}; }
};

inline Eigen::AlignedBox2d box(double x0, double y0, double x1, double y1) {
  return {Eigen::Vector2d(x0, y0), Eigen::Vector2d(x1, y1)};
}

inline Waypoint standing(double x, double y, double heading = 0.0) {
  Waypoint at;
  at.stance.position = {x, y, 0.0};
  at.stance.heading = heading;
  return at;
}

/// A room of 8 x 6 m cut by a wall at x = 4 with a gap, both ends of the wall touching the sides.
///
///   +-------+-------+ 6
///   |       |       |
///   |               |   gap of `width` around y = 4.5
///   |       |       |
///   +-------+-------+ 0
///   0       4       8
inline void twoRooms(DiscSteering& steering, double width) {
  steering.boxes = {box(-1, -1, 9, 0),
                    box(-1, 6, 9, 7),
                    box(-1, -1, 0, 7),
                    box(8, -1, 9, 7),
                    box(3.9, 0, 4.1, 4.5 - width / 2),
                    box(3.9, 4.5 + width / 2, 4.1, 6)};
}

inline const Eigen::AlignedBox2d kRoom = box(0, 0, 8, 6);

}  // namespace amble
