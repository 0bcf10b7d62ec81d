#include "viz/page/thin_clips.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/text.h"

namespace amble {
namespace {

constexpr size_t kExact = size_t{3} << 20;  // [bytes]
constexpr size_t kExactRotation = 16;       // of a joint in a frame [bytes]
constexpr size_t kMostNamed = 3;
// Of a joint in a frame: a rotation in 16 bits each, three angles, and a place where it has one.
constexpr size_t kRotation = 8, kAngles = 6, kPlace = 12;

size_t bytesOf(const Clip& clip, int every) {
  const size_t frames = (clip.frames() + every - 1) / every;
  const size_t joint = kRotation + kAngles + (clip.joint_positions.empty() ? 0 : kPlace);
  return frames * joint * clip.skeleton.size();
}

double rateOf(const ShownClip& shown, int every) {
  return 1.0 / (shown.motion.clip.frame_time * every);
}

void keepEvery(int every, ShownClip& shown) {
  Clip& clip = shown.motion.clip;
  PoseArray poses(clip.poses.joints());
  std::vector<Eigen::Vector3d> places;
  for (int frame = 0; frame < clip.frames(); frame += every) {
    poses.append(clip.poses[frame]);
    if (clip.joint_positions.empty()) continue;
    const auto first = clip.joint_positions.begin() + frame * clip.skeleton.size();
    places.insert(places.end(), first, first + clip.skeleton.size());
  }
  clip.poses = std::move(poses);
  clip.joint_positions = std::move(places);
  clip.frame_time *= every;
  shown.every = every;
}

}  // namespace

std::vector<std::string> thinClips(std::vector<ShownClip>& clips, size_t most) {
  std::vector<int> every(clips.size(), 1);
  const auto total = [&] {
    size_t sum = 0;
    for (size_t i = 0; i < clips.size(); ++i) sum += bytesOf(clips[i].motion.clip, every[i]);
    return sum;
  };
  while (total() > most) {
    int fastest = -1;  // of those that are fast enough to be thinned once more
    for (size_t i = 0; i < clips.size(); ++i) {
      if (rateOf(clips[i], every[i] + 1) < kFewestFrames) continue;
      if (fastest < 0 || rateOf(clips[i], every[i]) > rateOf(clips[fastest], every[fastest]))
        fastest = static_cast<int>(i);
    }
    if (fastest < 0) break;
    ++every[fastest];
  }
  // By what was done to them: frames a second of the file and of the page.
  std::map<std::pair<long, long>, std::vector<std::string>> thinned;
  for (size_t i = 0; i < clips.size(); ++i) {
    if (every[i] == 1) continue;
    const auto rates =
        std::pair(std::lround(rateOf(clips[i], 1)), std::lround(rateOf(clips[i], every[i])));
    thinned[rates].push_back(clips[i].name);
    keepEvery(every[i], clips[i]);
  }
  std::vector<std::string> notes;
  for (const auto& [rates, names] : thinned) {
    notes.push_back(fmt::format("{}: {} of {} frames a second are on this page.",
                                names.size() > kMostNamed
                                    ? counted(static_cast<long long>(names.size()), "clip")
                                    : joined(names),
                                rates.second, rates.first));
  }
  return notes;
}

bool fitExactly(const std::vector<ShownClip>& clips) {
  size_t sum = 0;
  for (const ShownClip& shown : clips)
    sum += kExactRotation * shown.motion.clip.frames() * shown.motion.clip.skeleton.size();
  return sum <= kExact;
}

}  // namespace amble
