#include "animation/preparation/heel_rise_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "animation/preparation/leg_track.h"
#include "animation/preparation/swing_fit.h"
#include "animation/steps/leg_reach.h"
#include "base/ease.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr int kStance = FootCycle::kStanceSamples, kSwing = FootCycle::kSwingSamples;
constexpr int kPitches = LegTrack::kSamples, kToes = FootCycle::kToeSplines;
constexpr int kTerms = static_cast<int>(SwingTerms().size());

// Where the unknowns of a leg are: pitches, how far its prints go forward, FootCycle::toes,
// progress and height. Those of the pelvis are behind both legs'.
constexpr int kForward = kPitches, kRolls = kForward + 1, kProgress = kRolls + kToes,
              kHeight = kProgress + kTerms, kOfLeg = kHeight + kTerms, kPelvis = 2 * kOfLeg,
              kUnknowns = kPelvis + kSwayNumbers;

// What squares are weighed with against those of a knee, whose weights over a cycle are 1 together.
// By trial, on walks of seven persons.
struct Weight {
  static constexpr double kStraight = 300.0;  // of straight knees, which are seen, more
  static constexpr double kHip = 1.5;         // of how far forward the leg goes
  static constexpr double kAnkle = 0.5;       // of the ankle
  static constexpr double kPitch = 0.45;      // of the pitch against the captured one
  static constexpr double kFlat = 100.0;      // the same of a foot that stands flat
  static constexpr double kBends = 0.5;       // of what the pitch's second differences are more
  static constexpr double kToes = 0.02;       // of the toes against the captured ones
  static constexpr double kToesBend = 0.05;   // of the second differences of their coefficients
  static constexpr double kMoved = 0.2;       // of the print against where it was, in metres
  static constexpr double kCurled = 10.0;     // of toes that reach down too far
  static constexpr double kTooFar = 3000.0;   // of a leg in front that is too long, in its lengths
  static constexpr double kTooLow = 3000.0;   // of a sole that does not clear the ground, in metres
  // Of the pelvis against where it was, in metres: a wave a cycle, and how much more faster ones.
  static constexpr double kAlong = 1.5, kUp = 31.0, kWaves = 0.01;
  static constexpr double kNone = 1e3;  // of what is 0: may not be less and would, feet that are
                                        // flat, waves that a series lacks
};

double weightOf(int sample) { return sample < kStance ? 0.6 / kStance : 0.4 / kSwing; }

// Whether every foot is flat at a sample.
bool isFlat(int sample) {
  return std::abs(LegTrack::timeOf(sample) - FootCycle::kFlat) < FootCycle::kFlatFor;
}

// How flat a foot stands at a time of it [0, 1], where it was captured so: this is its pitch [rad].
double flatness(double at, double captured) {
  constexpr double kFlatPitch = 0.6 * kDegree;
  const double mostly = smoothstep((at - 0.1) / 0.15) * smoothstep((0.75 - at) / 0.15);
  return mostly * (1.0 - smoothstep(std::abs(captured) / kFlatPitch));
}

// More of knees that are as good as straight [rad]: these are seen.
double straightness(double knee) {
  constexpr double kBent = 3.0 * kDegree;
  return 1.0 + Weight::kStraight * (1.0 - smoothstep(knee / kBent));
}

// What is linear in the unknowns near where they are now.
struct Row {
  const Eigen::VectorXd& now;
  double target;  // that the sum of slope times unknown is to be
  std::vector<std::pair<int, double>> terms = {};

  /// @param missing  what is wanted less what there is now
  Row(const Eigen::VectorXd& unknowns, double missing) : now(unknowns), target(missing) {}
  void by(int unknown, double slope) {
    if (slope == 0.0) return;
    terms.emplace_back(unknown, slope);
    target += slope * now[unknown];
  }
};

// Least squares: the sum of weight * (terms - target)^2 over all rows.
class Squares {
 public:
  void add(double weight, const Row& row) {
    for (const auto& [i, a] : row.terms) {
      right_[i] += weight * a * row.target;
      for (const auto& [k, b] : row.terms) normal_(i, k) += weight * a * b;
    }
  }
  Eigen::VectorXd least() const { return normal_.ldlt().solve(right_); }

 private:
  Eigen::MatrixXd normal_ = 1e-9 * Eigen::MatrixXd::Identity(kUnknowns, kUnknowns);
  Eigen::VectorXd right_ = Eigen::VectorXd::Zero(kUnknowns);
};

FootCycle footOf(FootCycle foot, const Eigen::VectorXd& x, int first) {
  std::copy_n(x.data() + first, kPitches, foot.pitch.begin());
  std::copy_n(x.data() + first + kRolls, kToes, foot.toes.begin());
  std::copy_n(x.data() + first + kProgress, kTerms, foot.progress.begin());
  std::copy_n(x.data() + first + kHeight, kTerms, foot.height.begin());
  return foot;
}

