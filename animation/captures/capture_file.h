/// What the readers of capture files share: a file's text, its axes and unit, and how much of it is
/// taken for true.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "animation/body/clip.h"
#include "base/file_axes.h"
#include "base/files.h"

namespace amble {

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

/// Captures as text: an hour of a whole body at 60 Hz.
inline constexpr FileKind kBvhFile{"a BVH file", size_t{400} << 20};
inline constexpr FileKind kAmcFile{"an AMC file", size_t{400} << 20};
inline constexpr FileKind kAsfFile{"an ASF file", size_t{16} << 20};

/// The text as TextCursor reads it, without the NUL or Ctrl-Z that old programs put behind it, each
/// with a warning. @param mended  keeps the text where lines end in CR alone, as on old Macs
/// @throws InputError naming the encoding where it is UTF-16.
std::string_view plainText(std::string_view text, const std::string& name, std::string& mended,
                           std::vector<std::string>& warnings);

/// Frame times of captures: from 1 to 10,000 frames a second [s].
inline constexpr double kMinFrameTime = 1e-4, kMaxFrameTime = 1.0;
inline bool isFrameTime(double seconds) {
  return seconds >= kMinFrameTime && seconds <= kMaxFrameTime;
}

/// Turns a clip that is as its file has it, axes and all, to z up.
void turnUpright(UpAxis up, Clip& clip);
/// Takes such a clip from file units to metres and settles its offsets.
void scaleToMetres(double metres_per_unit, Clip& clip);

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
