#include "animation/steps/step_timing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/ease.h"

namespace amble {

StepTiming::StepTiming(const TimedSteps& steps)
    : lengths_(steps.lengths),
      frame_time_(steps.frame_time),
      start_sway_(steps.start_sway),
      stop_sway_(steps.stop_sway) {
  const double wanted =
      std::accumulate(steps.durations.begin(), steps.durations.end(),
                      start_sway_ * steps.durations.front() + stop_sway_ * steps.durations.back());
  frames_ = std::max(2, static_cast<int>(std::lround(wanted / frame_time_)));
  const double scale = frames_ * frame_time_ / wanted;
  first_ = scale * steps.durations.front();
  last_ = scale * steps.durations.back();
  std::vector<double> times = {start_sway_ * first_}, nodes = {0.0};
  for (size_t i = 0; i < steps.durations.size(); ++i) {
    const double duration = scale * steps.durations[i];
    times.push_back(times.back() + duration);
    nodes.push_back(nodes.back() + 1.0);
    speeds_.push_back((steps.arcs[i + 1] - steps.arcs[i]) / duration);
  }
  // Cadence at a walking stance is its speed over its step.
  const auto cadence = [](double speed, double length, double duration) {
    return speed > 0.0 ? speed / length : 1.0 / duration;
  };
  progress_ = CubicSpline(times, std::move(nodes),
                          cadence(steps.first_speed, lengths_.front(), steps.durations.front()),
                          cadence(steps.last_speed, lengths_.back(), steps.durations.back()));
  progress_.keepRising();
  arc_ = CubicSpline(std::move(times), steps.arcs, steps.first_speed, steps.last_speed);
  arc_.keepRising();
}

SpeedProfile::Sample StepTiming::at(int frame) const {
  const double t = frame * frame_time_;
  const double before = start_sway_ * first_ - t;
  if (before > 0.0) return {0.0, 0.0, 0.0, lengths_.front(), -before / first_};
  const double after = t - (frames_ * frame_time_ - stop_sway_ * last_);
  if (after > 0.0 && stop_sway_ > 0.0)
    return {arc_.at(t), 0.0, progress_.at(t), lengths_.back(), after / last_};
  const double progress = progress_.at(t);
  const int last = static_cast<int>(lengths_.size()) - 1;
  const int i = std::clamp(static_cast<int>(progress), 0, last - 1);
  const double ease = smoothstep(progress - i);
  return {arc_.at(t), arc_.slope(t), progress,
          lengths_[i] + ease * (lengths_[i + 1] - lengths_[i])};
}

}  // namespace amble
