#include "animation/analysis/plant_signals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "animation/analysis/low_pass.h"
#include "base/ease.h"
#include "base/statistics.h"

namespace amble {
namespace {

// Heights of a standing joint are read from its slow frames at this quantile: low enough to leave
// out a heel that has risen while the foot is still slow, high enough to pass over noise.
constexpr double kStandingQuantile = 0.25;

// Frames that count as slow there: below this share of the foot's own speed quantile. By trial.
constexpr double kSwingQuantile = 0.95;

// The point between toe (0) and ankle (1) whose vertical velocity tells of strike and lift-off:
// O'Connor's middle of the foot. Scores hardly change from 0.5 to 0.7.
constexpr double kAnkleShare = 0.5;

// Every `factor`th row, times `unit`.
Eigen::MatrixXd coarserRows(const Eigen::MatrixXd& rows, int factor, double unit) {
  Eigen::MatrixXd coarse((rows.rows() - 1) / factor + 1, rows.cols());
  for (Eigen::Index i = 0; i < coarse.rows(); ++i) coarse.row(i) = unit * rows.row(i * factor);
  return coarse;
}

PlantLimits inMetres(PlantLimits limits, double leg) {
  for (const int joint : {0, 1}) {
    limits.height[joint] *= leg;
    limits.speed[joint] *= leg;
  }
  limits.still *= leg;
  return limits;
}

}  // namespace

PlantSignals plantSignals(Eigen::MatrixXd path, const FloorFit& floor, double leg, double rate,
                          double cutoff) {
  path /= leg;
  lowPass(path, rate, cutoff);
  const Eigen::MatrixXd velocity = derivative(path, rate);
  const Eigen::Vector3d& n = floor.normal;
  const auto along = [&n](const Eigen::MatrixXd& rows, int j) -> Eigen::VectorXd {
    return n.x() * rows.col(3 * j) + n.y() * rows.col(3 * j + 1) + n.z() * rows.col(3 * j + 2);
  };
  PlantSignals signals;
  signals.height.resize(path.rows(), 2);
  signals.speed.resize(path.rows(), 2);
  for (int j = 0; j < 2; ++j) {
    signals.height.col(j) = along(path, j).array() - floor.height / leg;
    signals.speed.col(j) =
        (velocity.col(3 * j).array().square() + velocity.col(3 * j + 1).array().square() +
         velocity.col(3 * j + 2).array().square())
            .sqrt();
    const Eigen::VectorXd speed = signals.speed.col(j);
    signals.swing[j] = quantile({speed.begin(), speed.end()}, kSwingQuantile);
  }
  signals.rise = kAnkleShare * along(velocity, 0) + (1.0 - kAnkleShare) * along(velocity, 1);
  return signals;
}

PlantLimits plantLimits(const PlantSignals& signals, const PlantOptions& options) {
  PlantLimits limits;
  limits.still = options.min_speed;
  for (int j = 0; j < 2; ++j) {
    limits.speed[j] =
        std::clamp(options.speed_of_swing * signals.swing[j], options.min_speed, options.max_speed);
    std::vector<double> slow_heights;
    for (Eigen::Index i = 0; i < signals.frames(); ++i) {
      if (signals.speed(i, j) < limits.speed[j]) slow_heights.push_back(signals.height(i, j));
    }
    limits.height[j] = slow_heights.empty()
                           ? -std::numeric_limits<double>::infinity()
                           : quantile(slow_heights, kStandingQuantile) + options.height;
  }
  return limits;
}

Eigen::MatrixXd finerRows(const Eigen::MatrixXd& rows, int factor) {
  const Eigen::Index last = rows.rows() - 1;
  Eigen::MatrixXd fine(last * factor + 1, rows.cols());
  for (Eigen::Index i = 0; i <= last * factor; ++i) {
    const Eigen::Index k = std::min(i / factor, std::max<Eigen::Index>(0, last - 1));
    const double t = static_cast<double>(i - k * factor) / factor;
    const auto row = [&](Eigen::Index r) { return rows.row(std::clamp<Eigen::Index>(r, 0, last)); };
    const Eigen::RowVectorXd from = row(k), to = row(k + 1);
    const Eigen::RowVectorXd slope_from = 0.5 * (to - row(k - 1)),
                             slope_to = 0.5 * (row(k + 2) - from);
    const double s = smoothstep(t);
    fine.row(i) = (1.0 - s) * from + s * to + t * (1.0 - t) * (1.0 - t) * slope_from -
                  t * t * (1.0 - t) * slope_to;
  }
  return fine;
}

int plantFactor(double frame_time, Eigen::Index frames) {
  const double rate = 1.0 / frame_time;
  return rate < kPlantRate && frames > 1 ? static_cast<int>(std::ceil(kPlantRate / rate)) : 1;
}

std::array<PlantTrace, 2> tracePlants(const FootPaths& paths, const std::array<double, 2>& legs,
                                      double frame_time, const PlantOptions& options) {
  const int factor = plantFactor(frame_time, paths[kLeft].rows());
  FootPaths fine = paths;
  if (factor > 1) {
    for (Eigen::MatrixXd& path : fine) path = finerRows(path, factor);
  }
  const FloorFit floor = fitFloor(fine, legs, frame_time / factor);
  std::array<PlantTrace, 2> traces;
  for (const Side side : {kLeft, kRight}) {
    PlantSignals seen =
        plantSignals(fine[side], floor, legs[side], factor / frame_time, options.cutoff);
    traces[side].limits = inMetres(plantLimits(seen, options), legs[side]);
    PlantSignals& shown = traces[side].signals;
    shown.height = coarserRows(seen.height, factor, legs[side]);
    shown.speed = coarserRows(seen.speed, factor, legs[side]);
    shown.rise = coarserRows(seen.rise, factor, legs[side]);
    for (const int joint : {0, 1}) shown.swing[joint] = seen.swing[joint] * legs[side];
  }
  return traces;
}

}  // namespace amble
