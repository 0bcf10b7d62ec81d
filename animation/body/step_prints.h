/// From where the soles of a step were to what it measures.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "animation/body/foot_shape.h"
#include "animation/body/step_measure.h"

namespace amble {

/// A sole that stands.
struct SolePrint {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< its middle, on the ground [m, World]
  SoleEnds ends;                                 ///< as it lies there [m, World]
};

/// Where the soles of a step were.
struct StepPrints {
  Side side = kLeft;            ///< of the foot that lands
  SolePrint from, to;           ///< its print before and after
  SolePrint other;              ///< of the foot that stands
  double along = 0.0;           ///< heading of the way [rad]
  std::vector<SoleEnds> swing;  ///< frame by frame; none where it was not seen
};

/// Stride, width, lift, climb and the print, of what was seen.
StepMeasure measureStep(const StepPrints& prints);

/// The way between two prints that head so: toeing out of left and right feet cancels [rad].
double headingBetween(double other, double landing);

}  // namespace amble
