/// Which closed pieces of a scene bound a hollow, not a solid.
///
/// Within an object: a piece is hollow where all of it lies in the solid of those of the object's
/// other pieces that go around it, so that of shells in one another every second is. Where solids
/// overlap there is none: they stay solid. Files may keep the shells of a room as objects of their
/// own, too: a piece of one mesh is the hollow of another where all of it lies in that one's solid
/// and it is as large as a room. A solid thing within another cannot be told from that by its
/// shape; so what is smaller stays solid (a table in a house that is one block), and so do
/// primitives, which are solid by what they are, and objects with hollows of their own.
#pragma once

#include <vector>

#include "environments/scene/scene_pieces.h"

namespace amble {

/// Sets `hollow` and `solid_of` of the pieces, which have them as if none were hollow.
/// @throws Stopped if that is asked for.
void markHollows(const Scene& scene, std::vector<ScenePiece>& pieces, const StopRequest& stop);

}  // namespace amble
