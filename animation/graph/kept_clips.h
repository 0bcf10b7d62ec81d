/// The clips of a graph that is kept in a file, read again, and what its frames are called.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "animation/graph/graph_clips.h"
#include "animation/graph/graph_file.h"
#include "animation/graph/play_graph.h"

namespace amble {

/// These of the graph's clips [indices, ascending], as they were read for it. The first of the
/// graph's must be among them: they are on its skeleton. @param frame_time  of all of them [s, > 0]
/// @throws InputError as readGraphClips
GraphClips readKeptClips(const KeptGraph& kept, const std::filesystem::path& graph_file,
                         const std::set<int>& wanted, double frame_time, int threads);

/// "Walk1:147", of a frame among those of all clips: the file's own number.
std::string frameName(const ClusterGraph& graph, int frame);
/// "Walk1:100-147,Run:69-120": what `amble graph play` takes.
std::string rangesText(const ClusterGraph& graph, const std::vector<PlayedRange>& ranges);

}  // namespace amble
