#include "animation/editing/least_curve.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "base/range_maximum.h"

namespace amble {
namespace {

constexpr int kBand = 3;  // of a third difference: so many frames apart are tied together

/// A symmetric matrix of which only the diagonal and kBand below it are not zero: at [i][k] is that
/// of row i, column i - k.
using Banded = std::vector<std::array<double, kBand + 1>>;

Banded normalMatrix(const std::vector<double>& weights, double stiffness) {
  constexpr std::array<double, kBand + 1> kThird = {-1.0, 3.0, -3.0, 1.0};
  const int frames = static_cast<int>(weights.size());
  Banded matrix(frames, std::array<double, kBand + 1>{});
  for (int i = 0; i < frames; ++i) matrix[i][0] = weights[i] + 1.0;
  for (int i = 0; i + kBand < frames; ++i) {
    for (int row = 0; row <= kBand; ++row) {
      for (int column = 0; column <= row; ++column) {
        matrix[i + row][row - column] += stiffness * kThird[row] * kThird[column];
      }
    }
  }
  return matrix;
}

/// Its Cholesky factor in its place.
void factorise(Banded& matrix) {
  const int rows = static_cast<int>(matrix.size());
  for (int i = 0; i < rows; ++i) {
    for (int k = std::min(kBand, i); k >= 0; --k) {
      const int column = i - k;
      double sum = matrix[i][k];
      for (int m = std::max(0, i - kBand); m < column; ++m) {
        if (column - m <= kBand) sum -= matrix[i][i - m] * matrix[column][column - m];
      }
      matrix[i][k] = k == 0 ? std::sqrt(sum) : sum / matrix[column][0];
    }
  }
}

void solve(const Banded& factor, Eigen::MatrixXd& rows) {
  const int count = static_cast<int>(factor.size());
  for (int i = 0; i < count; ++i) {
    for (int k = 1; k <= std::min(kBand, i); ++k) rows.row(i) -= factor[i][k] * rows.row(i - k);
    rows.row(i) /= factor[i][0];
  }
  for (int i = count - 1; i >= 0; --i) {
    rows.row(i) /= factor[i][0];
    for (int k = 1; k <= std::min(kBand, i); ++k) rows.row(i - k) -= factor[i][k] * rows.row(i);
  }
}

}  // namespace

Eigen::MatrixXd leastCurve(const Eigen::MatrixXd& wanted, const std::vector<double>& weights,
                           double frame_time, double width) {
  assert(static_cast<size_t>(wanted.rows()) == weights.size());
  Banded matrix = normalMatrix(weights, std::pow(width / frame_time, 6));
  factorise(matrix);
  Eigen::MatrixXd curve = wanted;
  for (Eigen::Index i = 0; i < curve.rows(); ++i) curve.row(i) *= weights[i];
  solve(matrix, curve);
  return curve;
}

std::vector<double> averaged(const std::vector<double>& values, double frame_time, double width) {
  const int frames = static_cast<int>(values.size());
  const int reach = std::max(1, static_cast<int>(std::lround(width / frame_time)));
  std::vector<double> weights;
  double total = 0.0;
  for (int k = -reach; k <= reach; ++k) {
    const double u = k / (reach + 1.0);
    weights.push_back(std::pow(1.0 - u * u, 3));
    total += weights.back();
  }
  std::vector<double> result(values.size(), 0.0);
  for (int i = 0; i < frames; ++i) {
    for (int k = -reach; k <= reach; ++k) {
      result[i] += weights[k + reach] / total * values[std::clamp(i + k, 0, frames - 1)];
    }
  }
  return result;
}

std::vector<double> curveOver(const std::vector<double>& missing, double frame_time, double width) {
  const int frames = static_cast<int>(missing.size());
  const int reach = std::max(1, static_cast<int>(std::lround(width / frame_time)));
  const RangeMaximum largest(missing);
  std::vector<double> within(missing.size(), 0.0);
  for (int i = 0; i < frames; ++i) {
    within[i] = largest.over(std::max(0, i - reach), std::min(frames - 1, i + reach));
  }
  return averaged(within, frame_time, width);
}

}  // namespace amble
