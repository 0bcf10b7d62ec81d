/// A capture of the shared folder on a level floor, as preparation looks at it.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "animation/body/foot_shape.h"
#include "animation/clips/level_capture.h"
#include "animation/preparation/gait_track.h"
#include "animation/preparation/walk_cycle_fit.h"
#include "tests/animation/captures.h"

namespace amble {

struct LevelWalk {
  Clip clip;
  JointRoles roles;
  std::array<FootShape, 2> feet{shape(kLeft), shape(kRight)};
  GaitTrack track{clip, roles, feet};

  LevelWalk(Clip level, JointRoles of) : clip(std::move(level)), roles(std::move(of)) {}
  explicit LevelWalk(const CapturedMotion& motion) : LevelWalk(motion.clip, motion.roles) {}
  /// @param path  within mocap/
  explicit LevelWalk(const std::string& path)
      : LevelWalk(readLevelCapture(sharedFolder() / "mocap" / path).motion) {}
  LevelWalk(const LevelWalk&) = delete;  // its track looks at its clip

  FootShape shape(Side side) const {
    return makeFootShape(clip.skeleton, roles, side, statureOf(clip.skeleton, roles));
  }
  /// The mean pose, the root against the heading: what its own cycles may be against.
  std::vector<Eigen::Quaterniond> reference() const {
    return preparePosture(clip, roles, feet, 0, clip.frames() - 1).rotations;
  }
  WalkCycle cycle(const std::vector<Eigen::Quaterniond>& against,
                  const CycleOptions& options = {"the clip", false, 6, {}}) const {
    return prepareWalkCycle(clip, roles, feet, against, options);
  }
};

/// Largest difference of two cycles' series [m, rad].
inline double seriesGap(const WalkCycle& a, const WalkCycle& b) {
  return std::max((a.series.alpha - b.series.alpha).cwiseAbs().maxCoeff(),
                  (a.series.beta - b.series.beta).cwiseAbs().maxCoeff());
}

}  // namespace amble
