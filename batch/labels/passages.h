/// What a walk passed: doors and other narrow places, steps up and down, turns.
#pragma once

#include <string>
#include <vector>

#include "scenarios/run_scenario.h"

namespace amble {

/// A stretch of the way with something close on both sides.
struct PassedGap {
  bool door = false;        ///< as high as a head on both sides, and short: a door
  std::string left, right;  ///< objects of the scene beside its narrowest place
  double width = 0.0;       ///< there, from one to the other, to a few centimetres [m]
  double time = 0.0;        ///< there [s]
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< on the ground [m, World]
};

struct PassedThings {
  std::vector<PassedGap> gaps;  ///< in order of time
  std::vector<int> flights;     ///< steps on end, up positive, down negative; in order
  double turned_left = 0.0, turned_right = 0.0;  ///< in all [rad, >= 0]
  int turns_on_spot = 0;
};

/// Sides are looked at so far, and what is narrower in all is a gap [m].
inline constexpr double kSideReach = 0.8, kWidestGap = 1.3;
/// A gap that is longer is a corridor, and no door [m].
inline constexpr double kLongestDoor = 1.2;

/// @pre the run is solved
PassedThings findPassed(const RunResult& run);

}  // namespace amble
