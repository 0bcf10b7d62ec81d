#include "animation/analysis/low_pass.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/rotation.h"

namespace amble {
namespace {

// Two runs of a filter have their -3 dB where each has -1.5 dB: the cut-off of one is higher by
// this, in the frequencies of the bilinear transform (Winter, eq. 3.9).
const double kTwoRuns = std::pow(std::sqrt(2.0) - 1.0, 0.25);

// Reflected samples before and behind, in periods of the cut-off: the filter has forgotten its
// start by then.
constexpr double kPadding = 3.0;

struct Biquad {
  double b0, b1, b2, a1, a2;
};

Biquad butterworth(double rate, double cutoff) {
  const double w = std::tan(kPi * cutoff / rate) / kTwoRuns;
  const double k = std::sqrt(2.0) * w, w2 = w * w;
  const double b0 = w2 / (1.0 + k + w2);
  const double a1 = 2.0 * (w2 - 1.0) / (1.0 + k + w2);
  return {b0, 2.0 * b0, b0, a1, 4.0 * b0 - a1 - 1.0};
}

// In place; begins as if the first sample had lasted for ever.
void run(const Biquad& f, std::vector<double>& x) {
  double x1 = x.front(), x2 = x1, y1 = x1, y2 = x1;
  for (double& value : x) {
    const double x0 = value;
    value = f.b0 * x0 + f.b1 * x1 + f.b2 * x2 - f.a1 * y1 - f.a2 * y2;
    x2 = x1;
    x1 = x0;
    y2 = y1;
    y1 = value;
  }
}

}  // namespace

void lowPass(Eigen::MatrixXd& rows, double rate, double cutoff) {
  assert(rate > 0.0 && cutoff > 0.0);
  const int n = static_cast<int>(rows.rows());
  if (n < 2 || cutoff >= kLargestCutoff * rate) return;
  const Biquad filter = butterworth(rate, cutoff);
  const int pad = std::min(n - 1, static_cast<int>(std::ceil(kPadding * rate / cutoff)));
  std::vector<double> x(n + 2 * pad);
  for (Eigen::Index c = 0; c < rows.cols(); ++c) {
    // Without the line through both ends a reflected signal is zero there, which is what the filter
    // begins with.
    const double first = rows(0, c), slope = (rows(n - 1, c) - first) / (n - 1);
    for (int i = 0; i < n; ++i) x[pad + i] = rows(i, c) - first - slope * i;
    for (int i = 1; i <= pad; ++i) {
      x[pad - i] = -x[pad + i];
      x[pad + n - 1 + i] = -x[pad + n - 1 - i];
    }
    run(filter, x);
    std::reverse(x.begin(), x.end());
    run(filter, x);
    std::reverse(x.begin(), x.end());
    for (int i = 0; i < n; ++i) rows(i, c) = x[pad + i] + first + slope * i;
  }
}

Eigen::MatrixXd derivative(const Eigen::MatrixXd& rows, double rate) {
  const Eigen::Index n = rows.rows();
  Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(n, rows.cols());
  for (Eigen::Index i = 0; n > 1 && i < n; ++i) {
    const Eigen::Index before = std::max<Eigen::Index>(0, i - 1), after = std::min(n - 1, i + 1);
    slope.row(i) =
        (rows.row(after) - rows.row(before)) * (rate / static_cast<double>(after - before));
  }
  return slope;
}

}  // namespace amble
