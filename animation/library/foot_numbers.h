/// A foot's swing and roll as a row of numbers, so that these can be fitted over speed.
#pragma once

#include <Eigen/Core>

#include "animation/library/foot_cycle.h"

namespace amble {

/// All numbers of a foot cycle but its two phases: slip, the polynomials of the swing, the pitch.
Eigen::RowVectorXd footNumbers(const FootCycle& foot);
/// How many they are.
int footNumberCount();
/// The foot cycle of such numbers, its phases 0. @pre footNumberCount() of them
FootCycle footOf(const Eigen::RowVectorXd& numbers);

}  // namespace amble
