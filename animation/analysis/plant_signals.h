/// What foot plants are told by, and the thresholds that tell them (Shanbhag's thesis, §3.1, stage
/// 1): how high and how fast ankle and toe of each foot are.
#pragma once

#include <Eigen/Core>
#include <array>

#include "animation/analysis/foot_plants.h"
#include "animation/clips/floor_fit.h"

namespace amble {

/// A foot's ankle (0) and toe (1) over the fitted floor, low-passed. In leg lengths and leg lengths
/// a second, or in metres and metres a second: as it is said where they are made.
struct PlantSignals {
  Eigen::MatrixXd height;  ///< a row a frame; columns ankle, toe
  Eigen::MatrixXd speed;   ///< the same [>= 0]
  Eigen::VectorXd rise;    ///< velocity of the foot's middle along the floor's normal, a frame each
  std::array<double, 2> swing = {0, 0};  ///< how fast ankle and toe swing

  Eigen::Index frames() const { return speed.rows(); }
};

/// A planted joint is lower and slower than these; by joint, ankle and toe. In the signals' unit.
struct PlantLimits {
  std::array<double, 2> height = {0, 0};  ///< -infinity where the joint is never slow
  std::array<double, 2> speed = {0, 0};
  double still = 0.0;  ///< slower, and low, is certainly planted
};

/// In leg lengths. @param path  rows: frames, columns: ankle x y z, toe x y z [m] @param leg  [m]
PlantSignals plantSignals(Eigen::MatrixXd path, const FloorFit& floor, double leg, double rate,
                          double cutoff);
/// In leg lengths. @pre the signals are, too
PlantLimits plantLimits(const PlantSignals& signals, const PlantOptions& options);

/// The path at `factor` times the rate, on a Catmull-Rom spline through its rows. Slow clips are so
/// looked at: see kPlantRate.
Eigen::MatrixXd finerRows(const Eigen::MatrixXd& rows, int factor);
/// By how much a clip is made finer [>= 1].
int plantFactor(double frame_time, Eigen::Index frames);

/// A foot's signals as detectPlants() saw them, for people to look at: a row a frame of the clip.
struct PlantTrace {
  PlantSignals signals;  ///< [m, m/s]
  PlantLimits limits;    ///< [m, m/s]
};
/// By Side. @pre the paths have a frame; legs [m, > 0], frame time [s, > 0]
std::array<PlantTrace, 2> tracePlants(const FootPaths& paths, const std::array<double, 2>& legs,
                                      double frame_time, const PlantOptions& options = {});

}  // namespace amble
