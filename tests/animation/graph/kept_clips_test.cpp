#include "animation/graph/kept_clips.h"

#include <gtest/gtest.h>

#include "tests/animation/graph/graph_captures.h"

namespace amble {
namespace {

TEST(KeptClips, AreThoseThatTheGraphWasMadeOf) {
  const std::filesystem::path file = sharedFolder() / "mocap" / "some.graph";  // is never written
  KeptGraph kept{someGraph(), {}, {}};
  for (const std::string& path : graphPaths())
    kept.inputs.push_back({graphInput(file, sharedFolder() / "mocap" / path)});
  const GraphClips again = readKeptClips(kept, file, {0, 4}, someClips().frame_time, 1);
  ASSERT_EQ(again.clips.size(), 2u);
  for (const auto& [read, was] : {std::pair(0, 0), std::pair(1, 4)}) {
    const Clip &clip = again.clips[read].clip, &before = someClips().clips[was].clip;
    ASSERT_EQ(clip.frames(), before.frames());
    for (int frame = 0; frame < clip.frames(); ++frame)
      for (int joint = 0; joint < clip.skeleton.size(); ++joint)
        EXPECT_EQ(clip.poses.rotations(frame)[joint].coeffs(),
                  before.poses.rotations(frame)[joint].coeffs());
  }
}

TEST(KeptClips, FramesAreCalledAsTheirFileNumbersThem) {
  ClusterGraph graph = drawnGraph({{0.0f, 1.0f, 2.0f}, {0.0f, 1.0f, 2.0f}});
  graph.clips[1].name = "b: \"x\", 1-2";
  graph.clips[1].first_frame = 10;
  graph.clips[1].step = 4.0;
  EXPECT_EQ(frameName(graph, 4), "b: \"x\", 1-2:14");
  EXPECT_EQ(rangesText(graph, {{0, 0, 1}, {1, 1, 2}}), "drawn0:0-1,b: \"x\", 1-2:14-18");
}

}  // namespace
}  // namespace amble
