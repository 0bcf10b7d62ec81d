#include "animation/preparation/gait_space_fit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>

namespace amble {
namespace {

using Values = std::function<double(const EngineCycle&)>;

bool speedsSpread(const std::vector<EngineCycle>& cycles) {
  double mean = 0.0, square = 0.0;
  const double n = static_cast<double>(cycles.size());
  for (const EngineCycle& cycle : cycles) mean += std::log(cycle.speed) / n;
  for (const EngineCycle& cycle : cycles) square += std::pow(std::log(cycle.speed) - mean, 2) / n;
  return cycles.size() >= 2 && std::sqrt(square) >= kSpeedSpread;
}

// Least squares over the speeds (eq. 2); level where they do not spread.
class LineFit {
 public:
  explicit LineFit(const std::vector<EngineCycle>& cycles) : spread_(speedsSpread(cycles)) {
    const double n = static_cast<double>(cycles.size());
    for (const EngineCycle& cycle : cycles) mean_ += cycle.speed / n;
    double square = 0.0;
    for (const EngineCycle& cycle : cycles) square += std::pow(cycle.speed - mean_, 2);
    for (const EngineCycle& cycle : cycles) {
      even_.push_back(1.0 / n);
      rising_.push_back(spread_ ? (cycle.speed - mean_) / square : 0.0);
    }
  }

  bool spread() const { return spread_; }
  template <typename T>  // a number or a matrix
  T slope(const std::vector<T>& values, T zero) const {
    for (size_t i = 0; i < values.size(); ++i) zero += rising_[i] * values[i];
    return zero;
  }
  template <typename T>
  T atZero(const std::vector<T>& values, T zero) const {
    for (size_t i = 0; i < values.size(); ++i) zero += (even_[i] - mean_ * rising_[i]) * values[i];
    return zero;
  }
  SpeedLine line(const std::vector<double>& values) const {
    return {atZero(values, 0.0), slope(values, 0.0)};
  }

 private:
  bool spread_;
  double mean_ = 0.0;
  std::vector<double> even_, rising_;  // weights of the values in the mean and in the slope
};

std::vector<double> valuesOf(const std::vector<EngineCycle>& cycles, const Values& value) {
  std::vector<double> values;
  for (const EngineCycle& cycle : cycles) values.push_back(value(cycle));
  return values;
}

// eq. 1: the components that keep `variance`, from the products of the cycles, which are few, not
// of the channels, which are many.
void findComponents(const std::vector<EngineCycle>& cycles, const LineFit& fit, double variance,
                    GaitSpace& space) {
  const auto n = static_cast<Eigen::Index>(cycles.size());
  const Eigen::Index rows = space.mean.rows(), columns = space.mean.cols();
  Eigen::MatrixXd off(rows * columns, n);  // rows: of the motion vector; columns: cycles
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::MatrixXd d = cycles[i].channels.bottomRows(rows) - space.mean;
    off.col(i) = d.reshaped();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(off.transpose() * off);
  const double all = solver.eigenvalues().sum();
  for (Eigen::Index k = n - 1; k >= 0 && space.variance() < variance; --k) {
    const Eigen::VectorXd direction = (off * solver.eigenvectors().col(k)).normalized();
    PrincipalComponent component;
    component.share = solver.eigenvalues()[k] / all;
    component.direction = direction.reshaped(rows, columns);
    std::vector<double> alphas;
    for (Eigen::Index i = 0; i < n; ++i) alphas.push_back(direction.dot(off.col(i)));
    component.coefficient = fit.line(alphas);
    if (component.coefficient.slope < 0.0) {  // either sign is a component: that which speed raises
      component.direction *= -1.0;
      component.coefficient = {-component.coefficient.at_zero, -component.coefficient.slope};
    }
    space.components.push_back(std::move(component));
  }
}

void fitFurtherChannels(const std::vector<EngineCycle>& cycles, const LineFit& fit,
                        GaitSpace& space) {
  std::vector<Eigen::MatrixXd> roots;
  for (const EngineCycle& cycle : cycles) roots.emplace_back(cycle.channels.topRows(3));
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(3, roots.front().cols());
  space.root.resize(6, zero.cols());
  space.root << fit.atZero(roots, zero), fit.slope(roots, zero);
  for (size_t i = 0; i < 2; ++i) {
    space.foot_forward[i] =
        fit.line(valuesOf(cycles, [i](const EngineCycle& c) { return c.foot_forward[i]; }));
    space.support[i] =
        fit.line(valuesOf(cycles, [i](const EngineCycle& c) { return c.support[i]; }));
    space.toe_out[i] =
        fit.line(valuesOf(cycles, [i](const EngineCycle& c) { return c.toe_out[i]; }));
  }
  space.step_width = fit.line(valuesOf(cycles, [](const auto& c) { return c.step_width; }));
}

}  // namespace

GaitSpace fitGaitSpace(const std::vector<EngineCycle>& cycles, double leg, double variance) {
  GaitSpace space;
  const LineFit fit(cycles);
  const Eigen::Index rows = cycles.front().channels.rows() - 3;
  space.mean = Eigen::MatrixXd::Zero(rows, cycles.front().channels.cols());
  std::vector<FrequencySample> samples;
  for (const EngineCycle& cycle : cycles) {
    space.mean += cycle.channels.bottomRows(rows) / static_cast<double>(cycles.size());
    samples.push_back({cycle.speed / leg, 1.0 / cycle.period});
  }
  space.law = fitFrequencyLaw(samples);
  if (fit.spread()) findComponents(cycles, fit, variance, space);
  fitFurtherChannels(cycles, fit, space);
  return space;
}

Eigen::MatrixXd motionVectorAt(const GaitSpace& space, double speed) {
  Eigen::MatrixXd vector = space.mean;
  for (const PrincipalComponent& component : space.components) {
    vector += component.coefficient.at(speed) * component.direction;
  }
  return vector;
}

}  // namespace amble
