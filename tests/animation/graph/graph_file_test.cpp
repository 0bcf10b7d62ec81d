#include "animation/graph/graph_file.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/sha256.h"
#include "tests/animation/graph/graph_captures.h"

namespace amble {
namespace {

/// Two clips of a few made-up frames.
KeptGraph small() {
  KeptGraph kept;
  kept.graph.clips = {{"a, \"<b>\"", 0, 3, 2, 4.0}, {"b\n", 3, 2, 0, 1.0}};
  kept.graph.states = {SupportState::kL, SupportState::kL, SupportState::kLB, SupportState::kL,
                       SupportState::kLB};
  kept.graph.features = FrameFeatures::Random(kFeatureRows, 5);
  growTrees(kept.graph, 1);
  kept.inputs = {{{"a.amc", std::string(64, '0')}, {"a.asf", std::string(64, '1')}},
                 {{"../b.bvh", std::string(64, '2')}}};
  kept.reading.metres_per_unit = 0.0254;
  kept.reading.up = UpAxis::kZ;
  kept.reading.facing = 1.5;
  kept.reading.asf = "a.asf";
  return kept;
}

void expectRefused(const std::string& bytes, const std::string& why) {
  try {
    unpackGraph(bytes, "it.graph");
    FAIL() << why;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
  }
}

std::string packedAfter(const std::function<void(KeptGraph&)>& change) {
  KeptGraph kept = small();
  change(kept);
  return packGraph(kept);
}

TEST(GraphFile, ComesBackAsItWas) {
  const KeptGraph kept = small();
  const std::string bytes = packGraph(kept);
  const KeptGraph back = unpackGraph(bytes, "it.graph");
  EXPECT_EQ(packGraph(back), bytes);
  EXPECT_EQ(back.graph.features, kept.graph.features);
  EXPECT_EQ(back.graph.clips[0].name, "a, \"<b>\"");
  EXPECT_EQ(back.inputs[0][1].path, "a.asf");
  EXPECT_EQ(back.reading.up, UpAxis::kZ);
}

TEST(GraphFile, WhatIsNoneCutOffOrAlteredIsSeen) {
  const std::string bytes = packGraph(small());
  expectRefused("", "is no cluster graph");
  expectRefused("amble graph 2\n", "of another format");
  for (size_t size : {bytes.size() - 1, bytes.size() / 2, size_t{40}})
    expectRefused(bytes.substr(0, size), "damaged");
  for (size_t at = 14; at < bytes.size(); at += 97) {
    std::string altered = bytes;
    altered[at] = static_cast<char>(altered[at] ^ 4);
    expectRefused(altered, "damaged");
  }
  expectRefused(bytes + "x", "damaged");
}

TEST(GraphFile, WhatIsMadeUpIsSeenByItsValues) {
  const std::vector<std::pair<std::string, std::function<void(KeptGraph&)>>> faults = {
      {"a frame time", [](KeptGraph& k) { k.graph.frame_time = -1.0; }},
      {"a clip of no frames", [](KeptGraph& k) { k.graph.clips[1].first = 2; }},
      {"a clip of no frames", [](KeptGraph& k) { k.graph.clips[0].frames = 2147483647; }},
      {"frames of no clip", [](KeptGraph& k) { k.graph.clips[1].frames = 1; }},
      {"a frame that is nowhere", [](KeptGraph& k) { k.graph.features(3, 3) = NAN; }},
      {"a state that is none", [](KeptGraph& k) { k.graph.states[1] = SupportState(9); }},
      {"a tree that is none", [](KeptGraph& k) { k.graph.merges[0].a = 99; }},
      {"a tree that is none", [](KeptGraph& k) { k.graph.merges[1].a = k.graph.merges[0].a; }},
      {"a cluster of two states", [](KeptGraph& k) { k.graph.merges[0].b = 2; }},
      {"trees that are not whole", [](KeptGraph& k) { k.graph.merges.pop_back(); }},
      {"an error that is none", [](KeptGraph& k) { k.graph.merges[0].error = -1.0f; }},
      {"a clip of no file", [](KeptGraph& k) { k.inputs[1].clear(); }},
      {"a unit", [](KeptGraph& k) { k.reading.metres_per_unit = -2.0; }}};
  for (const auto& [why, change] : faults) expectRefused(packedAfter(change), why);
}

TEST(GraphFile, AnnouncedMemoryIsNotTaken) {
  std::string bytes = packGraph(small());
  bytes.resize(bytes.size() - 64);
  // The count of clips stands behind the reading and the frame time: as many as memory has bytes.
  const size_t count_at = bytes.find(std::string("a, \"<b>\"")) - 16;
  bytes.replace(count_at, 8, std::string(8, '\x7f'));
  expectRefused(bytes + sha256(bytes), "ends too soon");
}

TEST(GraphFile, ThreadsAndASecondReadingChangeNoByte) {
  AMBLE_NEEDS_CAPTURES();
  KeptGraph one, three;
  one.graph = someGraph();
  three.graph = makeGraph(graphClips(graphPaths(), 3), 3);
  one.inputs = three.inputs = std::vector(graphPaths().size(), std::vector<GraphInput>(1));
  EXPECT_EQ(sha256(packGraph(one)), sha256(packGraph(three)));
}

}  // namespace
}  // namespace amble
