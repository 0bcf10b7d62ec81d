/// Foot plants: when which foot is on the ground, found in the motion itself (Shanbhag's thesis,
/// §3.1).
///
/// Two stages as there: ankle and toe joint are planted while they are low and slow; the foot is
/// while either is. Beyond the thesis: the floor is a fitted plane, since captures are tilted by a
/// degree; thresholds are in leg lengths and follow the foot's own swing, so that one set of
/// defaults serves every subject; drop-outs are closed and flickers removed by time, not by frames;
/// and the two ends of each plant are moved to where O'Connor et al. (Gait & Posture 25, 2007) read
/// strike and lift-off from the vertical velocity of the foot: its trough (middle of the foot) and
/// its peak (ankle). One level floor is assumed: feet on stairs and slopes are not found.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "animation/clip.h"
#include "animation/joint_roles.h"

namespace amble {

/// A foot on the ground from strike to lift-off.
struct FootPlant {
  int first = 0;  ///< first and last frame on the ground, both included
  int last = 0;
  double strike = 0.0;    ///< the same between frames [frames]; first - 1 < strike <= first
  double lift_off = 0.0;  ///< last < lift_off <= last + 1
};

/// By Side. A plant that touches the clip's first or last frame began before it or went on after
/// it.
struct FootPlants {
  std::array<std::vector<FootPlant>, 2> plants;  ///< in order of time
  int frames = 0;

  bool planted(Side side, int frame) const;
  /// One value a frame.
  std::vector<bool> planted(Side side) const;
};

/// Plants from what is planted at each frame; strike and lift-off fall half a frame outside.
FootPlants plantsOf(const std::array<std::vector<bool>, 2>& planted);

/// Defaults found by trial on CMU and ACCAD walks and runs, but for the two durations (thesis: a
/// window of some frames).
struct PlantOptions {
  double cutoff = 12.0;  ///< low-pass of the joints' places [Hz, > 0]
  double height = 0.06;  ///< a planted joint is lower over its standing height [leg lengths, > 0]
  double speed_of_swing =
      0.18;  ///< and slower than this share of the foot's 95th percentile of speed [> 0]
  double min_speed = 0.35;  ///< but that limit stays within these [leg lengths a second]
  double max_speed = 0.9;
  double shortest_gap = 0.08;    ///< shorter gaps are closed [s]
  double shortest_plant = 0.06;  ///< then shorter plants are dropped [s]
  double reach =
      0.15;  ///< how far strike and lift-off are looked for from the thresholds' crossing [s]
  double clear_velocity =
      0.1;  ///< a trough or peak below it says nothing: the crossing stands [leg lengths a second]
};

/// Ankle and toe (where the rig has none: the tip of the foot joint, or the ankle) of both feet
/// against the fitted floor. Against the eight trials with force plates, of four children:
/// precision 0.990, recall 0.975, specificity 0.987, accuracy 0.980; strike 12 ms and lift-off 11
/// ms off on average.
FootPlants detectPlants(const Clip& clip, const JointRoles& roles,
                        const PlantOptions& options = {});

/// Where ankle and toe point of both feet are, by Side: a row a frame, columns ankle x y z, toe x y
/// z [m, World]. The toe point is what detectPlants takes for the toe.
std::array<Eigen::MatrixXd, 2> footPaths(const Clip& clip, const JointRoles& roles);

}  // namespace amble