void putFoot(const FootCycle& foot, int first, Eigen::VectorXd& x) {
  std::copy(foot.pitch.begin(), foot.pitch.end(), x.data() + first);
  std::copy(foot.toes.begin(), foot.toes.end(), x.data() + first + kRolls);
  std::copy(foot.progress.begin(), foot.progress.end(), x.data() + first + kProgress);
  std::copy(foot.height.begin(), foot.height.end(), x.data() + first + kHeight);
}

// What a number of a leg does by all unknowns, whose slopes by what can be moved are these.
void addSlopes(const LegTrack& track, int first, int sample, const LegMoves& slopes, Row& row) {
  const double at = LegTrack::timeOf(sample), phase = track.phaseOf(sample);
  row.by(first + sample, slopes[kByPitch]);
  row.by(first + kForward, slopes[kByPrint]);
  for (int k = 0; k < kToes; ++k) row.by(first + kRolls + k, slopes[kByToes] * toeSpline(k, at));
  double power = std::pow((at - 1.0) * (2.0 - at), 2);
  for (int k = 0; k < kTerms && sample >= kStance; ++k, power *= at - 1.0) {
    if (k < kProgressTerms)
      row.by(first + kProgress + k, slopes[kByWay] * track.wayLength() * power);
    if (k < kHeightTerms) row.by(first + kHeight + k, slopes[kByHeight] * power);
  }
  for (int k = 0; k < kSwayNumbers; ++k)
    row.by(kPelvis + k, slopes[swayAxis(k) == 0 ? kByHip : kByHipUp] * swayBasis(k, phase));
}

// Legs bend as captured.
void addLeg(const LegTrack& track, const Eigen::VectorXd& now, int first, int sample,
            Squares& squares) {
  constexpr double kStep = 1e-4;  // [rad, m]
  const double at = LegTrack::timeOf(sample);
  const LegTrack::Made leg = track.made(sample);
  const Eigen::Vector3d& line = leg.line;
  const LegBend bend = track.bendOf(sample, leg), wanted = track.capturedBend(sample);
  std::array<LegMoves, 3> slopes;
  LegMoves longer;
  for (int k = 0; k < kLegMoves; ++k) {
    LegMoves moved = {};
    moved[k] = kStep;
    const LegTrack::Made there = track.made(sample, moved);
    const LegBend by = (track.bendOf(sample, there) - bend) / kStep;
    for (const int i : {0, 1, 2}) slopes[i][k] = by[i];
    longer[k] = (there.line.norm() - line.norm()) / kStep;
  }
  const LegBend weights(straightness(wanted[0]), Weight::kHip, Weight::kAnkle);
  for (const int i : {0, 1, 2}) {
    Row row(now, wanted[i] - bend[i]);
    addSlopes(track, first, sample, slopes[i], row);
    squares.add(weightOf(sample) * weights[i], row);
  }
  // A leg in front is no longer than it may be (LegReach): heels cannot help there, and hips would
  // be lowered.
  const double most = std::clamp(track.capturedLength(sample), LegReach::kStraight * track.length(),
                                 LegReach::kLongest * track.length());
  if (line.norm() <= most || (at > 0.4 && at < 1.6)) return;
  Row row(now, most - line.norm());
  addSlopes(track, first, sample, longer, row);
  squares.add(weightOf(sample) * Weight::kTooFar / std::pow(track.length(), 2), row);
}

// Heels rise as captured, as smoothly.
void addPitches(const std::vector<double>& captured, const Eigen::VectorXd& now, int first,
                Squares& squares) {
  for (int i = 0; i < kPitches; ++i) {
    Row pitch(now, (isFlat(i) ? 0.0 : captured[i]) - now[first + i]);
    pitch.by(first + i, 1.0);
    const double flat = Weight::kFlat * flatness(LegTrack::timeOf(i), captured[i]);
    squares.add(isFlat(i) ? Weight::kNone : weightOf(i) * (Weight::kPitch + flat), pitch);
    const int before = (i + kPitches - 1) % kPitches, after = (i + 1) % kPitches;
    const auto bend = [&](const auto& p, int offset) {
      return p[offset + before] - 2.0 * p[offset + i] + p[offset + after];
    };
    Row row(now, bend(captured, 0) - bend(now, first));
    row.by(first + before, 1.0);
    row.by(first + i, -2.0);
    row.by(first + after, 1.0);
    squares.add(Weight::kBends / kPitches, row);
  }
}

