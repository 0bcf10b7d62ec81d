#include "animation/preparation/swing_fit.h"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace amble {
namespace {

// How far any point of the sole stays above the ground in the middle of a swing, and less towards
// its ends, where captured heels come down to 2 mm [m].
constexpr double kSwingClearance = 0.012;
// Coefficients that a captured swing is fitted with: along and up, where feet go quickly at first;
// and beside that.
constexpr int kStrayTerms = 3;

// Least squares of tau^2 (1 - tau)^2 (c0 + c1 tau + ...) to values at even tau, with `terms`
// coefficients.
SwingTerms fitSwing(const std::vector<double>& values, int terms) {
  const int n = static_cast<int>(values.size());
  Eigen::MatrixXd basis(n, terms);
  Eigen::VectorXd target(n);
  for (int i = 0; i < n; ++i) {
    const double tau = static_cast<double>(i) / (n - 1);
    const double window = tau * tau * (1.0 - tau) * (1.0 - tau);
    for (int k = 0; k < terms; ++k) basis(i, k) = window * std::pow(tau, k);
    target[i] = values[i];
  }
  const Eigen::VectorXd solved = basis.colPivHouseholderQr().solve(target);
  SwingTerms coefficients = {};
  for (int k = 0; k < terms; ++k) coefficients[k] = solved[k];
  return coefficients;
}

}  // namespace

double soleClearance(const FootShape& shape, double pitch, double height) {
  const double pivot = pitch < 0.0 ? shape.heel_x : shape.ball_x;
  const double s = std::sin(pitch);
  const double heel = -s * (shape.heel_x - pivot), ball = -s * (shape.ball_x - pivot);
  return height + std::min(heel, ball);
}

double swingClearance(double tau) {
  const double window = 16.0 * tau * tau * (1.0 - tau) * (1.0 - tau);
  return kSwingClearance * window * window;
}

SwingTerms fitProgress(const std::vector<double>& values) {
  return fitSwing(values, kProgressTerms);
}

SwingTerms fitStray(const std::vector<double>& values) { return fitSwing(values, kStrayTerms); }

SwingTerms fitSwingHeight(const FootShape& shape, const FootCycle& foot,
                          std::vector<double> height) {
  constexpr int kRounds = 40;  // of raising what dips; by then a tenth of a millimetre is missing
  SwingTerms fitted = fitSwing(height, kHeightTerms);
  for (int round = 0; round < kRounds; ++round) {
    for (int i = 0; i < kSwingPoints; ++i) {
      const double tau = static_cast<double>(i) / (kSwingPoints - 1);
      const double have =
          soleClearance(shape, footPitch(foot, 1.0 + tau), swingPolynomial(fitted, tau));
      height[i] += 2.0 * std::max(0.0, swingClearance(tau) - have);  // twice: fits take back
    }
    fitted = fitSwing(height, kHeightTerms);
  }
  return fitted;
}

}  // namespace amble
