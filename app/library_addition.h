/// Motions of captures added to a library: what `amble library add` does before it writes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "animation/preparation/motion_library_add.h"

namespace amble {

/// How clips become motions.
struct LibraryAddition {
  std::string name;  ///< of the motion; "": the clip's
  MotionKind kind = MotionKind::kWalk;
  std::optional<bool> turning;  ///< of a walk; none: as it is found
  std::string style;
  std::vector<std::string> chains;            ///< that a movement or posture moves; none: all
  std::optional<std::pair<int, int>> frames;  ///< of the file: look only there
  std::vector<double> speeds;  ///< of a speed engine: a walk at each [m/s]; none of a capture
  /// Whether the mirror image of a walk or of a turn on the spot is added too; none: where it has
  /// no style.
  std::optional<bool> mirror;
  std::string licence = "unknown", credit = "unknown";
  MotionReadOptions read;
};

/// What is made of one clip: the motion, and the mirror image of a walk or a turn on the spot. Of a
/// speed engine: that of each speed, called NAME-SPEED.
/// @throws InputError for a speed engine without speeds, and for speeds of anything else
std::vector<MotionRequest> requestsOf(const std::filesystem::path& clip,
                                      const LibraryAddition& how);

/// Whether it is called as YAML is, in letters of either case.
bool isYaml(const std::filesystem::path& file);

/// @throws InputError where a library cannot be called so
void requireLibraryName(const std::filesystem::path& file);

/// The library of a file, or where there is none an empty one that may be written there.
/// @throws InputError
MotionLibrary libraryAt(const std::filesystem::path& file);

}  // namespace amble
