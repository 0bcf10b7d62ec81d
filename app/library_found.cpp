#include "app/library_found.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "animation/library/motion_library_reader.h"
#include "app/analysed_clip.h"
#include "app/clip_sources.h"

namespace amble {
namespace {

MotionType typeNamed(const std::string& name) {
  int i = 0;
  while (motionTypeName(static_cast<MotionType>(i)) != name) ++i;
  return static_cast<MotionType>(i);
}

FoundMotion foundIn(const AnalysedClip& clip, MotionType type) {
  FoundMotion found{
      clip.file.string(), clip.analysis.kind.largest(), clip.analysis.kind.shareOf(type), {}};
  for (MotionSegment segment : clip.analysis.kind.segments) {
    if (segment.type != type) continue;
    segment.first += clip.first_frame;
    segment.last += clip.first_frame;
    found.segments.push_back(segment);
  }
  return found;
}

/// A library's motions are cut from clips so that each is of one type.
std::vector<FoundMotion> foundIn(const MotionLibrary& library, MotionType type) {
  std::vector<FoundMotion> all;
  for (const Motion& motion : library.motions) {
    const MotionType own = motion.kind == MotionKind::kWalk      ? MotionType::kWalk
                           : motion.kind == MotionKind::kPosture ? MotionType::kStand
                                                                 : MotionType::kUnknown;
    const MotionSource& source = motion.source;
    const std::string part =
        source.speed ? partText(source)
                     : fmt::format("{} {}-{}", source.clip, source.frames[0], source.frames[1]);
    const std::string name = fmt::format("{}: {} ({})", library.file.string(), motion.name, part);
    all.push_back({name, own, own == type ? 1.0 : 0.0, {}});
  }
  return all;
}

bool isLibrary(const std::string& path) { return path == "default" || path.ends_with(".yaml"); }

}  // namespace

std::vector<FoundMotion> findMotions(const MotionSearch& search, std::vector<std::string>& wrong) {
  const MotionType type = typeNamed(search.type);
  std::vector<FoundMotion> all;
  std::vector<std::string> clip_paths;
  for (const std::string& path : search.paths) {
    if (!isLibrary(path)) {
      clip_paths.push_back(path);
      continue;
    }
    const std::vector<FoundMotion> motions =
        foundIn(readMotionLibrary(motionLibraryFile(path)), type);
    all.insert(all.end(), motions.begin(), motions.end());
  }
  const std::vector<std::filesystem::path> files = findClips(clip_paths);
  const auto done = [&](int count) {
    return !search.done || search.done(count, static_cast<int>(files.size()));
  };
  for (const AnalysedClip& clip : analyseFiles(files, {search.read}, search.threads, done)) {
    if (clip.good())
      all.push_back(foundIn(clip, type));
    else
      wrong.push_back(clip.error);
  }
  std::erase_if(all,
                [&](const FoundMotion& found) { return found.share < search.at_least - 1e-12; });
  std::stable_sort(all.begin(), all.end(),
                   [](const FoundMotion& a, const FoundMotion& b) { return a.share > b.share; });
  return all;
}

nlohmann::ordered_json foundJson(const std::vector<FoundMotion>& all, const std::string& type) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const FoundMotion& found : all) {
    Json segments = Json::array();
    for (const MotionSegment& segment : found.segments)
      segments.push_back({{"first_frame", segment.first}, {"last_frame", segment.last}});
    list.push_back({{"name", found.name},
                    {"type", type},
                    {"share", found.share},
                    {"largest", motionTypeName(found.largest)},
                    {"segments", segments}});
  }
  return list;
}

}  // namespace amble
