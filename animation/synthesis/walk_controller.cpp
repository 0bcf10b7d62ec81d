#include "animation/synthesis/walk_controller.h"

#include <algorithm>
#include <cmath>

#include "base/rotation.h"

namespace amble {

void projectChannels(std::span<const double> channels,
                     const std::vector<Eigen::Quaterniond>& reference,
                     const std::array<const FrameState*, 4>& states,
                     const std::array<int, 4>& frames, PoseArray& poses) {
  LaneRoots roots;
  std::array<double*, 4> position, rotations;
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) roots.position[4 * k + i] = states[i]->position[k];
    roots.heading[i] = states[i]->heading;
    roots.lean[i] = states[i]->lean;
    position[i] = poses.p_WR(frames[i]).data();
    rotations[i] = poses.rotations(frames[i])[0].coeffs().data();
  }
  cycleKernel().project(poses.joints(), reference[0].coeffs().data(), channels.data(), roots,
                        position.data(), rotations.data());
}

WalkController::WalkController(const GaitBlend& blend,
                               const std::vector<Eigen::Quaterniond>& reference,
                               const Eigen::VectorXd& stand_channels, Carriage carriage)
    : blend_(blend),
      reference_(reference),
      stand_(stand_channels),
      carriage_(std::move(carriage)) {}

double WalkController::lowering(double step_length) const {
  const std::vector<double>& table = carriage_.lowering;
  if (table.size() < 2) return 0.0;
  const double at =
      std::clamp(step_length / carriage_.longest, 0.0, 1.0) * static_cast<double>(table.size() - 1);
  const size_t i = std::min(static_cast<size_t>(at), table.size() - 2);
  const double t = at - static_cast<double>(i);
  return table[i] + t * (table[i + 1] - table[i]);
}

double WalkController::height(double phase, double step_length) const {
  Eigen::VectorXd channels(stand_.size());
  blend_.evaluate(phase, 0.0, step_length, channels);
  return channels[2] - lowering(step_length) * loweringShare(phase);
}

double WalkController::loweringShare(double phase) {
  return kLeastLowering + (1.0 - kLeastLowering) * 0.5 * (1.0 + std::cos(4.0 * kPi * phase));
}

// Of a frame beside three others: what walking and standing add to its cycle.
void WalkController::carry(const FrameState& state, int frame, std::span<double> channels) const {
  const auto channel = [&](Eigen::Index i) -> double& { return channels[4 * i + frame]; };
  if (state.standing < 1.0) {
    channel(0) += carriage_.lead;
    channel(2) -= lowering(state.step_length) * loweringShare(state.phase);
  }
  if (state.standing > 0.0) {
    for (Eigen::Index i = 0; i < stand_.size(); ++i) {
      double& value = channel(i);
      value = state.standing >= 1.0 ? stand_[i] : value + state.standing * (stand_[i] - value);
    }
  }
  channel(1) += state.sway;
  channel(2) -= state.crouch;
}

// Four frames at a time; the last ones fewer, of which one stands for what is missing.
bool WalkController::apply(AnimationBuffer& buffer) const {
  std::vector<double> channels(4 * stand_.size());
  for (int first = 0; first < buffer.size(); first += 4) {
    std::array<int, 4> frames;
    std::array<const FrameState*, 4> states;
    GaitBlend::Frames moments;
    for (int i = 0; i < 4; ++i) {
      frames[i] = std::min(first + i, buffer.size() - 1);
      states[i] = &buffer.states[frames[i]];
      moments.phase[i] = states[i]->phase;
      moments.turn_rate[i] = states[i]->blended_turn_rate;
      moments.step_length[i] = states[i]->step_length;
    }
    blend_.evaluate(moments, channels);
    for (int i = 0; i < 4; ++i) carry(*states[i], i, channels);
    projectChannels(channels, reference_, states, frames, buffer.poses);
  }
  return true;
}

}  // namespace amble
