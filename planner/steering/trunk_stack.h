/// Balls of the trunk and the head, one over the other, that go up and down together.
///
/// Walking, a trunk hardly bends: seen from the abdomen pelvis and chest stay where they are, and
/// so do chest, neck and head seen from the neck's lower end, but for some centimetres that their
/// balls are taken as smaller by. What is between two balls however high the hips are is touched by
/// one of them.
#pragma once

#include <vector>

#include "planner/steering/straight_walk.h"

namespace amble {

struct StackedBall {
  double height = 0.0;  ///< over the ground, midway between the poses' [m]
  /// Of what is in the body there, straight over or under what the balls are seen from [m, > 0].
  double radius = 0.0;
  int part = -1;  ///< of the body
};
struct TrunkStack {
  std::vector<StackedBall> balls;  ///< from below; none: there is no stack
  double sway = 0.0;  ///< how much lower and higher than so the walk's poses have them [m, >= 0]
};

/// About the middle of the abdomen, and about the neck's lower end, of a body on a walk; fewer
/// balls, or no stack, where the body lacks parts. @param margin  that other poses may have them
/// farther from there [m, >= 0]
std::vector<TrunkStack> trunkStacks(const StraightWalk& walk, const Skeleton& skeleton,
                                    const JointRoles& roles, const Body& body, double margin);

}  // namespace amble
