/// What cycle_lanes.h says, of four frames at once, written once for every instruction set
/// (lanes.h).
#pragma once

#include <algorithm>

#include "animation/library/harmonics.h"
#include "animation/synthesis/cycle_lanes.h"
#include "base/lanes.h"

namespace amble {
namespace {

// cos and sin of 2 pi k phase, k = 1 to harmonics, interleaved.
inline void basisOf(const Lanes& phase, int harmonics, Lanes* basis) {
  constexpr double kTurn = 6.28318530717958647692;
  const SinCos first = sinCos(kTurn * phase);
  Lanes c = first.cosine, s = first.sine;
  for (int k = 0; k < harmonics; ++k) {
    basis[2 * k] = c;
    basis[2 * k + 1] = s;
    const Lanes next = c * first.cosine - s * first.sine;
    s = c * first.sine + s * first.cosine;
    c = next;
  }
}

// Adds `pace` to the channels, or begins them with it: its mean times the weights, its amplitudes
// warped too. Three channels at a time: a rotation vector, or the root's.
template <bool kBegins>
inline void addPace(const LanePace& pace, int channels, const Lanes& weight, const Lanes& warp,
                    const Lanes* basis, double* values) {
  const int terms = 2 * pace.harmonics, columns = terms + 1;
  Lanes amplitudes[2 * kMaxHarmonics];
  for (int k = 0; k < terms; ++k) amplitudes[k] = weight * warp * basis[k];
  for (int row = 0; row < channels; row += 3) {
    const double *x = pace.coefficients + row * columns, *y = x + columns, *z = y + columns;
    Point sum = {};
    const auto add = [&](int k) {
      sum.x += x[1 + k] * amplitudes[k];
      sum.y += y[1 + k] * amplitudes[k];
      sum.z += z[1 + k] * amplitudes[k];
    };
    for (int k = 0; k < terms; k += 2) add(k), add(k + 1);  // of a harmonic
    double* value = values + 4 * row;
    const auto put = [&](int i, const Lanes& more) {
      store(value + i, (kBegins ? Lanes{} : loaded(value + i)) + more);
    };
    put(0, weight * x[0] + sum.x);
    put(4, weight * y[0] + sum.y);
    put(8, weight * z[0] + sum.z);
  }
}

inline void blendLanes(const LaneBlend& blend, int channels, double* values) {
  Lanes basis[2 * kMaxHarmonics];
  int harmonics = 0;
  for (int i = 0; i < blend.count; ++i)
    harmonics = std::max(harmonics, blend.paces[i].pace->harmonics);
  basisOf(loaded(blend.phase), harmonics, basis);
  if (blend.count == 0) std::memset(values, 0, sizeof(double) * 4 * channels);
  const Lanes step = loaded(blend.step_length);
  for (int i = 0; i < blend.count; ++i) {
    const LanePace& pace = *blend.paces[i].pace;
    const Lanes weight = loaded(blend.paces[i].weight), warp = step / pace.step;
    if (i == 0)
      addPace<true>(pace, channels, weight, warp, basis, values);
    else
      addPace<false>(pace, channels, weight, warp, basis, values);
  }
}

// expRotation: series of the half angle's square x, cos as the sum of (-x)^k / (2 k)!, sin over the
// angle as that of (-x)^k / (2 k + 1)!, up to turns of 2 radians.
constexpr int kSeriesTerms = 10;
struct Series {
  double cosine[kSeriesTerms] = {}, sine[kSeriesTerms] = {};
  constexpr Series() {
    double factorial = 1.0;
    for (int k = 0; k < kSeriesTerms; ++k) {
      if (k > 0) factorial *= (2.0 * k - 1.0) * (2.0 * k);
      cosine[k] = 1.0 / factorial;
      sine[k] = 1.0 / (factorial * (2.0 * k + 1.0));
    }
  }
};
constexpr Series kSeries;

inline Turn exponential(const Point& v) {
  const Lanes square = 0.25 * (v.x * v.x + v.y * v.y + v.z * v.z);
  Lanes c = kSeries.cosine[kSeriesTerms - 1] + Lanes{},
        s = kSeries.sine[kSeriesTerms - 1] + Lanes{};
  for (int k = kSeriesTerms - 2; k >= 0; --k) {
    c = kSeries.cosine[k] - c * square;
    s = kSeries.sine[k] - s * square;
  }
  if (any(square > 1.0)) {
    const Lanes half = root(square);
    const SinCos far = sinCos(half);
    c = square > 1.0 ? far.cosine : c;
    s = square > 1.0 ? far.sine / half : s;
  }
  s *= 0.5;
  return {s * v.x, s * v.y, s * v.z, c};
}

inline Turn referenceAt(const double* reference, int joint) {
  const double* q = reference + 4 * joint;
  return {q[0] + Lanes{}, q[1] + Lanes{}, q[2] + Lanes{}, q[3] + Lanes{}};
}

inline void projectLanes(int joints, const double* reference, const double* channels,
                         const LaneRoots& roots, double* const position[4],
                         double* const rotations[4]) {
  const auto channel = [&](int i) { return loaded(channels + 4 * i); };
  const SinCos half = sinCos(0.5 * loaded(roots.heading)), lean = sinCos(0.5 * loaded(roots.lean));
  const Lanes c = half.cosine * half.cosine - half.sine * half.sine,
              s = 2.0 * half.sine * half.cosine;
  const Lanes p[3] = {loaded(roots.position) + (c * channel(0) - s * channel(1)),
                      loaded(roots.position + 4) + (s * channel(0) + c * channel(1)),
                      loaded(roots.position + 8) + channel(2)};
  for (int lane = 0; lane < 4; ++lane)
    for (int k = 0; k < 3; ++k) position[lane][k] = p[k][lane];
  const Turn heading = {Lanes{}, Lanes{}, half.sine, half.cosine};
  const Turn about_left = {-lean.sine * s, lean.sine * c, Lanes{}, lean.cosine};
  for (int j = 0; j < joints; ++j) {
    const Point v = {channel(3 + 3 * j), channel(4 + 3 * j), channel(5 + 3 * j)};
    Turn q = product(referenceAt(reference, j), exponential(v));
    if (j == 0) q = product(about_left, product(heading, q));
    storeTurn(rotations, j, q);
  }
}

}  // namespace
}  // namespace amble
