/// What roadmaps that grow by samples share: samples judged in order of their index, on any number
/// of threads.
///
/// A batch of samples is judged ahead, in parallel, against the roadmap as it stands; steering's
/// answers are remembered with the sample. Then they are judged again one after another, each
/// against the roadmap that those before it left, which asks steering only what has become new. So
/// the roadmap depends on seed and indices, not on threads.
///
/// First come the ways that steering's guide knows, if it knows any: the places of each become
/// nodes, and where an edge between them is refused the guide is told. If none of them is walked it
/// is asked for a proof that nothing leads there, which ends the search, and then for the narrowest
/// place of the widest way. Walks straight through that are asked first, a few hundred, that begin
/// and end at different distances: arms swing alike only so. Then max_failures uniform samples are
/// drawn around it before others, whether they add guards or not, a quarter of them where those
/// walks were refused, unless something lies right across that steps may lead up to elsewhere; and
/// where not even the guide finds a way through it there are no others. On stairs nobody stands to
/// begin such walks: there it is those over the passages by that place, where something is right in
/// the way, with no more room beside it.
///
/// Large maps are looked at from the near to the far: start and goal are asked about first, then
/// the passages and samples of a region around both, which widens when most of it is covered. Where
/// the bounds are no wider than the first region it is all of them.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "planner/roadmap/roadmap.h"
#include "planner/roadmap/stance_sampler.h"
#include "planner/search_limits.h"
#include "planner/steering/edge_memory.h"

namespace amble {

struct TriedWalk;

/// An edge that was refused, for the report of why there is no walk.
struct RefusedLink : RefusedEdge {
  /// Nodes; a sample that was thrown away is stood for by the node that covered it. -1: of a walk
  /// straight through a narrow place.
  int from_node = -1, to_node = -1;
};

/// A place that may become a node, with what steering said about it so far.
struct Candidate {
  Waypoint at;
  bool enter = true, leave = true;  ///< edges may end here, begin here
  bool end = false;                 ///< of a query or a passage: kept in any case
  bool far = false;                 ///< of a query: nodes are asked however far they are
  bool all_round = true;            ///< the body can stand there by any heading
  bool counted = true;      ///< as a failure unless it becomes a guard, which sets the count back
  EdgeMemory answers = {};  ///< places are nodes by number, and kCandidate
  EdgeMemory known = {};    ///< what was asked and counted before it was judged
  /// What judging it asks is not steered one by one, but left open: all at once, on all threads.
  bool asks_together = false;
};
inline constexpr PlaceId kCandidate = -1;

/// One question that a judgement rests on.
struct Question {
  int node = -1;
  bool to_node = false;  ///< from the candidate to the node, or the other way

  PlaceId from() const { return to_node ? kCandidate : node; }
  PlaceId to() const { return to_node ? node : kCandidate; }
};

struct Verdict {
  bool keep = false;
  NodeKind kind = NodeKind::kSample;
  int stands_for = -1;              ///< of one that is not kept: a node that covers it, or -1
  std::vector<Question> questions;  ///< in order; every edge that was found is kept with the node
  /// What has to be answered before there is a verdict, whatever the answers are. The rest then
  /// says nothing.
  std::vector<Question> open = {};
};

/// Not for threads to share: it starts its own.
class SampledRoadmap {
 public:
  /// @pre the sampler's steering outlives the roadmap.
  explicit SampledRoadmap(const StanceSampler& sampler)
      : steering_(sampler.steering()), sampler_(sampler) {}
  virtual ~SampledRoadmap() = default;

  /// An end of a query, which becomes a node; one that is there already is found again. @return the
  /// node
  int insert(const Waypoint& at, bool enter, bool leave, int threads = 1);

  /// Adds the ends of passages, each once, and samples until walks lead from one node to the other,
  /// the counted limit is reached for all of the bounds, or limits.stopped().
  /// A proof that none leads there ends it before any sample. @return whether walks lead there
  bool connect(int from, int to, const SearchLimits& limits);

  /// Without a query: adds the ends of all passages, and samples from all of the bounds until the
  /// counted limit is reached or limits.stopped(). What then is in pieces is joined by ways over a
  /// map where they are walked: each piece with the nearest of the others.
  void fill(const SearchLimits& limits);

  void clear();  ///< as if made anew

  const Roadmap& roadmap() const { return roadmap_; }
  const SteeringCount& steering() const { return count_; }
  const std::vector<RefusedLink>& refused() const { return refused_; }
  long long samples() const { return samples_; }
  int failures() const { return failures_; }  ///< in a row, now

  /// Of the last connect() that failed: the proof that no walk leads there, where there is one.
  const std::optional<SteeringFailure>& shutOff() const { return shut_off_; }

