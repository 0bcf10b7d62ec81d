#include "planner/roadmap/kept_roadmap.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/sample_stream.h"
#include "planner/roadmap/roadmap.h"

namespace amble {
namespace {

TEST(KeptRoadmap, PiecesAreTheStronglyConnectedComponents) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SampleStream stream(seed, 0);
    const int size = 1 + stream.below(12);
    KeptRoadmap kept;
    Roadmap graph;
    for (int i = 0; i < size; ++i) {
      kept.nodes.emplace_back();
      graph.addNode({});
    }
    for (int i = stream.below(3 * size); i > 0; --i) {
      const int from = stream.below(size), to = stream.below(size);
      if (from == to || graph.hasEdge(from, to)) continue;
      kept.edges.push_back({from, to, 1.0});
      graph.addEdge(from, to, {});
    }
    const std::vector<int> component = graph.components();
    EXPECT_EQ(kept.pieces(), 1 + *std::max_element(component.begin(), component.end())) << seed;
  }
  EXPECT_EQ(KeptRoadmap{}.pieces(), 0);
}

TEST(KeptRoadmap, WhatChangedNamesThePartsAndTheirValues) {
  RoadmapSource then;
  then.scene = {{"room.yaml", std::string(64, 'a')}, {"door.obj", std::string(64, 'b')}};
  then.character = {{"height", "1.75"}};
  EXPECT_EQ(whatChanged(then, then), "");
  RoadmapSource now = then;
  now.scene["door.obj"] = std::string(64, 'c');
  now.scene.erase("room.yaml");
  now.character["height"] = "1.6";
  now.settings["speed"] = "1.2";
  EXPECT_EQ(whatChanged(then, now),
            "scene (door.obj; room.yaml is gone), character (height 1.6, was 1.75) and settings "
            "(speed 1.2)");
}

}  // namespace
}  // namespace amble
