/// A planner that is made once and asked many times, from as many threads as like.
///
///     const Planner planner(problem);                             // once
///     const PlanOutcome outcome = planner.plan({start, goal});    // any time, from any thread
///
/// What it keeps is a roadmap that no query adds to: start and goal are joined to it for the time
/// of their own query (planner/roadmap/kept_search.h). So an answer depends on the query alone, to
/// the bit, and not on those before it, beside it, or on threads. What the roadmap does not answer
/// is searched as planWalk searches it, so there is a walk wherever planWalk finds one. Every walk
/// is refined, and checked as a whole, as planWalk's are.
///
/// A visibility roadmap is next to a tree: between rooms with several doors it knows one way, which
/// may be a long one, and refinement leads by no other door.
#pragma once

#include <memory>

#include "planner/plan_request.h"

namespace amble {

struct KeptRoadmap;  // kept_roadmap.h

struct PlanQuery {
  PlanEnd start, goal;
  std::vector<Eigen::Vector3d> via = {};  ///< passed in order, by any heading [m, World]
};

class Planner {
 public:
  /// Failures in a row after which a roadmap that is kept is good enough: more cost many times as
  /// much, for crannies that hardly anybody asks for and that are searched then. By trial.
  static constexpr int kFailures = 25;

  /// The roadmap of a problem, whose start, goal and via points are not looked at: a visibility
  /// roadmap of all of the bounds, until limits.max_failures failures in a row or limits.stopped().
  /// The same at any number of limits.threads. Its `source` is left empty.
  static KeptRoadmap grow(const PlanRequest& problem);

  /// Of the roadmap that grow() makes. @pre, @throws as below
  explicit Planner(const PlanRequest& problem);
  /// @param problem  what queries have in common; its own start, goal and via points are not looked
  /// at, and what its pointers lead to outlives the planner
  /// @param roadmap  of the same problem, grown now or kept in a file
  /// @throws std::invalid_argument as planWalk, and for a roadmap whose edges lead nowhere
  Planner(const PlanRequest& problem, KeptRoadmap roadmap);
  ~Planner();
  Planner(Planner&&) noexcept;

  /// @throws std::invalid_argument as planWalk.
  PlanOutcome plan(const PlanQuery& query) const { return plan(query, limits()); }
  /// By limits of its own: a deadline, a stop. @param limits  .seed is that of refinement, and of
  /// the search where the roadmap does not answer
  PlanOutcome plan(const PlanQuery& query, const SearchLimits& limits) const;

  const SearchLimits& limits() const;  ///< the problem's
  const KeptRoadmap& roadmap() const;
  /// The roadmap to look at. A file holds no curves: each edge is drawn along the root path that is
  /// the likeliest between its ends (walk_proposals.h).
  RoadmapPicture picture() const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

}  // namespace amble
