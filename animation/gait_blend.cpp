#include "animation/gait_blend.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace amble {
namespace {

constexpr int kMaxHarmonics = 12;

// Rotations do not scale; the root's three lengths do.
Eigen::MatrixXd interleaved(const FourierSeries& series, int harmonics, double scale) {
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(series.channels(), 2 * harmonics + 2);
  for (int k = 0; k <= series.harmonics(); ++k) {
    m.col(2 * k) = series.alpha.col(k);
    m.col(2 * k + 1) = series.beta.col(k);
  }
  m.topRows(3) *= scale;
  return m;
}

}  // namespace

GaitBlend::GaitBlend(const MotionLibrary& library, double scale) {
  std::vector<const WalkCycle*> straight;
  int harmonics = 0;
  for (const Motion& motion : library.motions) {
    if (motion.kind != MotionKind::kWalk) continue;
    harmonics = std::max(harmonics, motion.cycle.series.harmonics());
    if (!motion.turning) straight.push_back(&motion.cycle);
  }
  if (straight.empty()) throw std::invalid_argument("a motion library without a straight walk");
  for (const Motion& motion : library.motions) {
    if (motion.kind != MotionKind::kWalk) continue;
    Mean& mean = !motion.turning ? straight_ : motion.cycle.turn_rate > 0.0 ? left_ : right_;
    add(mean, motion.cycle, harmonics, scale);
  }
  for (Mean* mean : {&straight_, &left_, &right_}) {
    if (mean->count == 0) continue;
    mean->coefficients /= mean->count;
    mean->turn_rate /= mean->count * std::sqrt(scale);
  }
  straight_.turn_rate = 0.0;
  max_turn_rate_ =
      left_.count > 0 && right_.count > 0 ? std::min(left_.turn_rate, -right_.turn_rate) : kNoTurns;
  averageFeet(straight, scale);
}

void GaitBlend::add(Mean& mean, const WalkCycle& cycle, int harmonics, double scale) {
  const Eigen::MatrixXd coefficients = interleaved(cycle.series, harmonics, scale);
  if (mean.count++ == 0) {
    mean.coefficients = coefficients;
  } else {
    mean.coefficients += coefficients;
  }
  mean.turn_rate += cycle.turn_rate;
}

// Also what else a straight walk says: speed, step, width, where the feet go.
void GaitBlend::averageFeet(const std::vector<const WalkCycle*>& straight, double scale) {
  const double share = 1.0 / static_cast<double>(straight.size());
  double speed = 0.0, step = 0.0;
  for (const WalkCycle* cycle : straight) {
    speed += share * cycle->speed * std::sqrt(scale);
    step += share * cycle->plantedStepLength() * scale;
    step_width_ += share * cycle->step_width * scale;
    foot_forward_ += share * cycle->foot_forward * scale;
    toe_out_ += share * 0.5 * (cycle->toe_out[kLeft] - cycle->toe_out[kRight]);
  }
  law_ = StrideLaw(speed, step);
  for (const Side side : {kLeft, kRight}) {
    FootCycle& foot = feet_[side];
    foot.pitch.assign(FootCycle::kStanceSamples + FootCycle::kSwingSamples, 0.0);
    for (const WalkCycle* cycle : straight) {
      const FootCycle& one = cycle->feet[side];
      for (int k = 0; k < 4; ++k) {
        foot.progress[k] += share * one.progress[k];
        foot.height[k] += share * one.height[k] * scale;
        foot.sideways[k] += share * one.sideways[k] * scale;
        foot.roll[k] += share * one.roll[k];
        foot.yaw[k] += share * one.yaw[k];
      }
      for (size_t i = 0; i < foot.pitch.size(); ++i) foot.pitch[i] += share * one.pitch[i];
    }
  }
}

void GaitBlend::evaluate(double phase, double turn_rate, double step_length,
                         Eigen::VectorXd& channels) const {
  const Mean& turn = turn_rate > 0.0 ? left_ : right_;
  const double weight = turn.count > 0 ? std::clamp(turn_rate / turn.turn_rate, 0.0, 1.0) : 0.0;
  const double warp = step_length / law_.capturedStep();
  std::array<double, 2 * kMaxHarmonics + 2> basis;
  const auto columns = straight_.coefficients.cols();
  fourierBasis(phase, static_cast<int>(columns / 2) - 1, basis.data());
  for (Eigen::Index k = 2; k < columns; ++k) basis[k] *= warp;
  const Eigen::Map<const Eigen::VectorXd> b(basis.data(), columns);
  channels.noalias() = (1.0 - weight) * (straight_.coefficients * b);
  if (weight > 0.0) channels.noalias() += weight * (turn.coefficients * b);
  // Height: warped once above, once more here.
  const auto mean_height = [&](const Mean& m) { return m.coefficients(2, 0); };
  double mean = (1.0 - weight) * mean_height(straight_);
  if (weight > 0.0) mean += weight * mean_height(turn);
  channels[2] = mean + warp * (channels[2] - mean);
}

}  // namespace amble
