/// What is drawn on the floor of a picture: start, goal, root path and footprints; where there is
/// no walk how far one gets, and what stood in the way.
#pragma once

#include <vector>

#include "viz/pictures/rasterizer.h"
#include "viz/walk_view.h"

namespace amble {

/// Discs with their headings, the path's ribbon, the prints of both feet. Without a walk the ground
/// that is reached from the start, a line from where it comes nearest to the goal's, and a pin
/// whose head is where a part of the body touched.
void addFloorMarks(const WalkView& view, std::vector<DrawTriangle>& triangles);

}  // namespace amble
