/// A roadmap without start and goal, to be asked many times: what of it is kept.
///
/// An edge is a function of two stances: steering makes the same walk of them again, to the bit. So
/// of an edge only its ends and its cost are kept, and the walk is made again when it is first on
/// the way of a query. A file of them is small, and it can lie about what is cheap but not about
/// what is walked: no curve, pose or contact is taken from it.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "planner/plan_request.h"

namespace amble {

class SampledRoadmap;

/// What a roadmap was made of, in four parts: named values, as text. A file is its SHA-256.
struct RoadmapSource {
  using Values = std::map<std::string, std::string>;
  Values scene, library, character, settings;

  /// Its parts by name, in this order.
  std::array<std::pair<const char*, const Values*>, 4> parts() const {
    return {{{"scene", &scene},
             {"library", &library},
             {"character", &character},
             {"settings", &settings}}};
  }
};

struct KeptRoadmap {
  struct Node {
    Stance stance;  ///< standing
    NodeKind kind = NodeKind::kGuard;
  };
  /// From a node to another; there may be none back.
  struct Edge {
    int from = -1, to = -1;
    double cost = 0.0;  ///< WalkEdge::cost [s, >= 0]
  };

  RoadmapSource source;
  std::uint64_t seed = 1;
  int max_failures = 0;
  long long samples = 0;  ///< that were drawn
  double coverage = 0.0;  ///< estimated share of the free space that guards cover [0 to 1]
  std::vector<Node> nodes;
  std::vector<Edge> edges;

  int count(NodeKind kind) const;
  /// Parts that walks lead between both ways: strongly connected.
  int pieces() const;
};

/// What of the source is another, in words: "scene (piano.obj) and settings (speed 1.2, was 1)"; ""
/// where nothing is.
std::string whatChanged(const RoadmapSource& then, const RoadmapSource& now);
/// SHA-256 of a part: of a line for each of its values, name and value with a blank between.
std::string digestOf(const RoadmapSource::Values& values);

/// Nodes, edges and counts of one that was filled.
KeptRoadmap keep(const SampledRoadmap& grown);

}  // namespace amble
