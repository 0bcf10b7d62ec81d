#include "planner/refine_walk.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "planner/refinement/walk_proposals.h"

namespace amble {
namespace {

// Less is rounding: durations are whole numbers of frames [s].
constexpr double kRounding = 1e-6;
// What an edge may cost is told with so much to spare, against the rounding of sums [s].
constexpr double kSlack = 1e-6;
// A radian that the path bends counts as so much time, and a proposal must gain so much: a bend
// that saves a frame because steps happen to come out whole looks like a stagger. By trial.
constexpr double kBendCost = 0.3;  // [s/rad]
constexpr double kGain = 0.05;     // [s]
// Rounds of pass 4: at most, and in a row without help until it ends. By trial: a long walk has
// more to gain.
constexpr int kMostRounds = 12;
constexpr int kIdleRounds = 3;
// Pass 3: edges are let be whose nearness to things costs less [s]; a node is moved so often at
// most.
constexpr double kUneasy = 0.1;
constexpr int kMostMoves = 8;

struct Answer {
  std::vector<WalkEdge> edges;  // empty where it is no help
  SteeringCount count;
};

// The same place of the plane on the same floor.
bool samePlace(const Stance& a, const Stance& b) {
  constexpr double kStorey = 0.5;  // floors over one another are farther apart [m]
  return inPlan(a) == inPlan(b) && std::abs(a.position.z() - b.position.z()) < kStorey;
}

// How far the edge's path turns, to either side [rad].
double bend(const WalkEdge& edge) {
  constexpr int kSamples = 24;
  if (edge.path.empty()) return 0.0;
  double sum = 0.0, last = edge.path.at(0.0).heading;
  for (int i = 1; i <= kSamples; ++i) {
    const double heading = edge.path.at(edge.length * i / kSamples).heading;
    sum += std::abs(heading - last);
    last = heading;
  }
  return sum;
}

class Refiner {
 public:
  Refiner(const Steering& steering, EdgePath path, const SearchLimits& limits, SteeringCount& count)
      : steering_(steering), path_(std::move(path)), limits_(limits), count_(count) {
    for (int i = 0; i < limits.threads; ++i) scratches_.push_back(steering.makeScratch());
  }

  void shortcuts();
  /// Passes 2 and 3 until nothing helps; stances that walk slower than planned are tried where
  /// `slower`.
  void walkOn(int tries, bool slower);
  bool stops() const { return path_.stops() > 0; }
  EdgePath take() { return std::move(path_); }

 private:
  bool stopped() const { return limits_.stopped(); }
  void passStops();
  void keepAway();
  bool tries(int round, int tries);
  bool leavesOutPinned(const Proposal& proposal) const;
  // What a proposal has to be better than, and what it has of that so far.
  struct Tally {
    double old_duration = 0.0;  // of what it replaces, as cost [s]
    double duration = 0.0;      // of its own edges, the same [s]
    double straightened = 0.0;  // by how much less they bend [rad]

    void add(const WalkEdge& edge) {
      duration += edge.cost();
      straightened -= bend(edge);
    }
  };
  double leastDuration(const std::vector<Waypoint>& way, size_t from) const;
  bool mayHelp(const Tally& so_far, const std::vector<Waypoint>& way, size_t from) const;
  double mostFor(const Tally& so_far, const std::vector<Waypoint>& way, size_t edge) const;
  Answer judge(const Proposal& proposal, SteeringScratch& scratch) const;
  int firstThatHelps(const std::vector<Proposal>& proposals);
  void take(const Proposal& proposal, std::vector<WalkEdge> edges);

