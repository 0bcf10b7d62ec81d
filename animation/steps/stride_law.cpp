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
  supports_.clear();
  for (const Support& at : captured) supports_.push_back(againstNorm(at));
}

StrideLaw::Support StrideLaw::againstNorm(const Support& support) const {
  return {support.speed, support.steps / doubleSupportNorm(support.speed, leg_length_)};
}

void StrideLaw::addTurn(int way, const Turn& turn) {
  const double share = std::clamp(turn.share, kLeastTurned, kMostTurned);
  turns_[way].push_back({turn.rate, share, againstNorm(turn.support)});
}

// What a straight walk has, mixed with what the turns next to a rate have of it.
template <typename T, typename Of>
T StrideLaw::turned(const T& straight, double rate, const Of& of) const {
  const std::vector<Turn>& turns = turns_[rate > 0.0 ? 0 : 1];
  const CapturedShares shares = capturedShares(
      turns.size(), [&](size_t i) { return turns[i].rate; }, std::abs(rate));
  T value = straight;
  if (shares.of_low > 0.0) value += shares.of_low * (of(turns[shares.low]) - straight);
  if (shares.of_next > 0.0) value += shares.of_next * (of(turns[shares.low + 1]) - straight);
  return value;
}

double StrideLaw::turnedShare(double rate) const {
  return turned(1.0, rate, [](const Turn& turn) { return turn.share; });
}

DoubleSupports StrideLaw::supports(double speed, double turn_rate) const {
  DoubleSupports steps = DoubleSupports::Constant(0.5);  // against the norm's share of the cycle
  if (!supports_.empty()) {
    const auto next = std::upper_bound(supports_.begin(), supports_.end(), speed,
                                       [](double v, const Support& at) { return v < at.speed; });
    const Support& above = next == supports_.end() ? supports_.back() : *next;
    const Support& below = next == supports_.begin() ? above : *(next - 1);
    const double span = above.speed - below.speed;
    const double t = span > 0.0 ? (speed - below.speed) / span : 0.0;
    steps = below.steps + t * (above.steps - below.steps);
  }
  steps = turned(steps, turn_rate, [](const Turn& turn) { return turn.support.steps; });
  const double norm = doubleSupportNorm(speed, leg_length_);
  steps *= norm;
  const double near = std::clamp(0.5 * steps.sum(), norm - kSupportOff, norm + kSupportOff);
  const DoubleSupports off = steps - steps.mean();
  const double uneven = off.abs().maxCoeff(), most = kUneven * 0.5 * near;
  return 0.5 * near + (uneven > most ? most / uneven : 1.0) * off;
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
