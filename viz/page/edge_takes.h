/// Edges of a roadmap, walked and refused, as takes of a page.
#pragma once

#include "planner/roadmap/replay_edge.h"
#include "scenarios/problem.h"
#include "viz/page/walk_page.h"

namespace amble {

/// Adds edges of the roadmap, and attempts, that the page plays: no more than these, evenly spread,
/// and no more frames than kMostEdgeFrames in all. Of each but the first every other frame.
/// @param sole  length of the soles [m]
void addEdgeTakes(const Problem& problem, const RoadmapPicture& roadmap, double sole,
                  WalkPage& page);
inline constexpr int kMostEdgeTakes = 40, kMostAttemptTakes = 16, kMostEdgeFrames = 6000;

/// Why an attempt is none, in a few words.
std::string whatRefused(const Problem& problem, WalkRule rule, int part, int object);

/// The root's way on the ground, a point every few centimetres [m, World].
std::vector<Eigen::Vector3d> wayOf(const AnimationBuffer& walk);

/// A motion of ours: its way, headings, prints and plants. @pre the buffer outlives it
PageTake takeOf(const AnimationBuffer& walk, double sole);

}  // namespace amble
