/// Walk cycles blended to a speed and a turn rate and warped to a step length (Pettré §4.2, eq. 3).
///
/// Walks that go alike are averaged into one captured pace: straight ones of the same speed, left
/// and right turns of the same rate. The straight walk is mixed of the two paces next to the plan's
/// speed; where a walk slows, for a turn, a slope or a stop, slower paces take its place. A turn
/// adds what the captured turns do otherwise than the straight walk there at their step, in its
/// mean and lowest harmonics, and brings its feet (SwingCycles). Which is which is told by each
/// cycle's own measured turn rate. (The paper has left turns negative; ours are positive.)
/// Beyond the captured paces nothing is extrapolated but the step: the slowest and the fastest walk
/// are warped, turns are held at the fastest captured rate. A path may turn as much faster as two
/// captures of one pace differ, since they stand for it; beyond, the speed drops instead.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "animation/library/motion_library.h"
#include "animation/steps/stride_law.h"
#include "animation/steps/swing_cycles.h"
#include "animation/synthesis/cycle_lanes.h"
#include "animation/synthesis/transition_blend.h"

namespace amble {

class GaitBlend {
 public:
  /// For a character `scale` [> 0] times the captured subject: lengths grow with scale, speeds and
  /// turn rates by Froude's law with its root and the inverse of it. The walker is to walk at
  /// `speed` [m/s, > 0]. @throws std::invalid_argument without a straight walk.
  GaitBlend(const MotionLibrary& library, double scale, double speed = 1.2);
  GaitBlend(const GaitBlend&) = delete;
  GaitBlend& operator=(const GaitBlend&) = delete;

  const StrideLaw& law() const { return law_; }
  /// The pace of the library's fastest turns and kSamePace of it more; without turns in the library
  /// kNoTurns [rad/s, > 0].
  double maxTurnRate() const { return max_turn_rate_; }
  static constexpr double kNoTurns = 0.5;           ///< that a straight walk may be bent to [rad/s]
  double stepWidth() const { return step_width_; }  ///< of the straight walk [m]
  /// Of WalkCycle::foot_forward the mean, and half of what left is before right [m].
  double footForward() const { return foot_forward_; }
  double stagger() const { return stagger_; }
  /// By Side, left positive [rad].
  const std::array<double, 2>& toeOut() const { return toe_out_; }
  const FootCycle& foot(Side side) const { return feet_.walk[side]; }
  const SwingCycles& feet() const { return feet_; }
  const TransitionBlend& transitions() const { return transitions_; }

  /// Channels of WalkCycle::series at a phase [cycles], blended for a turn rate [rad/s] and for so
  /// much slower a walk than the plan's (WalkDepartures) [m/s], and warped to a step length [m].
  /// Amplitudes are proportional to step length, means stay. (The root's
  /// height would go with its square, were it an inverted pendulum's; people's rises less.)
  void evaluate(double phase, double turn_rate, double step_length, Eigen::VectorXd& channels,
                double slower = 0.0) const;
  /// The same at four frames at once, into values[4 * channel + frame].
  struct Frames {
    std::array<double, 4> phase, turn_rate, step_length, slower = {};
  };
  void evaluate(const Frames& frames, std::span<double> values) const;
  /// Motions that are averaged into one, by name, and how much of them is in a frame [0 to 1].
  struct Share {
    std::vector<std::string> motions;
    double share = 0.0;
  };
  /// Of what the walk is blended where it is so much slower than the plan's [m/s] and at a turn
  /// rate [rad/s]: the same motions in the same order whatever these are, with shares that sum to
  /// 1. For who wants to know, not for who blends. @pre the library is the one that it was made of
  std::vector<Share> shares(const MotionLibrary& library, double slower, double turn_rate) const;
  int channels() const { return static_cast<int>(straight_.coefficients.rows()); }

  /// Walks whose speeds, or turn rates, differ by less than this share are one pace: two captures
  /// of one manner differ by as much [1].
  static constexpr double kSamePace = 0.15;
  /// Harmonics of what turns add: beyond, two walks differ by what their captures shake, and a fast
  /// walk would make much of it.
  static constexpr int kTurnHarmonics = 3;
  /// Half of the moment over which a blend changes; by trial: shorter, and the trunk jerks where
  /// two curves join; longer, and walkers lean when the turn is over [s].
  static constexpr double kBlendTime = 0.12;
  /// The power of the law of step length is the walks' own where their fastest is so many times as
  /// fast as their slowest, and within bounds beyond which a fit is a fluke of few walks [1].
  static constexpr double kSpreadOfSpeeds = 1.3;
  static constexpr double kLeastPower = 0.2, kMostPower = 0.7;

 private:
  using Cycles = std::vector<const WalkCycle*>;
  struct Pace {
    std::vector<std::pair<Cycles, double>> sources;  ///< of what it is mixed; shares sum to 1
    Eigen::MatrixXd coefficients;  ///< rows: channels; columns: alpha_0, beta_0 = 0, alpha_1, ...
    double speed = 0.0;            ///< [m/s]
    double turn_rate = 0.0;        ///< [rad/s]
    double step = 0.0;             ///< [m]
    DoubleSupports supports = DoubleSupports::Zero();  ///< [steps]
  };
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  static Pace meanPace(const Cycles& cycles, int harmonics, double scale);
  void fitLaw(const std::vector<Pace>& paces, double leg_length);
  void takeOnset(const MotionLibrary& library, double scale);
  void mixStraight(const std::vector<Pace>& paces, const std::vector<Cycles>& cycles, double scale,
                   double speed);
  void joinTransitions(const MotionLibrary& library, double scale, double speed);
  void addSlower(const std::vector<Pace>& paces, const std::vector<Cycles>& cycles, double scale);
  void addTurns(const std::vector<Cycles>& turns, int harmonics, double scale);
  void addTurnFeet(const Cycles& cycles, double scale, double rate, int way);
  std::vector<const Pace*> allPaces() const;
  void layOut();
  void weigh(double slower, double turn_rate, int frame, LaneBlend& blend) const;

  StrideLaw law_;
  Pace straight_;                           // at the plan's speed
  std::array<std::vector<Pace>, 2> turns_;  // left, right, by rate: what they add to the straight
  std::vector<Pace> slower_;                // as WalkDepartures has them
  // By as much is what a turn replaces of the straight walk more than of those.
  std::vector<Pace> replaced_;
  std::vector<RowMajor> rows_;   // of allPaces(), as LanePace has them
  std::vector<LanePace> paces_;  // the same
  double max_turn_rate_ = 0.0, step_width_ = 0.0, foot_forward_ = 0.0, stagger_ = 0.0;
  std::array<double, 2> toe_out_ = {0.0, 0.0};
  SwingCycles feet_;
  TransitionBlend transitions_;
};

}  // namespace amble
