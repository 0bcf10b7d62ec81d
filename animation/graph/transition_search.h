/// Ways from one frame to another over a cluster graph (Shanbhag's thesis, §4.3.2), and loops
/// (§4.3.3).
///
/// A way plays a clip on from the frame where it begins, leaves it at the alignment frame of a
/// sequence, enters another sequence of the same cluster at its own, and so on. It comes to the
/// frame that is asked for, or to one before it in the same clip, which then plays on to it. Frames
/// without room for a blend (kJoinRoom) are left and entered only where there is no other way.
#pragma once

#include <optional>
#include <vector>

#include "animation/graph/cluster_graph.h"

namespace amble {

/// From a frame to one that is like it.
struct FrameJump {
  int leave = 0, enter = 0;  ///< among those of all clips
  double error = 0.0;        ///< E [m², >= 0]
};

/// Jumps, in the order in which they are made; none where the clip itself goes from the one frame
/// to the other.
struct GraphWay {
  std::vector<FrameJump> jumps;
  double error = 0.0;  ///< sum of the jumps' E [m², >= 0]
  int wait = 0;        ///< frames played before the first jump and after the last [frames, >= 0]
};

struct WaySearch {
  /// A clip is played for at least so long between two jumps: blends do not meet [frames, >= 0].
  int least_stay = 15;
};

/// The alignment of the cluster that both frames are in, of the sequences that they are in; none
/// where they are in two.
std::optional<GraphWay> wayWithin(const ClusterGraph& graph, const GraphCut& cut, int from, int to);
/// One jump that leaves the clip soonest after `from` and enters the other latest before `to`: the
/// fewest frames of both together, of these the least error.
std::optional<GraphWay> nearestWay(const ClusterGraph& graph, const GraphCut& cut, int from,
                                   int to);
/// One jump of least error.
std::optional<GraphWay> bestWay(const ClusterGraph& graph, const GraphCut& cut, int from, int to);
/// Jumps of least error in all, through whatever clips (Dijkstra; of equal ones fewest jumps).
std::optional<GraphWay> wayThrough(const ClusterGraph& graph, const GraphCut& cut, int from, int to,
                                   const WaySearch& search = {});

/// A part of a clip that can be played again and again: it is left at `leave` and goes on at
/// `enter`, which is before it, the two frames of both sequences that are most alike.
using FrameLoop = FrameJump;

/// Loops of a clip, those of least error first, those without room for a blend last. @param
/// shortest  [frames, > 0]
std::vector<FrameLoop> loopsOf(const ClusterGraph& graph, const GraphCut& cut, int clip,
                               int shortest);

}  // namespace amble
