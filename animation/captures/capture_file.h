/// What the readers of capture files share: a file's text, its vertical axis, and how much of it is
/// taken for true.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <istream>
#include <string>
#include <vector>

#include "animation/body/skeleton.h"

namespace amble {

/// The vertical axis of a capture file. World is z up (DESIGN.md, section 2).
enum class UpAxis { kY, kZ };

/// More joints than that are hostile, not data.
inline constexpr int kMaxJoints = 10'000;
/// Deeper nesting too.
inline constexpr int kMaxDepth = 1'000;
/// No capture is that far away or turned that often; beyond it sums of numbers lose the micrometre.
/// [file units, degrees]
inline constexpr double kMaxCaptureNumber = 1e9;
/// Joints without channels take memory but no text. A file may hold so many poses of joints a byte;
/// real files have one a six bytes or more.
inline constexpr size_t kMaxJointPosesPerByte = 4;

/// `.bvh` of `Walk.BVH`.
std::string lowerEnding(const std::filesystem::path& file);

/// The whole of a file; `-` is standard input. @throws InputError if it is missing, a folder or
/// unreadable; `expected` says what it should have been ("a BVH file").
std::string readText(const std::filesystem::path& file, const std::string& expected);
/// The same of a stream; `name` stands for the file in messages.
std::string readText(std::istream& in, const std::string& name, const std::string& expected);

/// A point of a file in World: of a y-up file (x, y, z) is (x, -z, y).
Eigen::Vector3d fileToWorld(const Eigen::Vector3d& p_file, UpAxis up);

/// Where exporters recompute a joint's place for each frame and round: it has not moved. A
/// micrometre is what we write [m].
inline constexpr double kFixedOffsetTolerance = 1e-6;

/// Joints whose positions in their parent never move by more than `tolerance` get them as their
/// offset once and for all; where none moves `joint_positions` is emptied.
/// @param joint_positions  frame-major, joints of them a frame, root first [m]
void settleOffsets(double metres_per_unit, std::vector<Joint>& joints_in_file_units,
                   std::vector<Eigen::Vector3d>& joint_positions,
                   double tolerance = kFixedOffsetTolerance);

}  // namespace amble
