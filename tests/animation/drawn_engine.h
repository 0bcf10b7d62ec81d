/// An engine drawn from formulas: its motion vectors lie on lines over speed, so that what it walks
/// at any speed is known.
#pragma once

#include <cmath>

#include "animation/preparation/gait_space_fit.h"
#include "base/rotation.h"
#include "tests/animation/rig.h"

namespace amble {

/// One thigh swings by as much as the stride is long, the other the other way; the root bobs.
struct DrawnEngine {
  static constexpr double kFactor = 0.7, kPower = 0.5;  // of the frequency law
  static constexpr double kHeight = 0.9;                // of the root [m]

  Rig rig;
  double leg = rig.roles.meanLeg(rig.skeleton);

  double frequency(double speed) const { return kFactor * std::pow(speed / leg, kPower); }
  static double swing(double speed, double phase) {
    return (0.1 + 0.2 * speed) * std::cos(2.0 * kPi * phase);
  }
  static double support(double speed) { return 0.2 - 0.08 * speed; }

  EngineCycle cycle(int clip, double speed) const {
    const int joints = rig.skeleton.size();
    EngineCycle cycle;
    cycle.clip = clip;
    cycle.speed = speed;
    cycle.period = 1.0 / frequency(speed);
    cycle.channels = Eigen::MatrixXd::Zero(3 + 3 * joints, kEnginePhases);
    for (int i = 0; i < kEnginePhases; ++i) {
      const double phase = static_cast<double>(i) / kEnginePhases;
      cycle.channels(2, i) = kHeight - 0.01 * speed * std::cos(4.0 * kPi * phase);
      for (const Side side : {kLeft, kRight}) {
        cycle.channels(3 + 3 * rig.roles.legs[side].up_leg, i) =
            swing(speed, phase + (side == kLeft ? 0.5 : 0.0));
      }
    }
    cycle.support = {support(speed), support(speed)};
    cycle.step_width = 0.1;
    cycle.toe_out = {0.1, -0.1};
    return cycle;
  }

  GaitSpace space(const std::vector<double>& speeds) const {
    std::vector<EngineCycle> cycles;
    for (const double speed : speeds)
      cycles.push_back(cycle(static_cast<int>(cycles.size()), speed));
    GaitSpace space = fitGaitSpace(cycles, leg, 0.8);
    for (const double speed : speeds) {
      space.clips.push_back({{"drawn.bvh", {0, 100}, false, "none", "none"},
                             speed,
                             frequency(speed),
                             1,
                             {0.01, 4.0, 90.0 + speed, 2.0},
                             std::nullopt});
    }
    return space;
  }

  /// Walks of these speeds, in rising order; and runs.
  EngineData data(const std::vector<double>& walks, const std::vector<double>& runs = {}) const {
    EngineData data;
    data.skeleton_file = "drawn.bvh";
    data.skeleton = rig.skeleton;
    data.roles = rig.roles;
    data.stature = statureOf(rig.skeleton, rig.roles);
    data.mean_posture = rig.reference();
    data.stand.rotations = rig.reference();
    data.stand.root_height = kHeight + 0.01;
    data.stand.step_width = 0.2;
    data.stand_source = {"stand.bvh", {3, 33}, false, "none", "none"};
    if (!walks.empty()) data.walk = space(walks);
    if (!runs.empty()) data.run = space(runs);
    return data;
  }
};

}  // namespace amble
