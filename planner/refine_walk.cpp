#include "planner/refine_walk.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "base/parallel.h"
#include "base/rotation.h"
#include "base/sample_stream.h"

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
// Pass 1: nodes farther apart than this are not joined: what could be is by the roadmap [m].
constexpr double kFarthestShortcut = 20.0;
// Pass 2: how far from the node to the line between its neighbours, and headings off that line's.
constexpr std::array<double, 5> kPulls = {0.5, 0.25, 0.0, 0.75, 1.0};
constexpr std::array<double, 5> kTurns = {0.0, 20 * kDegree, -20 * kDegree, 40 * kDegree,
                                          -40 * kDegree};
// And how fast, of the plan's speed: slower where nothing passes at that.
constexpr std::array<double, 3> kPaces = {1.0, 0.7, 0.5};
// Pass 3: an edge that goes near things is led past them: from where along it, and how far aside
// [m]; a node between such edges is moved: along, aside [m] and turned. Not where that costs less
// than kUneasy [s].
constexpr std::array<double, 3> kShares = {0.5, 0.3, 0.7};
constexpr std::array<double, 6> kAside = {0.2, -0.2, 0.4, -0.4, 0.1, -0.1};
struct Move {
  double along, aside, turn;
};
constexpr std::array<Move, 10> kMoves = {{{0.0, 0.15, 0.0},
                                          {0.0, -0.15, 0.0},
                                          {0.0, 0.0, 15 * kDegree},
                                          {0.0, 0.0, -15 * kDegree},
                                          {0.2, 0.0, 0.0},
                                          {-0.2, 0.0, 0.0},
                                          {0.0, 0.15, 15 * kDegree},
                                          {0.0, 0.15, -15 * kDegree},
                                          {0.0, -0.15, 15 * kDegree},
                                          {0.0, -0.15, -15 * kDegree}}};
constexpr double kUneasy = 0.1;
constexpr int kMostMoves = 8;
// How far from a corner it is cut [m]: about the radius of the tightest walks and more.
constexpr std::array<double, 3> kCuts = {0.6, 0.9, 1.3};
// Pass 4: how far a random stance lies from where it is looked for [m], and how far its heading is
// off [rad].
constexpr double kStray = 0.25;
constexpr double kFarStray = 1.0;  // every other time
constexpr double kTwist = 40 * kDegree;

/// Walk from node `first` to node `last` by way of these, instead of as it is now.
struct Proposal {
  int first = 0;
  int last = 0;
  std::vector<Stance> between;
};

struct Answer {
  std::vector<WalkEdge> edges;  // empty where it is no help
  SteeringCount count;
};

Eigen::Vector2d at(const Stance& stance) { return stance.position.head<2>(); }

// The same place of the plane on the same floor.
bool samePlace(const Stance& a, const Stance& b) {
  constexpr double kStorey = 0.5;  // floors over one another are farther apart [m]
  return at(a) == at(b) && std::abs(a.position.z() - b.position.z()) < kStorey;
}

double direction(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return std::atan2(to.y() - from.y(), to.x() - from.x());
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

Eigen::Vector2d stray(SampleStream& stream) {
  const double far = stream.uniform() < 0.5 ? kStray : kFarStray;
  const double x = stream.uniform(-far, far);
  return {x, stream.uniform(-far, far)};
}

// `near`: the height at which ground is looked for [m].
Stance walking(const Eigen::Vector2d& position, double near, double heading, Side leading,
               double pace = 1.0) {
  Stance stance;
  stance.position << position, near;
  stance.heading = wrapAngle(heading);
  stance.standing = false;
  stance.leading = leading;
  stance.pace = pace;
  return stance;
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
  std::vector<Proposal> asideOfEdge(int i) const;
  std::vector<Proposal> besideNode(int i) const;
  bool tries(int round, int tries);
  int last() const { return static_cast<int>(path_.edges.size()); }  // node
  Waypoint node(int i) const;
  bool leavesOutPinned(const Proposal& proposal) const;
  double leastDuration(const std::vector<Waypoint>& way, size_t from) const;
  Answer judge(const Proposal& proposal, SteeringScratch& scratch) const;
  int firstThatHelps(const std::vector<Proposal>& proposals);
  void take(const Proposal& proposal, std::vector<WalkEdge> edges);
  std::vector<Proposal> passings(int i) const;
  std::optional<Proposal> moveNode(SampleStream& stream) const;
  std::optional<Proposal> cutOff(SampleStream& stream) const;
  std::optional<Proposal> goBy(SampleStream& stream) const;
  std::optional<Proposal> randomProposal(int round, int index) const;
  std::pair<int, Stance> pointOfWalk(double s, double pace) const;
  double anyPace(SampleStream& stream) const;

  const Steering& steering_;
  EdgePath path_;
  const SearchLimits& limits_;
  SteeringCount& count_;
  std::vector<SteeringScratchPtr> scratches_;
  bool slower_ = false;
};

Waypoint Refiner::node(int i) const {
  if (i == 0) return path_.start;
  if (i == last()) return path_.goal;
  return {path_.edges[i].from, false, false};
}

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
    length += (at(way[i + 1].stance) - at(way[i].stance)).norm();
  return length / steering_.topSpeed();
}

