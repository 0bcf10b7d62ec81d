/// Soles on a level floor, z = 0: a foot that stands rests on it by its heel, its ball or the tips
/// of its toes, one that swings passes over it. What captured or made feet go into the floor, or
/// stand over it, is taken out.
///
/// Feet keep how they roll and turn: each is moved up or down as a whole, by the least smooth curve
/// that puts the lowest point of its sole (FootShape) on the floor while it stands, and by no less
/// than keeps it out of the floor. The pelvis goes along (shiftFeet). Toes that are bent down
/// farther than their ball, into the floor, are bent up.
#pragma once

#include "animation/analysis/foot_plants.h"
#include "animation/body/foot_shape.h"
#include "animation/editing/walk_tracks.h"

namespace amble {

/// @param clip  of which the tracks are, for how its toes turn. @pre toe joints
/// @param shapes  by Side
/// @return how far a foot is moved at most [m, >= 0]
double restOnFloor(const Clip& clip, const JointRoles& roles,
                   const std::array<FootShape, 2>& shapes, const FootPlants& plants,
                   WalkTracks& tracks);

}  // namespace amble
