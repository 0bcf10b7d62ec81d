/// A cluster graph on the workbench (Shanbhag's thesis, chapter 4): its clips to be played, which
/// parts of them are alike, and transitions between them, which are played as they are joined.
///
/// Where clusters lie beside one another on the page: the mean features of their frames along the
/// two directions in which all frames differ most (principal components), so that what is alike is
/// near and a cycle of a walk goes round.
#pragma once

#include <string>
#include <vector>

#include "animation/graph/graph_clips.h"
#include "animation/graph/kept_clips.h"
#include "animation/graph/transition_search.h"
#include "viz/page/bench.h"

namespace amble {

/// A transition that can be played.
struct BenchJoin {
  FrameJump jump;
  int cluster = 0;                  ///< that both frames are in
  std::vector<PlayedRange> ranges;  ///< what is played of both clips
  JoinReport report;                ///< frames of what is played
};

/// Borrowed: the graph outlives it.
struct BenchGraph {
  const ClusterGraph* graph = nullptr;  ///< never null
  GraphCut cut;
  std::vector<ShownClip> clips;  ///< those of the graph, then the joins'
  std::vector<BenchJoin> joins;
  int joins_found = 0;  ///< how many there would be [>= joins]
};

/// Transitions that are made for a page, at most. A second and a half each: some 25 kB.
inline constexpr int kMostJoins = 60;

/// Of each cluster, from each clip to each the jump of least error between alignment frames that
/// have room for a blend. Those that are made: of each two clips the smoothest, then the second
/// ones, and so on.
/// @pre the graph's clips, at its frame time
BenchGraph benchOfGraph(const ClusterGraph& graph, const GraphClips& clips, double error);

/// Everything but the clips' own curves.
std::string benchGraphJson(const BenchGraph& bench, const NumbersText& numbers);

}  // namespace amble
