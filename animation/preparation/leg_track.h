/// A leg over one stance and swing of its foot, as it was captured and as a walk is made of the
/// cycle: what heels, toes, prints, swings and the pelvis are fitted by (heel_rise_fit.h).
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "animation/body/foot_shape.h"
#include "animation/body/joint_roles.h"
#include "animation/body/pose.h"
#include "animation/library/walk_cycle.h"
#include "animation/preparation/cycle_path.h"

namespace amble {

/// By what a pelvis goes beside its captured way: cosine and sine of each of kSwayWaves waves a
/// cycle, along the path and then up [m].
inline constexpr int kSwayWaves = 4, kSwayNumbers = 4 * kSwayWaves;
using PelvisSway = Eigen::Matrix<double, kSwayNumbers, 1>;
/// Of number k: 0 where it goes along the path, 2 where it goes up.
inline int swayAxis(int k) { return k % 4 < 2 ? 0 : 2; }
/// Of number k: how many waves it has a cycle [>= 1].
inline int swayWaves(int k) { return k / 4 + 1; }
/// What number k is multiplied by at a phase [-1, 1].
double swayBasis(int k, double phase);
Eigen::Vector3d swayAt(const PelvisSway& sway, double phase);

/// What can be moved at one sample of a leg: pitch and toes [rad]; the print, the swing along its
/// way and up, the hip along the path and up [m].
enum LegMove { kByPitch, kByToes, kByPrint, kByWay, kByHeight, kByHip, kByHipUp, kLegMoves };
using LegMoves = std::array<double, kLegMoves>;

/// How a leg is bent: at the knee, how far forward it goes from the hip, and at the ankle, to which
/// the pitch of the foot belongs [rad].
using LegBend = Eigen::Vector3d;

/// Refers to what it is made of, whose feet and series are not to change meanwhile. Samples are
/// those of FootCycle::pitch. Where the walk begins along x.
class LegTrack {
 public:
  static constexpr int kSamples = FootCycle::kStanceSamples + FootCycle::kSwingSamples;

  LegTrack(const Skeleton& skeleton, const JointRoles& roles, const FootShape& shape,
           const std::vector<Eigen::Quaterniond>& reference, const WalkCycle& cycle, Side side);

  /// FootState::at of a sample [0, 2), and the phase of the cycle [cycles].
  static double timeOf(int sample);
  double phaseOf(int sample) const { return phaseAt(timeOf(sample)); }

  double length() const { return thigh_ + shank_; }  ///< thigh and shank [m]
  /// As captured at our sample: the bend, the distance from hip to ankle [m], the pitch, about the
  /// heel before every foot is flat and about the ball from then on, as ours are [rad], and how far
  /// the toes are rolled over their tip [rad, >= 0].
  LegBend capturedBend(int sample) const {
    return bendOf(sample, {captured_[sample].line(), capturedPitch(sample)});
  }
  double capturedLength(int sample) const { return captured_[sample].line().norm(); }
  double capturedPitch(int sample) const;
  double capturedToes(int sample) const;

  /// What a walk is made of from now on: the foot, by how much its prints are farther forward [m],
  /// and what the pelvis is moved by.
  void make(const FootCycle& foot, double forward, const PelvisSway& sway);
  /// From hip to ankle [m], and how the foot is pitched [rad].
  struct Made {
    Eigen::Vector3d line;
    double pitch;
  };
  /// As made, heels raised where legs would be too long (raisedPitch), with what is moved.
  Made made(int sample, const LegMoves& moved = {}) const;
  LegBend bendOf(int sample, const Made& leg) const;
  /// Length of the way from print to print [m].
  double wayLength() const { return stride().norm(); }
  /// From the print to the sole under the captured ankle, as the pitch and toes are made, in plan
  /// along the way as a share of it, and up [1, m]. @param tau  of the swing [0, 1]
  Eigen::Vector2d soleUnderAnkle(double tau) const;

 private:
  struct Leg {
    Eigen::Vector3d hip, ankle, ball;  // of the toe joint [m]
    Eigen::Vector3d line() const { return ankle - hip; }
  };
  Leg legAt(double at) const;
  double phaseAt(double at) const;
  Eigen::Quaterniond pathAt(double at) const;
  Eigen::Vector3d printAt(double u) const;
  Eigen::Vector3d print() const { return printAt(beside_); }
  Eigen::Vector3d stride() const { return printAt(beside_ + 1.0) - print(); }
  double headingAt(double at) const;
  double raised(const Eigen::Vector3d& sole, int sample, double pitch,
                const Eigen::Vector3d& hip) const;

  const Skeleton& skeleton_;
  LegJoints joints_;
  FootShape shape_;
  const std::vector<Eigen::Quaterniond>& reference_;
  const WalkCycle& cycle_;
  FittedPath path_;
  double toe_out_, thigh_, shank_;
  mutable std::vector<JointFrame> joints_at_;
  double strike_, stance_;  // [cycles]
  double beside_, forward_,
      left_;  // where along the path the print is [cycles], and from there [m]
  FootCycle foot_;
  double moved_ = 0.0;  // the prints forward [m]
  PelvisSway sway_ = PelvisSway::Zero();
  std::vector<Leg> captured_;
};

}  // namespace amble
