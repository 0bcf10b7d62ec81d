/// A straight walk of the body, to measure it by.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "animation/synthesis/walk_synthesizer.h"
#include "environments/body/body.h"

namespace amble {

struct StraightWalk {
  RootPath path;
  AnimationBuffer buffer;
  /// On the spot, where it begins, by a quarter and half a circle each way.
  std::vector<AnimationBuffer> turns = {};
};

/// Long enough for strides at full speed [m].
inline constexpr double kMeasuredWalk = 3.0;

/// From standing to standing over `length` [m], on level ground without end: what a body is
/// measured by is the same in every scene. Without frames where there is no such walk
/// (shortestWalk).
StraightWalk straightWalk(const WalkSynthesizer& synthesizer, double length = kMeasuredWalk);

/// How far the body reaches to the left of the path, right negative, over the walk, of what of it
/// is at some heights over the ground; empty without frames, or where nothing of it is [m].
Eigen::AlignedBox1d walkingBreadth(const StraightWalk& walk, const Skeleton& skeleton,
                                   const Body& body, const Eigen::AlignedBox1d& heights);
/// The same of all of it.
Eigen::AlignedBox1d walkingBreadth(const StraightWalk& walk, const Skeleton& skeleton,
                                   const Body& body);

/// The least clear width of a gap that the walk passes straight through, stepping into it as suits
/// best: so arms need not swing wide in a short one. Empty walks pass anything [m].
/// @param depth  of the gap, along the path [m, >= 0]
double passableBreadth(const StraightWalk& walk, const Skeleton& skeleton, const Body& body,
                       double depth);

/// The axis of a part of the body over a walk.
struct PartWay {
  Eigen::AlignedBox1d middle;  ///< of its middle over the ground [m]
  Eigen::AlignedBox1d upper;   ///< of its upper end [m]
  double aside = 0.0;          ///< of any of its points from the path's, in plan, at most [m]
};
/// Of each part.
std::vector<PartWay> waysOfParts(const StraightWalk& walk, const Skeleton& skeleton,
                                 const Body& body);

}  // namespace amble
