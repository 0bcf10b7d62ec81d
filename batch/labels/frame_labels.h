/// What is true of a walk frame by frame, beside its pose.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "animation/library/motion_library.h"
#include "scenarios/run_scenario.h"

namespace amble {

/// What the walker does.
enum class Activity : int32_t { kStand = 0, kWalk = 1, kTurn = 2, kClimb = 3, kDescend = 4 };
/// As files have them, by Activity.
const std::vector<std::string>& activityNames();

/// A print higher or lower than the other foot's by so much is a step of stairs, or a kerb [m].
inline constexpr double kStairStep = 0.06;
/// How far clearances are looked for [m].
inline constexpr double kLabelClearance = 0.25;

struct GaitEvent {
  Side side = kLeft;
  bool strike = true;  ///< else lift-off
  int frame = 0;
};

/// Rows are frames, columns body parts or motions, one row after another.
struct FrameLabels {
  int frames = 0;
  std::vector<std::string> parts;
  /// To the nearest thing, the ground that soles stand on apart; kLabelClearance where nothing is
  /// nearer [m].
  std::vector<float> clearance;
  std::vector<int32_t> nearest;      ///< of `objects`, -1 where nothing is within kLabelClearance
  std::vector<uint8_t> contact;      ///< whether the part touches ground or thing: soles that stand
  std::vector<std::string> objects;  ///< of the scene
  std::vector<int32_t> activity;     ///< by frame
  std::vector<GaitEvent> events;     ///< in order of time, left first
  /// Captured motions of the library, and how much of each is in a frame: all sum to 1.
  std::vector<const Motion*> motions;
  std::vector<float> shares;
};

/// @param near  whether clearances and contacts are looked for, which costs most. @pre the run is
/// solved, and outlives the labels
FrameLabels labelFrames(const RunResult& run, bool near);

}  // namespace amble
