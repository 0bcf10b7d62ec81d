/// The visibility roadmap (Siméon, Laumond and Nissoux, "Visibility-based probabilistic roadmaps
/// for motion planning", Advanced Robotics 14(6), 2000), for directed edges.
///
/// Nodes are guards, no two of which cover each other, and connectors, which join what could not be
/// walked before. What the paper's symmetric "sees" becomes here:
/// - A guard covers a sample when walks lead both ways between them. In each component (strongly
///   connected) the guards are asked one after another, the nearest first, until one covers the
///   sample. An edge that is found in one direction only is kept with the node.
/// - A sample that no guard covers becomes a guard. One through which some node can be walked to
///   that could not be before becomes a connector: with walks both ways that is the paper's "sees
///   guards of two components". Any other is thrown away.
/// - A guard is a place where the body can stand by any heading. Samples in narrow passages, where
///   it stands by one heading only, become connectors or nothing: as guards they would cover next
///   to nothing, since one turns on the spot at a node, and there are many such crannies between
///   things. So a passage too narrow to turn in, with a bend that no edge walks through, is not
///   found.
/// - Headings: a node is a standing stance with a sampled heading. It may be entered and left by
///   any heading, since the walker turns on the spot there; the turn is a part of the edge and
///   checked with it.
/// - Failures: M = max_failures uniform samples in a row that made no guard stop the search, and
///   1 - 1/M estimates the covered share of the places where the body can stand by any heading
///   (stance_sampler.h). As in the paper a connector does not set the count back; it counts as a
///   failure. Samples of the bridge test become guards and connectors too, but are not counted and
///   set nothing back, since the estimate is about uniform ones.
/// - Ends of a query are the first guards, and stay guards even where one covers the other. An end
///   that can only be left or only be entered (a free heading, a stance that walks) is a terminal:
///   it covers nothing, and is asked only where it could join.
/// - Guards farther than kFarthestGuard are not asked: a guard's domain is as large as a hall, not
/// as a map, and no walk that is worth a check leads through all of it. Ends of a query ask all.
/// - The search ends as soon as walks lead from start to goal; it does not wait for walks back.
/// - Of a sample that is to join start and goal only what could is asked. Walks to where one gets
///   from the start anyway, and from where one gets to the goal anyway, are on no way that is still
///   missing: who walks one of them at last could leave it out. So of the guards beyond what is in
///   the way a sample on the start's side asks whether it leads there, one on the goal's side
///   whether they lead to it, and those of its own side only until one covers it. A sample that is
///   kept asks all the rest as well, for other queries and for shorter ways; what is thrown away
///   although it would have joined something, where that was of no use, is all that is lost. So as
///   many samples are guards, as many failures, and start and goal are joined by the same sample.
#pragma once

#include "planner/roadmap/sampled_roadmap.h"

namespace amble {

class VisibilityRoadmap : public SampledRoadmap {
 public:
  using SampledRoadmap::SampledRoadmap;

  /// 1 - 1/failures, of the failures in a row so far [0 to 1).
  double coverage() const override { return failures() > 0 ? 1.0 - 1.0 / failures() : 0.0; }

 protected:
  Verdict judge(Candidate& candidate, SteeringScratch& scratch) const override;
  long long effort() const override { return failures(); }
  void resetEffort() override { setFailures(0); }

 private:
  struct Sides;
  Verdict judge(Candidate& candidate, const Sides* sides, SteeringScratch& scratch) const;
  void askFree(Candidate& candidate, const std::vector<int>& guards, Verdict& verdict,
               SteeringScratch& scratch) const;
  bool askGuards(Candidate& candidate, const Sides* sides, Verdict& verdict,
                 SteeringScratch& scratch) const;
  void askTerminals(Candidate& candidate, Verdict& verdict, SteeringScratch& scratch) const;
  bool joins(const Candidate& candidate, const Verdict& verdict) const;
  std::vector<int> guardsByDistance(const Candidate& candidate) const;
};

}  // namespace amble
