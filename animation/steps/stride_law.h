/// How step length, cadence and double support go with speed.
#pragma once

#include <array>
#include <cmath>
#include <vector>

namespace amble {

/// Step length grows with a power of speed, 0.42 (Grieve & Gear 1966) unless the subject's own
/// walks say otherwise, and cadence with the rest, through a captured walk's own speed and step
/// length: the constants differ from subject to subject (Inman's law, Glardon eq. 4, is 5 % high on
/// ours). Below `kSlowestCadence` of the captured cadence people take shorter steps rather than
/// slower ones.
class StrideLaw {
 public:
  static constexpr double kStepPower = 0.42;
  static constexpr double kSlowestCadence = 0.7;  ///< by trial: slower steps look like wading [1]
  /// Steps shorter or longer than this, times the captured one, are not walked: the warped cycle no
  /// longer looks like a walk.
  static constexpr double kShortestStep = 0.3;
  static constexpr double kLongestStep = 1.4;

  StrideLaw() = default;
  /// Of the captured walk: speed [m/s, > 0] and step length [m, > 0]; power (0, 1).
  StrideLaw(double speed, double step_length, double power = kStepPower)
      : speed_(speed),
        step_(step_length),
        power_(power),
        slow_(std::pow(kSlowestCadence, 1.0 / (1.0 - power))) {}

  /// How walking begins and ends: captured, or by trial.
  struct Onset {
    /// Fastest that a first step leads to, and a last one stops from; by trial [m/s, > 0].
    double first_speed = 1.0, last_speed = 1.0;
    /// People speed up and slow down by about this much [m/s^2, > 0].
    double acceleration = 1.0;
    /// How long weight is shifted, both feet standing, before a first step and after a last one, in
    /// times of that step: 0 where no such sequences are captured [1, >= 0].
    double start_sway = 0.0, stop_sway = 0.0;
  };
  const Onset& onset() const { return onset_; }
  void setOnset(const Onset& onset) { onset_ = onset; }

  /// Share of time with both feet planted, of a captured walk.
  struct Support {
    double speed = 1.0;  ///< [m/s, > 0]
    double share = 0.2;  ///< [0 to 0.9]
  };
  /// Of the walks that were captured, by growing speed, of a subject with legs so long [m, > 0].
  void setSupports(const std::vector<Support>& captured, double leg_length);
  /// Share of time with both feet planted at a speed [m/s]: the captured one at captured speeds; at
  /// others the norm's (doubleSupportNorm), times what the walks next to it have of theirs. No
  /// farther from the norm than kSupportOff.
  double doubleSupport(double speed) const;
  /// Detectors of plants in captures err by as much: beyond, the norm is the better witness [1].
  static constexpr double kSupportOff = 0.022;

  /// Of a captured turn: rate [rad/s, > 0] and its steps against stepLength() at its speed, within
  /// bounds beyond which they are a fluke [1].
  struct Turn {
    double rate = 0.0, share = 1.0;
  };
  static constexpr double kLeastTurned = 0.8, kMostTurned = 1.1;
  /// By growing rate. @param way  0 to the left, 1 to the right
  void addTurn(int way, const Turn& turn);
  bool hasTurns() const { return !turns_[0].empty() || !turns_[1].empty(); }
  /// Of steps while turning at a rate [rad/s, left positive], against stepLength() [1].
  double turnedShare(double rate) const;

  double capturedStep() const { return step_; }  ///< [m]
  double stepLength(double speed) const;         ///< [m]; inverse of speed()
  double speed(double step_length) const;        ///< [m/s]

 private:
  double speed_ = 1.0;
  double step_ = 0.65;
  double power_ = kStepPower;
  // Share of the captured speed below which the cadence is the slowest [1].
  double slow_ = std::pow(kSlowestCadence, 1.0 / (1.0 - kStepPower));
  Onset onset_;
  std::vector<Support> supports_;  // shares of the norm's
  double leg_length_ = 0.8;
  std::array<std::vector<Turn>, 2> turns_;  // left, right
};

/// Share of time with both feet planted, at a speed [m/s], for a leg length [m, > 0]: norms of
/// Schwartz, Rozumalski & Trost (J. Biomech. 41, 2008), linear between the middles of their five
/// classes of v / sqrt(g leg).
double doubleSupportNorm(double speed, double leg_length);

}  // namespace amble
