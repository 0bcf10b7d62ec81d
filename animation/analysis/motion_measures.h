/// How smooth a motion is, and how well it keeps to its path: the measures of QUALITY.md that know
/// no feet.
///
/// Differences are taken at 30 Hz, a sample aside at each end. A faster clip is low-passed at its
/// own rate before it is sampled down (low_pass.h: Butterworth, no delay), a clip of 30 Hz is taken
/// as it is: so QUALITY.md's figures come out, which does not name its filter. Medians of root
/// acceleration are 3.9, 6.8 and 10.1 m/s² on lab, CMU and ACCAD walks (there 3.9, 6.8, 9.5), of
/// joint jerk 90, 127 and 117 m/s³ (99, 115, 119). The noise of a capture at 30 Hz is in its
/// figures, that of a faster one mostly not.
#pragma once

#include <span>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

inline constexpr double kMeasureRate = 30.0;  ///< at which differences are taken [Hz]
/// Low-pass of clips faster than that [Hz]: of the root, of the joints.
inline constexpr double kRootMeasureCutoff = 8.0;
inline constexpr double kJointMeasureCutoff = 10.0;

/// Largest second difference of the root at 30 Hz [m/s², >= 0]; 0 for clips shorter than that
/// takes.
double rootAcceleration(const Clip& clip);

/// Mean over joints and frames of the size of the third difference of joints' places at 30 Hz
/// [m/s³, >= 0].
double jointJerk(const Clip& clip);

/// Largest angular acceleration of a joint over that joint's own 99th percentile, the largest over
/// joints, at the clip's own rate [1, >= 0]. A joint that hardly turns (99th percentile below 1
/// rad/s²) is measured against that.
double pops(const Clip& clip);

/// Share of frames in which a knee is bent backwards by more than 8 degrees, against the pelvis'
/// left-right axis [0, 1].
double kneeBackwardsShare(const Clip& clip, const JointRoles& roles);

/// Largest change of a bone's length over the clip: of moving joints only [m, >= 0].
double boneLengthChange(const Clip& clip);

/// A moving average over `window` seconds, centred; at the ends over what is there on both sides
/// alike, so that they stay.
std::vector<Eigen::Vector3d> smoothed(const std::vector<Eigen::Vector3d>& points, double frame_time,
                                      double window);

/// Where the plan wants the root at a frame.
struct PlannedPoint {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
  double heading = 0.0;                                ///< [rad]
};

struct PathError {
  double mean = 0.0;         ///< of the root, smoothed over 0.25 s, from the planned path [m, >= 0]
  double largest = 0.0;      ///< [m, >= 0]
  double end = 0.0;          ///< at the last frame from the last planned point [m, >= 0]
  double end_heading = 0.0;  ///< of the pelvis then against the planned one [rad, >= 0]
};

/// Of the root joint, smoothed. Its distance is to the nearest point of the path within half a
/// second, so that a root which is a little early or late is not blamed for it; a path that crosses
/// itself is not mistaken.
/// @pre planned.size() == clip.frames() > 0
PathError pathError(const Clip& clip, const JointRoles& roles,
                    std::span<const PlannedPoint> planned);

}  // namespace amble
