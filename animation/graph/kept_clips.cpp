#include "animation/graph/kept_clips.h"

#include <cassert>

#include "base/text.h"

namespace amble {

namespace fs = std::filesystem;

GraphClips readKeptClips(const KeptGraph& kept, const fs::path& graph_file,
                         const std::set<int>& wanted, double frame_time, int threads) {
  assert(wanted.contains(0));
  std::vector<fs::path> files;
  for (const int clip : wanted) files.push_back(inputFile(graph_file, kept.inputs[clip][0]));
  MotionReadOptions reading = kept.reading;
  if (!reading.asf.empty()) reading.asf = inputFile(graph_file, {reading.asf.string(), ""});
  if (!reading.roles.empty()) reading.roles = inputFile(graph_file, {reading.roles.string(), ""});
  return readGraphClips(files, reading, frame_time, threads);
}

std::string frameName(const ClusterGraph& graph, int frame) {
  const GraphClip& clip = graph.clips[graph.clipOf(frame)];
  return clip.name + ":" + std::to_string(clip.inFile(frame));
}

std::string rangesText(const ClusterGraph& graph, const std::vector<PlayedRange>& ranges) {
  std::vector<std::string> parts;
  for (const PlayedRange& range : ranges) {
    const GraphClip& clip = graph.clips[range.clip];
    parts.push_back(frameName(graph, clip.first + range.first) + "-" +
                    std::to_string(clip.inFile(clip.first + range.last)));
  }
  return joined(parts, ",");
}

}  // namespace amble
