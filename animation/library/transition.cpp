#include "animation/library/transition.h"

#include <algorithm>

namespace amble {

SplineWeights splineWeights(int pieces, double x) {
  const double at = std::clamp(x, 0.0, 1.0) * pieces;
  const int piece = std::min(static_cast<int>(at), pieces - 1);
  const double t = at - piece, u = 1.0 - t;
  return {piece,
          {u * u * u / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
           (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0, t * t * t / 6.0}};
}

void splineAt(const Eigen::MatrixXd& spline, double x, std::span<double> channels) {
  const SplineWeights w = splineWeights(static_cast<int>(spline.cols()) - 3, x);
  const double* columns[4];
  for (int k = 0; k < 4; ++k) columns[k] = spline.col(w.first + k).data();
  for (size_t i = 0; i < channels.size(); ++i) {
    channels[i] = w.weight[0] * columns[0][i] + w.weight[1] * columns[1][i] +
                  w.weight[2] * columns[2][i] + w.weight[3] * columns[3][i];
  }
}

void transitionAt(const TransitionSequence& sequence, double clock, std::span<double> channels) {
  const double length = TransitionSequence::kEnd + sequence.sway;
  splineAt(sequence.spline, (clock + sequence.sway) / length, channels);
}

}  // namespace amble
