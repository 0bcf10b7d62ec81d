#include "animation/synthesis/hip_dip.h"

#include <algorithm>
#include <cmath>

#include "base/ease.h"
#include "base/range_maximum.h"

namespace amble {
namespace {

// Replaces every value by the mean of those within `half` of it.
void smoothed(std::vector<double>& values, int half) {
  const int n = static_cast<int>(values.size());
  std::vector<double> sums(n + 1, 0.0);
  for (int i = 0; i < n; ++i) sums[i + 1] = sums[i] + values[i];
  for (int i = 0; i < n; ++i) {
    const int first = std::max(0, i - half), last = std::min(n - 1, i + half);
    values[i] = (sums[last + 1] - sums[first]) / (last + 1 - first);
  }
}

// What the stances at both ends lower the hips by, and how they come back.
std::vector<double> ofStances(double first, double last, int frames, double frame_time) {
  std::vector<double> dip(frames, 0.0);
  if (first == 0.0 && last == 0.0) return dip;
  const double time = std::max(1, frames - 1) * frame_time;
  const double recovery = std::min(HipDip::kRecovery, time);
  for (int i = 0; i < frames; ++i) {
    const double t = i * frame_time;
    dip[i] =
        first * (1.0 - smoothstep(t / recovery)) + last * (1.0 - smoothstep((time - t) / recovery));
  }
  dip.front() = first;
  dip.back() = last;
  return dip;
}

}  // namespace

std::vector<double> hipDip(const std::vector<double>& missing, double frame_time) {
  const int n = static_cast<int>(missing.size());
  std::vector<double> dip = ofStances(missing.front(), missing.back(), n, frame_time);
  std::vector<double> more(n);
  for (int i = 0; i < n; ++i) more[i] = std::max(0.0, missing[i] - dip[i]);
  if (std::all_of(more.begin(), more.end(), [](double m) { return m == 0.0; })) return dip;
  const int reach = std::max(1, static_cast<int>(std::lround(HipDip::kTime / frame_time)));
  const RangeMaximum largest(std::move(more));
  std::vector<double> over(n);
  for (int i = 0; i < n; ++i)
    over[i] = largest.over(std::max(0, i - reach), std::min(n - 1, i + reach));
  for (int pass = 0; pass < 2; ++pass) smoothed(over, reach / 2);
  for (int i = 0; i < n; ++i) {
    const double from_end = std::min(i, n - 1 - i) * frame_time;
    const double fade = std::max(HipDip::kShortestFade, over[i] / HipDip::kSpeed);
    dip[i] += over[i] * smoothstep(from_end / fade);
    if (i > 0 && i + 1 < n) dip[i] += std::clamp(missing[i] - dip[i], 0.0, HipDip::kAtOnce);
  }
  return dip;
}

}  // namespace amble
