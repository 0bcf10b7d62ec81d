/// A captured turn on the spot as a sequence (Pettré §4.3).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>

#include "animation/body/clip.h"
#include "animation/body/foot_shape.h"
#include "animation/body/joint_roles.h"
#include "animation/library/turn_sequence.h"
#include "animation/library/walk_cycle.h"
#include "base/rotation.h"

namespace amble {

/// What is looked for.
struct SpotTurnFit {
  std::array<FootShape, 2> feet;
  const Posture* stand = nullptr;             ///< with which it begins and ends
  std::string file;                           ///< for messages
  std::optional<std::pair<int, int>> frames;  ///< of the clip: look only there
};

/// The largest turn of a level clip in which somebody keeps to one spot (kOnSpot), puts down a foot
/// anew and does not run: from a moment before the pelvis turns, in which the head leads, to a
/// moment after.
///
/// The body is the captured one against the heading of its pelvis. Only for a moment at either end
/// does it come out of the posture `stand` and go back into it. Where the pelvis is over the ground
/// and what the legs do is left out: captured feet pivot, and whoever turns is to step. Of the
/// pelvis' height only how it rises and falls is kept, below that of `stand`.
/// @param frames  of the clip that it was taken from
/// @pre how.stand is there
/// @throws InputError naming the file where nobody turns so, or farther, longer or in more steps
/// than a library may hold.
TurnSequence fitTurnOnSpot(const Clip& level, const JointRoles& roles, const SpotTurnFit& how,
                           std::array<int, 2>& frames);

/// A pelvis that turns keeps within a rectangle with a diagonal of twice this [m].
inline constexpr double kOnSpot = 0.3;
/// Smaller turns are what walkers and waiting people sway by [rad].
inline constexpr double kLeastTurn = 30.0 * kDegree;

}  // namespace amble
