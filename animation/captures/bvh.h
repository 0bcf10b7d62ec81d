/// BVH, read as exporters really write it and written as every reader agrees on it.
///
/// A BVH file is y up unless told otherwise: file (x, y, z) is World (x, -z, y). Only the root is
/// placed in World; every other joint's channels stay as they are in the file.
#pragma once

#include <filesystem>
#include <istream>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "animation/body/clip.h"
#include "base/file_axes.h"

namespace amble {

struct BvhReadOptions {
  double metres_per_unit = 1.0;  ///< length of a file's unit [m, > 0]
  UpAxis up = UpAxis::kY;
  std::optional<double> frame_time = {};  ///< instead of the file's [s, > 0]
};

/// What reading found besides the clip.
struct BvhNotes {
  std::vector<std::string> warnings;  ///< of what is wrong and was read all the same
  bool frame_time_guessed = false;    ///< the file's cannot be one
};

/// All frames are read where there are more than the file says. A frame time that can only be a
/// rate is taken as one (30 is 1/30 s).
/// @param file  `-` is standard input. @throws InputError with file and line: not a BVH, unknown
/// channel, wrong count of numbers, fewer frames than it says, a number that is not finite, frame
/// time outside kMinFrameTime to kMaxFrameTime, more than 10,000 joints, nesting deeper than 1,000.
/// Uses memory in proportion to the file's size.
Clip readBvh(const std::filesystem::path& file, const BvhReadOptions& options = {},
             BvhNotes* notes = nullptr);
/// The same from a stream; `name` stands for the file in messages.
Clip readBvh(std::istream& in, const std::string& name, const BvhReadOptions& options = {},
             BvhNotes* notes = nullptr);
/// The same from the text of a file.
Clip parseBvh(std::string_view text, const std::string& name, const BvhReadOptions& options = {},
              BvhNotes* notes = nullptr);
/// The same in file units and axes, its offsets not settled: turnUpright() and scaleToMetres() make
/// it a clip.
Clip parseBvhAsWritten(std::string_view text, const std::string& name,
                       std::optional<double> frame_time, BvhNotes& notes);

struct BvhWriteOptions {
  double metres_per_unit = 1.0;  ///< 1 writes metres, 0.01 centimetres [m, > 0]
};

/// Root OFFSET 0 0 0, six channels on the root and three elsewhere, Z X Y order, unwrapped angles,
/// unique names of letters, digits and `_`, y up, true frame count, seven digits of frame time.
/// Reading and writing it again gives the same bytes.
/// @pre the clip has no joint_positions that move (they are flattened to the skeleton's offsets).
void writeBvh(std::ostream& out, const Clip& clip, const BvhWriteOptions& options = {});
/// The names that writeBvh gives a skeleton's joints, by joint.
std::vector<std::string> bvhJointNames(const Skeleton& skeleton);
/// Written beside and renamed, so that no half-written file is left. @throws InputError if it
/// cannot be written.
void writeBvh(const std::filesystem::path& file, const Clip& clip,
              const BvhWriteOptions& options = {});

}  // namespace amble
