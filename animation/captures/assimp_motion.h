/// Skeletal animation of FBX, glTF, GLB and Collada files, read by Assimp.
///
/// These formats say their vertical axis and their unit; both are applied. Interpolation between
/// keys is linear, whatever the file asks for.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "animation/body/clip.h"
#include "animation/captures/capture_file.h"

namespace amble {

struct AssimpMotionOptions {
  std::optional<double> metres_per_unit = {};  ///< none: as the file says [m, > 0]
  std::optional<UpAxis> up = {};               ///< none: as the file says
  std::optional<double> frame_time = {};       ///< sampled at; none: the file's [s, > 0]
};

/// What the file says of itself, and what was passed over.
struct AssimpMotionNotes {
  double metres_per_unit = 1.0;  ///< of the clip that was read [m]
  UpAxis up = UpAxis::kY;
  std::vector<std::string> warnings;
};

/// Of several animations the one with the most keys is read.
/// @throws InputError: missing, not such a file, no animation of a skeleton, as clipOfNodes() has
/// it; with a line where Assimp names one.
Clip readAssimpMotion(const std::filesystem::path& file, const AssimpMotionOptions& options = {},
                      AssimpMotionNotes* notes = nullptr);

/// The same from the bytes of a file; the end of `name` says of which format. Files that it refers
/// to are not there.
Clip parseAssimpMotion(std::string_view bytes, const std::string& name,
                       const AssimpMotionOptions& options = {}, AssimpMotionNotes* notes = nullptr);

/// Whether such a file has animations at all, or meshes only. @throws InputError: missing, not such
/// a file.
bool holdsAnimation(const std::filesystem::path& file);

}  // namespace amble
