/// Four numbers at once, for kernels that are written once for every instruction set: the files
/// that include this are compiled for one each. Nothing here has a name outside of its file, or the
/// linker would take one of them for all; nothing includes Eigen, for the same reason.
///
/// Sums are in one order, products are not fused, and nothing is asked of the C library but square
/// roots: results are the same to the bit on every machine, and no lane's depend on another's.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace amble {
namespace {

using Lanes = double __attribute__((vector_size(4 * sizeof(double))));
using LaneBits = std::int64_t __attribute__((vector_size(4 * sizeof(double))));

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

inline Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Point operator*(const Lanes& s, const Point& p) { return {s * p.x, s * p.y, s * p.z}; }
inline Lanes dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Lanes length(const Point& p) { return root(dot(p, p)); }
inline Point unit(const Point& p) { return (1.0 / length(p)) * p; }
inline Point cross(const Point& a, const Point& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline Turn turnAt(const double* const rotations[4], int joint) {
  const Four q = transposed({{loaded(rotations[0] + 4 * joint), loaded(rotations[1] + 4 * joint),
                              loaded(rotations[2] + 4 * joint), loaded(rotations[3] + 4 * joint)}});
  return {q.v[0], q.v[1], q.v[2], q.v[3]};
}
inline Turn product(const Turn& a, const Turn& b) {
  return {
      a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z,
      a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

// A joint's frame applied to a point given in it.
template <typename Vector>
inline Point placedAt(const Turn& q, const Point& p, const Vector& x, const Vector& y,
                      const Vector& z) {
  const Lanes ux = 2.0 * (q.y * z - q.z * y), uy = 2.0 * (q.z * x - q.x * z),
              uz = 2.0 * (q.x * y - q.y * x);
  return {p.x + (x + q.w * ux + (q.y * uz - q.z * uy)),
          p.y + (y + q.w * uy + (q.z * ux - q.x * uz)),
          p.z + (z + q.w * uz + (q.x * uy - q.y * ux))};
}
inline Point placed(const Turn& q, const Point& p, const double* v) {
  return placedAt(q, p, v[0], v[1], v[2]);
}
inline Point placed(const Turn& q, const Point& p, const Point& v) {
  return placedAt(q, p, v.x, v.y, v.z);
}

inline bool any(const LaneBits& lanes) {
#if defined(__AVX2__)
  return _mm256_movemask_pd((__m256d)lanes) != 0;
#else
  return (lanes[0] | lanes[1] | lanes[2] | lanes[3]) != 0;
#endif
}

struct SinCos {
  Lanes sine, cosine;
};

// The nearest quarter turn is taken off in two parts, of which the first has few enough digits for
// its multiples to be exact; the rest are fdlibm's polynomials (Sun Microsystems 1993) up to an
// eighth of a turn. Within 3e-16 up to 1e5 radians.
inline __attribute__((always_inline)) SinCos sinCos(const Lanes& angle) {
  constexpr double kQuarters = 0.63661977236758134308;  // 2 / pi
  constexpr double kQuarter = 1.57079632673412561417, kQuarterRest = 6.07710050650619224932e-11;
  constexpr double kRound = 6755399441055744.0;  // 1.5 * 2^52: what is added to it is rounded
  const Lanes shifted = angle * kQuarters + kRound, n = shifted - kRound;
  const LaneBits quarters = (LaneBits)shifted;
  const Lanes r = (angle - n * kQuarter) - n * kQuarterRest, z = r * r;
  const Lanes s =
      r + r * z *
              (-1.66666666666666324348e-01 +
               z * (8.33333333332248946124e-03 +
                    z * (-1.98412698298579493134e-04 +
                         z * (2.75573137070700676789e-06 + z * (-2.50507602534068634195e-08 +
                                                                z * 1.58969099521155010221e-10)))));
  const Lanes c =
      1.0 - 0.5 * z +
      z * z *
          (4.16666666666666019037e-02 +
           z * (-1.38888888888741095749e-03 +
                z * (2.48015872894767294178e-05 +
                     z * (-2.75573143513906633035e-07 +
                          z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)))));
  const LaneBits odd = (quarters & 1) != 0;
  const LaneBits minus = (quarters & 2) != 0, minus_cosine = ((quarters + 1) & 2) != 0;
  const Lanes sine = odd ? c : s, cosine = odd ? s : c;
  return {minus ? -sine : sine, minus_cosine ? -cosine : cosine};
}

inline Turn conjugate(const Turn& q) { return {-q.x, -q.y, -q.z, q.w}; }

// Into the joint's quaternion (x, y, z, w) of each of four poses.
inline void storeTurn(double* const rotations[4], int joint, const Turn& q) {
  const Four four = transposed({{q.x, q.y, q.z, q.w}});
  for (int lane = 0; lane < 4; ++lane) store(rotations[lane] + 4 * joint, four.v[lane]);
}

}  // namespace
}  // namespace amble
