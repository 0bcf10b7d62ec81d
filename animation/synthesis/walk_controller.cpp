#include "animation/synthesis/walk_controller.h"

#include <algorithm>
#include <cmath>

#include "base/rotation.h"

namespace amble {

void projectChannels(const Eigen::VectorXd& channels,
                     const std::vector<Eigen::Quaterniond>& reference,
                     const Eigen::Vector3d& position, double heading, Eigen::Vector3d& p_WR,
                     std::span<Eigen::Quaterniond> rotations) {
  const double c = std::cos(heading), s = std::sin(heading);
  p_WR = position + Eigen::Vector3d(c * channels[0] - s * channels[1],
                                    s * channels[0] + c * channels[1], channels[2]);
  for (size_t j = 0; j < rotations.size(); ++j) {
    const Eigen::Vector3d v = channels.segment<3>(3 + 3 * static_cast<Eigen::Index>(j));
    rotations[j] = reference[j] * expRotation(v);
  }
  rotations[0] = aboutZ(heading) * rotations[0];
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

bool WalkController::apply(AnimationBuffer& buffer) const {
  Eigen::VectorXd channels(stand_.size());
  for (int i = 0; i < buffer.size(); ++i) {
    const FrameState& state = buffer.states[i];
    if (state.standing >= 1.0) {
      channels = stand_;
    } else {
      blend_.evaluate(state.phase, state.blended_turn_rate, state.step_length, channels);
      channels[0] += carriage_.lead;
      channels[2] -= lowering(state.step_length) * loweringShare(state.phase);
      if (state.standing > 0.0) channels += state.standing * (stand_ - channels);
    }
    channels[1] += state.sway;
    channels[2] -= state.crouch;
    projectChannels(channels, reference_, state.position, state.heading, buffer.poses.p_WR(i),
                    buffer.poses.rotations(i));
    if (state.lean != 0.0) {
      const Eigen::Vector3d left(-std::sin(state.heading), std::cos(state.heading), 0.0);
      Eigen::Quaterniond& root = buffer.poses.rotations(i)[0];
      root = Eigen::AngleAxisd(state.lean, left) * root;
    }
  }
  return true;
}

}  // namespace amble
