#include "animation/library/fourier.h"

#include <Eigen/QR>
#include <cmath>

#include "base/rotation.h"

namespace amble {

FourierSeries fitFourier(const Eigen::MatrixXd& samples, const std::vector<double>& phases,
                         int harmonics) {
  const Eigen::Index times = samples.cols();
  Eigen::MatrixXd basis(times, 2 * harmonics + 1);  // rows: times; columns: 1, cos, sin, cos, ...
  for (Eigen::Index i = 0; i < times; ++i) {
    basis(i, 0) = 1.0;
    for (int k = 1; k <= harmonics; ++k) {
      basis(i, 2 * k - 1) = std::cos(2.0 * kPi * k * phases[i]);
      basis(i, 2 * k) = std::sin(2.0 * kPi * k * phases[i]);
    }
  }
  const Eigen::MatrixXd solved = basis.householderQr().solve(samples.transpose());
  FourierSeries series;
  series.alpha = Eigen::MatrixXd::Zero(samples.rows(), harmonics + 1);
  series.beta = series.alpha;
  series.alpha.col(0) = solved.row(0).transpose();
  for (int k = 1; k <= harmonics; ++k) {
    series.alpha.col(k) = solved.row(2 * k - 1).transpose();
    series.beta.col(k) = solved.row(2 * k).transpose();
  }
  return series;
}

Eigen::VectorXd fourierAt(const FourierSeries& series, double phase) {
  std::vector<double> basis(2 * static_cast<size_t>(series.harmonics()) + 2);
  fourierBasis(phase, series.harmonics(), basis.data());
  Eigen::VectorXd value = Eigen::VectorXd::Zero(series.channels());
  for (int k = 0; k <= series.harmonics(); ++k) {  // Pettré eq. 2
    value += basis[2 * k] * series.alpha.col(k) + basis[2 * k + 1] * series.beta.col(k);
  }
  return value;
}

void fourierBasis(double phase, int harmonics, double* basis) {
  const double c1 = std::cos(2.0 * kPi * phase), s1 = std::sin(2.0 * kPi * phase);
  double c = 1.0, s = 0.0;
  for (int k = 0; k <= harmonics; ++k) {
    basis[2 * k] = c;
    basis[2 * k + 1] = s;
    const double next = c * c1 - s * s1;
    s = c * s1 + s * c1;
    c = next;
  }
}

}  // namespace amble
