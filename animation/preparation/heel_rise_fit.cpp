#include "animation/preparation/heel_rise_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "animation/body/pose.h"
#include "animation/preparation/cycle_path.h"
#include "animation/preparation/swing_fit.h"
#include "animation/steps/leg_reach.h"
#include "animation/steps/stride_law.h"
#include "base/ease.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr int kStance = FootCycle::kStanceSamples, kSwing = FootCycle::kSwingSamples;
constexpr int kPitches = kStance + kSwing;

// What squares are weighed with against those of knee and hip, whose weights over a cycle are 1
// together. By trial, on walks of seven persons.
struct Weight {
  static constexpr double kPitch = 0.15;     // of the pitch against the captured one
  static constexpr double kFlat = 100.0;     // the same while the foot stands flat
  static constexpr double kBends = 2.0;      // of what the pitch's second differences are more
  static constexpr double kMoved = 20.0;     // of the print against where it was, in metres
  static constexpr double kTooFar = 3000.0;  // of a leg in front that is too long, in its lengths
};
double timeOf(int sample) {
  return sample < kStance ? static_cast<double>(sample) / kStance
                          : 1.0 + static_cast<double>(sample - kStance) / kSwing;
}

// How flat a foot stands at a time of it [0, 1].
double flatness(double at) {
  return smoothstep((at - 0.1) / 0.15) * smoothstep((0.75 - at) / 0.15);
}

// Least squares: the sum of weight * (terms - wanted)^2 over all that is added.
class Squares {
 public:
  using Term = std::pair<int, double>;  // unknown and coefficient

  explicit Squares(int unknowns)
      : normal_(Eigen::MatrixXd::Zero(unknowns, unknowns)),
        right_(Eigen::VectorXd::Zero(unknowns)) {}

  void add(double weight, double wanted, std::initializer_list<Term> terms) {
    for (const auto& [row, a] : terms) {
      right_[row] += weight * a * wanted;
      for (const auto& [column, b] : terms) normal_(row, column) += weight * a * b;
    }
  }
  Eigen::VectorXd least() const { return normal_.ldlt().solve(right_); }

 private:
  Eigen::MatrixXd normal_;
  Eigen::VectorXd right_;
};

// How a leg is bent: at the knee, and how far forward it goes from the hip [rad].
using Bend = Eigen::Vector2d;

// A leg over the stance and the swing of its foot, as captured and as ours, where the walk begins
// along x.
class LegTrack {
 public:
  LegTrack(const Skeleton& skeleton, const JointRoles& roles, const FootShape& shape,
           const std::vector<Eigen::Quaterniond>& reference, const WalkCycle& cycle, Side side)
      : skeleton_(skeleton),
        joints_(roles.legs[side]),
        shape_(shape),
        reference_(reference),
        cycle_(cycle),
        path_{Eigen::Vector2d::Zero(), 0.0, 2.0 * cycle.stepLength(),
              cycle.turn_rate * cycle.period},
        toe_out_(cycle.toe_out[side]),
        thigh_(skeleton.joint(joints_.leg).offset.norm()),
        shank_(skeleton.joint(joints_.foot).offset.norm()),
        joints_at_(skeleton.size()) {
    const double node = side == kLeft ? 0.0 : 0.5, sign = side == kLeft ? 1.0 : -1.0;
    const double half = 0.25 * support(roles.legLength(skeleton, kLeft));
    strike_ = node - half;
    stance_ = 0.5 + 2.0 * half;
    beside_ = node + 0.25;
    forward_ = cycle.foot_forward[side];
    left_ = cycle.prints_left + 0.5 * sign * cycle.step_width;
    for (int i = 0; i < kPitches; ++i) captured_.push_back(legAt(timeOf(i)));
  }

  double length() const { return thigh_ + shank_; }
  void movePrint(double forward) { forward_ += forward; }
  // Of the print that the foot stands on or leaves, and from there to its next one [m].
  Eigen::Vector3d print() const { return printAt(beside_); }
  Eigen::Vector3d stride() const { return printAt(beside_ + 1.0) - print(); }
  // Where the path goes beside the foot [unit].
  Eigen::Vector3d ahead(double at) const {
    return aboutZ(path_.headingAt(beside_) + turned(at)) * Eigen::Vector3d::UnitX();
  }

