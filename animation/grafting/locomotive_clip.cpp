#include "animation/grafting/locomotive_clip.h"

#include <algorithm>

#include "animation/clips/good_frames.h"
#include "animation/clips/level_capture.h"
#include "base/error.h"

namespace amble {
namespace {

void shift(FootPlants& plants, int by) {
  for (auto& side : plants.plants) {
    for (FootPlant& plant : side) {
      plant.first += by;
      plant.last += by;
      plant.strike += by;
      plant.lift_off += by;
    }
  }
}

bool isOneOfFour(MotionType type) {
  return type != MotionType::kUnknown && type != MotionType::kOther;
}

}  // namespace

LocomotiveClip locomotiveClip(Clip clip, const JointRoles& roles, const std::string& file) {
  if (clip.frames() == 0) throw InputError(file, 0, "holds no frames", "a motion");
  LocomotiveClip result;
  result.file = file;
  result.roles = roles;
  const GoodFrames good = goodFrames(clip);
  result.first = good.first;
  result.last = good.last;
  const Clip level = levelled(trimmed(clip, good.first, good.last), roles);
  result.plants = detectPlants(level, roles);
  result.kind = classifyClip(result.plants, level.frame_time);
  shift(result.plants, good.first);
  result.plants.frames = clip.frames();
  std::vector<MotionType>& frames = result.kind.frames;
  frames.insert(frames.begin(), static_cast<size_t>(good.first), MotionType::kUnknown);
  frames.resize(static_cast<size_t>(clip.frames()), MotionType::kUnknown);
  for (MotionSegment& segment : result.kind.segments) {
    segment.first += good.first;
    segment.last += good.first;
  }
  result.clip = std::move(clip);
  return result;
}

MotionStretch stretchOf(const LocomotiveClip& clip) {
  return stretchOf(clip, {0, clip.clip.frames() - 1});
}

MotionStretch stretchOf(const LocomotiveClip& clip, std::pair<int, int> within) {
  MotionStretch best;
  best.last = -1;
  for (const MotionSegment& segment : clip.kind.segments) {
    const MotionStretch here{segment.type, std::max(segment.first, within.first),
                             std::min(segment.last, within.second)};
    if (isOneOfFour(here.type) && here.frames() > best.frames()) best = here;
  }
  return best;
}

FootPlants plantsWithin(const FootPlants& plants, int first, int last) {
  FootPlants within;
  within.frames = last - first + 1;
  for (const Side side : {kLeft, kRight}) {
    for (const FootPlant& plant : plants.plants[side]) {
      if (plant.last < first || plant.first > last) continue;
      within.plants[side].push_back({std::max(plant.first - first, 0),
                                     std::min(plant.last, last) - first, plant.strike - first,
                                     plant.lift_off - first});
    }
  }
  return within;
}

}  // namespace amble