  const Steering& steering_;
  EdgePath path_;
  const SearchLimits& limits_;
  SteeringCount& count_;
  std::vector<SteeringScratchPtr> scratches_;
  WalkProposals ways_{path_, limits_.seed};
};

bool Refiner::leavesOutPinned(const Proposal& proposal) const {
  for (int i = proposal.first + 1; i < proposal.last; ++i) {
    if (!path_.pinned[i]) continue;
    const Stance& pin = path_.edges[i].from;
    if (std::none_of(proposal.between.begin(), proposal.between.end(),
                     [&](const Stance& stance) { return samePlace(stance, pin); })) {
      return true;
    }
  }
  return false;
}

double Refiner::leastDuration(const std::vector<Waypoint>& way, size_t from) const {
  double length = 0.0;
  for (size_t i = from; i + 1 < way.size(); ++i)
    length += (inPlan(way[i + 1].stance) - inPlan(way[i].stance)).norm();
  return length / steering_.topSpeed();
}

// Where what is left is as quick as can be.
bool Refiner::mayHelp(const Tally& so_far, const std::vector<Waypoint>& way, size_t from) const {
  return so_far.duration + leastDuration(way, from) <= so_far.old_duration + kRounding;
}

// What an edge may cost for the whole to help, by the last line of judge(), if what is left is as
// quick and as straight as can be [s].
double Refiner::mostFor(const Tally& so_far, const std::vector<Waypoint>& way, size_t edge) const {
  const double may_be =
      so_far.old_duration + std::min(0.0, kBendCost * so_far.straightened - kGain);
  return may_be - so_far.duration - leastDuration(way, edge + 1) + kRounding + kSlack;
}

// Edges along the proposal, if they are all allowed and cost less, in time and effort, than what
// they replace. An edge is made once the next one may be there too.
Answer Refiner::judge(const Proposal& proposal, SteeringScratch& scratch) const {
  Answer answer;
  if (leavesOutPinned(proposal)) return answer;
  std::vector<Waypoint> way = {path_.node(proposal.first)};
  for (const Stance& stance : proposal.between) {
    way.push_back({stance, false, true});
    if (!steering_.place(way.back().stance)) return answer;
  }
  way.push_back(path_.node(proposal.last));
  Tally tally;
  for (int i = proposal.first; i < proposal.last; ++i) {
    tally.old_duration += path_.edges[i].cost();
    tally.straightened += bend(path_.edges[i]);
  }
  std::vector<WalkEdge> edges;
  for (size_t i = 0; i + 1 < way.size(); ++i) {
    if (!mayHelp(tally, way, i)) return answer;
    const double most = mostFor(tally, way, i);
    const Steering::LeadsOn leads_on = [&](const WalkEdge& planned) {
      Tally then = tally;
      then.add(planned);
      then.duration -= kSlack;
      Waypoint here = way[i + 1];
      here.stance = planned.to;
      return mayHelp(then, way, i + 1) &&
             steering_.mayLead(here, way[i + 2], mostFor(then, way, i + 1), scratch);
    };
    const SteerResult result = i + 2 < way.size()
                                   ? steering_.steerOn(way[i], way[i + 1], most, leads_on, scratch)
                                   : steering_.steerWithin(way[i], way[i + 1], most, scratch);
    answer.count.add(result);
    if (!result.edge) return answer;
    tally.add(*result.edge);
    if (i + 2 < way.size()) way[i + 1].stance = result.edge->to;
    edges.push_back(*result.edge);
  }
  const double gain = tally.old_duration - tally.duration + kBendCost * tally.straightened;
  if (tally.duration <= tally.old_duration + kRounding && gain >= kGain)
    answer.edges = std::move(edges);
  return answer;
}

void Refiner::take(const Proposal& proposal, std::vector<WalkEdge> edges) {
  std::vector<bool> pinned(path_.pinned.begin(), path_.pinned.begin() + proposal.first + 1);
  for (size_t i = 0; i + 1 < edges.size(); ++i) {
    bool pin = false;
    for (int k = proposal.first + 1; k < proposal.last; ++k) {
      pin = pin || (path_.pinned[k] && samePlace(path_.edges[k].from, edges[i].to));
    }
    pinned.push_back(pin);
  }
  pinned.insert(pinned.end(), path_.pinned.begin() + proposal.last, path_.pinned.end());
  std::vector<WalkEdge>& all = path_.edges;
  const auto place = all.erase(all.begin() + proposal.first, all.begin() + proposal.last);
  all.insert(place, std::make_move_iterator(edges.begin()), std::make_move_iterator(edges.end()));
  path_.pinned = std::move(pinned);
  assert(path_.pinned.size() == path_.edges.size() + 1);
}

// Takes the first proposal that helps and returns its index; -1 where none does. Threads go on to
// the next ones until one helps: of those before it all are judged, whoever is first, and of those
// after it nothing is used.
int Refiner::firstThatHelps(const std::vector<Proposal>& proposals) {
  const int total = static_cast<int>(proposals.size());
  std::vector<Answer> answers(total);
  std::atomic<bool> cut_short{false};
  const int taken = firstOf(total, limits_.threads, [&](int i, int thread) {
    if (stopped()) cut_short = true;
    if (cut_short) return true;
    answers[i] = judge(proposals[i], *scratches_[thread]);
    return !answers[i].edges.empty();
  });
  for (int i = 0; i <= std::min(taken, total - 1); ++i) count_.add(answers[i].count);
  if (cut_short || taken == total) return -1;
  take(proposals[taken], std::move(answers[taken].edges));
  return taken;
}

void Refiner::shortcuts() {
  while (firstThatHelps(ways_.shortcuts()) >= 0) {
  }
}

void Refiner::passStops() {
  for (int i = 1; i < path_.last() && !stopped(); ++i) {
    if (path_.node(i).stance.standing) firstThatHelps(ways_.passings(i));
  }
}

void Refiner::keepAway() {
  for (int i = 0; i < path_.last() && !stopped(); ++i)
    if (!path_.edges[i].path.empty() && path_.edges[i].unease >= kUneasy)
      firstThatHelps(ways_.asideOfEdge(i));
  for (int i = 1; i < path_.last() && !stopped(); ++i) {
    const auto uneasy = [&] {
      return path_.edges[i - 1].unease + path_.edges[i].unease >= kUneasy;
    };
    if (path_.pinned[i] || path_.node(i).stance.standing) continue;
    for (int k = 0; k < kMostMoves && uneasy() && firstThatHelps(ways_.besideNode(i)) >= 0; ++k) {
    }
  }
}

bool Refiner::tries(int round, int tries) {
  bool helped = false;
  for (int next = 0; next < tries && !stopped();) {
    std::vector<Proposal> proposals;
    std::vector<int> index;
    for (int i = next; i < tries; ++i) {
      if (auto proposal = ways_.random(round, i)) {
        proposals.push_back(std::move(*proposal));
        index.push_back(i);
      }
    }
    const int taken = firstThatHelps(proposals);
    if (taken < 0) return helped;
    helped = true;
    next = index[taken] + 1;
    if (limits_.progress) limits_.progress({"refine", next, tries, 0, 0});
  }
  return helped;
}

void Refiner::walkOn(int most_tries, bool slower) {
  ways_.walkSlower(slower);
  passStops();
  keepAway();
  for (int round = 0, idle = 0; round < kMostRounds && idle < kIdleRounds && !stopped(); ++round) {
    if (!tries(round, most_tries)) {
      ++idle;
      continue;
    }
    idle = 0;
    shortcuts();
    passStops();
    keepAway();
  }
}

}  // namespace

EdgePath refineWalk(const Steering& steering, EdgePath path, const RefineSettings& settings,
                    const SearchLimits& limits, SteeringCount& count) {
  assert(!path.edges.empty() && path.pinned.size() == path.edges.size() + 1);
  Refiner refiner(steering, std::move(path), limits, count);
  refiner.shortcuts();
  if (!settings.walk_on) return refiner.take();
  refiner.walkOn(settings.tries, false);
  if (refiner.stops()) refiner.walkOn(settings.tries, true);
  return refiner.take();
}

}  // namespace amble
