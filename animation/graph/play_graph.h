/// Motions of a graph put into another order (Shanbhag's thesis, §4.3.2), and looped (§4.3.3).
#pragma once

#include <vector>

#include "animation/graph/graph_clips.h"
#include "animation/graph/transition_search.h"

namespace amble {

/// Frames of one clip, played from the one to the other.
struct PlayedRange {
  int clip = 0;
  int first = 0, last = 0;  ///< of the clip, 0 its first [first <= last]
};

/// Half a second: the thesis lets animators choose, and finds 1 to 2 s good for its clips. Of a
/// walk that is a cycle and more, in which feet of both clips stand at other times. [s]
inline constexpr double kGraphBlend = 0.5;

/// The ranges one after another: the last frame of each meets the first of the next, and half of
/// `blend` [frames, >= 0] before and after that both clips are mixed. @pre ranges of clips that are
/// there, at least one
JoinedClip played(const GraphClips& clips, const std::vector<PlayedRange>& ranges, int blend);

/// Ranges that play a way from one frame to the other, all of them frames among those of all clips.
std::vector<PlayedRange> rangesOf(const ClusterGraph& graph, const GraphWay& way, int from, int to);
/// Ranges that play a clip from its first frame on, go through a loop `count` times [>= 1], and on
/// to its last frame.
std::vector<PlayedRange> rangesOf(const ClusterGraph& graph, const FrameLoop& loop, int count);

}  // namespace amble
