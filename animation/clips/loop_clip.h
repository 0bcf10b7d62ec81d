/// A loop of one cycle, as games and shops of motion have them, walked on.
#pragma once

#include <optional>
#include <span>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

/// Root mean square distance of the joints of two poses of a skeleton, each seen from its root's
/// place and its pelvis' heading; heights count [m, >= 0].
double poseGap(std::span<const JointFrame> a, std::span<const JointFrame> b,
               const JointRoles& roles);

/// The ends of a loop are at most so far apart [m]: those of the loops in our captures are within
/// 20 mm, those of other clips differ by 100 and more.
inline constexpr double kLoopGap = 0.05;

/// So often repeated, two whole cycles at least are in a loop of one, whatever it begins with.
inline constexpr int kLoopRuns = 4;

/// A clip whose last frame is its first one again, `times` [>= 1] times in a row, each from where
/// and as the one before ended; nothing where the ends differ by more than kLoopGap.
std::optional<Clip> repeatedLoop(const Clip& clip, const JointRoles& roles, int times);

}  // namespace amble
