#include "animation/editing/root_rise.h"

#include <algorithm>
#include <cmath>

#include "base/rotation.h"
#include "base/statistics.h"

namespace amble {
namespace {

// Steps so much shorter than the leg put a foot beside the other: the ratio is its limit, that of
// the squares.
constexpr double kShort = 0.1;

/// Eq. 6.1: how much lower the hip is in double support than over the foot that stands [m].
double fall(double stride, double leg) {
  const double half = std::min(0.5 * stride, 0.99 * leg);
  return leg - std::sqrt(leg * leg - half * half);
}

/// The middle of a double support, and the step about it.
struct DoubleSupport {
  double middle = 0.0;  // [frames]
  double stride = 0.0;  // [m]
};

std::vector<DoubleSupport> doubleSupports(const GaitMeasures& gait, double frame_time) {
  std::vector<DoubleSupport> supports;
  for (const StepMeasure& step : gait.steps) {
    double lift_off = step.strike;  // of the other foot
    for (const PlantMeasures& plant : gait.plants) {
      const bool stands = plant.plant.strike * frame_time < step.strike;
      if (plant.side != step.side && stands) lift_off = plant.plant.lift_off * frame_time;
    }
    const double end = std::clamp(lift_off, step.strike, step.strike + 0.5 * step.duration);
    supports.push_back({0.5 * (step.strike + end) / frame_time, step.stride});
  }
  return supports;
}

/// How much the captured root falls from over a foot to double support: the median [m, >= 0].
double capturedFall(const std::vector<DoubleSupport>& supports,
                    const std::vector<Eigen::Vector3d>& root) {
  std::vector<double> falls;
  for (size_t k = 0; k + 1 < supports.size(); ++k) {
    const int from = static_cast<int>(supports[k].middle);
    const int to =
        std::min(static_cast<int>(supports[k + 1].middle) + 1, static_cast<int>(root.size()) - 1);
    double highest = root[from].z();
    for (int i = from; i <= to; ++i) highest = std::max(highest, root[i].z());
    falls.push_back(std::max(0.0, highest - 0.5 * (root[from].z() + root[to].z())));
  }
  return median(falls);
}

}  // namespace

double riseRatio(double stride, double factor, double leg) {
  if (stride < kShort * leg) return factor * factor;
  return fall(factor * stride, leg) / fall(stride, leg);
}

void riseWithStride(const CapturedWalk& walk, const std::function<double(int frame)>& factor,
                    WalkTracks& tracks) {
  const GaitMeasures& gait = walk.analysis.gait;
  const std::vector<DoubleSupport> supports = doubleSupports(gait, walk.clip.frame_time);
  const int frames = walk.clip.frames(), count = static_cast<int>(supports.size());
  if (count < 2) return;
  const double captured = capturedFall(supports, tracks.root);
  const double leg = gait.leg_length * (1.0 + kAnkleHeightOfLeg);
  for (int k = 0; k < count; ++k) {
    const double middle = supports[k].middle;
    const double before = k > 0 ? middle - supports[k - 1].middle : supports[1].middle - middle;
    const double after = k + 1 < count ? supports[k + 1].middle - middle : before;
    const int at = std::clamp(static_cast<int>(std::lround(middle)), 0, frames - 1);
    const double lower = captured * (riseRatio(supports[k].stride, factor(at), leg) - 1.0);
    const int first = std::max(0, static_cast<int>(std::ceil(middle - 0.5 * before)));
    const int last = std::min(frames - 1, static_cast<int>(std::floor(middle + 0.5 * after)));
    for (int i = first; i <= last; ++i) {
      const double away = (i - middle) / (i < middle ? before : after);  // [-0.5, 0.5]
      tracks.root[i].z() -= lower * 0.5 * (1.0 + std::cos(2.0 * kPi * away));
    }
  }
}

}  // namespace amble
