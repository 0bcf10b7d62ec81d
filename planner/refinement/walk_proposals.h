/// What may be tried to make a walk better: stretches of it walked by other ways (refine_walk.h
/// says which are taken).
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "base/sample_stream.h"
#include "planner/refinement/edge_path.h"

namespace amble {

/// Walk from node `first` to node `last` by way of these, instead of as it is now.
struct Proposal {
  int first = 0;
  int last = 0;
  std::vector<Stance> between;
};

/// Of a path as it is when they are asked for.
class WalkProposals {
 public:
  /// @pre `path` outlives it
  WalkProposals(const EdgePath& path, std::uint64_t seed) : path_(path), seed_(seed) {}
  /// Whether stances that walk slower than planned are proposed too.
  void walkSlower(bool slower) { slower_ = slower; }

  /// Pass 1: direct edges between two nodes, the widest apart first.
  std::vector<Proposal> shortcuts() const;
  /// Pass 2: ways to walk by node i, and, after those, to stand there with one turn instead of two.
  std::vector<Proposal> passings(int i) const;
  /// Pass 3: ways that leave an edge to one side; ways by places around a node that is walked
  /// through.
  std::vector<Proposal> asideOfEdge(int i) const;
  std::vector<Proposal> besideNode(int i) const;
  /// Pass 4: the one of an index in a round, from a stream of its own; none where it comes to none.
  std::optional<Proposal> random(int round, int index) const;

 private:
  std::optional<Proposal> moveNode(SampleStream& stream) const;
  std::optional<Proposal> cutOff(SampleStream& stream) const;
  std::optional<Proposal> goBy(SampleStream& stream) const;
  std::pair<int, Stance> pointOfWalk(double s, double pace) const;
  double anyPace(SampleStream& stream) const;

  const EdgePath& path_;
  std::uint64_t seed_;
  bool slower_ = false;
};

}  // namespace amble
