#include "animation/synthesis/motion_shares.h"

#include <algorithm>

namespace amble {
namespace {

const TransitionBlend::Joined* transitionOf(const TransitionBlend& blend, int stop, Side side) {
  return stop == 1 ? blend.stop(side) : blend.start(side);
}

}  // namespace

MotionShares::MotionShares(const MotionLibrary& library, const WalkSynthesizer& synthesizer)
    : library_(library),
      blend_(library, synthesizer.stature() / library.stature, synthesizer.settings().speed),
      turns_(library, synthesizer.stature() / library.stature) {
  motions_.push_back({library.find("stand")});
  for (const GaitBlend::Share& share : blend_.shares(library, 0.0, 0.0)) {
    motions_.emplace_back();
    for (const std::string& name : share.motions) motions_.back().push_back(library.find(name));
  }
  transitions_ = motions_.size();
  for (const int stop : {0, 1}) {
    for (const Side side : {kLeft, kRight}) {
      if (const auto* joined = transitionOf(blend_.transitions(), stop, side))
        motions_.push_back({joined->motion});
    }
  }
  for (int i = 0; i < turns_.size(); ++i) motions_.push_back({&turns_.motion(i)});
}

// As WalkController mixes them.
std::vector<double> MotionShares::at(const FrameState& state) const {
  std::vector<double> shares = {state.posture};
  for (const GaitBlend::Share& share :
       blend_.shares(library_, state.slower, state.blended_turn_rate))
    shares.push_back((1.0 - state.posture) * share.share);
  shares.resize(motions_.size(), 0.0);
  mix(0, state.start, shares);
  mix(1, state.stop, shares);
  if (state.spot.turn >= 0) {
    std::fill(shares.begin(), shares.end(), 0.0);
    shares[shares.size() - turns_.size() + state.spot.turn] = 1.0;
  }
  return shares;
}

void MotionShares::mix(int stop, const TransitionMoment& moment,
                       std::vector<double>& shares) const {
  if (!moment.there) return;
  const auto* joined = transitionOf(blend_.transitions(), stop, moment.side);
  const double own = joined->share(moment.clock);
  for (double& share : shares) share *= 1.0 - own;
  size_t at = 0;
  if (moment.clock > -joined->sequence.sway) {
    at = transitions_;
    while (motions_[at][0] != joined->motion) ++at;
  }
  shares[at] += own;
}

}  // namespace amble
