/// How clips and frames of a cluster graph are called on the command line: CLIP:FRAME and
/// CLIP:A-B, frames as the clip's file numbers them, from 0.
#pragma once

#include <string>
#include <vector>

#include "animation/graph/graph_clips.h"
#include "animation/graph/graph_file.h"
#include "animation/graph/play_graph.h"
#include "animation/graph/transition_search.h"

namespace amble {

/// Reads a graph, and refuses one whose clips have changed.
KeptGraph readFreshGraph(const std::string& file);

/// @param option  for messages. @throws InputError where no clip, or several, are called so
int clipNamed(const KeptGraph& kept, const std::string& name, const std::string& option);
/// CLIP:FRAME, as a frame among those of all clips. @throws InputError
int frameNamed(const KeptGraph& kept, const std::string& text, const std::string& option);

/// CLIP:A-B.
struct NamedRange {
  int clip = 0;
  int first = 0, last = 0;  ///< of the file
};
/// CLIP:A-B,CLIP:C-D; names may hold commas and colons. @throws InputError
std::vector<NamedRange> rangesNamed(const KeptGraph& kept, const std::string& text,
                                    const std::string& option);

/// "Walk1:147", of a frame among those of all clips.
std::string frameName(const ClusterGraph& graph, int frame);
/// "Walk1:100-147,Run:69-120": what `amble graph play` takes.
std::string rangesText(const ClusterGraph& graph, const std::vector<PlayedRange>& ranges);

}  // namespace amble
