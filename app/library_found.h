/// Clips and motions of libraries by what kind of motion they hold: what `amble library find`
/// finds.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "animation/analysis/clip_analysis.h"
#include "animation/captures/motion_reader.h"

namespace amble {

/// A clip, or a motion of a library, and how much of it is of the type that is looked for.
struct FoundMotion {
  std::string name;
  MotionType largest = MotionType::kUnknown;
  double share = 0.0;                   ///< [0, 1]
  std::vector<MotionSegment> segments;  ///< of that type, in frames of the file
};

struct MotionSearch {
  std::vector<std::string> paths;  ///< clips, folders of them, libraries
  std::string type;                ///< as motionTypeName() says it
  double at_least = 0.75;          ///< share of the frames that are of that type [0, 1]
  MotionReadOptions read;
  int threads = 1;  ///< changes no result
  /// Called with how many clips of how many are read, from any thread; false ends the search.
  std::function<bool(int done, int count)> done;
};

/// Those of which most is of the type first. @param wrong  of clips that cannot be read: what is
/// wrong @throws InputError for a library that is wrong
std::vector<FoundMotion> findMotions(const MotionSearch& search, std::vector<std::string>& wrong);

nlohmann::ordered_json foundJson(const std::vector<FoundMotion>& all, const std::string& type);

}  // namespace amble