// Toes do not roll far over a sole that lies: their tips would leave the ground, or toes curl.
void addCurling(const FootCycle& foot, const Eigen::VectorXd& now, int first, Squares& squares) {
  constexpr double kMost = 5.0 * kDegree;  // by trial
  for (int i = FootCycle::kToesFrom - 1; i <= FootCycle::kToesFrom + kToes; ++i) {
    const double at = LegTrack::timeOf(i);
    const double over = toeRoll(foot, at) - std::max(foot.pitch[i], 0.0) - kMost;
    if (over <= 0.0) continue;
    Row row(now, over);
    row.by(first + i, 1.0);
    for (int k = 0; k < kToes; ++k) row.by(first + kRolls + k, -toeSpline(k, at));
    squares.add(Weight::kCurled * weightOf(i), row);
  }
}

// Toes roll as captured.
void addToes(const LegTrack& track, const FootCycle& foot, const Eigen::VectorXd& now, int first,
             Squares& squares) {
  for (int i = FootCycle::kToesFrom - 1; i <= FootCycle::kToesFrom + kToes; ++i) {
    const double at = LegTrack::timeOf(i);
    Row row(now, track.capturedToes(i) - toeRoll(foot, at));
    for (int k = 0; k < kToes; ++k) row.by(first + kRolls + k, toeSpline(k, at));
    squares.add(Weight::kToes * weightOf(i), row);
  }
  for (int k = 0; k < kToes; ++k) {
    const int at = first + kRolls + k;
    const auto roll = [&](int i) { return i < 0 || i >= kToes ? 0.0 : now[first + kRolls + i]; };
    Row row(now, 2.0 * roll(k) - roll(k - 1) - roll(k + 1));
    row.by(at, -2.0);
    if (k > 0) row.by(at - 1, 1.0);
    if (k + 1 < kToes) row.by(at + 1, 1.0);
    squares.add(Weight::kToesBend / kPitches, row);
  }
}

// Swings clear the ground.
void addClearance(const FootShape& shape, const FootCycle& foot, const Eigen::VectorXd& now,
                  int first, Squares& squares) {
  constexpr double kStep = 1e-4;  // [rad]
  for (int i = 1; i < kSwing; ++i) {
    const double tau = static_cast<double>(i) / kSwing, p = foot.pitch[kStance + i];
    const double height = swingPolynomial(foot.height, tau);
    const double have = soleClearance(shape, p, height), wanted = swingClearance(tau);
    if (have >= wanted) continue;
    Row row(now, wanted - have);
    row.by(first + kStance + i, (soleClearance(shape, p + kStep, height) - have) / kStep);
    double power = std::pow(tau * (1.0 - tau), 2);
    for (int k = 0; k < kHeightTerms; ++k, power *= tau) row.by(first + kHeight + k, power);
    squares.add(weightOf(kStance + i) * Weight::kTooLow, row);
  }
}

// The pelvis goes as captured, and by no waves that its series has not.
void addPelvis(const Eigen::VectorXd& now, int harmonics, Squares& squares) {
  for (int k = 0; k < kSwayNumbers; ++k) {
    Row row(now, -now[kPelvis + k]);
    row.by(kPelvis + k, 1.0);
    const double faster = 1.0 + Weight::kWaves * std::pow(swayWaves(k), 4);
    const double weight = swayAxis(k) == 0 ? Weight::kAlong : Weight::kUp;
    squares.add(swayWaves(k) > harmonics ? Weight::kNone : weight * faster, row);
  }
}

// Toes do not roll into the ground: what would is held at 0.
Eigen::VectorXd leastUpward(Squares& squares) {
  constexpr int kRounds = 4;
  Eigen::VectorXd least = squares.least();
  for (int round = 0; round < kRounds; ++round) {
    bool held = false;
    for (const int first : {0, kOfLeg}) {
      for (int i = first + kRolls; i < first + kRolls + kToes; ++i) {
        if (least[i] > -1e-5) continue;
        const Eigen::VectorXd none = Eigen::VectorXd::Zero(kUnknowns);
        Row row(none, 0.0);
        row.by(i, 1.0);
        squares.add(Weight::kNone, row);
        held = true;
      }
    }
    if (!held) break;
    least = squares.least();
  }
  return least;
}

// Along and up, so that the ankle goes as captured.
void fitSwing(const LegTrack& track, const FootShape& shape, FootCycle& foot) {
  std::vector<double> progress, height;
  for (int i = 0; i < kSwingPoints; ++i) {
    const double tau = static_cast<double>(i) / (kSwingPoints - 1);
    const Eigen::Vector2d sole = track.soleUnderAnkle(tau);
    progress.push_back(sole[0] - smoothstep(tau));
    height.push_back(sole[1]);
  }
  foot.progress = fitProgress(progress);
  foot.height = fitSwingHeight(shape, foot, height);
}

