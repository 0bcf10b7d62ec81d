/// The floor of a capture, fitted to its standing feet: captures are tilted by a degree or so
/// (QUALITY.md).
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"
#include "animation/clips/foot_paths.h"

namespace amble {

/// The plane on which the ankles of standing feet lie, in World.
struct FloorFit {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, up
  double height = 0.0;      ///< of the ankles' plane above the origin, along the normal [m]
  double residual = 0.0;    ///< rms distance of the ankles from it [m]
  int samples = 0;          ///< standing feet that were found: frames, both feet counted
  int plants = 0;           ///< times that a foot stood
  double ankle_mean = 0.0;  ///< mean height of the standing ankles, whatever the tilt [m]

  double tilt() const;  ///< from level [rad, 0 to pi/2]
};

/// Why a clip should not be turned by a fit: a tilt of more than 3 degrees is a ramp's rather than
/// a capture's (QUALITY.md: 1.2 at most), and one or two places where a foot stood span no floor.
/// "" to trust it.
std::string doubtOf(const FloorFit& floor);
/// The level plane through the same ankles.
FloorFit levelPlane(const FloorFit& floor);

/// What is made of tilt in a direction in which feet do not spread: a straight walk says little of
/// the tilt across it, where a foot that stands higher than the other looks like a floor's slope.
enum class TiltAcross {
  kHeld,  ///< it is held towards level, the less they spread the more: each fit leaves some
  /// Up to an rms spread of 0.2 m there is none, beyond it is all taken: what was levelled by such
  /// a fit is level by the next.
  kIgnored
};

/// Least squares over frames in which a foot stands (ankle and toe slower than 0.3 leg lengths a
/// second). No samples: the level plane of the lowest ankle.
FloorFit fitFloor(const Clip& clip, const JointRoles& roles, TiltAcross across = TiltAcross::kHeld);
/// The same of paths that are there already: leg lengths [m], frame time [s].
FloorFit fitFloor(const FootPaths& paths, const std::array<double, 2>& legs, double frame_time,
                  TiltAcross across = TiltAcross::kHeld);

/// The clip turned so that the floor is level, and lifted so that standing ankles are
/// `ankle_height` above z = 0 [m].
Clip levelClip(const Clip& clip, const FloorFit& floor, double ankle_height);

}  // namespace amble
