#include "animation/clips/resample_clip.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace amble {
namespace {

// BVH writes frame times to 1e-7 s or so, which adds up over a clip: a last frame that is missed by
// so little is there. [frames]
constexpr double kRounding = 0.01;

}  // namespace

Clip resampleClip(const Clip& clip, double frame_time) {
  assert(frame_time > 0.0);
  if (clip.frames() < 2 || frame_time == clip.frame_time) return clip;
  Clip result;
  result.name = clip.name;
  result.skeleton = clip.skeleton;
  result.poses = PoseArray(clip.skeleton.size());
  result.frame_time = frame_time;
  const double ratio = frame_time / clip.frame_time;
  const int frames = static_cast<int>(std::floor((clip.frames() - 1) / ratio + kRounding)) + 1;
  const size_t joints = clip.skeleton.size();
  Pose pose;
  for (int i = 0; i < frames; ++i) {
    const double at = std::min(i * ratio, clip.frames() - 1.0);
    const int before = std::min(static_cast<int>(at), clip.frames() - 2);
    const double part = at - before;
    interpolatePose(clip.poses[before], clip.poses[before + 1], part, pose);
    result.poses.append(pose);
    for (size_t j = 0; j < joints && !clip.joint_positions.empty(); ++j) {
      const Eigen::Vector3d& a = clip.joint_positions[before * joints + j];
      const Eigen::Vector3d& b = clip.joint_positions[(before + 1) * joints + j];
      result.joint_positions.push_back((1.0 - part) * a + part * b);
    }
  }
  return result;
}

}  // namespace amble
