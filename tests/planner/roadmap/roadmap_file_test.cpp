#include "planner/roadmap/roadmap_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>

#include "base/byte_pack.h"
#include "base/error.h"
#include "base/sha256.h"

namespace amble {
namespace {

KeptRoadmap small() {
  KeptRoadmap roadmap;
  roadmap.source.scene = {{"room.yaml", std::string(64, 'a')}};
  roadmap.source.settings = {{"speed", "1.2"}, {"actions", ""}};
  roadmap.seed = 7;
  roadmap.max_failures = 25;
  roadmap.samples = 80;
  roadmap.coverage = 0.96;
  for (int i = 0; i < 3; ++i) {
    KeptRoadmap::Node node;
    node.stance.position = {0.1 * i, -1.0 / 3.0, 1e-9};
    node.stance.heading = -0.7 * i;
    node.kind = i == 1 ? NodeKind::kConnector : NodeKind::kGuard;
    roadmap.nodes.push_back(node);
  }
  roadmap.edges = {{0, 1, 2.5}, {1, 0, 2.5000000001}, {1, 2, 1.0 / 3.0}};
  return roadmap;
}

std::string refusal(const std::string& bytes) {
  try {
    unpackRoadmap(bytes, "it.roadmap");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// What would be believed: the same with a digest that fits.
std::string resigned(std::string bytes) {
  bytes.resize(bytes.size() - 64);
  return bytes + sha256(bytes);
}

TEST(RoadmapFile, WhatIsWrittenIsReadAgainToTheBit) {
  const KeptRoadmap roadmap = small();
  const std::string bytes = packRoadmap(roadmap);
  const KeptRoadmap read = unpackRoadmap(bytes, "it.roadmap");
  EXPECT_EQ(read.source.scene, roadmap.source.scene);
  EXPECT_EQ(read.source.settings, roadmap.source.settings);
  EXPECT_EQ(read.seed, 7u);
  EXPECT_EQ(read.coverage, 0.96);
  ASSERT_EQ(read.nodes.size(), 3u);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read.nodes[i].stance.position, roadmap.nodes[i].stance.position);
    EXPECT_EQ(read.nodes[i].stance.heading, roadmap.nodes[i].stance.heading);
    EXPECT_EQ(read.nodes[i].kind, roadmap.nodes[i].kind);
  }
  ASSERT_EQ(read.edges.size(), 3u);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read.edges[i].from, roadmap.edges[i].from);
    EXPECT_EQ(read.edges[i].to, roadmap.edges[i].to);
    EXPECT_EQ(read.edges[i].cost, roadmap.edges[i].cost);
  }
  EXPECT_EQ(packRoadmap(read), bytes);
}

TEST(RoadmapFile, OfWhatIsCutOffOrAlteredNoByteIsBelieved) {
  const std::string bytes = packRoadmap(small());
  for (size_t size = 0; size < bytes.size(); ++size)
    EXPECT_TRUE(refusal(bytes.substr(0, size)).starts_with("it.roadmap: is ")) << size;
  for (size_t i = 0; i < bytes.size(); ++i) {
    std::string altered = bytes;
    altered[i] = static_cast<char>(altered[i] ^ 0x40);
    EXPECT_NE(refusal(altered), "") << i;
  }
  EXPECT_NE(refusal(bytes + "x"), "");
  EXPECT_NE(refusal(resigned(bytes.substr(0, bytes.size() - 64) + "x" + std::string(64, '0'))), "");
}

TEST(RoadmapFile, WhatIsNoRoadmapIsSaidToBeNone) {
  for (const char* text : {"", "scene: room.yaml\n", "amble", "HIERARCHY\n"})
    EXPECT_EQ(refusal(text),
              "it.roadmap: is no roadmap; expected one that `amble roadmap build` has written");
  EXPECT_NE(refusal("amble roadmap 2\n....").find("another format"), std::string::npos);
}

// Each with a digest that fits: somebody made it up.
TEST(RoadmapFile, WhatCannotBeIsRefusedByWhatItIs) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<const char*, std::function<void(KeptRoadmap&)>> lies[] = {
      {"a node that is nowhere", [&](KeptRoadmap& r) { r.nodes[1].stance.position.y() = nan; }},
      {"a node that is nowhere", [](KeptRoadmap& r) { r.nodes[1].stance.position.x() = 1e9; }},
      {"a node that is nowhere", [&](KeptRoadmap& r) { r.nodes[2].stance.heading = nan; }},
      {"a node of no kind", [](KeptRoadmap& r) { r.nodes[0].kind = static_cast<NodeKind>(99); }},
      {"an edge to a node that is not there", [](KeptRoadmap& r) { r.edges[0].to = 3; }},
      {"an edge to a node that is not there", [](KeptRoadmap& r) { r.edges[0].from = -1; }},
      {"an edge twice", [](KeptRoadmap& r) { r.edges[1] = r.edges[0]; }},
      {"from a node to itself", [](KeptRoadmap& r) { r.edges[0].to = 0; }},
      {"an edge that costs no time", [&](KeptRoadmap& r) { r.edges[2].cost = nan; }},
      {"an edge that costs no time", [](KeptRoadmap& r) { r.edges[2].cost = -1.0; }},
      {"counts that no search has", [](KeptRoadmap& r) { r.max_failures = 0; }},
      {"counts that no search has", [](KeptRoadmap& r) { r.samples = -1; }},
      {"counts that no search has", [&](KeptRoadmap& r) { r.coverage = nan; }}};
  for (const auto& [what, lie] : lies) {
    KeptRoadmap roadmap = small();
    lie(roadmap);
    EXPECT_NE(refusal(packRoadmap(roadmap)).find(what), std::string::npos)
        << what << ": " << refusal(packRoadmap(roadmap));
  }
}

// Counts are announced before what they count: none is believed before it is there.
TEST(RoadmapFile, HugeCountsTakeNoMemory) {
  const std::string bytes = packRoadmap(small());
  const std::uint64_t huge[] = {std::uint64_t{1} << 62, std::uint64_t{1} << 33, 1000};
  int refused = 0;
  for (size_t at = 16; at + 8 + 64 <= bytes.size(); ++at) {
    for (const std::uint64_t count : huge) {
      std::string altered = bytes;
      altered.replace(at, 8, reinterpret_cast<const char*>(&count), 8);
      refused += !refusal(resigned(altered)).empty();
    }
  }
  EXPECT_GT(refused, 100);
}

TEST(RoadmapFile, AFileIsReadAsItWasWritten) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / "amble_roadmap_file_test.roadmap";
  writeRoadmap(small(), file);
  EXPECT_EQ(packRoadmap(readRoadmap(file)), packRoadmap(small()));
  std::filesystem::remove(file);
  EXPECT_THROW(readRoadmap(file), InputError);
}

}  // namespace
}  // namespace amble
