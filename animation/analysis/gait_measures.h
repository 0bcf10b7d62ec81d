/// What a walk measures: QUALITY.md's table, of any clip and its foot plants.
///
/// The clip is level (floor_fit.h) and World is z up; the ground is given or z = 0. Each measure is
/// as QUALITY.md defines it; where that leaves a choice it is said at the field. Checked against
/// its figures for real clips: toe skate 51, 106 and 32 mm/s on lab, CMU and ACCAD walks (there 54,
/// 106, 32).
#pragma once

#include <array>
#include <vector>

#include "animation/analysis/foot_plants.h"
#include "animation/analysis/motion_measures.h"
#include "animation/ground/ground.h"

namespace amble {

/// One stay of a foot on the ground. Slides are of the toe joint (the tip of the foot where the rig
/// has none), over the plant without 15 % of its length at both ends.
struct PlantMeasures {
  Side side = kLeft;
  FootPlant plant;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< footprint: median of the middle between ankle
                                                 ///< and toe, on the ground [m]
  double drift = 0.0;       ///< largest horizontal distance of the toe from its median place [m]
  double travel = 0.0;      ///< horizontal way of the toe, at the clip's own rate [m]
  double time = 0.0;        ///< over which that was [s]
  double toe_height = 0.0;  ///< median over the ground [m]
  double ankle_height =
      0.0;  ///< median over the ground, first half of the plant, where the foot is flat [m]
};

/// From a strike of one foot to the next strike of the other.
struct StepMeasures {
  Side side = kLeft;   ///< of the foot that lands
  double begin = 0.0;  ///< strikes, in frames
  double end = 0.0;
  double duration = 0.0;  ///< [s]
  double length =
      0.0;  ///< between the two footprints along the pelvis' way (the papers' "stride") [m]
  double width = 0.0;  ///< across it, positive where feet do not cross [m]
  double lift = 0.0;  ///< of the landing foot's ankle in its swing, over where it stood before [m];
                      ///< 0 where it was not seen to
  double rise = 0.0;  ///< of the footprint over the other one [m]
  double stride = 0.0;  ///< between this footprint and the same foot's before [m]; 0 where not seen
  double speed = 0.0;   ///< of the pelvis, smoothed as for the clip, over the step [m/s]
  double turn_rate = 0.0;       ///< of the pelvis' heading, mean, left positive [rad/s]
  double toe_clearance = 0.0;   ///< least height of the swinging toe over its standing, in the
                                ///< middle of its swing [m]; 0 where not seen
  double double_support = 0.0;  ///< share of the step with both feet planted [0, 1]
};

struct GaitMeasures {
  std::vector<PlantMeasures> plants;  ///< in order of strike
  std::vector<StepMeasures> steps;    ///< in order

  double toe_skate = 0.0;      ///< way of planted toes over planted time [m/s]
  double drift = 0.0;          ///< median over plants [m]
  double largest_drift = 0.0;  ///< [m]
  double penetration =
      0.0;  ///< largest depth of toe or ankle below its standing height over the ground [m, >= 0]
  std::array<double, 2> toe_height = {0,
                                      0};  ///< standing: median over the foot's plants, by Side [m]
  std::array<double, 2> ankle_height = {0, 0};  ///< the same of the ankle
  double root_acceleration = 0.0;               ///< motion_measures.h [m/s²]
  double joint_jerk = 0.0;                      ///< motion_measures.h [m/s³]
  double pops = 0.0;                            ///< motion_measures.h [1]
  double knee_backwards = 0.0;                  ///< share of frames [0, 1]
  double bone_length_change = 0.0;              ///< [m]

  /// Of the walking span: whole strides between the first and the last strike seen of one foot;
  /// else from first to last strike of either; else the clip. So standing before and after does not
  /// count.
  double begin = 0.0, end = 0.0;     ///< the span [frames]
  double double_support = 0.0;       ///< share of the span with both feet planted
  double flight = 0.0;               ///< share with neither
  double speed = 0.0;                ///< of the pelvis, smoothed over 0.5 s, along its way [m/s]
  double turn_rate = 0.0;            ///< of the pelvis' heading, mean, left positive [rad/s]
  double peak_turn_rate = 0.0;       ///< over any 0.5 s, whole clip [rad/s, >= 0]
  double cadence = 0.0;              ///< steps a minute
  double step_length = 0.0;          ///< mean [m]
  double step_time = 0.0;            ///< mean [s]
  double step_time_variation = 0.0;  ///< standard deviation of step times over their mean [1]
  double step_width = 0.0;           ///< mean [m]
  double stride_length = 0.0;        ///< mean over steps that show it [m]
  double lift = 0.0;                 ///< mean [m]
  double toe_clearance = 0.0;        ///< mean over steps that show it [m]
  double length_asymmetry =
      0.0;                      ///< |left - right| over the mean of both, of mean step lengths [1]
  double time_asymmetry = 0.0;  ///< the same of step times [1]

  double leg_length = 0.0;  ///< thigh + shank, mean of both [m]
  double normalised_speed =
      0.0;  ///< V = v / leg (Glardon), so that subjects of all sizes compare [1/s]
  double cycle_frequency = 0.0;  ///< two steps are a cycle [Hz]
};

/// @pre plants.frames == clip.frames(). Where `ground` has no height, z = 0 holds.
GaitMeasures measureGait(const Clip& clip, const JointRoles& roles, const FootPlants& plants,
                         const Ground* ground = nullptr);

}  // namespace amble
