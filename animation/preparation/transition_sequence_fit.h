/// A captured start or stop as a sequence (Pettré §4.3): what the body does on the way of the
/// path's point between standing and the walk.
#pragma once

#include <array>
#include <optional>

#include "animation/body/clip.h"
#include "animation/body/foot_shape.h"
#include "animation/body/joint_roles.h"
#include "animation/library/transition.h"
#include "animation/library/walk_cycle.h"

namespace amble {

/// The first start of a level clip that stands at first, or its last stop: from the moment in which
/// the body is about to leave the place where it stands to the second double support of the walk.
/// Nothing where the clip does not show three steps of it, or stands with its feet too near one
/// another.
///
/// The captured way is laid on a straight path by the prints, so that the path's point is midway
/// between two of them at each double support, as that of every walk, along the path and across it:
/// people start and stop beside the line that they walk on, by up to 14 cm. While both feet stand
/// the body is laid across the path as it is seen from the foot that stays. It begins as the
/// posture `stand`, from which captured standing differs a little.
/// @param frames  of the clip that it was taken from
std::optional<TransitionSequence> fitTransitionSequence(const Clip& level, const JointRoles& roles,
                                                        const std::array<FootShape, 2>& feet,
                                                        const Posture& stand, bool start,
                                                        std::array<int, 2>& frames);

}  // namespace amble
