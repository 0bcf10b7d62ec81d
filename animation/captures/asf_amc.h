/// Acclaim's ASF (a skeleton) and AMC (its motion), as Vicon's BodyBuilder and CMU's library write
/// them; after M. Schafer, Acclaim Skeleton File Definition V1.10 (1994).
///
/// A bone's joint is at the bone's start, and a bone starts where its parent ends. Directions and
/// axes are given in the file's global axes, in the rest pose: so every joint frame is parallel to
/// those at rest, as in BVH, and a bone's rotation in its parent is C M C^-1, where C is its `axis`
/// and M its degrees of freedom, the first of `dof` turned first about fixed axes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "animation/body/clip.h"
#include "base/file_axes.h"

namespace amble {

/// Frame time of CMU's library; the files mostly do not say theirs [s].
inline constexpr double kAmcFrameTime = 1.0 / 120.0;

struct AsfAmcOptions {
  double metres_per_unit = 1.0;  ///< of both files [m, > 0]
  UpAxis up = UpAxis::kY;
  std::optional<double> frame_time = {};  ///< none: the AMC's own, else kAmcFrameTime [s, > 0]
};

/// What reading found besides the clip.
struct AsfAmcNotes {
  std::vector<std::string> warnings;  ///< `FILE:LINE: ...`: sections that were passed over
  double length_unit = 1.0;           ///< the ASF's `length`; CMU's 0.45 is 1 / 0.45 inch a unit
  bool frame_time_said = false;       ///< the AMC says its rate
};

/// Limits are checked and not kept. A root's preset orientation is turned before its motion, a
/// preset position added to it. `l` is the change of a bone's length, as some programs take it for
/// the length itself. An AMC has no count of frames: one that is cut between two frames is read.
/// @throws InputError with file and line: a keyword, bone or number that is none; a bone without a
/// parent, with two, or in a cycle; of a fully specified AMC a frame without one of the bones;
/// frames not in order; more joints than kMaxJoints, deeper than kMaxDepth. Uses memory in
/// proportion to the files' sizes.
Clip readAsfAmc(const std::filesystem::path& asf, const std::filesystem::path& amc,
                const AsfAmcOptions& options = {}, AsfAmcNotes* notes = nullptr);

/// A file's text and the name that stands for it in messages.
struct NamedText {
  std::string_view text;
  std::string name;
};
/// The same from the texts of files.
Clip parseAsfAmc(const NamedText& asf, const NamedText& amc, const AsfAmcOptions& options = {},
                 AsfAmcNotes* notes = nullptr);
/// The same in file units and axes, its offsets not settled: turnUpright() and scaleToMetres() make
/// it a clip.
Clip parseAsfAmcAsWritten(const NamedText& asf, const NamedText& amc,
                          std::optional<double> frame_time, AsfAmcNotes& notes);

}  // namespace amble
