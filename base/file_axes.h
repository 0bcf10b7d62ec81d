/// The axes of files: World is z up (DESIGN.md, section 2), many files are y up.
#pragma once

#include <Eigen/Core>

namespace amble {

/// The vertical axis of a file.
enum class UpAxis { kY, kZ };

/// Takes a y-up file's (x, y, z) to World's (x, -z, y), exactly: without the rounding of a
/// quaternion (yUpToWorld in rotation.h is that).
inline Eigen::Matrix3d yUpMatrix() {
  return (Eigen::Matrix3d() << 1, 0, 0, 0, 0, -1, 0, 1, 0).finished();
}

/// A point of a file in World, exactly.
inline Eigen::Vector3d fileToWorld(const Eigen::Vector3d& p_file, UpAxis up) {
  return up == UpAxis::kY ? Eigen::Vector3d(p_file.x(), -p_file.z(), p_file.y()) : p_file;
}

}  // namespace amble