// Raised where it does not clear the ground.
void clearGround(const FootShape& shape, FootCycle& foot) {
  std::vector<double> height;
  for (int i = 0; i < kSwingPoints; ++i)
    height.push_back(swingPolynomial(foot.height, static_cast<double>(i) / (kSwingPoints - 1)));
  foot.height = fitSwingHeight(shape, foot, height);
}

// Both legs of a walk and its pelvis, and what is unknown of them.
class WalkFit {
 public:
  WalkFit(const Skeleton& skeleton, const JointRoles& roles, const std::array<FootShape, 2>& shapes,
          const std::vector<Eigen::Quaterniond>& reference, const WalkCycle& cycle)
      : shapes_(shapes),
        feet_(cycle.feet),
        harmonics_(cycle.series.harmonics()),
        now_(Eigen::VectorXd::Zero(kUnknowns)) {
    for (const Side side : {kLeft, kRight}) {
      LegTrack& track = tracks_.emplace_back(skeleton, roles, shapes[side], reference, cycle, side);
      for (int i = 0; i < kPitches; ++i) captured_[side].push_back(track.capturedPitch(i));
      FootCycle foot = cycle.feet[side];
      foot.pitch = captured_[side];
      track.make(foot, 0.0, PelvisSway::Zero());
      fitSwing(track, shapes[side], foot);
      putFoot(foot, side * kOfLeg, now_);
    }
  }

  // One step of Gauss and Newton.
  void step() {
    constexpr double kShare = 0.5;  // of it: farther, and knees that are straight overshoot
    Squares squares;
    addPelvis(now_, harmonics_, squares);
    for (const Side side : {kLeft, kRight}) {
      const int first = side * kOfLeg;
      const FootCycle made = foot(side);
      tracks_[side].make(made, now_[first + kForward], sway());
      for (int i = 0; i < kPitches; ++i) addLeg(tracks_[side], now_, first, i, squares);
      addPitches(captured_[side], now_, first, squares);
      addToes(tracks_[side], made, now_, first, squares);
      addCurling(made, now_, first, squares);
      addClearance(shapes_[side], made, now_, first, squares);
      Row still(now_, -now_[first + kForward]);
      still.by(first + kForward, 1.0);
      squares.add(Weight::kMoved, still);
    }
    now_ += kShare * (leastUpward(squares) - now_);
    for (const Side side : {kLeft, kRight}) {
      for (int i = 0; i < kStance; ++i)
        if (isFlat(i)) now_[side * kOfLeg + i] = 0.0;
      auto toes = now_.segment<kToes>(side * kOfLeg + kRolls);
      toes = toes.cwiseMax(0.0).eval();
      if (!isRigid(side)) continue;
      toes.setZero();
      now_.segment<kPitches>(side * kOfLeg).setZero();
    }
  }

  FootCycle foot(Side side) const { return footOf(feet_[side], now_, side * kOfLeg); }
  double forward(Side side) const { return now_[side * kOfLeg + kForward]; }
  PelvisSway sway() const { return now_.tail<kSwayNumbers>(); }

 private:
  // Feet that no capture rolls.
  bool isRigid(Side side) const {
    return std::ranges::all_of(feet_[side].pitch, [](double pitch) { return pitch == 0.0; });
  }

  std::array<FootShape, 2> shapes_;
  std::array<FootCycle, 2> feet_;                // as they were
  std::array<std::vector<double>, 2> captured_;  // pitches
  std::vector<LegTrack> tracks_;
  int harmonics_;  // of the series
  Eigen::VectorXd now_;
};

}  // namespace

void fitHeelRise(const Skeleton& skeleton, const JointRoles& roles,
                 const std::array<FootShape, 2>& shapes,
                 const std::vector<Eigen::Quaterniond>& reference, WalkCycle& cycle) {
  constexpr int kRounds = 12;  // by then no angle of a leg moves by more than a tenth of a degree
  WalkFit fit(skeleton, roles, shapes, reference, cycle);
  for (int round = 0; round < kRounds; ++round) fit.step();
  for (const Side side : {kLeft, kRight}) {
    cycle.feet[side] = fit.foot(side);
    clearGround(shapes[side], cycle.feet[side]);
    cycle.foot_forward[side] += fit.forward(side);
  }
  const PelvisSway sway = fit.sway();
  FourierSeries& series = cycle.series;
  for (int k = 0; k < kSwayNumbers && swayWaves(k) <= series.harmonics(); ++k)
    (k % 2 == 0 ? series.alpha : series.beta)(swayAxis(k), swayWaves(k)) += sway[k];
}

}  // namespace amble
