/// The soles that a library's character stands on: how its feet drop at rest (footDrops), which is
/// how FootShape reads them.
///
/// They are the mean of what the straight walks of its own rig stand on, each walk with its mirror
/// image if the library has it, and where there are turns between that and what turns stand on: of
/// walks rather than of the posture `stand`, for it is walks that are compared with their captures,
/// and markers tilt feet that are loaded in passing otherwise than feet of somebody who poses. Each
/// motion is prepared on the soles that it was captured on itself, somebody else's too: on the
/// library's it stands flat as well, and its root is as far over its ankles. So a library is the
/// same in whatever order motions came behind the first, which gives its skeleton and, where it is
/// no `stand`, is what one is borrowed for: to rounding, of 1e-11 m and rad, and of a micrometre
/// where it is written and read between them. Only captures in which no foot stands are taken on
/// the soles that the library has just then.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "animation/body/clip.h"
#include "animation/library/motion_library.h"

namespace amble {

/// Whether a skeleton is the library's own, however its feet drop at rest.
bool isOfRig(const MotionLibrary& library, const Skeleton& skeleton);

/// The whole clip so much higher [m].
void raise(Clip& clip, double rise);

/// A clip of the library's rig on soles of these drops [rad]: joints stay where they are in World,
/// but roots are as much higher as ankles are over the sole.
Clip onSoles(const MotionLibrary& library, const Clip& clip, const std::array<double, 2>& drops);

/// How much higher ankles are over the sole of one skeleton than of another, which is the same rig
/// but for how its feet drop [m].
double riseBetween(const Skeleton& from, const Skeleton& to, const JointRoles& roles);

/// How far the feet of a captured mean cycle drop while their soles are down, by Side [rad]: the
/// mean from a tenth of their stance, when the fore foot has landed, to half of it, when the heel
/// begins to rise. Of the mean cycle rather than of each stance, for that is what the walk is to
/// be; stances of one capture differ by some degrees. @param skeleton, reference  that the series
/// is of
std::array<double, 2> standingDrops(const WalkCycle& cycle, const Skeleton& skeleton,
                                    const JointRoles& roles,
                                    const std::vector<Eigen::Quaterniond>& reference);

/// The library on the soles of this skeleton, which is its own but for how feet drop at rest; its
/// motions keep how their feet stand on them.
void standOn(Skeleton soles, MotionLibrary& library);

/// The library on the soles of its walks (WalkCycle::foot_drops); as it is where none says what it
/// stood on.
void settleSoles(MotionLibrary& library);

}  // namespace amble
