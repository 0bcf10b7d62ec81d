#include "base/cubic_spline.h"

#include <algorithm>

namespace amble {

CubicSpline::CubicSpline(std::vector<double> x, std::vector<double> y, double first_slope,
                         double last_slope)
    : x_(std::move(x)), y_(std::move(y)), slopes_(x_.size()) {
  // Continuous second derivatives: h1 m0 + 2 (h0 + h1) m1 + h0 m2 = 3 (h1 d0 + h0 d1), a
  // tridiagonal system that is solved by elimination.
  const size_t last = x_.size() - 1;
  std::vector<double> over(x_.size(), 0.0);
  slopes_[0] = first_slope;
  for (size_t i = 1; i < last; ++i) {
    const double h0 = x_[i] - x_[i - 1], h1 = x_[i + 1] - x_[i];
    const double d0 = (y_[i] - y_[i - 1]) / h0, d1 = (y_[i + 1] - y_[i]) / h1;
    const double pivot = 2.0 * (h0 + h1) - h1 * over[i - 1];
    over[i] = h0 / pivot;
    slopes_[i] = (3.0 * (h1 * d0 + h0 * d1) - h1 * slopes_[i - 1]) / pivot;
  }
  slopes_[last] = last_slope;
  for (size_t i = last; i-- > 1;) slopes_[i] -= over[i] * slopes_[i + 1];
}

void CubicSpline::keepRising() {
  for (size_t i = 0; i + 1 < x_.size(); ++i) {
    const double steepest = 3.0 * (y_[i + 1] - y_[i]) / (x_[i + 1] - x_[i]);
    slopes_[i] = std::clamp(slopes_[i], 0.0, std::max(0.0, steepest));
    slopes_[i + 1] = std::clamp(slopes_[i + 1], 0.0, std::max(0.0, steepest));
  }
}

int CubicSpline::piece(double x) const {
  const auto after = std::upper_bound(x_.begin(), x_.end(), x);
  const auto i = after - x_.begin() - 1;
  return static_cast<int>(std::clamp<std::ptrdiff_t>(i, 0, static_cast<int>(x_.size()) - 2));
}

double CubicSpline::at(double x) const {
  x = std::clamp(x, x_.front(), x_.back());
  const int i = piece(x);
  const double h = x_[i + 1] - x_[i], t = (x - x_[i]) / h, rise = y_[i + 1] - y_[i];
  const double a = h * slopes_[i] - rise, b = rise - h * slopes_[i + 1];
  return y_[i] + t * rise + t * (1.0 - t) * (a * (1.0 - t) + b * t);
}

double CubicSpline::slope(double x) const {
  x = std::clamp(x, x_.front(), x_.back());
  const int i = piece(x);
  const double h = x_[i + 1] - x_[i], t = (x - x_[i]) / h, rise = y_[i + 1] - y_[i];
  const double a = h * slopes_[i] - rise, b = rise - h * slopes_[i + 1];
  const double bend = (1.0 - 2.0 * t) * (a * (1.0 - t) + b * t) + t * (1.0 - t) * (b - a);
  return (rise + bend) / h;
}

}  // namespace amble
