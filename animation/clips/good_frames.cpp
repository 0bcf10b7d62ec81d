#include "animation/clips/good_frames.h"

#include <algorithm>
#include <cmath>

#include "animation/captures/capture_checks.h"
#include "base/statistics.h"

namespace amble {
namespace {

constexpr double kStart = 0.25;    // where bad starts are looked for [s]
constexpr int kFewestFrames = 12;  // of it, in slow captures
constexpr double kLeap = 5.5;      // times the 99th percentile of the rest: no person does that
constexpr double kSlide = 2.0;     // times the median: still on the way out of a reference pose
constexpr double kFrozen = 1e-9;   // [rad]: the same numbers again

// Mean angle of the joints between frame i and the next [rad]: a change of the whole pose, which a
// single wrist that flips over is not.
std::vector<double> changes(const Clip& clip) {
  std::vector<double> change;
  const int joints = clip.poses.joints();
  for (int i = 0; i + 1 < clip.frames(); ++i) {
    const auto a = clip.poses.rotations(i), b = clip.poses.rotations(i + 1);
    double sum = 0.0;
    for (int j = 0; j < joints; ++j) sum += a[j].angularDistance(b[j]);
    change.push_back(sum / joints);
  }
  return change;
}

/// Where the clip begins to be motion.
GoodFrames afterBadStart(const Clip& clip) {
  GoodFrames good{0, clip.frames() - 1};
  const int start = std::max(kFewestFrames, static_cast<int>(kStart / clip.frame_time));
  if (clip.frames() < 3 * start) return good;  // too short to say what is usual in it
  const std::vector<double> change = changes(clip);
  const std::vector<double> rest(change.begin() + start, change.end());
  const double leap = kLeap * quantile(rest, 0.99), slide = kSlide * quantile(rest, 0.5);
  const double frozen = std::min(kFrozen, 0.1 * quantile(rest, 0.5));
  for (int i = start - 1; i >= 0 && good.first == 0; --i) {
    if (change[i] > leap) good.first = i + 1;
  }
  if (good.first == 0) return good;
  while (good.first < 2 * start && (change[good.first] <= frozen || change[good.first] > slide)) {
    ++good.first;
  }
  return good;
}

/// The longest stretch without a jump of the root, the earliest of several.
GoodFrames longestWithoutJump(const Clip& clip, const GoodFrames& all) {
  GoodFrames longest{all.first, all.first};
  int first = all.first;
  const auto end = [&](int last) {
    if (last - first > longest.last - longest.first) longest = {first, last};
    first = last + 1;
  };
  for (const RootJump& jump : rootJumps(clip)) {
    if (jump.frame >= all.first && jump.frame < all.last) end(jump.frame);
  }
  end(all.last);
  return longest;
}

}  // namespace

GoodFrames goodFrames(const Clip& clip) { return longestWithoutJump(clip, afterBadStart(clip)); }

Clip trimmed(const Clip& clip, int first, int last) {
  Clip part{clip.name, clip.skeleton, clip.frame_time, PoseArray(clip.poses.joints()), {}};
  part.poses.append(clip.poses, first, last - first + 1);
  if (!clip.joint_positions.empty()) {
    const auto joints = static_cast<std::ptrdiff_t>(clip.skeleton.size());
    part.joint_positions.assign(clip.joint_positions.begin() + first * joints,
                                clip.joint_positions.begin() + (last + 1) * joints);
  }
  return part;
}

}  // namespace amble
