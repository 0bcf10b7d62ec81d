/// Skeletal animation of FBX, glTF, GLB, VRM animation and Collada files.
///
/// These formats say their vertical axis and their unit; both are applied. Each is read in a
/// process of its own with bounds on memory and time (guarded_run.h).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "animation/body/clip.h"
#include "animation/captures/capture_file.h"
#include "base/guarded_run.h"

namespace amble {

struct NodeFileOptions {
  std::optional<double> metres_per_unit = {};  ///< none: as the file says [m, > 0]
  std::optional<UpAxis> up = {};               ///< none: as the file says
  std::optional<double> frame_time = {};       ///< sampled at; none: the file's [s, > 0]
  std::string take = {};                       ///< animation; "": the one in which most moves
  size_t memory = GuardLimits{}.memory;        ///< that reading may fill [bytes, > 0]
};

/// What the file says of itself, and what was passed over.
struct NodeFileNotes {
  double metres_per_unit = 1.0;  ///< of the clip that was read [m]
  UpAxis up = UpAxis::kY;
  std::vector<std::string> warnings;
};

/// Longest such file [bytes].
inline constexpr size_t kMaxNodeFile = size_t{400} << 20;

/// Whether a name ends as that of such a file.
bool isNodeFile(const std::filesystem::path& file);

/// @throws InputError: missing, no regular file, not such a file, more memory or time than the
/// guard allows, no animation of that name, none at all, as clipOfNodes() has it; with a line where
/// the format's reader names one.
Clip readNodeFile(const std::filesystem::path& file, const NodeFileOptions& options = {},
                  NodeFileNotes* notes = nullptr);
/// The same; nothing where the file has no animation at all.
std::optional<Clip> readNodeFileIfAny(const std::filesystem::path& file,
                                      const NodeFileOptions& options = {},
                                      NodeFileNotes* notes = nullptr);

/// The same from the bytes of a file; the end of `name` says of which format. Files that it refers
/// to are not there.
Clip parseNodeFile(std::string_view bytes, const std::string& name,
                   const NodeFileOptions& options = {}, NodeFileNotes* notes = nullptr);

}  // namespace amble