// Edges along the proposal, if they are all allowed and cost less, in time and effort, than what
// they replace.
Answer Refiner::judge(const Proposal& proposal, SteeringScratch& scratch) const {
  Answer answer;
  if (leavesOutPinned(proposal)) return answer;
  std::vector<Waypoint> way = {node(proposal.first)};
  for (const Stance& stance : proposal.between) {
    way.push_back({stance, false, true});
    if (!steering_.place(way.back().stance)) return answer;
  }
  way.push_back(node(proposal.last));
  double old_duration = 0.0, duration = 0.0, straightened = 0.0;
  for (int i = proposal.first; i < proposal.last; ++i) {
    old_duration += path_.edges[i].cost();
    straightened += bend(path_.edges[i]);
  }
  std::vector<WalkEdge> edges;
  for (size_t i = 0; i + 1 < way.size(); ++i) {
    if (duration + leastDuration(way, i) > old_duration + kRounding) return answer;
    // What it may cost for the whole to help, by the last line of this, if what is left is as quick
    // and as straight as can be.
    const double may_be = old_duration + std::min(0.0, kBendCost * straightened - kGain);
    const double most = may_be - duration - leastDuration(way, i + 1) + kRounding + kSlack;
    const SteerResult result = steering_.steerWithin(way[i], way[i + 1], most, scratch);
    answer.count.add(result);
    if (!result.edge) return answer;
    duration += result.edge->cost();
    straightened -= bend(*result.edge);
    if (i + 2 < way.size()) way[i + 1].stance = result.edge->to;
    edges.push_back(*result.edge);
  }
  const double gain = old_duration - duration + kBendCost * straightened;
  if (duration <= old_duration + kRounding && gain >= kGain) answer.edges = std::move(edges);
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
  std::atomic<int> first{total};  // that helps, of those judged so far
  std::atomic<bool> cut_short{false};
  parallelFor(total, limits_.threads, [&](int i, int thread) {
    if (i > first) return;
    if (stopped()) cut_short = true;
    if (cut_short) return;
    answers[i] = judge(proposals[i], *scratches_[thread]);
    if (answers[i].edges.empty()) return;
    for (int known = first; i < known && !first.compare_exchange_weak(known, i);) continue;
  });
  const int taken = first;
  for (int i = 0; i <= std::min(taken, total - 1); ++i) count_.add(answers[i].count);
  if (cut_short || taken == total) return -1;
  take(proposals[taken], std::move(answers[taken].edges));
  return taken;
}

void Refiner::shortcuts() {
  std::vector<Proposal> proposals;
  do {
    proposals.clear();
    for (int span = last(); span >= 2; --span) {
      for (int first = 0; first + span <= last(); ++first) {
        const Stance from = node(first).stance, to = node(first + span).stance;
        if ((at(from) - at(to)).norm() <= kFarthestShortcut)
          proposals.push_back({first, first + span, {}});
      }
    }
  } while (firstThatHelps(proposals) >= 0);
}

