/// The shortest way from anywhere to anywhere over a kept roadmap, with as few edges steered as can
/// be: start and goal are not put into the roadmap, which stays as it is.
///
/// Candidates are the straight way from start to goal, an edge from the start to every node and one
/// from every node to the goal, each as cheap as no walk can beat. The cheapest way over them and
/// over what is kept is looked for (Dijkstra); what on it does not look free (Steering::looksFree)
/// is held to cost kDoubt times as much, and the search is made again; what looks free, or is still
/// cheapest, is steered. What steering refuses is struck out, and the search goes on; the first way
/// that is walked whole is the answer (Bohlin and Kavraki, "Path planning using lazy PRM", ICRA
/// 2000). So where nothing is in between one edge is steered, and around things few more.
///
/// Edges of the roadmap are made when they are first on a way, once, and then kept: they depend on
/// their ends only, and so no answer depends on what was asked before or at the same time.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "planner/roadmap/kept_roadmap.h"
#include "planner/search_limits.h"
#include "planner/steering/steering.h"

namespace amble {

/// Threads may share it, each with its own scratch.
class KeptSearch {
 public:
  static constexpr double kDoubt = 30.0;  ///< by trial: 10 steers more in vain, 1000 no less

  /// @pre steering outlives it; edges lead between nodes that are there.
  KeptSearch(const Steering& steering, KeptRoadmap roadmap);

  const KeptRoadmap& roadmap() const { return roadmap_; }

  /// Edges that follow one another from one place to the other, each made and checked by steering;
  /// none where the roadmap knows no way, or limits.stopped(). @param count  of what was steered,
  /// kept edges included, whether they were made now or before
  std::optional<std::vector<WalkEdge>> walk(const Waypoint& from, const Waypoint& to,
                                            const SearchLimits& limits, SteeringScratch& scratch,
                                            SteeringCount& count) const;

 private:
  class Query;
  const SteerResult& made(int edge, SteeringScratch& scratch) const;

  const Steering& steering_;
  const KeptRoadmap roadmap_;
  std::vector<Waypoint> places_;       // by node
  std::vector<std::vector<int>> out_;  // edges from each node
  struct Made {
    std::once_flag once;
    SteerResult result;
  };
  const std::unique_ptr<Made[]> made_;  // by edge
};

}  // namespace amble
