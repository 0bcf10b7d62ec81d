/// What a walk measures: QUALITY.md's table, of any clip and its foot plants.
///
/// The clip is level (floor_fit.h) and World is z up; the ground is given or z = 0. Each measure is
/// as QUALITY.md defines it; where that leaves a choice it is said at the field. Checked against
/// its figures for real clips: toe skate 51, 106 and 32 mm/s on lab, CMU and ACCAD walks (there 54,
/// 106, 32).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "animation/analysis/foot_plants.h"
#include "animation/body/foot_shape.h"
#include "animation/body/step_measure.h"
#include "animation/ground/ground.h"

namespace amble {

/// One stay of a foot on the ground. Slides are of the toe joint (the tip of the foot where the rig
/// has none), over the plant without 15 % of its length at both ends: of the median length of those
/// that are seen whole where the clip cuts it, and it is shorter; 0 where nothing is left of it.
struct PlantMeasures {
  Side side = kLeft;
  FootPlant plant;
  /// Footprint: the middle between ankle and toe, medians, on the ground [m, World].
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  SoleEnds ends;            ///< heel and toe as they stand, medians [m, World]
  double flat_pitch = 0.0;  ///< of the way from ankle to toe then, down positive [rad]
  double drift = 0.0;   ///< largest horizontal distance of the toe from its median place [m, >= 0]
  double travel = 0.0;  ///< horizontal way of the toe, at the clip's own rate [m, >= 0]
  double time = 0.0;    ///< over which that was [s, >= 0]
  double toe_height = 0.0;    ///< median over the ground [m]
  double ankle_height = 0.0;  ///< the same of the ankle, first half of the plant: flat then [m]
};

struct GaitMeasures {
  std::vector<PlantMeasures> plants;  ///< in order of strike
  /// In order. Captured feet have no sole that is known to the millimetre: `lift` is that of the
  /// toe and of the point of the heel below the ankle, each over where it stood.
  std::vector<StepMeasure> steps;

  double toe_skate = 0.0;      ///< way of planted toes over planted time [m/s, >= 0]
  double drift = 0.0;          ///< median over plants [m, >= 0]
  double largest_drift = 0.0;  ///< [m, >= 0]
  /// Largest depth of toe or ankle below its standing height over the ground [m, >= 0].
  double penetration = 0.0;
  /// Standing: medians over the foot's plants, by Side [m].
  std::array<double, 2> toe_height = {0, 0}, ankle_height = {0, 0};
  double root_acceleration = 0.0;   ///< motion_measures.h [m/s², >= 0]
  double joint_jerk = 0.0;          ///< motion_measures.h [m/s³, >= 0]
  double pops = 0.0;                ///< motion_measures.h [1, >= 0]
  double knee_backwards = 0.0;      ///< share of frames [0, 1]
  double bone_length_change = 0.0;  ///< [m, >= 0]

  /// Of the walking span: whole strides between the first and the last strike seen of one foot;
  /// else from first to last strike of either; else the clip. So standing before and after does not
  /// count.
  double begin = 0.0, end = 0.0;  ///< the span [frames, 0 <= begin <= end]
  double double_support = 0.0;    ///< share of the span with both feet planted [0, 1]
  double flight = 0.0;            ///< share with neither [0, 1]
  double speed = 0.0;             ///< of the pelvis, smoothed over 0.5 s, along its way [m/s, >= 0]
  double turn_rate = 0.0;         ///< of the pelvis' heading, mean, left positive [rad/s]
  double peak_turn_rate = 0.0;    ///< over any 0.5 s, whole clip [rad/s, >= 0]
  double cadence = 0.0;           ///< steps a minute [>= 0]
  /// Means of all steps but one that closes a walk which ends standing: it has no length.
  double step_length = 0.0;          ///< of the steps' stride [m]
  double step_time = 0.0;            ///< [s, >= 0]
  double step_time_variation = 0.0;  ///< standard deviation of step times over their mean [1, >= 0]
  double step_width = 0.0;           ///< mean [m]
  double stride_length = 0.0;        ///< mean of two steps, of those seen [m, >= 0]
  double lift = 0.0;                 ///< mean of those seen [m, >= 0]
  double toe_clearance = 0.0;        ///< mean of those seen [m, >= 0]
  /// |left - right| over the mean of both, of mean step lengths and of mean step times [1, >= 0];
  /// nothing where there is no step of one foot, or where steps on the spot have no length.
  std::optional<double> length_asymmetry, time_asymmetry;

  double leg_length = 0.0;  ///< thigh + shank, mean of both [m, > 0]
  /// V = v / leg (Glardon): subjects of all sizes compare [1/s, >= 0].
  double normalised_speed = 0.0;
  double cycle_frequency = 0.0;  ///< two steps are a cycle [Hz, >= 0]
};

/// @pre plants.frames == clip.frames(). Where `ground` has no height, z = 0 holds.
GaitMeasures measureGait(const Clip& clip, const JointRoles& roles, const FootPlants& plants,
                         const Ground* ground = nullptr);

/// GaitMeasures::speed of anything that is at way[frame] [m], between two moments [frames]: what is
/// compared with a walk's must be smoothed as that is, for where a walk gains speed its smoothed
/// way is a longer one [m/s, >= 0].
double smoothedSpeed(const std::vector<Eigen::Vector3d>& way, double frame_time, double begin,
                     double end);

/// Heel and toe of a captured foot: the heel is the point so far [m] below the ankle of a flat foot
/// (kAnkleHeightOfLeg), whose way from ankle to toe goes down by `flat_pitch` [rad], and turns with
/// the foot.
SoleEnds capturedSole(const Eigen::Vector3d& ankle, const Eigen::Vector3d& toe, double heel,
                      double flat_pitch);

/// The fastest that a foot turns, over the time of a frame [rad/s, >= 0].
double fastestFootTurn(const Clip& clip, const JointRoles& roles);

}  // namespace amble