// Ways to walk by node i, and, after those, to stand there with one turn instead of two.
std::vector<Proposal> Refiner::passings(int i) const {
  const Eigen::Vector2d before = at(node(i - 1).stance), here = at(node(i).stance),
                        after = at(node(i + 1).stance);
  const Eigen::Vector2d middle = 0.5 * (before + after);
  const double along = direction(before, after);
  const double arriving = direction(before, here), leaving = direction(here, after);
  // Half way between arriving and leaving, which on a corner is where the line between the
  // neighbours goes, nearly.
  const double bisecting = arriving + 0.5 * wrapAngle(leaving - arriving);
  const double height = node(i).stance.position.z();
  std::vector<Proposal> proposals;
  for (const double pace : kPaces) {
    if (pace < 1.0 && !slower_) continue;
    for (const double pull : kPulls) {
      if (path_.pinned[i] && pull > 0.0) continue;
      for (const double turn : kTurns) {
        const double heading = (pull > 0.5 ? along : bisecting) + turn;
        const Eigen::Vector2d position =
            pull > 0.0 ? Eigen::Vector2d(here + pull * (middle - here)) : here;
        proposals.push_back({i - 1, i + 1, {walking(position, height, heading, kLeft, pace)}});
      }
    }
    for (const double cut : kCuts) {  // the corner rounded, from one leg to the other
      if (path_.pinned[i] || cut > (here - before).norm() - kCuts[0] ||
          cut > (after - here).norm() - kCuts[0])
        continue;
      const Eigen::Vector2d first = here + cut * (before - here).normalized();
      const Eigen::Vector2d second = here + cut * (after - here).normalized();
      proposals.push_back({i - 1,
                           i + 1,
                           {walking(first, height, arriving, kLeft, pace),
                            walking(second, height, leaving, kLeft, pace)}});
    }
  }
  for (const double heading : {arriving, leaving}) {
    Stance turned = node(i).stance;
    turned.heading = heading;
    proposals.push_back({i - 1, i + 1, {turned}});
  }
  return proposals;
}

void Refiner::passStops() {
  for (int i = 1; i < last() && !stopped(); ++i) {
    if (node(i).stance.standing) firstThatHelps(passings(i));
  }
}

void Refiner::keepAway() {
  for (int i = 0; i < last() && !stopped(); ++i)
    if (!path_.edges[i].path.empty() && path_.edges[i].unease >= kUneasy)
      firstThatHelps(asideOfEdge(i));
  for (int i = 1; i < last() && !stopped(); ++i) {
    const auto uneasy = [&] {
      return path_.edges[i - 1].unease + path_.edges[i].unease >= kUneasy;
    };
    if (path_.pinned[i] || node(i).stance.standing) continue;
    for (int k = 0; k < kMostMoves && uneasy() && firstThatHelps(besideNode(i)) >= 0; ++k) {
    }
  }
}

// Ways that leave an edge to one side.
std::vector<Proposal> Refiner::asideOfEdge(int i) const {
  std::vector<Proposal> proposals;
  double before = 0.0;
  for (int k = 0; k < i; ++k) before += path_.edges[k].length;
  for (const double share : kShares) {
    const Stance on = pointOfWalk(before + share * path_.edges[i].length, 1.0).second;
    const Eigen::Vector2d left(-std::sin(on.heading), std::cos(on.heading));
    for (const double aside : kAside) {
      proposals.push_back(
          {i, i + 1, {walking(at(on) + aside * left, on.position.z(), on.heading, kLeft, 1.0)}});
    }
  }
  return proposals;
}

// Ways by places around a node that is walked through.
std::vector<Proposal> Refiner::besideNode(int i) const {
  const Stance& here = node(i).stance;
  const Eigen::Vector2d ahead(std::cos(here.heading), std::sin(here.heading));
  const Eigen::Vector2d left(-ahead.y(), ahead.x());
  std::vector<Proposal> proposals;
  for (const Move& move : kMoves) {
    proposals.push_back({i - 1,
                         i + 1,
                         {walking(at(here) + move.along * ahead + move.aside * left,
                                  here.position.z(), here.heading + move.turn, kLeft, here.pace)}});
  }
  return proposals;
}

