/// top.svg: the plan view of a walk.
#pragma once

#include <filesystem>
#include <ostream>

#include "viz/walk_view.h"

namespace amble {

/// The room from above: what stands between 5 cm and 1.8 m over the floor, darker where it is at
/// the height of hips and hands (0.5 to 1.2 m); the roadmap faint, guards as rings and connectors
/// as squares; the root path; every footprint by foot; start, via points and goal with their
/// headings; names of things, scale bar and legend. Units of the drawing are World metres times a
/// scale that fits the room to about 1,100 units of width; text is drawn with the viewer's
/// sans-serif font. The same view gives the same bytes.
void writePlanView(std::ostream& out, const WalkView& view);
/// Written beside and renamed. @throws InputError if it cannot be written.
void writePlanView(const std::filesystem::path& file, const WalkView& view);

}  // namespace amble
