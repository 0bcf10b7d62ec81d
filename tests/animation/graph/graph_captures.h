/// Cluster graphs of captures of the shared folder.
#pragma once

#include "animation/graph/graph_clips.h"
#include "tests/animation/captures.h"

namespace amble {

inline GraphClips graphClips(const std::vector<std::string>& paths, int threads = 1) {
  std::vector<std::filesystem::path> files;
  for (const std::string& path : paths) files.push_back(sharedFolder() / "mocap" / path);
  return readGraphClips(files, {}, {}, threads);
}

/// A graph of drawn clips: what one row of the features is at each frame; all of one state.
inline ClusterGraph drawnGraph(const std::vector<std::vector<float>>& clips) {
  ClusterGraph graph;
  int first = 0;
  for (const std::vector<float>& clip : clips) {
    const int frames = static_cast<int>(clip.size());
    graph.clips.push_back({"drawn" + std::to_string(first), first, frames, 0, 1.0});
    first += frames;
  }
  graph.features = FrameFeatures::Zero(kFeatureRows, first);
  graph.states.assign(first, SupportState::kL);
  for (size_t c = 0; c < clips.size(); ++c)
    for (size_t i = 0; i < clips[c].size(); ++i)
      graph.features(0, graph.clips[c].first + static_cast<int>(i)) = clips[c][i];
  growTrees(graph, 1);
  return graph;
}

/// Walk, run, turn, stand and a kick: of three skeletons, 30 and 120 frames a second.
inline const std::vector<std::string>& graphPaths() {
  static const std::vector<std::string> kPaths = {
      "accad_female1/Female1_B03_Walk1.bvh",
      "accad_female1/Female1_C05_WalkToRun.bvh",
      "accad_female1/Female1_B09_WalkTurnLeft90.bvh",
      "accad_female1/Female1_D3_ConversationGestures.bvh",
      "cmu_mb2/02_05.bvh",
      "cmu_asfamc/11_01.amc"};
  return kPaths;
}

/// Read and made once.
inline const GraphClips& someClips() {
  static const GraphClips kClips = graphClips(graphPaths());
  return kClips;
}
inline const ClusterGraph& someGraph() {
  static const ClusterGraph kGraph = makeGraph(someClips(), 1);
  return kGraph;
}

}  // namespace amble
