/// Where to put cameras that see a walk: nothing stands between them and the walker.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "scenarios/run_scenario.h"

namespace amble {

struct CameraView {
  Eigen::Vector3d position = Eigen::Vector3d::Zero(), target = Eigen::Vector3d::Zero();  ///< [m]
  double field_of_view = 0.0;  ///< that the whole walk fills, to all sides [rad, at most kWidest]
  double seen = 0.0;  ///< share of head and hips, along the walk, that nothing hides [0, 1]
};

inline constexpr int kMostCameras = 4;
inline constexpr double kWidestView = 1.6;  ///< [rad]
/// Fewer than that is seen of it, and a camera is none [0 to 1].
inline constexpr double kLeastSeen = 0.6;

/// The best of a ring of places about the walk, at the height of eyes and below a ceiling: those
/// that see most, from different sides. World, z up. None where walls hide the walk from all.
/// @pre the run is solved
std::vector<CameraView> suggestCameras(const RunResult& run);

}  // namespace amble
