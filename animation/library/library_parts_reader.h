/// What the files of motion libraries and of speed engines have in common, read.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "animation/library/motion_library.h"

namespace amble {

class YamlNode;

// All throw InputError with file and line.

/// Two angles in degrees [rad].
std::array<double, 2> degreePair(const YamlNode& node);
/// A list of rows. @param what  the rows are, for messages
Eigen::MatrixXd readMatrix(const YamlNode& node, int rows, int columns, const std::string& what);
/// Quaternions, one a joint.
std::vector<Eigen::Quaterniond> readRotations(const YamlNode& node, int joints);
/// `posture:` of a skeleton of so many joints.
Posture readPosture(const YamlNode& node, int joints);
/// @param of_engine  whether it may be a speed engine
MotionSource readSource(const YamlNode& node, bool of_engine = false);
CaptureQuality readCapture(const YamlNode& node);
/// `joints:` by role; legs whole.
JointRoles readRoles(const YamlNode& node, const Skeleton& skeleton);

}  // namespace amble
