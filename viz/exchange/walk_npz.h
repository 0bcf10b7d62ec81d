/// A walk as arrays for NumPy: `walk = numpy.load("walk.npz")`.
///
/// World, z up; metres, seconds, radians; turns as unit quaternions w, x, y, z. F frames, J joints,
/// P footprints:
///
///     title                 text
///     frame_time            [s]
///     joint_names           J texts         parents          J int, -1 of the root
///     offsets               J x 3           of each joint in its parent's frame
///     root_positions        F x 3           quaternions      F x J x 4, joint in its parent, root
///                                                            in World
///     positions             F x J x 3       joints in World
///     path_positions        F x 3           on the ground    path_headings, path_speeds,
///     path_arcs             F               walked so far    path_turn_rates, phases   F each
///     planted               F x 2 bool      left, right
///     footprint_sides       P int           0 left, 1 right  footprint_positions   P x 3
///     footprint_headings    P               footprint_frames P x 2 int, first and last
#pragma once

#include <ostream>
#include <span>
#include <string>

#include "viz/exchange/npy_archive.h"
#include "viz/walk_view.h"

namespace amble {

/// @param joint_names  by joint. @pre view.hasBody(), and the animation has a state a frame
void writeWalkNpz(std::ostream& out, const WalkView& view,
                  std::span<const std::string> joint_names);

/// The same arrays, to which others may be added.
NpyArchive walkArrays(const WalkView& view, std::span<const std::string> joint_names);

}  // namespace amble
