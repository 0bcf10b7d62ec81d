#include "planner/roadmap/sampled_roadmap.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/parallel.h"

namespace amble {
namespace {

// Samples judged ahead, a thread: more keep threads busy, but are lost when the search ends with
// one of the first.
constexpr int kAheadPerThread = 4;
// A map is looked at to so far around start and goal, and then to twice as far [m]: all of a house,
// and a part of a level. By trial.
constexpr double kFirstMargin = 12.0;
// Of the effort that ends a search, 1 over this widens the region.
constexpr int kShareOfRegion = 4;
// Ways over the map that are tried at most.
constexpr int kMostWays = 16;
// From the narrowest place of the widest way samples are drawn so far to each side [m]: where a
// walk through it begins and ends.
constexpr double kAroundNarrow = 2.5;
// Of walks straight through a narrow place: how far from it they begin and end, at most and apart
// [m]; and how far from its middle, and by what heading to the way there, they pass it [m], [rad].
constexpr double kNearestCrossing = 0.3, kFarthestCrossing = 1.5;
constexpr double kCrossingsBefore = 0.15, kCrossingsBeyond = 0.4;
constexpr double kAslant = 0.14;
constexpr std::array<std::pair<double, double>, 9> kCrossings = {{{0.0, 0.0},
                                                                  {-0.02, 0.0},
                                                                  {0.02, 0.0},
                                                                  {0.0, kAslant},
                                                                  {0.0, -kAslant},
                                                                  {-0.04, 0.0},
                                                                  {0.04, 0.0},
                                                                  {-0.02, -kAslant},
                                                                  {0.02, kAslant}}};
// As many of them tell what a place refuses.
constexpr int kEnoughCrossings = 100;
// Of the search's effort, 1 over this where what is left leads by a place that refuses them.
constexpr int kShareOfRefused = 4;
// How much farther from a passage its ends are tried [m]: shares of a step.
constexpr std::array<double, 5> kPassageShifts = {0.0, 0.1, -0.1, 0.2, -0.2};

// The stance moved along its heading.
Stance ahead(Stance stance, double by) {
  stance.position += by * Eigen::Vector3d(std::cos(stance.heading), std::sin(stance.heading), 0.0);
  return stance;
}

Eigen::AlignedBox2d grown(const Eigen::AlignedBox2d& box, double by) {
  return {box.min().array() - by, box.max().array() + by};
}

bool samePlace(const Waypoint& a, const Waypoint& b) {
  return a.stance.position == b.stance.position && a.stance.heading == b.stance.heading &&
         a.stance.standing == b.stance.standing && a.stance.leading == b.stance.leading &&
         a.any_heading == b.any_heading;
}

}  // namespace

// A sample judged ahead.
struct SampledRoadmap::Draft {
  std::uint64_t index = 0;
  std::optional<Candidate> candidate;  // none where no free stance was found
};

bool SampledRoadmap::ask(Candidate& candidate, Question question, Verdict& verdict,
                         SteeringScratch& scratch) const {
  verdict.questions.push_back(question);
  const SteerResult& answer = candidate.answers.answer(
      question.from(), question.to(), [&] { return steer(candidate, question, scratch); });
  return answer.edge.has_value();
}

bool SampledRoadmap::askRoughly(Candidate& candidate, Question question, Verdict& verdict,
                                SteeringScratch& scratch) const {
  if (!candidate.answers.find(question.from(), question.to()) &&
      !candidate.known.find(question.from(), question.to())) {
    const Waypoint& node = roadmap_.nodes()[question.node].at;
    const Waypoint& from = question.to_node ? candidate.at : node;
    const Waypoint& to = question.to_node ? node : candidate.at;
    if (steering_.looksFree(from, to, scratch)) {
      SteerResult assumed;
      assumed.edge = WalkEdge{};
      assumed.assumed = true;
      candidate.answers.learn(question.from(), question.to(), std::move(assumed));
    }
  }
  return ask(candidate, question, verdict, scratch);
}

SteerResult SampledRoadmap::steer(const Candidate& candidate, Question question,
                                  SteeringScratch& scratch) const {
  if (const SteerResult* known = candidate.known.find(question.from(), question.to()))
    return *known;
  const Waypoint& node = roadmap_.nodes()[question.node].at;
  return question.to_node ? steering_.steer(candidate.at, node, scratch)
                          : steering_.steer(node, candidate.at, scratch);
}

// A verdict that rests on no assumed edge, or throws the candidate away.
Verdict SampledRoadmap::judgeExactly(Candidate& candidate, SteeringScratch& scratch) const {
  while (true) {
    Verdict verdict = judge(candidate, scratch);
    bool exact = true;
    for (const Question& question : verdict.questions) {
      if (!verdict.keep || !candidate.answers.find(question.from(), question.to())->assumed)
        continue;
      exact = false;
      candidate.answers.learn(question.from(), question.to(), steer(candidate, question, scratch));
    }
    if (exact) return verdict;
  }
}

int SampledRoadmap::commit(Candidate& candidate, SteeringScratch& scratch) {
  const Verdict verdict = judgeExactly(candidate, scratch);
  int node = -1;
  if (verdict.keep) {
    node = roadmap_.addNode({candidate.at, verdict.kind, candidate.enter, candidate.leave});
    if (verdict.kind == NodeKind::kGuard && candidate.counted) failures_ = 0;
  }
  const int stands_for = verdict.keep ? node : verdict.stands_for;
  for (const Question& question : verdict.questions) {
    const SteerResult& answer = *candidate.answers.find(question.from(), question.to());
    if (!candidate.known.find(question.from(), question.to())) count_.add(answer);
    const int from = question.to_node ? stands_for : question.node;
    const int to = question.to_node ? question.node : stands_for;
    if (!answer.edge) {
      const auto at = [&](PlaceId place) {
        return place == kCandidate ? candidate.at : roadmap_.nodes()[place].at;
      };
      if (stands_for >= 0)
        refused_.push_back({{at(question.from()), at(question.to()), answer.failure}, from, to});
    } else if (verdict.keep) {
      roadmap_.addEdge(from, to, *answer.edge);
    }
  }
  return node;
}

int SampledRoadmap::insert(const Waypoint& at, bool enter, bool leave) {
  const SteeringScratchPtr scratch = steering_.makeScratch();
  return insert({.at = at, .enter = enter, .leave = leave, .end = true, .far = true}, *scratch);
}

int SampledRoadmap::insert(Candidate candidate, SteeringScratch& scratch) {
  for (int node = 0; node < roadmap_.size(); ++node) {
    const RoadmapNode& known = roadmap_.nodes()[node];
    if (samePlace(known.at, candidate.at) && known.enter == candidate.enter &&
        known.leave == candidate.leave)
      return node;
  }
  return commit(candidate, scratch);
}

void SampledRoadmap::clear() {
  roadmap_ = {};
  count_ = {};
  refused_.clear();
  shut_off_.reset();
  way_.clear();
  narrow_.reset();
  samples_ = 0;
  failures_ = 0;
  passages_.reset();
  resetEffort();
}

// Those with an end in the region, in their order.
void SampledRoadmap::insertPassages(const Eigen::AlignedBox2d& region, const SearchLimits& limits) {
  if (!passages_) passages_ = steering_.passages();
  std::vector<StancePair> near, far;
  for (const StancePair& pair : *passages_) {
    const bool is_near = region.contains(pair.first.position.head<2>()) ||
                         region.contains(pair.second.position.head<2>());
    (is_near ? near : far).push_back(pair);
  }
  passages_ = std::move(far);
  const SteeringScratchPtr scratch = steering_.makeScratch();
  for (const StancePair& pair : near) insertPassage(pair, limits, *scratch);
}

// Both ends become nodes if walks lead between them. Where steps fall on a flight depends on how
// far before it a walk begins: a few such places are tried for each direction.
void SampledRoadmap::insertPassage(const StancePair& pair, const SearchLimits& limits,
                                   SteeringScratch& scratch) {
  bool up = false, down = false;
  for (const double shift : kPassageShifts) {
    if (limits.stopped() || (up && down)) return;
    const auto [rises, falls] = insertPair({ahead(pair.first, -shift), ahead(pair.second, shift)},
                                           !up, !down, limits.threads, scratch);
    up = up || rises;
    down = down || falls;
  }
}

// Straight through a narrow place: where arms swing wide there depends on how far before it, and
// how far beyond, one stands; and they do not swing alike. Ends become nodes where a walk is found.
SampledRoadmap::Crossing SampledRoadmap::insertCrossing(const WayGuide::Narrow& narrow,
                                                        const SearchLimits& limits,
                                                        SteeringScratch& scratch) {
  int asked = 0;
  for (const auto& [aside, turned] : kCrossings) {
    Stance middle;
    middle.heading = narrow.heading + turned;
    middle.position = narrow.at + aside * Eigen::Vector3d(-std::sin(middle.heading),
                                                          std::cos(middle.heading), 0.0);
    const auto standing = [&](double direction, double spacing) {
      std::vector<Stance> stances;
      for (double far = kNearestCrossing; far < kFarthestCrossing; far += spacing) {
        Stance stance = ahead(middle, direction * far);
        if (!steering_.stand(stance, scratch)) stances.push_back(stance);
      }
      return stances;
    };
    const std::vector<Stance> firsts = standing(-1.0, kCrossingsBefore),
                              seconds = standing(1.0, kCrossingsBeyond);
    for (const Stance& first : firsts) {
      for (const Stance& second : seconds) {
        if (limits.stopped()) return Crossing::kUnknown;
        ++asked;
        if (insertPair({first, second}, true, false, 1, scratch).first) return Crossing::kWalked;
      }
    }
  }
  return asked >= kEnoughCrossings ? Crossing::kRefused : Crossing::kUnknown;
}

// The ends become nodes if one of the walks between them that are asked for is there.
// @return whether walks lead from the first to the second, and back
std::pair<bool, bool> SampledRoadmap::insertPair(const StancePair& pair, bool there, bool back,
                                                 int threads, SteeringScratch& scratch) {
  const auto& [first, second] = pair;
  SteerResult going, coming;
  if (there && back) {
    const SteeringScratchPtr other = steering_.makeScratch();
    parallelFor(2, threads, [&](int i, int) {
      (i == 0 ? going : coming) = i == 0 ? steering_.steer({first}, {second}, scratch)
                                         : steering_.steer({second}, {first}, *other);
    });
    note({first}, {second}, going);
    note({second}, {first}, coming);
  } else {
    if (there) going = steer({first}, {second}, scratch);
    if (back) coming = steer({second}, {first}, scratch);
  }
  if (going.edge || coming.edge) {
    Candidate end{.at = {second}, .end = true};
    const PlaceId begin = insert({.at = {first}, .end = true}, scratch);
    if (there) end.known.learn(begin, kCandidate, going);
    if (back) end.known.learn(kCandidate, begin, coming);
    insert(std::move(end), scratch);
  }
  return {going.edge.has_value(), coming.edge.has_value()};
}

SteerResult SampledRoadmap::steer(const Waypoint& from, const Waypoint& to,
                                  SteeringScratch& scratch) {
  SteerResult result = steering_.steer(from, to, scratch);
  note(from, to, result);
  return result;
}

void SampledRoadmap::note(const Waypoint& from, const Waypoint& to, const SteerResult& result) {
  count_.add(result);
  if (!result.edge) refused_.push_back({{from, to, result.failure}});
}

std::vector<SampledRoadmap::Draft> SampledRoadmap::draft(
    const StanceSampler& sampler, const SearchLimits& limits,
    std::vector<SteeringScratchPtr>& scratches) const {
  const int count = limits.threads > 1 ? kAheadPerThread * limits.threads : 1;
  std::vector<Draft> drafts(count);
  parallelFor(count, limits.threads, [&](int i, int thread) {
    if (limits.stopped()) return;
    drafts[i].index = samples_ + i;
    const auto sample = sampler.draw(limits.seed, drafts[i].index, *scratches[thread]);
    if (!sample) return;
    const bool counted = StanceSampler::isUniform(drafts[i].index);
    drafts[i].candidate =
        Candidate{.at = {sample->stance}, .all_round = sample->all_round, .counted = counted};
    judge(*drafts[i].candidate, *scratches[thread]);  // for its answers
  });
  return drafts;
}

bool SampledRoadmap::leads(int from, int to) const {
  return from >= 0 && roadmap_.reachableFrom(from)[to];
}

// Samples until walks lead from one node to the other, if there are such, or the effort is spent.
bool SampledRoadmap::grow(int from, int to, const StanceSampler& sampler, const Budget& budget,
                          const SearchLimits& limits, std::vector<SteeringScratchPtr>& scratches) {
  const long long before = samples_;
  const auto isSpent = [&] {
    return effort() >= budget.effort || samples_ - before >= budget.samples;
  };
  while (!leads(from, to)) {
    if (isSpent() || limits.stopped()) return false;
    for (Draft& draft : draft(sampler, limits, scratches)) {
      if (limits.stopped()) return false;
      ++samples_;
      if (StanceSampler::isUniform(draft.index)) ++failures_;  // a guard sets it back
      if (draft.candidate) commit(*draft.candidate, *scratches[0]);
      if (limits.progress) {
        limits.progress({"roadmap", effort(), limits.max_failures, roadmap_.count(NodeKind::kGuard),
                         roadmap_.count(NodeKind::kConnector)});
      }
      if (isSpent() || leads(from, to)) break;
    }
  }
  return true;
}

// Where the edge from one of the nodes to the next was refused, of the first that is not walked.
std::optional<Eigen::Vector3d> SampledRoadmap::firstRefused(const std::vector<int>& nodes) const {
  for (size_t i = 0; i + 1 < nodes.size(); ++i) {
    if (roadmap_.reachableFrom(nodes[i])[nodes[i + 1]]) continue;
    for (size_t k = refused_.size(); k-- > 0;) {
      if (refused_[k].from_node == nodes[i] && refused_[k].to_node == nodes[i + 1])
        return refused_[k].failure.body;
    }
    const auto at = [&](int node) { return roadmap_.nodes()[node].at.stance.position; };
    return 0.5 * (at(nodes[i]) + at(nodes[i + 1]));
  }
  return std::nullopt;
}

void SampledRoadmap::noteWay(const std::vector<Stance>& way, int from, int to) {
  way_ = {roadmap_.nodes()[from].at.stance.position};
  for (const Stance& stance : way) way_.push_back(stance.position);
  way_.push_back(roadmap_.nodes()[to].at.stance.position);
}

// The stances of ways over the map become nodes, way after way, until walks lead from end to end.
bool SampledRoadmap::followWays(WayGuide& guide, int from, int to, const SearchLimits& limits) {
  const SteeringScratchPtr scratch = steering_.makeScratch();
  for (int i = 0; i < kMostWays && !limits.stopped(); ++i) {
    const auto way = guide.next();
    if (!way) return false;
    if (way_.empty()) noteWay(*way, from, to);
    std::vector<int> nodes = {from};
    for (Stance stance : *way) {
      if (limits.stopped()) return false;
      if (steering_.stand(stance, *scratch)) {
        guide.avoid(stance.position);
        continue;
      }
      nodes.push_back(insert({.at = {stance}, .end = true}, *scratch));
      if (roadmap_.reachableFrom(from)[to]) return true;
    }
    nodes.push_back(to);
    const auto refused = firstRefused(nodes);
    if (!refused) return true;
    guide.avoid(*refused);
  }
  return false;
}

bool SampledRoadmap::isShutOff(int from, int to, const SearchLimits& limits,
                               SteeringScratch& scratch) {
  const auto place = [&](int node) { return roadmap_.nodes()[node].at.stance.position; };
  shut_off_ = steering_.shutOff(
      place(from), place(to), [&] { return limits.stopped(); }, scratch);
  if (shut_off_) count_.add(*shut_off_);
  return shut_off_.has_value();
}

// Ways over the map first, where there is one, and whether things shut the places off.
// @return whether walks lead there; none where samples are to say
std::optional<bool> SampledRoadmap::askMap(WayGuide* guide, int from, int to,
                                           const SearchLimits& limits, SteeringScratch& scratch) {
  if (guide && followWays(*guide, from, to, limits)) return true;
  if (limits.stopped() || isShutOff(from, to, limits, scratch)) return false;
  return std::nullopt;
}

// Where there is hardly room: walks straight through it, and samples around it.
// @return whether walks lead there; none where samples of the rest are to say
std::optional<bool> SampledRoadmap::askNarrow(const WayGuide::Narrow& narrow, int from, int to,
                                              const SearchLimits& limits,
                                              std::vector<SteeringScratchPtr>& scratches) {
  const Crossing crossing = insertCrossing(narrow, limits, *scratches[0]);
  if (roadmap_.reachableFrom(from)[to]) return true;
  const int share = crossing == Crossing::kRefused ? kShareOfRefused : 1;
  const Eigen::Vector2d at = narrow.at.head<2>();
  const StanceSampler around = sampler_.within(grown({at, at}, kAroundNarrow));
  // Every other sample is uniform.
  const Budget once{limits.max_failures, (2LL * limits.max_failures + share - 1) / share};
  if (grow(from, to, around, once, limits, scratches)) return true;
  const bool may_pass = narrow.may_pass || crossing == Crossing::kWalked;
  if (!may_pass || limits.stopped()) return false;
  resetEffort();
  if (share == 1) return std::nullopt;
  insertPassages(sampler_.bounds(), limits);
  const Budget rest{(limits.max_failures + share - 1) / share, 2LL * limits.max_failures};
  return grow(from, to, sampler_, rest, limits, scratches);
}

bool SampledRoadmap::connect(int from, int to, const SearchLimits& limits) {
  way_.clear();
  narrow_.reset();
  if (roadmap_.reachableFrom(from)[to]) return true;
  std::vector<SteeringScratchPtr> scratches(limits.threads);
  for (SteeringScratchPtr& scratch : scratches) scratch = steering_.makeScratch();
  const Eigen::AlignedBox2d& bounds = sampler_.bounds();
  const auto place = [&](int node) { return roadmap_.nodes()[node].at.stance.position; };
  Eigen::AlignedBox2d ends;
  for (const int node : {from, to}) ends.extend(place(node).head<2>().eval());
  insertPassages(grown(ends, kFirstMargin), limits);
  const auto guide =
      steering_.guide(place(from), place(to), bounds, [&] { return limits.stopped(); });
  if (const auto known = askMap(guide.get(), from, to, limits, *scratches[0])) return *known;
  if (guide) narrow_ = guide->narrowest();
  if (narrow_) {
    if (const auto known = askNarrow(*narrow_, from, to, limits, scratches)) return *known;
  }
  for (double margin = kFirstMargin;; margin *= 2.0) {
    const Eigen::AlignedBox2d region = grown(ends, margin);
    const bool is_all = region.contains(bounds);
    insertPassages(is_all ? Eigen::AlignedBox2d(bounds).extend(region) : region, limits);
    const int most = is_all ? limits.max_failures : (limits.max_failures + 3) / kShareOfRegion;
    const StanceSampler sampler = is_all ? sampler_ : sampler_.within(region);
    if (grow(from, to, sampler, {most}, limits, scratches)) return true;
    if (is_all || limits.stopped()) return false;
    resetEffort();
  }
}

void SampledRoadmap::fill(const SearchLimits& limits) {
  std::vector<SteeringScratchPtr> scratches(limits.threads);
  for (SteeringScratchPtr& scratch : scratches) scratch = steering_.makeScratch();
  insertPassages(sampler_.bounds(), limits);
  grow(-1, -1, sampler_, {limits.max_failures}, limits, scratches);
  const int failures = failures_;  // that coverage is told from: what follows are no samples
  joinPieces(limits);
  failures_ = failures;
}

// A node of the piece that `node` is of and the nearest one that is of another, or none.
std::optional<std::pair<int, int>> SampledRoadmap::nearestOutside(int node) const {
  const std::vector<int> piece = roadmap_.components();
  const auto at = [&](int other) { return roadmap_.nodes()[other].at.stance.position; };
  std::optional<std::pair<int, int>> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (int inside = 0; inside < roadmap_.size(); ++inside) {
    if (piece[inside] != piece[node]) continue;
    for (int outside = 0; outside < roadmap_.size(); ++outside) {
      const double distance = (at(inside) - at(outside)).squaredNorm();
      if (piece[outside] == piece[node] || distance >= least) continue;
      least = distance;
      nearest = {inside, outside};
    }
  }
  return nearest;
}

// Ways from one node to the other over a map of what is around both.
void SampledRoadmap::followWaysNear(int from, int to, const SearchLimits& limits) {
  if (leads(from, to)) return;
  const auto place = [&](int node) { return roadmap_.nodes()[node].at.stance.position; };
  Eigen::AlignedBox2d ends(place(from).head<2>());
  ends.extend(place(to).head<2>().eval());
  const auto guide = steering_.guide(place(from), place(to),
                                     sampler_.bounds().intersection(grown(ends, kFirstMargin)),
                                     [&] { return limits.stopped(); });
  if (guide) followWays(*guide, from, to, limits);
}

// Each piece once, with the nearest of the others, there and back: with more of them few more are
// joined, and the stances of ways in vain are many.
void SampledRoadmap::joinPieces(const SearchLimits& limits) {
  std::vector<int> first;  // node of each piece
  const std::vector<int> piece = roadmap_.components();
  for (int node = 0; node < roadmap_.size(); ++node)
    if (piece[node] == static_cast<int>(first.size())) first.push_back(node);
  for (const int node : first) {
    const auto pair = nearestOutside(node);
    if (!pair || limits.stopped()) return;
    followWaysNear(pair->first, pair->second, limits);
    followWaysNear(pair->second, pair->first, limits);
  }
}

}  // namespace amble
