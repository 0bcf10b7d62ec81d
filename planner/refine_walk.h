/// From the crooked walk that a roadmap gives, which stops and turns at every node, to one that is
/// shorter and walks on.
///
/// Every proposal replaces a stretch of the walk by new edges, which steering checks as it checks
/// any other; it is taken if the walk costs no more (WalkEdge::cost) and gains: in cost, or by
/// bending less. So a refined walk never costs more than the one it came from and is as valid. Four
/// passes:
///   1 shortcuts   a direct edge between two nodes, the widest apart first, until none helps; none
///                 over more than 20 m, which is what roadmaps are for
///   2 stops       each node where the walk stands is replaced by a stance that walks: on the node
///                 or nearer to the line between its neighbours, headed as they lie; the first on a
///                 fixed list that passes
///   3 nearness    edges that go near things are led past them, and nodes between such edges are
///                 moved and turned by a fixed pattern, while that helps
///   4 tries       a counted number of random ones: a node moved, left out, or cut off between two
///                 points of the walk
/// Pass 4 comes in rounds until some in a row are no help, and after each that helped 1 to 3
/// again. Where the walk still stops somewhere then, all is done once more with stances that walk
/// slower than planned (Stance::pace): who walks fast passes tight corners at no other.
/// Tries come from a stream each, by index, and are judged in that order, so the result is
/// the same for any number of threads.
#pragma once

#include "planner/plan_request.h"
#include "planner/refinement/edge_path.h"
#include "planner/search_limits.h"
#include "planner/steering/steering.h"

namespace amble {

/// @pre path.edges is not empty. limits.deadline and limits.stop end it early, with what is
/// reached.
EdgePath refineWalk(const Steering& steering, EdgePath path, const RefineSettings& settings,
                    const SearchLimits& limits, SteeringCount& count);

}  // namespace amble