  struct Leg {
    Eigen::Vector3d hip, ankle;  // [m]
    Eigen::Vector3d line() const { return ankle - hip; }
  };
  const Leg& captured(int sample) const { return captured_[sample]; }
  // At a time of the foot, FootState::at.
  Leg legAt(double at) const {
    const double phase = phaseAt(at);
    const Eigen::VectorXd c = fourierAt(cycle_.series, phase);
    const Eigen::Quaterniond along = aboutZ(path_.headingAt(phase));
    Pose pose;
    pose.p_WR = along * c.head<3>();
    pose.p_WR.head<2>() += path_.at(phase);
    for (size_t j = 0; j < reference_.size(); ++j) {
      const Eigen::Vector3d v = c.segment<3>(3 + 3 * static_cast<Eigen::Index>(j));
      pose.rotations.push_back(reference_[j] * expRotation(v));
    }
    pose.rotations[0] = along * pose.rotations[0];
    forwardKinematics(skeleton_, pose, joints_at_);
    return {joints_at_[joints_.up_leg].p_WJ, joints_at_[joints_.foot].p_WJ};
  }

  // From the sole that stands on the print to that under the captured ankle, were it so pitched
  // [m].
  Eigen::Vector3d soleUnder(double at, double pitch) const {
    return legAt(at).ankle - ankleOver(at, pitch) - print();
  }
  // From the captured hip to our ankle [m].
  Eigen::Vector3d line(const FootCycle& foot, int sample, double pitch) const {
    Eigen::Vector3d sole = print();
    if (sample >= kStance) {
      const double tau = timeOf(sample) - 1.0;
      const Eigen::Vector3d way = stride();
      const Eigen::Vector3d left = Eigen::Vector3d(-way.y(), way.x(), 0.0) / way.norm();
      sole += swingProgress(foot, tau) * way + swingPolynomial(foot.sideways, tau) * left;
      sole.z() += swingPolynomial(foot.height, tau);
    }
    return sole + ankleOver(timeOf(sample), pitch) - captured_[sample].hip;
  }
  // Of a line from hip to ankle at a sample.
  Bend bendOf(int sample, const Eigen::Vector3d& line_W) const {
    const Eigen::Vector3d line = aboutZ(-path_.headingAt(phaseAt(timeOf(sample)))) * line_W;
    const double l = std::min(line.norm(), LegReach::kLongest * length());
    const double cosine = (l * l - thigh_ * thigh_ - shank_ * shank_) / (2.0 * thigh_ * shank_);
    return {std::acos(std::clamp(cosine, -1.0, 1.0)), std::atan2(line.x(), -line.z())};
  }

 private:
  double phaseAt(double at) const {
    return strike_ + (at <= 1.0 ? at * stance_ : stance_ + (at - 1.0) * (1.0 - stance_));
  }
  // What the foot has turned since it stood [rad].
  double turned(double at) const { return smoothstep(at - 1.0) * path_.turn; }
  Eigen::Vector3d printAt(double u) const {
    Eigen::Vector3d print = aboutZ(path_.headingAt(u)) * Eigen::Vector3d(forward_, left_, 0.0);
    print.head<2>() += path_.at(u);
    return print;
  }
  Eigen::Vector3d ankleOver(double at, double pitch) const {
    return aboutZ(path_.headingAt(beside_) + turned(at) + toe_out_) * rolledAnkle(shape_, pitch);
  }
  // Share of the cycle with both feet down, of walks at the captured speed.
  double support(double leg_length) const {
    StrideLaw law(cycle_.speed, cycle_.stepLength());
    law.setSupports({{cycle_.speed, cycle_.doubleSupport()}}, leg_length);
    return law.doubleSupport(cycle_.speed);
  }

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
      left_;                   // where along the path the print is [cycles], and from there [m]
  std::vector<Leg> captured_;  // by sample of the pitch
};

