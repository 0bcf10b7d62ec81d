#include "animation/steps/stride_law.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "animation/steps/captured_shares.h"

namespace amble {

double StrideLaw::stepLength(double speed) const {
  const double ratio = speed / speed_;
  return step_ * (ratio >= slow_ ? std::pow(ratio, power_) : ratio / kSlowestCadence);
}

double StrideLaw::speed(double step_length) const {
  const double ratio = step_length / step_;
  const double slow = std::pow(kSlowestCadence, power_ / (1.0 - power_));
  return speed_ * (ratio >= slow ? std::pow(ratio, 1.0 / power_) : ratio * kSlowestCadence);
}

void StrideLaw::setSupports(const std::vector<Support>& captured, double leg_length) {
  leg_length_ = leg_length;
  supports_ = captured;
  for (Support& at : supports_) at.share /= doubleSupportNorm(at.speed, leg_length);
}

void StrideLaw::addTurn(int way, const Turn& turn) {
  turns_[way].push_back({turn.rate, std::clamp(turn.share, kLeastTurned, kMostTurned)});
}

double StrideLaw::turnedShare(double rate) const {
  const std::vector<Turn>& turns = turns_[rate > 0.0 ? 0 : 1];
  const CapturedShares shares = capturedShares(
      turns.size(), [&](size_t i) { return turns[i].rate; }, std::abs(rate));
  double share = 1.0;
  if (shares.of_low > 0.0) share += shares.of_low * (turns[shares.low].share - 1.0);
  if (shares.of_next > 0.0) share += shares.of_next * (turns[shares.low + 1].share - 1.0);
  return share;
}

double StrideLaw::doubleSupport(double speed) const {
  const double norm = doubleSupportNorm(speed, leg_length_);
  if (supports_.empty()) return norm;
  const auto next = std::upper_bound(supports_.begin(), supports_.end(), speed,
                                     [](double v, const Support& at) { return v < at.speed; });
  const Support& above = next == supports_.end() ? supports_.back() : *next;
  const Support& below = next == supports_.begin() ? above : *(next - 1);
  const double span = above.speed - below.speed;
  const double t = span > 0.0 ? (speed - below.speed) / span : 0.0;
  const double share = norm * (below.share + t * (above.share - below.share));
  return std::clamp(share, norm - kSupportOff, norm + kSupportOff);
}

double doubleSupportNorm(double speed, double leg_length) {
  // Middles of the classes very slow, slow, free, fast and very fast; the outer ranges are taken as
  // wide as the others.
  constexpr std::array<double, 5> kSpeed = {0.159, 0.295, 0.432, 0.568, 0.704};
  constexpr std::array<double, 5> kShare = {0.36, 0.24, 0.19, 0.16, 0.14};
  constexpr double kGravity = 9.81;  // [m/s^2]
  const double v = speed / std::sqrt(kGravity * leg_length);
  if (v <= kSpeed.front()) return kShare.front();
  for (size_t i = 1; i < kSpeed.size(); ++i) {
    if (v > kSpeed[i]) continue;
    const double t = (v - kSpeed[i - 1]) / (kSpeed[i] - kSpeed[i - 1]);
    return kShare[i - 1] + t * (kShare[i] - kShare[i - 1]);
  }
  return kShare.back();
}

}  // namespace amble
