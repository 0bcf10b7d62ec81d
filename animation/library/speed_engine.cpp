#include "animation/library/speed_engine.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "animation/library/harmonics.h"
#include "base/ease.h"
#include "base/rotation.h"

namespace amble {
namespace {

// Where walks and runs were captured at the same speeds, people walk below the middle and run
// above it; the two are mixed over so much of it to both sides [1].
constexpr double kChangeOfGait = 0.05;
// Of the cycle, with both feet down around either of its middles: standing.
constexpr double kStandingSupport = 0.5;

// Channels at speed 0 of the space's lines, or per m/s. Rows: channels; columns: phases.
Eigen::MatrixXd channelsOf(const GaitSpace& space, bool slope) {
  Eigen::MatrixXd rotations = space.mean;  // eq. 1
  if (slope) rotations.setZero();
  for (const PrincipalComponent& component : space.components) {
    rotations +=
        (slope ? component.coefficient.slope : component.coefficient.at_zero) * component.direction;
  }
  Eigen::MatrixXd channels(3 + rotations.rows(), rotations.cols());
  channels << space.root.middleRows(slope ? 3 : 0, 3), rotations;
  return channels;
}

// Where the root stands between the feet of the slowest walk, so that these stay when it shrinks.
Eigen::VectorXd standChannels(const EngineData& data) {
  const size_t joints = data.mean_posture.size();
  Eigen::VectorXd channels(3 + 3 * static_cast<Eigen::Index>(joints));
  double feet = 0.0;
  for (const Side side : {kLeft, kRight}) {
    if (data.walk) feet += 0.5 * data.walk->foot_forward[side].at(data.walk->slowest());
  }
  channels.head<3>() << feet + data.stand.root_forward, 0.0, data.stand.root_height;
  for (size_t j = 0; j < joints; ++j) {
    channels.segment<3>(3 + 3 * static_cast<Eigen::Index>(j)) =
        logRotation(data.mean_posture[j].conjugate() * data.stand.rotations[j]);
  }
  return channels;
}

}  // namespace

double GaitSpace::variance() const {
  double sum = 0.0;
  for (const PrincipalComponent& component : components) sum += component.share;
  return sum;
}

SpeedEngine::SpeedEngine(EngineData data) : data_(std::move(data)) {
  assert(data_.walk || data_.run);
  leg_ = data_.roles.meanLeg(data_.skeleton);
  stand_ = standChannels(data_);
  for (const bool run : {false, true}) {
    const std::optional<GaitSpace>& space = run ? data_.run : data_.walk;
    if (!space) continue;
    arrays_[run ? 2 : 0] = channelsOf(*space, false);
    arrays_[run ? 3 : 1] = channelsOf(*space, true);
    if (!run) walk_top_ = space->fastest();
    if (run) run_bottom_ = space->slowest();
    fastest_ = std::max(fastest_, space->fastest());
  }
  slowest_ = data_.walk ? 0.0 : run_bottom_;
  if (data_.walk && data_.run && walk_top_ > run_bottom_) {
    const double change = 0.5 * (walk_top_ + run_bottom_);
    walk_top_ = change * (1.0 - kChangeOfGait);
    run_bottom_ = change * (1.0 + kChangeOfGait);
  }
}

double SpeedEngine::clamped(double speed) const { return std::clamp(speed, slowest_, fastest_); }

bool SpeedEngine::isCaptured(double speed) const {
  if (speed < slowest_ || speed > fastest_) return false;
  return !data_.walk || !data_.run || speed <= walk_top_ || speed >= run_bottom_;
}

double SpeedEngine::runShare(double speed) const {
  if (!data_.run) return 0.0;
  if (!data_.walk) return 1.0;
  return smoothstep((clamped(speed) - walk_top_) / (run_bottom_ - walk_top_));
}

// By the law v / f = x^(1 - power); a parabola below kCrawl, with the same value and slope there.
double SpeedEngine::strideShare(double x) const {
  const double power = data_.walk->law.law.power;
  if (x >= kCrawl) return std::pow(x, 1.0 - power);
  return std::pow(kCrawl, -power) * x * (1.0 + power - power * x / kCrawl);
}

double SpeedEngine::frequency(double speed) const {
  const double v = clamped(speed), run = runShare(speed);
  double f = 0.0;
  if (run > 0.0) f += run * data_.run->law.law(std::max(v, run_bottom_) / leg_);  // eq. 6
  if (run < 1.0) {
    const double x = v / data_.walk->slowest();
    // v / stride: below kCrawl the speed cancels out.
    const double power = data_.walk->law.law.power;
    const double crawl = data_.walk->law.law(kCrawl * data_.walk->slowest() / leg_);
    f += (1.0 - run) * (x >= kCrawl ? data_.walk->law.law(std::min(v, walk_top_) / leg_)
                                    : crawl / (1.0 + power - power * x / kCrawl));
  }
  return f;
}

double SpeedEngine::walkShare(double speed) const {
  if (!data_.walk) return 1.0;
  const double x = clamped(speed) / data_.walk->slowest();
  constexpr double kBegin = 1.0 - kBend;
  if (x >= 1.0) return 1.0;
  if (x <= kBegin) return strideShare(x);
  // From there a cubic to 1, with no slope at its end.
  const double t = (x - kBegin) / kBend, begin = strideShare(kBegin);
  const double slope = (1.0 - data_.walk->law.law.power) * begin / kBegin * kBend;
  return begin + slope * t * (1.0 - t) * (1.0 - t) + (1.0 - begin) * t * t * (3.0 - 2.0 * t);
}

// The slowest walk's up to it, then a cubic to the speed itself, with the slopes of both.
double SpeedEngine::walkSpeed(double speed) const {
  const double slow = data_.walk->slowest();
  const double t = std::max(0.0, (clamped(speed) / slow - 1.0) / kBend);
  const double beyond = t < 1.0 ? t * t * (2.0 - t) : t;
  return std::min(slow * (1.0 + kBend * beyond), std::max(slow, walk_top_));
}

SpeedEngine::Reading SpeedEngine::readingAt(double phase) {
  const double at = (phase - std::floor(phase)) * kEnginePhases;
  const int i = std::min(static_cast<int>(at), kEnginePhases - 1);
  const double t = at - i, tt = t * t, ttt = tt * t;
  const auto wrapped = [](int column) { return (column + kEnginePhases) % kEnginePhases; };
  return {{wrapped(i - 1), i, wrapped(i + 1), wrapped(i + 2)},
          {0.5 * (2.0 * tt - t - ttt), 0.5 * (3.0 * ttt - 5.0 * tt + 2.0),
           0.5 * (4.0 * tt - 3.0 * ttt + t), 0.5 * (ttt - tt)}};
}

SpeedEngine::Weights SpeedEngine::weigh(double speed) const {
  const double v = clamped(speed), run = runShare(speed), share = walkShare(speed);
  Weights weights;
  weights.stand = 1.0 - share;
  if (run < 1.0) {
    weights.arrays[0] = share * (1.0 - run);
    weights.arrays[1] = weights.arrays[0] * walkSpeed(speed);
  }
  if (run > 0.0) {
    weights.arrays[2] = run;
    weights.arrays[3] = run * std::max(v, run_bottom_);
  }
  return weights;
}

// Three channels at a phase, the first of them `row`.
Eigen::Vector3d SpeedEngine::threeAt(const Weights& weights, const Reading& reading,
                                     Eigen::Index row) const {
  Eigen::Vector3d sum = weights.stand * stand_.segment<3>(row);
  for (size_t k = 0; k < arrays_.size(); ++k) {
    if (weights.arrays[k] == 0.0) continue;
    Eigen::Vector3d value = Eigen::Vector3d::Zero();
    for (size_t i = 0; i < 4; ++i) {
      value += reading.weight[i] * arrays_[k].col(reading.column[i]).segment<3>(row);
    }
    sum += weights.arrays[k] * value;
  }
  return sum;
}

void SpeedEngine::poseAt(double speed, double phase, Pose& pose) const {
  assert(static_cast<int>(pose.rotations.size()) == joints());
  const Weights weights = weigh(speed);
  const Reading reading = readingAt(phase);
  pose.p_WR = threeAt(weights, reading, 0);
  pose.p_WR.z() = stand_[2] + (1.0 - weights.stand) * (pose.p_WR.z() - stand_[2]);
  for (int j = 0; j < joints(); ++j) {
    pose.rotations[j] = data_.mean_posture[j] * expRotation(threeAt(weights, reading, 3 + 3 * j));
  }
}

void SpeedEngine::cycleAt(double speed, Eigen::MatrixXd& cycle) const {
  const Weights weights = weigh(speed);
  cycle = (weights.stand * stand_).replicate(1, kEnginePhases);
  for (size_t k = 0; k < arrays_.size(); ++k) {
    if (weights.arrays[k] != 0.0) cycle += weights.arrays[k] * arrays_[k];
  }
  cycle.row(2).array() = stand_[2] + (1.0 - weights.stand) * (cycle.row(2).array() - stand_[2]);
}

double SpeedEngine::mixed(double speed, const SpeedLine& walk, const SpeedLine& run,
                          double stand) const {
  const double v = clamped(speed), share = walkShare(speed), running = runShare(speed);
  double value = (1.0 - share) * stand;
  if (running < 1.0) {
    value += share * (1.0 - running) * walk.at(walkSpeed(speed));
  }
  if (running > 0.0) value += running * run.at(std::max(v, run_bottom_));
  return value;
}

std::array<double, 2> SpeedEngine::support(double speed) const {
  static const GaitSpace kNone;
  const GaitSpace &walk = data_.walk ? *data_.walk : kNone, &run = data_.run ? *data_.run : kNone;
  std::array<double, 2> support;
  for (size_t i = 0; i < 2; ++i) {
    support[i] = mixed(speed, walk.support[i], run.support[i], kStandingSupport);
  }
  return support;
}

bool SpeedEngine::planted(double speed, double phase, Side side) const {
  const std::array<double, 2> both = support(speed);
  // The left foot strikes around phase 0 and leaves around 0.5, the right one half a cycle later.
  const double strike = (side == kLeft ? 0.0 : 0.5) - 0.5 * both[side];
  const double lift_off = (side == kLeft ? 0.5 : 1.0) + 0.5 * both[other(side)];
  const double since = phase - strike - std::floor(phase - strike);
  return since < lift_off - strike;
}

}  // namespace amble
