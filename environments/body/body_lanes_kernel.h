/// What body_lanes.h says, of four poses at once, written once for every instruction set (lanes.h).
#pragma once

#include "base/lanes.h"
#include "environments/body/body_lanes.h"

namespace amble {
namespace {

constexpr int kFrameLanes = 7;  // of a joint's scratch: q_WJ (x, y, z, w), p_WJ
// The same: theta_1 + ... + theta_j down to it, how far its origin moves at most, A of that.
constexpr int kTurnedLanes = 3;
constexpr int kCapsuleDoubles = 7;

inline Point rootAt(const LanePoses& poses) {
  const auto along = [&](int k) {
    return Lanes{poses.position[0][k], poses.position[1][k], poses.position[2][k],
                 poses.position[3][k]};
  };
  return {along(0), along(1), along(2)};
}

inline void keep(double* to, const Turn& q, const Point& p) {
  const Lanes all[kFrameLanes] = {q.x, q.y, q.z, q.w, p.x, p.y, p.z};
  std::memcpy(to, all, sizeof all);
}
inline void recall(const double* from, Turn& q, Point& p) {
  Lanes all[kFrameLanes];
  std::memcpy(all, from, sizeof all);
  q = {all[0], all[1], all[2], all[3]};
  p = {all[4], all[5], all[6]};
}

inline void placeLanes(const LaneBody& body, const LanePoses& poses, double* scratch,
                       double* const capsules[4]) {
  constexpr int kJoint = 4 * kFrameLanes;
  keep(scratch, turnAt(poses.rotations, 0), rootAt(poses));
  Turn q;
  Point p;
  for (int j = 1; j < body.joints; ++j) {
    recall(scratch + body.parent[j] * kJoint, q, p);
    keep(scratch + j * kJoint, product(q, turnAt(poses.rotations, j)),
         placed(q, p, body.offset + 3 * j));
  }
  for (int i = 0; i < body.parts; ++i) {
    recall(scratch + body.part_joint[i] * kJoint, q, p);
    const Point from = placed(q, p, body.part_from + 3 * i),
                to = placed(q, p, body.part_to + 3 * i);
    const Four first = transposed({{from.x, from.y, from.z, to.x}}),
               second = transposed({{to.x, to.y, to.z, body.radius[i] + Lanes{}}});
    for (int lane = 0; lane < 4; ++lane) {
      double* capsule = capsules[lane] + i * kCapsuleDoubles;
      store(capsule, first.v[lane]);
      store(capsule + 3, second.v[lane]);
    }
  }
}

// The angle between two rotations, on the shorter way: |a - b| = 2 sin(angle / 4). No less than it
// is: asin(x) <= x (1 + 0.19 x^2) up to x = 1/2, an angle of 120 degrees, as its series has 1/6,
// 3/40, ...; beyond no more than x pi / 2.
inline Lanes angleBetween(const Turn& a, const Turn& b) {
  const auto squared = [](const Lanes& x, const Lanes& y, const Lanes& z, const Lanes& w) {
    return x * x + y * y + (z * z + w * w);
  };
  const Lanes minus = squared(a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w),
              plus = squared(a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w);
  const Lanes x = 0.5 * root(lesser(minus, plus));
  constexpr double kHalfPi = 1.57079632679489661923;
  return 4.0 * (x < 0.5 ? x * (1.0 + 0.19 * x * x) : kHalfPi * x);
}

// The larger distance that an end of a part's axis moves.
inline Lanes chordOf(const double* const a[4], const double* const b[4], int part) {
  Four first, second;
  for (int lane = 0; lane < 4; ++lane) {
    const double *from = a[lane] + part * kCapsuleDoubles, *to = b[lane] + part * kCapsuleDoubles;
    const Lanes d = loaded(to) - loaded(from), e = loaded(to + 3) - loaded(from + 3);
    first.v[lane] = d * d;
    second.v[lane] = e * e;
  }
  const Four one = transposed(first), two = transposed(second);
  return root(larger(one.v[0] + one.v[1] + one.v[2], two.v[0] + two.v[1] + two.v[2]));
}

// The bounds of motion_bound.h, link by link from the root.
inline void measureLanes(const LaneBody& body, const LanePoses& a, const LanePoses& b,
                         const double* const capsules_a[4], const double* const capsules_b[4],
                         double rounding, double* scratch, double* const motions[4],
                         double* const nears[4]) {
  constexpr int kJoint = 4 * kTurnedLanes;
  const Point from = rootAt(a), to = rootAt(b);
  const Lanes dx = to.x - from.x, dy = to.y - from.y, dz = to.z - from.z;
  const auto turned = [&](int joint, int k) { return loaded(scratch + joint * kJoint + 4 * k); };
  store(scratch, angleBetween(turnAt(a.rotations, 0), turnAt(b.rotations, 0)));
  store(scratch + 4, root(dx * dx + dy * dy + dz * dz));
  store(scratch + 8, Lanes{});
  for (int j = 1; j < body.joints; ++j) {
    const int parent = body.parent[j];
    const Lanes angle = turned(parent, 0), arc = body.offset_length[j] * angle;
    double* here = scratch + j * kJoint;
    store(here, angle + angleBetween(turnAt(a.rotations, j), turnAt(b.rotations, j)));
    store(here + 4, turned(parent, 1) + arc);
    store(here + 8, turned(parent, 2) + arc * angle);
  }
  for (int i = 0; i < body.parts; ++i) {
    const int joint = body.part_joint[i];
    const Lanes angle = turned(joint, 0), arc = body.part_length[i] * angle;
    const Lanes path = turned(joint, 1) + arc, bend = 0.125 * (turned(joint, 2) + arc * angle);
    const Lanes near =
        lesser(0.5 * path, 0.5 * chordOf(capsules_a, capsules_b, i) + bend) + rounding;
    for (int lane = 0; lane < 4; ++lane) {
      motions[lane][2 * i] = path[lane];
      motions[lane][2 * i + 1] = bend[lane];
      nears[lane][i] = near[lane];
    }
  }
}

}  // namespace
}  // namespace amble
