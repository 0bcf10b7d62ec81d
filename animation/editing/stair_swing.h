/// Feet that swing from tread to tread, over the nosings between.
#pragma once

#include "animation/editing/foot_prints.h"
#include "animation/ground/stair_ground.h"

namespace amble {

/// What a sole that swings keeps over a nosing, and ahead of a riser [m]. QUALITY.md asks for 10
/// mm.
inline constexpr double kOverNosing = 0.02, kAheadOfRiser = 0.015;

/// Takes the feet of the tracks to where their prints are shifted and raised. How early a foot goes
/// ahead and how fast it rises is chosen for each swing, of some shapes, so that it needs to be
/// raised least to clear the stairs; it is raised by one smooth curve over that.
/// @param origin  of the stairs [m, World]
void swingOver(const CapturedWalk& walk, const Stairs& stairs, const Eigen::Vector2d& origin,
               const FootPrints& prints, WalkTracks& tracks);

/// The sole's points that may hit something, in the foot joint's frame: heel, ball and tip of the
/// toes, as they lie on the floor where the foot stands flattest [m]. @param foot  as it was
/// captured
std::array<Eigen::Vector3d, 3> solePoints(const CapturedWalk& walk, const FootTrack& foot,
                                          Side side);

}  // namespace amble
