/// What a capture's file does not say and its motion shows: which axis is vertical, and which way
/// the person faces.
#pragma once

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"
#include "animation/captures/capture_file.h"
#include "animation/captures/reading.h"

namespace amble {

/// The vertical axis: that along which the head is over the feet, on average over the clip. The
/// usual y holds unless z is clear: a person who lies or crawls in a y-up file is along z as well,
/// but then moves far along it.
/// @param clip  read as if z were up: file axes, any unit.
Reading<UpAxis> guessUp(const Clip& clip, const JointRoles& roles);

/// The heading of the pelvis in the first frame, across the hip joints from left to right [rad].
/// Unsure where the feet point the other way, which they do when left and right are exchanged; the
/// text says how travel goes against it. @param clip  in World, metres.
Reading<double> guessFacing(const Clip& clip, const JointRoles& roles);

}  // namespace amble
