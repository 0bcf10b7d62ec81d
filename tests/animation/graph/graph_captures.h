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
