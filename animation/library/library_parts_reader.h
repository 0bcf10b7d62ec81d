/// What the files of motion libraries and of speed engines have in common, read.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
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
/// @param of  kind of the motion that it is of; none: it is of a speed engine's clip or posture
MotionSource readSource(const YamlNode& node, std::optional<MotionKind> of = std::nullopt);
CaptureQuality readCapture(const YamlNode& node);
/// `joints:` by role; legs whole.
JointRoles readRoles(const YamlNode& node, const Skeleton& skeleton);

}  // namespace amble
