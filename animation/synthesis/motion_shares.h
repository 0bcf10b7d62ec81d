/// Of which captured motions each frame of a walk is made, for who wants to know.
#pragma once

#include <string>
#include <vector>

#include "animation/synthesis/captured_turns.h"
#include "animation/synthesis/gait_blend.h"
#include "animation/synthesis/walk_synthesizer.h"

namespace amble {

class MotionShares {
 public:
  /// @pre the library is the synthesizer's, and outlives this
  MotionShares(const MotionLibrary& library, const WalkSynthesizer& synthesizer);

  /// The posture `stand`, then the walks, of which some are averaged into one, then captured
  /// starts and stops, as many as the walk's speed allows, then turns on the spot.
  const std::vector<std::vector<const Motion*>>& motions() const { return motions_; }
  /// How much of each is in a frame [0 to 1]; they sum to 1. Actions, which are held over all of
  /// them, are left out. A start that has not begun is standing, as is a stop that is over.
  std::vector<double> at(const FrameState& state) const;

 private:
  void mix(int stop, const TransitionMoment& moment, std::vector<double>& shares) const;

  const MotionLibrary& library_;
  GaitBlend blend_;
  CapturedTurns turns_;
  std::vector<std::vector<const Motion*>> motions_;
  size_t transitions_ = 0;  // index of the first
};

}  // namespace amble
