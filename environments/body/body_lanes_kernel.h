/// What body_lanes.h says, of four poses at once, written once for every instruction set: the files
/// that include it are compiled for one each. Nothing here has a name outside of its file, or the
/// linker would take one of them for all; nothing includes Eigen, for the same reason.
///
/// Sums are in one order and products are not fused: results are the same to the bit.
#pragma once

#include <cmath>
#include <cstring>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "environments/body/body_lanes.h"

namespace amble {
namespace {

using Lanes = double __attribute__((vector_size(4 * sizeof(double))));
constexpr int kFrameLanes = 7;  // of a joint's scratch: q_WJ (x, y, z, w), p_WJ
// The same: theta_1 + ... + theta_j down to it, how far its origin moves at most, A of that.
constexpr int kTurnedLanes = 3;
constexpr int kCapsuleDoubles = 7;

inline Lanes loaded(const double* from) {
  Lanes v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
inline void store(double* to, const Lanes& v) { std::memcpy(to, &v, sizeof v); }

struct Four {
  Lanes v[4];
};

// Row i of the result is the i-th number of every vector.
inline Four transposed(const Four& m) {
  const Lanes a = __builtin_shufflevector(m.v[0], m.v[1], 0, 4, 2, 6),
              b = __builtin_shufflevector(m.v[0], m.v[1], 1, 5, 3, 7),
              c = __builtin_shufflevector(m.v[2], m.v[3], 0, 4, 2, 6),
              d = __builtin_shufflevector(m.v[2], m.v[3], 1, 5, 3, 7);
  return {{__builtin_shufflevector(a, c, 0, 1, 4, 5), __builtin_shufflevector(b, d, 0, 1, 4, 5),
           __builtin_shufflevector(a, c, 2, 3, 6, 7), __builtin_shufflevector(b, d, 2, 3, 6, 7)}};
}

inline Lanes root(const Lanes& v) {
#if defined(__AVX2__)
  return (Lanes)_mm256_sqrt_pd((__m256d)v);
#else
  return Lanes{std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])};
#endif
}
inline Lanes lesser(const Lanes& a, const Lanes& b) { return a < b ? a : b; }
inline Lanes larger(const Lanes& a, const Lanes& b) { return a < b ? b : a; }

struct Point {
  Lanes x, y, z;
};
struct Turn {
  Lanes x, y, z, w;
};

inline Turn turnAt(const double* const rotations[4], int joint) {
  const Four q = transposed({{loaded(rotations[0] + 4 * joint), loaded(rotations[1] + 4 * joint),
                              loaded(rotations[2] + 4 * joint), loaded(rotations[3] + 4 * joint)}});
  return {q.v[0], q.v[1], q.v[2], q.v[3]};
}
inline Point rootAt(const LanePoses& poses) {
  const auto along = [&](int k) {
    return Lanes{poses.position[0][k], poses.position[1][k], poses.position[2][k],
                 poses.position[3][k]};
  };
  return {along(0), along(1), along(2)};
}

inline Turn product(const Turn& a, const Turn& b) {
  return {
      a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z,
      a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

// A joint's frame applied to a point given in it.
inline Point placed(const Turn& q, const Point& p, const double* v) {
  const Lanes ux = 2.0 * (q.y * v[2] - q.z * v[1]), uy = 2.0 * (q.z * v[0] - q.x * v[2]),
              uz = 2.0 * (q.x * v[1] - q.y * v[0]);
  return {p.x + (v[0] + q.w * ux + (q.y * uz - q.z * uy)),
          p.y + (v[1] + q.w * uy + (q.z * ux - q.x * uz)),
          p.z + (v[2] + q.w * uz + (q.x * uy - q.y * ux))};
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
    const Four first = transposed({{from.x, from.y, from.z, to.x}});
    for (int lane = 0; lane < 4; ++lane) {
      double* capsule = capsules[lane] + i * kCapsuleDoubles;
      store(capsule, first.v[lane]);
      capsule[4] = to.y[lane];
      capsule[5] = to.z[lane];
      capsule[6] = body.radius[i];
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
    const Lanes d = loaded(to) - loaded(from);
    const Lanes e = {to[4] - from[4], to[5] - from[5], 0.0, 0.0};
    first.v[lane] = d * d;
    second.v[lane] = e * e;
  }
  const Four one = transposed(first), two = transposed(second);
  return root(larger(one.v[0] + one.v[1] + one.v[2], one.v[3] + two.v[0] + two.v[1]));
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
