#include "animation/graph/play_graph.h"

#include <cassert>

namespace amble {

JoinedClip played(const GraphClips& clips, const std::vector<PlayedRange>& ranges, int blend) {
  assert(!ranges.empty());
  const auto part = [&](const PlayedRange& range) {
    const PlayableClip& clip = clips.clips[range.clip];
    return ClipPart{clip.clip, clip.planted};
  };
  JoinedClip joined = joinedFrom(part(ranges[0]), ranges[0].first);
  int shift = -ranges[0].first;  // frame i of the clip that plays is frame i + shift of the motion
  for (size_t k = 1; k < ranges.size(); ++k) {
    joinOn(joined, part(ranges[k]), clips.roles,
           {ranges[k - 1].last + shift, ranges[k].first, blend});
    shift = joined.joins.back().frame_shift;
  }
  endAt(joined, ranges.back().last + shift);
  return joined;
}

namespace {

PlayedRange rangeOf(const ClusterGraph& graph, int first, int last) {
  const int clip = graph.clipOf(first);
  return {clip, first - graph.clips[clip].first, last - graph.clips[clip].first};
}

}  // namespace

std::vector<PlayedRange> rangesOf(const ClusterGraph& graph, const GraphWay& way, int from,
                                  int to) {
  std::vector<PlayedRange> ranges;
  for (const FrameJump& jump : way.jumps) {
    ranges.push_back(rangeOf(graph, std::min(from, jump.leave), jump.leave));
    from = jump.enter;
  }
  ranges.push_back(rangeOf(graph, from, std::max(from, to)));
  return ranges;
}

std::vector<PlayedRange> rangesOf(const ClusterGraph& graph, const FrameLoop& loop, int count) {
  const GraphClip& clip = graph.clips[graph.clipOf(loop.leave)];
  std::vector<PlayedRange> ranges = {rangeOf(graph, clip.first, loop.leave)};
  for (int i = 1; i < count; ++i) ranges.push_back(rangeOf(graph, loop.enter, loop.leave));
  if (count == 1) return {rangeOf(graph, clip.first, clip.last())};
  ranges.back().last = clip.last() - clip.first;
  return ranges;
}

}  // namespace amble
