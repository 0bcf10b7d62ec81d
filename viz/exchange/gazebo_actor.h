/// A walk as an actor of Gazebo: `gz sim walk.sdf` shows it (Fortress: `ign gazebo walk.sdf`).
///
/// SDF 1.9, <actor>: a skin in COLLADA and its animation, the walk's BVH, beside it. The actor goes
/// where the BVH goes: without a trajectory of its own Gazebo leaves the animation's root motion
/// (gz-sim, SceneManager). It takes a BVH for a skin only whose joints are the same tree and,
/// unless it is to guess, hang the same in the rest pose: here they do. Where both hold, Gazebo
/// places every joint where the BVH has it.
#pragma once

#include <ostream>
#include <span>
#include <string>

#include "environments/scene/scene.h"
#include "viz/figure/figure.h"

namespace amble {

/// walk.sdf: a world with the sun and the actor, whose files are walk.dae and walk.bvh beside it,
/// and the room to look at, room.dae, which nothing bumps into.
/// @param bvh_unit  length of the BVH's unit [m, > 0] @param with_room  whether the room is there
void writeActorSdf(std::ostream& out, double bvh_unit, bool with_room);

/// room.dae: the scene as pictures show it, in World; of more than kMostRoomTriangles fewer
/// (thinRoom).
void writeRoomCollada(std::ostream& out, const Scene& scene, double floor);
inline constexpr size_t kMostRoomTriangles = 300'000;

/// walk.dae: COLLADA 1.4.1, z up, metres; the figure in the skeleton's rest pose, and the joints in
/// the order in which a BVH has them.
/// @param joint_names  as the BVH has them, by joint
void writeSkinCollada(std::ostream& out, const Skeleton& skeleton, const Figure& figure,
                      std::span<const std::string> joint_names);

/// The figure in the skeleton's rest pose, the root at the origin and upright as its file has it:
/// the one that skinning takes back to the figure as it was, in its bind pose.
Figure restedFigure(const Skeleton& skeleton, const Figure& figure);

}  // namespace amble
