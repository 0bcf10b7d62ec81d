/// A captured cycle of a walk or a run, sampled: what is averaged, or fitted over speeds.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "animation/preparation/cycle_finder.h"
#include "animation/preparation/gait_track.h"

namespace amble {

struct CycleSamples {
  double speed = 0.0;   ///< along the line from end to end [m/s, > 0]
  double period = 0.0;  ///< [s, > 0]
  /// Rows: the channels of WalkCycle::series; columns: even phases, the first is 0, whichever foot
  /// led. Heights are over the footprints. Its ends meet: what they differ by is spread over the
  /// cycle.
  Eigen::MatrixXd channels;
  /// Share of the cycle with both feet down around phase 0 and 0.5; negative: with neither.
  std::array<double, 2> support = {0, 0};
  double step_width = 0.0;  ///< [m], as WalkCycle has these
  /// [m], but for what feet slide
  std::array<double, 2> foot_forward = {0, 0};
  std::array<double, 2> toe_out = {0, 0};  ///< [rad]
};

/// Of a straight stretch. @param reference  rotations against which the channels' vectors are, the
/// root's against the heading of the line first @param count  samples, even
CycleSamples sampleCycle(const GaitTrack& track, const Stretch& stretch, Gait gait,
                         const std::vector<Eigen::Quaterniond>& reference, int count);

}  // namespace amble
