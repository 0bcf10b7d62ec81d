#include "planner/refinement/walk_proposals.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/rotation.h"

namespace amble {
namespace {

// Pass 1: nodes farther apart than this are not joined: what could be is by the roadmap [m].
constexpr double kFarthestShortcut = 20.0;
// Pass 2: how far from the node to the line between its neighbours, and headings off that line's.
constexpr std::array<double, 5> kPulls = {0.5, 0.25, 0.0, 0.75, 1.0};
constexpr std::array<double, 5> kTurns = {0.0, 20 * kDegree, -20 * kDegree, 40 * kDegree,
                                          -40 * kDegree};
// And how fast, of the plan's speed: slower where nothing passes at that.
constexpr std::array<double, 3> kPaces = {1.0, 0.7, 0.5};
// Pass 3: an edge that goes near things is led past them: from where along it, and how far aside
// [m]; a node between such edges is moved: along, aside [m] and turned.
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
// How far from a corner it is cut [m]: about the radius of the tightest walks and more.
constexpr std::array<double, 3> kCuts = {0.6, 0.9, 1.3};
// Pass 4: how far a random stance lies from where it is looked for [m], and how far its heading is
// off [rad].
constexpr double kStray = 0.25;
constexpr double kFarStray = 1.0;  // every other time
constexpr double kTwist = 40 * kDegree;

double direction(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return std::atan2(to.y() - from.y(), to.x() - from.x());
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

}  // namespace

std::vector<Proposal> WalkProposals::shortcuts() const {
  std::vector<Proposal> proposals;
  for (int span = path_.last(); span >= 2; --span) {
    for (int first = 0; first + span <= path_.last(); ++first) {
      const Stance from = path_.node(first).stance, to = path_.node(first + span).stance;
      if ((inPlan(from) - inPlan(to)).norm() <= kFarthestShortcut)
        proposals.push_back({first, first + span, {}});
    }
  }
  return proposals;
}

// Ways to walk by node i, and, after those, to stand there with one turn instead of two.
std::vector<Proposal> WalkProposals::passings(int i) const {
  const Eigen::Vector2d before = inPlan(path_.node(i - 1).stance),
                        here = inPlan(path_.node(i).stance),
                        after = inPlan(path_.node(i + 1).stance);
  const Eigen::Vector2d middle = 0.5 * (before + after);
  const double along = direction(before, after);
  const double arriving = direction(before, here), leaving = direction(here, after);
  // Half way between arriving and leaving, which on a corner is where the line between the
  // neighbours goes, nearly.
  const double bisecting = arriving + 0.5 * wrapAngle(leaving - arriving);
  const double height = path_.node(i).stance.position.z();
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
    Stance turned = path_.node(i).stance;
    turned.heading = heading;
    proposals.push_back({i - 1, i + 1, {turned}});
  }
  return proposals;
}

// Ways that leave an edge to one side.
std::vector<Proposal> WalkProposals::asideOfEdge(int i) const {
  std::vector<Proposal> proposals;
  double before = 0.0;
  for (int k = 0; k < i; ++k) before += path_.edges[k].length;
  for (const double share : kShares) {
    const Stance on = pointOfWalk(before + share * path_.edges[i].length, 1.0).second;
    const Eigen::Vector2d left(-std::sin(on.heading), std::cos(on.heading));
    for (const double aside : kAside) {
      proposals.push_back(
          {i,
           i + 1,
           {walking(inPlan(on) + aside * left, on.position.z(), on.heading, kLeft, 1.0)}});
    }
  }
  return proposals;
}

// Ways by places around a node that is walked through.
std::vector<Proposal> WalkProposals::besideNode(int i) const {
  const Stance& here = path_.node(i).stance;
  const Eigen::Vector2d ahead(std::cos(here.heading), std::sin(here.heading));
  const Eigen::Vector2d left(-ahead.y(), ahead.x());
  std::vector<Proposal> proposals;
  for (const Move& move : kMoves) {
    proposals.push_back({i - 1,
                         i + 1,
                         {walking(inPlan(here) + move.along * ahead + move.aside * left,
                                  here.position.z(), here.heading + move.turn, kLeft, here.pace)}});
  }
  return proposals;
}

// The edge and the stance at a distance along the walk.
std::pair<int, Stance> WalkProposals::pointOfWalk(double s, double pace) const {
  int edge = 0;
  while (edge + 1 < path_.last() && s > path_.edges[edge].length) s -= path_.edges[edge++].length;
  const WalkEdge& here = path_.edges[edge];
  if (here.path.empty()) return {edge, here.from};
  const RootPath::Sample sample = here.path.at(s);
  const double share = std::clamp(s / here.length, 0.0, 1.0);
  const double height =
      here.from.position.z() + share * (here.to.position.z() - here.from.position.z());
  return {edge, walking(sample.position, height, sample.heading, kLeft, pace)};
}

double WalkProposals::anyPace(SampleStream& stream) const {
  return slower_ ? kPaces[stream.below(static_cast<int>(kPaces.size()))] : 1.0;
}

std::optional<Proposal> WalkProposals::moveNode(SampleStream& stream) const {
  if (path_.last() < 2) return std::nullopt;
  const int i = 1 + stream.below(path_.last() - 1);
  const Eigen::Vector2d before = inPlan(path_.node(i - 1).stance),
                        here = inPlan(path_.node(i).stance),
                        after = inPlan(path_.node(i + 1).stance);
  Eigen::Vector2d position = here + stream.uniform() * (0.5 * (before + after) - here);
  position += stray(stream);
  if (path_.pinned[i]) position = here;
  const double heading = direction(before, after) + stream.uniform(-kTwist, kTwist);
  const Stance& old = path_.node(i).stance;
  const double pace =
      !old.standing && old.pace < 1.0 ? stream.uniform(old.pace, 1.0) : 1.0;  // or faster
  return Proposal{i - 1, i + 1, {walking(position, old.position.z(), heading, kLeft, pace)}};
}

std::optional<Proposal> WalkProposals::cutOff(SampleStream& stream) const {
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

std::optional<Proposal> WalkProposals::goBy(SampleStream& stream) const {
  const int first = stream.below(path_.last());
  const int next = std::min(path_.last(), first + 1 + stream.below(3));
  const Eigen::Vector2d from = inPlan(path_.node(first).stance),
                        to = inPlan(path_.node(next).stance);
  const double share = stream.uniform();
  Eigen::Vector2d position = from + share * (to - from);
  position += stray(stream);
  const double low = path_.node(first).stance.position.z(),
               high = path_.node(next).stance.position.z();
  const double heading = direction(from, to) + stream.uniform(-kTwist, kTwist);
  return Proposal{first,
                  next,
                  {walking(position, low + share * (high - low), heading, kLeft, anyPace(stream))}};
}

std::optional<Proposal> WalkProposals::random(int round, int index) const {
  // The streams of the roadmap's samples begin at 0: these are far from them.
  SampleStream stream(seed_, (1ULL << 40) + (static_cast<std::uint64_t>(round) << 32) + index);
  // A walk of one edge has no node to move, nor one to leave out.
  switch (path_.last() < 2 ? 2 : stream.below(3)) {
    case 0:
      return moveNode(stream);
    case 1:
      return cutOff(stream);
    default:
      return goBy(stream);
  }
}

}  // namespace amble
