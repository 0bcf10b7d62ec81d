/// Whoever a capture is of, in a scene: his body, and the floor that he is on.
#pragma once

#include <string>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"
#include "environments/body/body.h"
#include "environments/ground/ground_settings.h"
#include "environments/scene/scene.h"

namespace amble {

/// Height of the ankles where they are lowest: the tenth lowest of a hundred, so that one bad frame
/// does not count [m, World]. @pre the clip has frames
double lowestAnkle(const Clip& clip, const JointRoles& roles);

/// Radii from the stature; soles' height from the toe joints or, of a rig without them, from the
/// lowest feet. @param floor  its height [m, World] @param stature  [m, > 0]
/// @pre the roles are a person's, and the clip has frames
Body capturedBody(const Clip& clip, const JointRoles& roles, double floor, double stature);

/// The floor that the walk begins on. Where its feet are near none, they hang over one or sink into
/// it: then it is that which most of the way lies over, and not a wall's top that is passed [m].
/// @throws InputError, of `file`, where no floor is below or above
double floorUnder(const Clip& clip, const JointRoles& roles, const Scene& scene,
                  const GroundSettings& settings, const std::string& file);

}  // namespace amble
