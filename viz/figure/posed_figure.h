/// The figure in a pose.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "viz/figure/figure.h"

namespace amble {

/// By vertex of the figure, World.
struct PosedFigure {
  std::vector<Eigen::Vector3f> vertices;  ///< [m]
  std::vector<Eigen::Vector3f> normals;   ///< unit length
};

/// As viewers skin it: a vertex is at the weighted mean of where its joints would carry it
/// (Figure::bind). @param frames  X_WJ of every joint
PosedFigure poseFigure(const Figure& figure, const std::vector<JointFrame>& frames);

}  // namespace amble
