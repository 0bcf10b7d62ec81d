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
    roots.heading[i] = states[i]->heading + states[i]->facing;
    roots.lean[i] = states[i]->lean;
    position[i] = poses.p_WR(frames[i]).data();
    rotations[i] = poses.rotations(frames[i])[0].coeffs().data();
  }
  cycleKernel().project(poses.joints(), reference[0].coeffs().data(), channels.data(), roots,
                        position.data(), rotations.data());
}

WalkController::WalkController(const GaitBlend& blend, const CapturedTurns& turns,
                               const std::vector<Eigen::Quaterniond>& reference,
                               const Eigen::VectorXd& stand_channels, double lead)
    : blend_(blend), turns_(turns), reference_(reference), stand_(stand_channels), lead_(lead) {}

// Of a frame beside three others: what walking and standing add to its cycle.
void WalkController::carry(const FrameState& state, int frame, std::span<double> scratch,
                           std::span<double> channels) const {
  const auto channel = [&](Eigen::Index i) -> double& { return channels[4 * i + frame]; };
  channel(0) += lead_;
  if (state.posture > 0.0) {
    for (Eigen::Index i = 0; i < stand_.size(); ++i) {
      double& value = channel(i);
      value = state.posture >= 1.0 ? stand_[i] : value + state.posture * (stand_[i] - value);
    }
  }
  const auto mix = [&](const TransitionBlend::Joined* joined, const TransitionMoment& moment) {
    joined->mix(moment.clock, state.step_length, scratch, &channels[frame], 4);
  };
  const TransitionBlend& transitions = blend_.transitions();
  if (state.start.there) mix(transitions.start(state.start.side), state.start);
  if (state.stop.there) mix(transitions.stop(state.stop.side), state.stop);
  if (state.spot.turn >= 0) {
    turnChannels(turns_.sequence(state.spot.turn), state.spot.clock, scratch);
    for (Eigen::Index i = 0; i < stand_.size(); ++i) channel(i) = scratch[i];
  }
  channel(1) += state.sway;
}

// Four frames at a time; the last ones fewer, of which one stands for what is missing.
bool WalkController::apply(AnimationBuffer& buffer) const {
  std::vector<double> channels(4 * stand_.size()), scratch(stand_.size());
  for (int first = 0; first < buffer.size(); first += 4) {
    std::array<int, 4> frames;
    std::array<const FrameState*, 4> states;
    GaitBlend::Frames moments;
    for (int i = 0; i < 4; ++i) {
      frames[i] = std::min(first + i, buffer.size() - 1);
      states[i] = &buffer.states[frames[i]];
      moments.phase[i] = states[i]->phase;
      moments.turn_rate[i] = states[i]->blended_turn_rate;
      moments.slower[i] = states[i]->slower;
      moments.step_length[i] = states[i]->step_length;
    }
    blend_.evaluate(moments, channels);
    for (int i = 0; i < 4; ++i) carry(*states[i], i, scratch, channels);
    projectChannels(channels, reference_, states, frames, buffer.poses);
  }
  return true;
}

}  // namespace amble