// The edge and the stance at a distance along the walk.
std::pair<int, Stance> Refiner::pointOfWalk(double s, double pace) const {
  int edge = 0;
  while (edge + 1 < last() && s > path_.edges[edge].length) s -= path_.edges[edge++].length;
  const WalkEdge& here = path_.edges[edge];
  if (here.path.empty()) return {edge, here.from};
  const RootPath::Sample sample = here.path.at(s);
  const double share = std::clamp(s / here.length, 0.0, 1.0);
  const double height =
      here.from.position.z() + share * (here.to.position.z() - here.from.position.z());
  return {edge, walking(sample.position, height, sample.heading, kLeft, pace)};
}

double Refiner::anyPace(SampleStream& stream) const {
  return slower_ ? kPaces[stream.below(static_cast<int>(kPaces.size()))] : 1.0;
}

std::optional<Proposal> Refiner::moveNode(SampleStream& stream) const {
  if (last() < 2) return std::nullopt;
  const int i = 1 + stream.below(last() - 1);
  const Eigen::Vector2d before = at(node(i - 1).stance), here = at(node(i).stance),
                        after = at(node(i + 1).stance);
  Eigen::Vector2d position = here + stream.uniform() * (0.5 * (before + after) - here);
  position += stray(stream);
  if (path_.pinned[i]) position = here;
  const double heading = direction(before, after) + stream.uniform(-kTwist, kTwist);
  const Stance& old = node(i).stance;
  const double pace =
      !old.standing && old.pace < 1.0 ? stream.uniform(old.pace, 1.0) : 1.0;  // or faster
  return Proposal{i - 1, i + 1, {walking(position, old.position.z(), heading, kLeft, pace)}};
}

std::optional<Proposal> Refiner::cutOff(SampleStream& stream) const {
  const double length = path_.length();
  const double a = stream.uniform(0.0, length), b = stream.uniform(0.0, length);
  const double pace = anyPace(stream);
  const auto [first, from] = pointOfWalk(std::min(a, b), pace);
  const auto [last_edge, to] = pointOfWalk(std::max(a, b), pace);
  if (first == last_edge || from.standing || to.standing) return std::nullopt;
  Proposal proposal{first, last_edge + 1, {}};
  const int which = stream.below(3);
  if (which != 1) proposal.between.push_back(from);
  if (which != 2) proposal.between.push_back(to);
  return proposal;
}

std::optional<Proposal> Refiner::goBy(SampleStream& stream) const {
  const int first = stream.below(last());
  const int next = std::min(last(), first + 1 + stream.below(3));
  const Eigen::Vector2d from = at(node(first).stance), to = at(node(next).stance);
  const double share = stream.uniform();
  Eigen::Vector2d position = from + share * (to - from);
  position += stray(stream);
  const double low = node(first).stance.position.z(), high = node(next).stance.position.z();
  const double heading = direction(from, to) + stream.uniform(-kTwist, kTwist);
  return Proposal{first,
                  next,
                  {walking(position, low + share * (high - low), heading, kLeft, anyPace(stream))}};
}

std::optional<Proposal> Refiner::randomProposal(int round, int index) const {
  // The streams of the roadmap's samples begin at 0: these are far from them.
  SampleStream stream(limits_.seed,
                      (1ULL << 40) + (static_cast<std::uint64_t>(round) << 32) + index);
  // A walk of one edge has no node to move, nor one to leave out.
  switch (last() < 2 ? 2 : stream.below(3)) {
    case 0:
      return moveNode(stream);
    case 1:
      return cutOff(stream);
    default:
      return goBy(stream);
  }
}

bool Refiner::tries(int round, int tries) {
  bool helped = false;
  for (int next = 0; next < tries && !stopped();) {
    std::vector<Proposal> proposals;
    std::vector<int> index;
    for (int i = next; i < tries; ++i) {
      if (auto proposal = randomProposal(round, i)) {
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
  slower_ = slower;
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

double EdgePath::duration() const {
  double sum = 0.0;
  for (const WalkEdge& edge : edges) sum += edge.duration;
  return sum;
}

double EdgePath::length() const {
  double sum = 0.0;
  for (const WalkEdge& edge : edges) sum += edge.length;
  return sum;
}

int EdgePath::stops() const {
  return static_cast<int>(std::count_if(edges.begin() + (edges.empty() ? 0 : 1), edges.end(),
                                        [](const WalkEdge& edge) { return edge.from.standing; }));
}

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
