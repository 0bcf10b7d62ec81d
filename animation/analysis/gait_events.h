/// The four events of a foot in each cycle: lift, lift-off, strike, landing (Johansen, Walk and Run
/// Cycle Analysis 2, 2008).
///
/// Johansen follows heel and toe from the time at which the foot stands most firmly to where they
/// have risen a tenth of their swing, and takes the point of greatest curvature on the way; a point
/// that moves along the ground earlier has left it then. A foot lifts with the first of its two
/// points and has landed with the last. Two departures: lift-off and strike are those of the foot's
/// plants (foot_plants.h), which force plates confirm; and the "50 % of slope" is half the speed at
/// which the foot travels over the cycle, since our captures move over the ground and his walk in
/// place. So every swing between two plants has one set in order, whether the foot drags, sinks
/// below the floor or stands flat.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "animation/analysis/foot_plants.h"
#include "animation/clips/foot_paths.h"

namespace amble {

/// Heel and toe of a foot over its standing, a value a frame. The heel is the point below the ankle
/// on the sole, moving with the foot (Johansen's); low-passed as for plants.
struct FootCurves {
  Eigen::VectorXd heel_height;  ///< [m], 0 where it stands
  Eigen::VectorXd toe_height;   ///< [m], 0 where it stands
  Eigen::VectorXd heel_speed;   ///< along the floor, of the ankle [m/s]
  Eigen::VectorXd toe_speed;    ///< [m/s]
};

/// @pre plants.frames == rows of the paths > 0; leg lengths [m], frame time [s]
std::array<FootCurves, 2> footCurves(const FootPaths& paths, const std::array<double, 2>& legs,
                                     double frame_time, const FootPlants& plants);

/// When heel or toe leaves the ground and comes down again [frames].
struct PointEvents {
  double lift = 0.0;
  double landing = 0.0;
};

/// A swing of a foot: lift <= lift_off < strike <= landing [frames]. The swing that is under way at
/// the clip's start has only the last two, that at its end only the first two; NaN stands for the
/// others.
struct SwingEvents {
  double lift = 0.0;      ///< heel or toe begins to rise
  double lift_off = 0.0;  ///< the whole foot has left the ground
  double strike = 0.0;    ///< it touches the ground again
  double landing = 0.0;   ///< heel and toe stand
  PointEvents heel, toe;  ///< each within: lift <= its lift <= lift_off, strike <= its landing
};

struct GaitEvents {
  std::array<std::vector<SwingEvents>, 2> swings;  ///< by Side, in order of time
};

GaitEvents findGaitEvents(const std::array<FootCurves, 2>& curves, double frame_time,
                          const FootPlants& plants, const FootPaths& paths);
/// The same from the clip itself.
GaitEvents findGaitEvents(const Clip& clip, const JointRoles& roles, const FootPlants& plants);

}  // namespace amble
