#include "app/played_graph.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/parallel.h"

namespace amble {
namespace {

// The clips of these ranges, read again as they were for the graph, after the first clip, whose
// skeleton they are on.
GraphClips readAgain(const KeptGraph& kept, const std::string& file, double fps,
                     std::vector<NamedRange>& ranges) {
  std::set<int> wanted = {0};
  for (const NamedRange& range : ranges) wanted.insert(range.clip);
  for (NamedRange& range : ranges)
    range.clip = static_cast<int>(std::distance(wanted.begin(), wanted.find(range.clip)));
  const double frame_time = fps > 0.0 ? 1.0 / fps : kept.graph.frame_time;
  return readKeptClips(kept, file, wanted, frame_time, usualThreads());
}

std::vector<PlayedRange> inFrames(const GraphClips& clips, const std::vector<NamedRange>& ranges) {
  std::vector<PlayedRange> frames;
  for (const NamedRange& range : ranges) {
    const GraphClip& clip = clips.about[range.clip];
    // At a lower rate a clip may end before its last frame.
    const auto frame = [&](int in_file) {
      const int found = clip.fromFile(in_file);
      return found < 0 ? clip.frames - 1 : found - clip.first;
    };
    frames.push_back({range.clip, frame(range.first), frame(range.last)});
  }
  return frames;
}

}  // namespace

PlayedGraph playGraph(const KeptGraph& kept, const std::string& file,
                      std::vector<NamedRange> ranges, const GraphPlaying& how) {
  const GraphClips clips = readAgain(kept, file, how.fps, ranges);
  const int blend = static_cast<int>(std::lround(how.blend / clips.frame_time));
  PlayedGraph made{played(clips, inFrames(clips, ranges), blend), clips.roles, {}};
  if (how.foot_lock) {
    made.lock.emplace();
    made.motion.clip =
        lockFeet(made.motion.clip, made.roles, plantsOf(made.motion.planted), &*made.lock);
  }
  return made;
}

std::vector<FrameLoop> loopsIn(const KeptGraph& kept, int clip, const LoopWishes& wishes) {
  const int shortest =
      std::max(1, static_cast<int>(std::lround(wishes.shortest / kept.graph.frame_time)));
  std::vector<FrameLoop> loops =
      loopsOf(kept.graph, cutAt(kept.graph, wishes.error), clip, shortest);
  if (!wishes.left_near) return loops;
  const int at = frameNamed(
      kept, kept.graph.clips[clip].name + ":" + std::to_string(*wishes.left_near), "--at");
  std::stable_sort(loops.begin(), loops.end(), [&](const FrameLoop& a, const FrameLoop& b) {
    return std::abs(a.leave - at) < std::abs(b.leave - at);
  });
  return loops;
}

std::vector<NamedRange> rangesOfLoop(const KeptGraph& kept, const FrameLoop& loop, int count) {
  std::vector<NamedRange> ranges;
  for (const PlayedRange& range : rangesOf(kept.graph, loop, count)) {
    const GraphClip& played = kept.graph.clips[range.clip];
    ranges.push_back({range.clip, played.inFile(played.first + range.first),
                      played.inFile(played.first + range.last)});
  }
  return ranges;
}

}  // namespace amble
