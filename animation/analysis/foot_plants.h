/// Foot plants: when which foot is on the ground, found in the motion itself (Shanbhag's thesis,
/// §3.1).
///
/// Two stages as there: ankle and toe joint are planted while they are low and slow; the foot is
/// while either is. Beyond the thesis: the floor is a fitted plane, since captures are tilted by a
/// degree; thresholds are in leg lengths and follow the foot's own swing, so that one set of
/// defaults serves every subject; drop-outs are closed and flickers removed by time, not by frames;
/// and the two ends of each plant are moved to where O'Connor et al. (Gait & Posture 25, 2007) read
/// strike and lift-off from the vertical velocity of the middle of the foot, low-passed: its trough
/// and its peak, within the frames in which ankle or toe is low: those who run draw their feet up
/// behind them and swing them faster yet. One level floor is assumed: feet on stairs and slopes are
/// not found.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"
#include "animation/clips/foot_paths.h"

namespace amble {

/// A foot on the ground from strike to lift-off.
struct FootPlant {
  int first = 0;  ///< first and last frame on the ground, both included [>= 0]
  int last = 0;   ///< [>= first]
  /// When the foot comes down, between frames [frames]: first - 1 < strike, and at most strike_lead
  /// after `first`.
  double strike = 0.0;
  /// When it leaves, between frames [frames]: last < lift_off, and at most lift_off_contact after
  /// last + 1.
  double lift_off = 0.0;
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
/// window of some frames). The cut-off and the two leads are from the eight trials with force
/// plates, each out of a range in which the scores hardly change (8 to 10 Hz, 8 to 10 ms, 14 to 20
/// ms; a subject left out, the frames that plates measured alone ask for 17.5 ms, by which fewer
/// frames are taken for planted that are not). What a last frame needs is not: a plate's frame is
/// planted when its mean force is over 20 N, which a foot that is down for a moment of it does not
/// reach. Plants that took such frames in ended late.
struct PlantOptions {
  double cutoff = 8.5;   ///< low-pass of the joints' places [Hz, > 0]
  double height = 0.06;  ///< a planted joint is lower over its standing height [leg lengths, > 0]
  /// And slower than this share of the foot's 95th percentile of speed [> 0, < 1],
  double speed_of_swing = 0.18;
  /// but that limit stays within these [leg lengths a second, 0 < min <= max].
  double min_speed = 0.35, max_speed = 0.9;
  double shortest_gap = 0.08;    ///< shorter gaps are closed [s, >= 0]
  double shortest_plant = 0.06;  ///< then shorter plants are dropped [s, >= 0]
  /// How far strike and lift-off are looked for from the thresholds' crossing [s, >= 0].
  double reach = 0.15;
  /// A trough or peak below it says nothing: the crossing stands [leg lengths a second, >= 0].
  double clear_velocity = 0.1;
  /// Frames are planted from so long before the strike: a frame of a force plate is the mean over
  /// the time until the next, and has force enough in it when the foot comes down early in that
  /// time [s, >= 0].
  double strike_lead = 0.009;
  double lift_off_lead = 0.018;  ///< the foot is off so long before its middle rises fastest [s]
  double lift_off_contact = 0.0015;  ///< its last frame has it down for longer than this [s, >= 0]
};

/// Ankle and toe (footPaths) of both feet against the fitted floor. Slow clips are interpolated to
/// kPlantRate first. Costs a forward kinematics a frame, and then a fraction of a microsecond
/// (benchmarks/plants_benchmark.cpp). Against the eight trials with force plates, of four children:
/// see tests/animation/foot_plants_test.cpp.
FootPlants detectPlants(const Clip& clip, const JointRoles& roles,
                        const PlantOptions& options = {});
/// The same of paths that are there already: leg lengths [m, > 0], frame time [s, > 0].
FootPlants detectPlants(const FootPaths& paths, const std::array<double, 2>& legs,
                        double frame_time, const PlantOptions& options = {});

/// Below this rate strikes between frames are read off too coarse a curve [Hz].
inline constexpr double kPlantRate = 90.0;

}  // namespace amble
