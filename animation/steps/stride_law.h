/// How step length, cadence and double support go with speed.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <vector>

namespace amble {

/// When feet strike and leave beside the node between two steps, at which one foot has come down in
/// front of the other [steps, >= 0]. Rows: Side of the foot in front; columns: since it has come
/// down, until the other one leaves.
using DoubleSupports = Eigen::Array22d;

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

  /// Double supports of a captured walk.
  struct Support {
    double speed = 1.0;                                    ///< [m/s, > 0]
    DoubleSupports steps = DoubleSupports::Constant(0.1);  ///< [steps, their sum > 0]
  };
  /// Of the walks that were captured, by growing speed, of a subject with legs so long [m, > 0].
  void setSupports(const std::vector<Support>& captured, double leg_length);
  /// At a speed [m/s] and a turn rate [rad/s, left positive]: the captured ones at captured speeds
  /// and rates; at others the norm's (doubleSupportNorm), times what the walks next to it have of
  /// theirs. Their sum is no farther from the norm's than kSupportOff of a cycle; all are longer or
  /// shorter by the same for that.
  DoubleSupports supports(double speed, double turn_rate) const;
  /// Detectors of plants in captures err by as much: beyond, the norm is the better witness [1].
  static constexpr double kSupportOff = 0.022;
  /// Of their mean, that single ones are longer or shorter: beyond, captures were read wrongly [1].
  static constexpr double kUneven = 0.75;

  /// Of a captured turn: rate [rad/s, > 0], its steps against stepLength() at its speed, within
  /// bounds beyond which they are a fluke [1], and its double supports.
  struct Turn {
    double rate = 0.0, share = 1.0;
    Support support;
  };
  static constexpr double kLeastTurned = 0.8, kMostTurned = 1.1;
  /// By growing rate, after the supports are set. @param way  0 to the left, 1 to the right
  void addTurn(int way, const Turn& turn);
  bool hasTurns() const { return !turns_[0].empty() || !turns_[1].empty(); }
  /// Of steps while turning at a rate [rad/s, left positive], against stepLength() [1].
  double turnedShare(double rate) const;

  double capturedStep() const { return step_; }  ///< [m]
  double stepLength(double speed) const;         ///< [m]; inverse of speed()
  double speed(double step_length) const;        ///< [m/s]

 private:
  Support againstNorm(const Support& support) const;
  template <typename T, typename Of>
  T turned(const T& straight, double rate, const Of& of) const;

  double speed_ = 1.0;
  double step_ = 0.65;
  double power_ = kStepPower;
  // Share of the captured speed below which the cadence is the slowest [1].
  double slow_ = std::pow(kSlowestCadence, 1.0 / (1.0 - kStepPower));
  Onset onset_;
  std::vector<Support> supports_;  // against the norm's double support, as those of turns [1]
  double leg_length_ = 0.8;
  std::array<std::vector<Turn>, 2> turns_;  // left, right
};

/// Share of time with both feet planted, at a speed [m/s], for a leg length [m, > 0]: norms of
/// Schwartz, Rozumalski & Trost (J. Biomech. 41, 2008), linear between the middles of their five
/// classes of v / sqrt(g leg).
double doubleSupportNorm(double speed, double leg_length);

}  // namespace amble
