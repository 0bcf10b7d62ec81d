/// Fourier series of many channels over one cycle (Pettré §4.1, eq. 2).
#pragma once

#include <Eigen/Core>
#include <vector>

namespace amble {

/// p(phase) = alpha_0 + sum over k = 1..harmonics of alpha_k cos(2 pi k phase)
///            + beta_k sin(2 pi k phase).
struct FourierSeries {
  Eigen::MatrixXd alpha;  ///< rows: channels; columns: k = 0..harmonics
  Eigen::MatrixXd beta;   ///< rows: channels; columns: k = 0..harmonics; column 0 is 0

  int channels() const { return static_cast<int>(alpha.rows()); }
  int harmonics() const { return static_cast<int>(alpha.cols()) - 1; }
};

/// Least squares over one period. `samples`: rows are channels, columns times at `phases` [cycles].
/// @param harmonics  [>= 0] @pre phases.size() == samples.cols() > 2 harmonics.
FourierSeries fitFourier(const Eigen::MatrixXd& samples, const std::vector<double>& phases,
                         int harmonics);

/// Pettré's eq. 2 at a phase: a value a channel.
Eigen::VectorXd fourierAt(const FourierSeries& series, double phase);

/// cos(2 pi k phase) and sin(2 pi k phase), k = 0..harmonics, interleaved into `basis`: 2 harmonics
/// and 2 more numbers.
void fourierBasis(double phase, int harmonics, double* basis);

}  // namespace amble