  /// Of the last connect(): the shortest way over the map of the room that the body has, and its
  /// narrowest place if there is hardly room; empty, or none, where no map was asked.
  const std::vector<Eigen::Vector3d>& way() const { return way_; }
  const std::optional<WayGuide::Narrow>& narrow() const { return narrow_; }

  /// Estimated share of the free space that is covered [0 to 1]; 0 where the method knows none.
  virtual double coverage() const { return 0.0; }

 protected:
  /// What becomes of a candidate, given the roadmap as it is. Steering's answers are left in the
  /// candidate.
  virtual Verdict judge(Candidate& candidate, SteeringScratch& scratch) const = 0;
  virtual long long effort() const = 0;  ///< what is compared with max_failures
  virtual void resetEffort() = 0;        ///< when the region has become wider
  void setFailures(int failures) { failures_ = failures; }

  /// What samples are drawn for: walks from node to node; -1: to cover all of the bounds.
  struct Query {
    int from = -1, to = -1;
  };
  const Query& query() const { return query_; }

  /// Asks steering unless the candidate knows the answer; notes the question. @return whether there
  /// is an edge; none where that is left open
  std::optional<bool> ask(Candidate& candidate, Question question, Verdict& verdict,
                          SteeringScratch& scratch) const;
  /// The same, content with that there looks to be an edge (Steering::looksFree). Most candidates
  /// are thrown away, and their edges with them: only those of one that is kept are made, and where
  /// one of them is refused the candidate is judged again.
  std::optional<bool> askRoughly(Candidate& candidate, Question question, Verdict& verdict,
                                 SteeringScratch& scratch) const;
  /// Whether the answer is known to be an edge, or there looks to be one, which askRoughly() then
  /// is content with.
  bool looksFree(Candidate& candidate, Question question, SteeringScratch& scratch) const;

 private:
  struct Draft;
  using Scratches = std::vector<SteeringScratchPtr>;  // one for each thread
  Scratches scratchesFor(int threads) const;
  std::vector<Draft> draft(const StanceSampler& sampler, const SearchLimits& limits,
                           Scratches& scratches) const;
  // What ends it: so much effort, or so many samples more.
  struct Budget {
    int effort;
    long long samples = std::numeric_limits<long long>::max();
  };
  bool grow(int from, int to, const StanceSampler& sampler, const Budget& budget,
            const SearchLimits& limits, Scratches& scratches);
  bool leads(int from, int to) const;
  void joinPieces(const SearchLimits& limits, Scratches& scratches);
  std::optional<std::pair<int, int>> nearestOutside(int node) const;
  void followWaysNear(int from, int to, const SearchLimits& limits, Scratches& scratches);
  int insert(Candidate candidate, Scratches& scratches);
  std::optional<bool> askMap(WayGuide* guide, int from, int to, const SearchLimits& limits,
                             Scratches& scratches);
  bool isShutOff(int from, int to, const SearchLimits& limits, Scratches& scratches);
  std::unique_ptr<WayGuide> findWays(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                     const SearchLimits& limits);
  void noteWay(const std::vector<Stance>& way, int from, int to);
  bool followWays(WayGuide& guide, int from, int to, const SearchLimits& limits,
                  Scratches& scratches);
  std::optional<Eigen::Vector3d> firstRefused(const std::vector<int>& nodes) const;
  int commit(Candidate& candidate, Scratches& scratches);
  std::vector<Question> unanswered(const Candidate& candidate, const Verdict& verdict) const;
  Verdict judgeExactly(Candidate& candidate, Scratches& scratches) const;
  SteerResult steer(const Candidate& candidate, Question question, SteeringScratch& scratch) const;
  void insertPassages(const Eigen::AlignedBox2d& region, const SearchLimits& limits,
                      Scratches& scratches);
  void insertTried(TriedWalk walk, Scratches& scratches);
  bool isRefusedOverPassages(const Eigen::Vector3d& at) const;
  std::optional<bool> askNarrow(const WayGuide::Narrow& narrow, int from, int to,
                                const SearchLimits& limits, Scratches& scratches);
  void note(const Waypoint& from, const Waypoint& to, const SteerResult& result);

  const Steering& steering_;
  StanceSampler sampler_;
  Roadmap roadmap_;
  SteeringCount count_;
  std::vector<RefusedLink> refused_;
  std::optional<SteeringFailure> shut_off_;
  std::vector<Eigen::Vector3d> way_;
  std::optional<WayGuide::Narrow> narrow_;
  long long samples_ = 0;
  int failures_ = 0;
  Query query_;
  std::optional<std::vector<StancePair>> passages_;  // those that are not inserted yet
  // Ends of walks over those that are, and whether one was found.
  std::vector<std::pair<StancePair, bool>> over_passages_;
};

}  // namespace amble
