/// Toes that give way: turned up about one axis of their foot, that they do not flick where they
/// hang down and any level axis is across them.
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace amble {

/// About which toes turn up at each frame [unit, level, World]: one axis of their foot, the mean of
/// those that are level and across them, each counting as much as they lie; 0 where there is none.
/// @param bones  from the toe joint to the tip, as captured [World]
/// @param q_WF  of the foot, of which the toes are. @pre as many
std::vector<Eigen::Vector3d> toeAxes(const std::vector<Eigen::Vector3d>& bones,
                                     const std::vector<Eigen::Quaterniond>& q_WF);

/// By how much a bone is turned up about a level axis for its tip to be `higher` [m]; as high as it
/// gets where that is too far [rad, >= 0].
double turnUp(const Eigen::Vector3d& bone, const Eigen::Vector3d& axis, double higher);

}  // namespace amble