// What one sample of the pitch and the print's way forward do to the leg.
void addLeg(const LegTrack& track, const FootCycle& foot, int sample, double weight,
            Squares& squares) {
  constexpr double kStep = 1e-4;  // [rad, m]
  const double at = timeOf(sample), p = foot.pitch[sample];
  const Eigen::Vector3d captured = track.captured(sample).line();
  const Eigen::Vector3d line = track.line(foot, sample, p);
  const Eigen::Vector3d pitched = track.line(foot, sample, p + kStep);
  const Eigen::Vector3d moved = line + kStep * track.ahead(at);
  const Bend bend = track.bendOf(sample, line), wanted = track.bendOf(sample, captured);
  const Bend by_pitch = (track.bendOf(sample, pitched) - bend) / kStep;
  const Bend by_move = (track.bendOf(sample, moved) - bend) / kStep;
  for (const int k : {0, 1}) {
    squares.add(weight, wanted[k] - bend[k] + by_pitch[k] * p,
                {{sample, by_pitch[k]}, {kPitches, by_move[k]}});
  }
  // A leg in front is no longer than it may be (LegReach): heels cannot help there, and hips would
  // be lowered.
  const double most = std::clamp(captured.norm(), LegReach::kStraight * track.length(),
                                 LegReach::kLongest * track.length());
  if (line.norm() <= most || (at > 0.4 && at < 1.6)) return;
  const double slope = (pitched.norm() - line.norm()) / kStep;
  squares.add(weight * Weight::kTooFar / std::pow(track.length(), 2),
              most - line.norm() + slope * p,
              {{sample, slope}, {kPitches, (moved.norm() - line.norm()) / kStep}});
}

// One step of Gauss and Newton. @return how far the print goes forward [m]
double fitPitch(const LegTrack& track, const std::vector<double>& captured, FootCycle& foot) {
  Squares squares(kPitches + 1);
  squares.add(Weight::kMoved, 0.0, {{kPitches, 1.0}});
  for (int i = 0; i < kPitches; ++i) {
    const double weight = i < kStance ? 0.6 / kStance : 0.4 / kSwing;
    addLeg(track, foot, i, weight, squares);
    squares.add(weight * (Weight::kPitch + Weight::kFlat * flatness(timeOf(i))), captured[i],
                {{i, 1.0}});
    const int before = (i + kPitches - 1) % kPitches, after = (i + 1) % kPitches;
    squares.add(Weight::kBends / kPitches, captured[before] - 2.0 * captured[i] + captured[after],
                {{before, 1.0}, {i, -2.0}, {after, 1.0}});
  }
  const Eigen::VectorXd least = squares.least();
  for (int i = 0; i < kPitches; ++i) foot.pitch[i] = captured[i] == 0.0 ? 0.0 : least[i];
  return least[kPitches];
}

// Along and up, so that the ankle goes as captured.
void fitSwing(const LegTrack& track, const FootShape& shape, FootCycle& foot) {
  std::vector<double> progress, height;
  const Eigen::Vector3d way = track.stride();
  for (int i = 0; i < kSwingPoints; ++i) {
    const double tau = static_cast<double>(i) / (kSwingPoints - 1);
    const Eigen::Vector3d sole = track.soleUnder(1.0 + tau, footPitch(foot, 1.0 + tau));
    progress.push_back(sole.dot(way) / way.squaredNorm() - smoothstep(tau));
    height.push_back(sole.z());
  }
  foot.progress = fitProgress(progress);
  foot.height = fitSwingHeight(shape, foot, height);
}

}  // namespace

void fitHeelRise(const Skeleton& skeleton, const JointRoles& roles,
                 const std::array<FootShape, 2>& shapes,
                 const std::vector<Eigen::Quaterniond>& reference, WalkCycle& cycle) {
  constexpr int kRounds = 8;  // by then nothing moves by more than a tenth of a millimetre
  for (const Side side : {kLeft, kRight}) {
    FootCycle& foot = cycle.feet[side];
    const std::vector<double> captured = foot.pitch;
    LegTrack track(skeleton, roles, shapes[side], reference, cycle, side);
    for (int round = 0; round < kRounds; ++round) {
      const double forward = fitPitch(track, captured, foot);
      fitSwing(track, shapes[side], foot);
      track.movePrint(forward);
      cycle.foot_forward[side] += forward;
    }
  }
}

}  // namespace amble
