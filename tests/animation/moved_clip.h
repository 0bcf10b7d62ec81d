/// A clip that somebody made elsewhere.
#pragma once

#include "animation/body/clip.h"

namespace amble {

/// The clip turned and moved as a whole.
inline Clip moved(const Clip& clip, const Eigen::Quaterniond& turn, const Eigen::Vector3d& by) {
  Clip out = clip;
  for (int i = 0; i < clip.frames(); ++i) {
    out.poses.p_WR(i) = turn * clip.poses.p_WR(i) + by;
    out.poses.rotations(i)[0] = turn * clip.poses.rotations(i)[0];
  }
  return out;
}

}  // namespace amble
