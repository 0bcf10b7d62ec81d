/// How alike two frames are (Shanbhag's thesis, §4.2.1, eq. 4.1): squares of the weighted distances
/// of positions, velocities and accelerations of end effectors, each frame seen in the neutral
/// frame: the root over the origin, its height kept, facing x.
///
/// End effectors are root, head, hands and toes. The weights of positions add up to 1, so that the
/// error is a mean square distance [m²]. Those of velocities and accelerations follow from a time,
/// kFeatureReach: what makes two frames differ by a distance after that time weighs as the
/// distance. Weights are taken into the features, whose squared distance is the error.
#pragma once

#include <Eigen/Core>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

/// A column a frame; rows position, velocity, acceleration of each end effector, x y z, and rows of
/// zeros that make a whole number of vectors. [m]
using FrameFeatures = Eigen::MatrixXf;
inline constexpr int kFeaturePoints = 6;
inline constexpr int kFeatureRows = 56;

/// How much each counts: the thesis names root, head and feet, and lets hands count less.
inline constexpr double kRootWeight = 1.0, kHeadWeight = 1.0, kHandWeight = 0.25, kFootWeight = 1.0;
inline constexpr double kFeatureReach = 0.1;  ///< a fifth of a step, by trial [s]

/// @pre roles as guessJointRoles requires them. One forward kinematics a frame.
FrameFeatures frameFeatures(const Clip& clip, const JointRoles& roles);

/// E of two frames [m², >= 0]: the same to the bit either way round, and on any machine that keeps
/// to IEEE 754. @param a, b  kFeatureRows values each
inline float frameError(const float* a, const float* b) {
  using Feature = Eigen::Matrix<float, kFeatureRows, 1>;
  return (Eigen::Map<const Feature>(a) - Eigen::Map<const Feature>(b)).squaredNorm();
}
inline float frameError(const FrameFeatures& features, int i, int j) {
  return frameError(features.col(i).data(), features.col(j).data());
}

}  // namespace amble
