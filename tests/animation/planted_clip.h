/// A capture of the shared folder, level, with its feet's plants.
#pragma once

#include <string>

#include "animation/analysis/foot_plants.h"
#include "animation/clips/join_clips.h"
#include "animation/clips/level_capture.h"
#include "base/rotation.h"
#include "tests/animation/captures.h"

namespace amble {

struct PlantedClip {
  Clip clip;
  JointRoles roles;
  PlantedFrames planted;

  operator ClipPart() const { return {clip, planted}; }  // NOLINT: a part is a view of it
};

/// @param path  within mocap/
inline PlantedClip plantedClip(const std::string& path) {
  CapturedMotion motion = readLevelCapture(sharedFolder() / "mocap" / path).motion;
  const FootPlants plants = detectPlants(motion.clip, motion.roles);
  return {motion.clip, motion.roles, {plants.planted(kLeft), plants.planted(kRight)}};
}

/// Largest angular acceleration of a joint in its parent, over frames [first, last] [rad/s²].
inline double jointAcceleration(const Clip& clip, int first, int last) {
  double most = 0.0;
  for (int i = std::max(first, 1); i <= std::min(last, clip.frames() - 2); ++i) {
    for (int j = 1; j < clip.skeleton.size(); ++j) {
      const auto q = [&](int k) { return clip.poses.rotations(k)[j]; };
      const Eigen::Vector3d change =
          logRotation(q(i).conjugate() * q(i + 1)) - logRotation(q(i - 1).conjugate() * q(i));
      most = std::max(most, change.norm() / (clip.frame_time * clip.frame_time));
    }
  }
  return most;
}

}  // namespace amble
