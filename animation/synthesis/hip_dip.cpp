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

// A curve over what hips give way, let go towards the stances at both ends.
class LetGo {
 public:
  LetGo(const std::vector<double>& missing, const std::vector<double>& over, double frame_time)
      : missing_(missing), over_(over), frame_time_(frame_time) {}

  // At a frame, where it is let go over so long. What then is missing is made up for at once.
  double at(int frame, int frames_from_end, double fade) const {
    const double dip = over_[frame] * smoothstep(frames_from_end * frame_time_ / fade);
    return dip + std::clamp(missing_[frame] - dip, 0.0, HipDip::kAtOnce);
  }

  // Over how long it is let go to an end: slowly and frames beside the stance are left to make up
  // for much at once, quickly and it leaps there. Legs that then do not reach are worse than that.
  double fade(bool to_last) const {
    double best = 0.0, least = HUGE_VAL;
    for (const double fade : HipDip::kFades) {
      const double jolt = worstJolt(to_last, fade, least);
      if (jolt < least) best = fade, least = jolt;
    }
    return best;
  }

 private:
  // Ends early where it is `enough` or more.
  double worstJolt(bool to_last, double fade, double enough) const {
    constexpr double kUnreached = 1000.0;
    const int n = static_cast<int>(over_.size());
    const int count =
        std::min((n - 1) / 2, static_cast<int>(HipDip::kFades.front() / frame_time_) + 1);
    double worst = 0.0, here = 0.0, before = 0.0;
    for (int k = 1; k <= count && worst < enough; ++k) {
      const int frame = to_last ? n - 1 - k : k;
      const double next = at(frame, k, fade);
      worst = std::max(worst, std::abs(next - 2.0 * here + before) +
                                  kUnreached * std::max(0.0, missing_[frame] - next));
      before = here;
      here = next;
    }
    return worst;
  }

  const std::vector<double>& missing_;
  const std::vector<double>& over_;
  double frame_time_;
};

}  // namespace

double givenWay(double missing) {
  const double squared = missing * missing;
  return missing + HipDip::kMore * squared / (squared + HipDip::kFar * HipDip::kFar);
}

std::vector<double> hipDip(const std::vector<double>& missing, double frame_time) {
  const int n = static_cast<int>(missing.size());
  std::vector<double> dip = ofStances(missing.front(), missing.back(), n, frame_time);
  std::vector<double> more(n);
  for (int i = 0; i < n; ++i) more[i] = std::max(0.0, missing[i] - dip[i]);
  if (std::all_of(more.begin(), more.end(), [](double m) { return m == 0.0; })) return dip;
  const int reach = std::max(1, static_cast<int>(std::lround(HipDip::kTime / frame_time)));
  std::vector<double> given(n);
  std::ranges::transform(more, given.begin(), givenWay);
  const RangeMaximum largest(std::move(given));
  std::vector<double> over(n);
  for (int i = 0; i < n; ++i)
    over[i] = largest.over(std::max(0, i - reach), std::min(n - 1, i + reach));
  for (int pass = 0; pass < 2; ++pass) smoothed(over, reach / 2);
  const LetGo curve(more, over, frame_time);
  const double first = curve.fade(false), last = curve.fade(true);
  for (int i = 1; i + 1 < n; ++i) {
    const int begin = i, end = n - 1 - i;
    dip[i] += curve.at(i, std::min(begin, end), begin < end ? first : last);
  }
  return dip;
}

}  // namespace amble
