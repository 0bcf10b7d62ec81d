#include "planner/roadmap/sampled_roadmap.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/parallel.h"
#include "planner/roadmap/tried_walks.h"

namespace amble {
namespace {

// Samples judged ahead, a thread: more keep threads busy, but are lost when the search ends with
// one of the first. So no more than 1 over kShareAhead of those that were judged; as long as that
// would not keep threads busy they are judged one by one, each by all threads.
constexpr int kAheadPerThread = 4, kLeastPerThread = 2;
constexpr int kShareAhead = 8;
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
// Of the search's effort, 1 over this where what is left leads by a place that refuses them.
constexpr int kShareOfRefused = 4;
// So near to a place passages lead by it, and so far from their ends [m]: nearer to these one may
// come aslant. And so many pairs of ends of walks over them, there and back, tell that it refuses
// them: those of two lines. By trial, with beams across 100 drawn flights and ramps.
constexpr double kBesidePassage = 1.0, kInPassage = 1.5;
constexpr int kEnoughOverPassages = 10;
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

std::optional<bool> SampledRoadmap::ask(Candidate& candidate, Question question, Verdict& verdict,
                                        SteeringScratch& scratch) const {
  if (candidate.asks_together && !candidate.answers.find(question.from(), question.to())) {
    verdict.open.push_back(question);
    return std::nullopt;
  }
  verdict.questions.push_back(question);
  const SteerResult& answer = candidate.answers.answer(
      question.from(), question.to(), [&] { return steer(candidate, question, scratch); });
  return answer.edge.has_value();
}

// What was asked before, ahead of others, changes nothing.
bool SampledRoadmap::looksFree(Candidate& candidate, Question question,
                               SteeringScratch& scratch) const {
  const SteerResult* answer = candidate.answers.find(question.from(), question.to());
  if (!answer) answer = candidate.known.find(question.from(), question.to());
  if (answer && (!answer->edge || answer->assumed)) return answer->edge.has_value();
  const Waypoint& node = roadmap_.nodes()[question.node].at;
  const Waypoint& from = question.to_node ? candidate.at : node;
  const Waypoint& to = question.to_node ? node : candidate.at;
  if (!steering_.looksFree(from, to, scratch)) return false;
  if (answer) return true;
  SteerResult assumed;
  assumed.edge = WalkEdge{};
  assumed.assumed = true;
  candidate.answers.learn(question.from(), question.to(), std::move(assumed));
  return true;
}

std::optional<bool> SampledRoadmap::askRoughly(Candidate& candidate, Question question,
                                               Verdict& verdict, SteeringScratch& scratch) const {
  if (!candidate.answers.find(question.from(), question.to()))
    looksFree(candidate, question, scratch);
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

// What is to be steered before a verdict stands: what it leaves open, and edges that it assumes,
// unless the candidate is thrown away.
std::vector<Question> SampledRoadmap::unanswered(const Candidate& candidate,
                                                 const Verdict& verdict) const {
  std::vector<Question> questions = verdict.open;
  const bool is_kept = candidate.end || (verdict.open.empty() && verdict.keep);
  for (const Question& question : verdict.questions)
    if (is_kept && candidate.answers.find(question.from(), question.to())->assumed)
      questions.push_back(question);
  return questions;
}

// A verdict that rests on no assumed edge, or throws the candidate away. What it asks for in any
// case is steered at once, on all threads.
Verdict SampledRoadmap::judgeExactly(Candidate& candidate, Scratches& scratches) const {
  candidate.asks_together = scratches.size() > 1;
  while (true) {
    Verdict verdict = judge(candidate, *scratches[0]);
    const std::vector<Question> questions = unanswered(candidate, verdict);
    if (questions.empty()) return verdict;
    std::vector<SteerResult> answers(questions.size());
    const int count = static_cast<int>(questions.size());
    parallelFor(count, static_cast<int>(scratches.size()), [&](int i, int thread) {
      answers[i] = steer(candidate, questions[i], *scratches[thread]);
    });
    for (int i = 0; i < count; ++i)
      candidate.answers.learn(questions[i].from(), questions[i].to(), std::move(answers[i]));
  }
}

int SampledRoadmap::commit(Candidate& candidate, Scratches& scratches) {
  const Verdict verdict = judgeExactly(candidate, scratches);
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

SampledRoadmap::Scratches SampledRoadmap::scratchesFor(int threads) const {
  Scratches scratches;
  for (int i = 0; i < threads; ++i) scratches.push_back(steering_.makeScratch());
  return scratches;
}

int SampledRoadmap::insert(const Waypoint& at, bool enter, bool leave, int threads) {
  Scratches scratches = scratchesFor(threads);
  return insert({.at = at, .enter = enter, .leave = leave, .end = true, .far = true}, scratches);
}

int SampledRoadmap::insert(Candidate candidate, Scratches& scratches) {
  for (int node = 0; node < roadmap_.size(); ++node) {
    const RoadmapNode& known = roadmap_.nodes()[node];
    if (samePlace(known.at, candidate.at) && known.enter == candidate.enter &&
        known.leave == candidate.leave)
      return node;
  }
  return commit(candidate, scratches);
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
  over_passages_.clear();
  resetEffort();
}

// Those with an end in the region, in their order.
void SampledRoadmap::insertPassages(const Eigen::AlignedBox2d& region, const SearchLimits& limits,
                                    Scratches& scratches) {
  if (!passages_) passages_ = steering_.passages();
  std::vector<StancePair> near, far;
  for (const StancePair& pair : *passages_) {
    const bool is_near = region.contains(pair.first.position.head<2>()) ||
                         region.contains(pair.second.position.head<2>());
    (is_near ? near : far).push_back(pair);
  }
  passages_ = std::move(far);
  for (TriedWalk& walk : tryPassages(steering_, near, limits, scratches)) {
    if (limits.stopped()) return;
    over_passages_.emplace_back(walk.ends, walk.isThere());
    insertTried(std::move(walk), scratches);
  }
}

// Whether walks over passages by a place were tried, and each was refused.
bool SampledRoadmap::isRefusedOverPassages(const Eigen::Vector3d& at) const {
  int refused = 0;
  for (const auto& [ends, is_there] : over_passages_) {
    const Eigen::Vector3d &first = ends.first.position, &second = ends.second.position;
    const Eigen::Vector2d line = (second - first).head<2>(), way = (at - first).head<2>();
    const double length = line.norm(), along = way.dot(line) / length;
    const double aside = std::sqrt(std::max(0.0, way.squaredNorm() - along * along));
    if (!(along >= kInPassage && along <= length - kInPassage && aside <= kBesidePassage)) continue;
    const auto [low, high] = std::minmax({first.z(), second.z()});
    if (at.z() < low - kBesidePassage || at.z() > high + kBesidePassage) continue;
    if (is_there) return false;
    ++refused;
  }
  return refused >= kEnoughOverPassages;
}

// The ends become nodes if one of the walks between them is there.
void SampledRoadmap::insertTried(TriedWalk walk, Scratches& scratches) {
  const Waypoint first{walk.ends.first}, second{walk.ends.second};
  if (walk.there) note(first, second, *walk.there);
  if (walk.back) note(second, first, *walk.back);
  if (!walk.isThere()) return;
  Candidate end{.at = second, .end = true};
  const PlaceId begin = insert({.at = first, .end = true}, scratches);
  if (walk.there) end.known.learn(begin, kCandidate, std::move(*walk.there));
  if (walk.back) end.known.learn(kCandidate, begin, std::move(*walk.back));
  insert(std::move(end), scratches);
}

void SampledRoadmap::note(const Waypoint& from, const Waypoint& to, const SteerResult& result) {
  count_.add(result);
  if (!result.edge) refused_.push_back({{from, to, result.failure}});
}

std::vector<SampledRoadmap::Draft> SampledRoadmap::draft(const StanceSampler& sampler,
                                                         const SearchLimits& limits,
                                                         Scratches& scratches) const {
  const int most = static_cast<int>(
      std::min<long long>(samples_ / kShareAhead, kAheadPerThread * limits.threads));
  const bool is_ahead = limits.threads > 1 && most >= kLeastPerThread * limits.threads;
  const int count = is_ahead ? most : 1;
  std::vector<Draft> drafts(count);
  parallelFor(count, limits.threads, [&](int i, int thread) {
    if (limits.stopped()) return;
    drafts[i].index = samples_ + i;
    const auto sample = sampler.draw(limits.seed, drafts[i].index, *scratches[thread]);
    if (!sample) return;
    const bool counted = StanceSampler::isUniform(drafts[i].index);
    drafts[i].candidate =
        Candidate{.at = {sample->stance}, .all_round = sample->all_round, .counted = counted};
    if (is_ahead) judge(*drafts[i].candidate, *scratches[thread]);  // for its answers
  });
  return drafts;
}

bool SampledRoadmap::leads(int from, int to) const {
  return from >= 0 && roadmap_.reachableFrom(from)[to];
}

// Samples until walks lead from one node to the other, if there are such, or the effort is spent.
bool SampledRoadmap::grow(int from, int to, const StanceSampler& sampler, const Budget& budget,
                          const SearchLimits& limits, Scratches& scratches) {
  const long long before = samples_;
  query_ = {from, to};
  const auto isSpent = [&] {
    return effort() >= budget.effort || samples_ - before >= budget.samples;
  };
  while (!leads(from, to)) {
    if (isSpent() || limits.stopped()) return false;
    for (Draft& draft : draft(sampler, limits, scratches)) {
      if (limits.stopped()) return false;
      ++samples_;
      if (StanceSampler::isUniform(draft.index)) ++failures_;  // a guard sets it back
      if (draft.candidate) commit(*draft.candidate, scratches);
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
bool SampledRoadmap::followWays(WayGuide& guide, int from, int to, const SearchLimits& limits,
                                Scratches& scratches) {
  for (int i = 0; i < kMostWays && !limits.stopped(); ++i) {
    const auto way = guide.next();
    if (!way) return false;
    if (way_.empty()) noteWay(*way, from, to);
    std::vector<int> nodes = {from};
    for (Stance stance : *way) {
      if (limits.stopped()) return false;
      if (steering_.stand(stance, *scratches[0])) {
        guide.avoid(stance.position);
        continue;
      }
      nodes.push_back(insert({.at = {stance}, .end = true}, scratches));
      if (roadmap_.reachableFrom(from)[to]) return true;
    }
    nodes.push_back(to);
    const auto refused = firstRefused(nodes);
    if (!refused) return true;
    guide.avoid(*refused);
  }
  return false;
}

bool SampledRoadmap::isShutOff(int from, int to, const SearchLimits& limits, Scratches& scratches) {
  const auto place = [&](int node) { return roadmap_.nodes()[node].at.stance.position; };
  shut_off_ = steering_.shutOff(
      place(from), place(to), [&] { return limits.stopped(); }, scratches);
  if (shut_off_) count_.add(*shut_off_);
  return shut_off_.has_value();
}

// Ways over the map first, where there is one, and whether things shut the places off.
// @return whether walks lead there; none where samples are to say
std::optional<bool> SampledRoadmap::askMap(WayGuide* guide, int from, int to,
                                           const SearchLimits& limits, Scratches& scratches) {
  if (guide && followWays(*guide, from, to, limits, scratches)) return true;
  if (limits.stopped() || isShutOff(from, to, limits, scratches)) return false;
  return std::nullopt;
}

// Where there is hardly room: walks straight through it, and samples around it.
// @return whether walks lead there; none where samples of the rest are to say
std::optional<bool> SampledRoadmap::askNarrow(const WayGuide::Narrow& narrow, int from, int to,
                                              const SearchLimits& limits, Scratches& scratches) {
  TriedCrossing crossing = tryCrossing(steering_, narrow, limits, scratches);
  for (TriedWalk& walk : crossing.tried) insertTried(std::move(walk), scratches);
  if (roadmap_.reachableFrom(from)[to]) return true;
  // What lies right across is as high everywhere over level ground; else steps may lead up to it.
  const bool tells_of_all = !narrow.blocked || steering_.layers() == 0;
  const bool is_refused = (crossing.outcome == TriedCrossing::Outcome::kRefused && tells_of_all) ||
                          (narrow.blocked && narrow.on_steps && crossing.tried.empty() &&
                           isRefusedOverPassages(narrow.at));
  const int share = is_refused ? kShareOfRefused : 1;
  const Eigen::Vector2d at = narrow.at.head<2>();
  const StanceSampler around = sampler_.within(grown({at, at}, kAroundNarrow));
  // Every other sample is uniform.
  const Budget once{limits.max_failures, (2LL * limits.max_failures + share - 1) / share};
  if (grow(from, to, around, once, limits, scratches)) return true;
  const bool may_pass = narrow.may_pass || crossing.outcome == TriedCrossing::Outcome::kWalked;
  if (!may_pass || limits.stopped()) return false;
  resetEffort();
  if (share == 1) return std::nullopt;
  insertPassages(sampler_.bounds(), limits, scratches);
  const Budget rest{(limits.max_failures + share - 1) / share, 2LL * limits.max_failures};
  return grow(from, to, sampler_, rest, limits, scratches);
}

// Looks for passages meanwhile, if nobody has.
std::unique_ptr<WayGuide> SampledRoadmap::findWays(const Eigen::Vector3d& from,
                                                   const Eigen::Vector3d& to,
                                                   const SearchLimits& limits) {
  std::unique_ptr<WayGuide> guide;
  parallelFor(2, limits.threads, [&](int i, int) {
    if (i == 0)
      guide = steering_.guide(
          from, to, sampler_.bounds(), [&] { return limits.stopped(); }, limits.threads);
    else if (!passages_)
      passages_ = steering_.passages();
  });
  return guide;
}

bool SampledRoadmap::connect(int from, int to, const SearchLimits& limits) {
  way_.clear();
  narrow_.reset();
  if (roadmap_.reachableFrom(from)[to]) return true;
  Scratches scratches = scratchesFor(limits.threads);
  const Eigen::AlignedBox2d& bounds = sampler_.bounds();
  const auto place = [&](int node) { return roadmap_.nodes()[node].at.stance.position; };
  Eigen::AlignedBox2d ends;
  for (const int node : {from, to}) ends.extend(place(node).head<2>().eval());
  const auto guide = findWays(place(from), place(to), limits);
  insertPassages(grown(ends, kFirstMargin), limits, scratches);
  if (const auto known = askMap(guide.get(), from, to, limits, scratches)) return *known;
  if (guide) narrow_ = guide->narrowest();
  if (narrow_) {
    if (const auto known = askNarrow(*narrow_, from, to, limits, scratches)) return *known;
  }
  for (double margin = kFirstMargin;; margin *= 2.0) {
    const Eigen::AlignedBox2d region = grown(ends, margin);
    const bool is_all = region.contains(bounds);
    insertPassages(is_all ? Eigen::AlignedBox2d(bounds).extend(region) : region, limits, scratches);
    const int most = is_all ? limits.max_failures : (limits.max_failures + 3) / kShareOfRegion;
    const StanceSampler sampler = is_all ? sampler_ : sampler_.within(region);
    if (grow(from, to, sampler, {most}, limits, scratches)) return true;
    if (is_all || limits.stopped()) return false;
    resetEffort();
  }
}

void SampledRoadmap::fill(const SearchLimits& limits) {
  Scratches scratches = scratchesFor(limits.threads);
  insertPassages(sampler_.bounds(), limits, scratches);
  grow(-1, -1, sampler_, {limits.max_failures}, limits, scratches);
  const int failures = failures_;  // that coverage is told from: what follows are no samples
  joinPieces(limits, scratches);
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
void SampledRoadmap::followWaysNear(int from, int to, const SearchLimits& limits,
                                    Scratches& scratches) {
  if (leads(from, to)) return;
  const auto place = [&](int node) { return roadmap_.nodes()[node].at.stance.position; };
  Eigen::AlignedBox2d ends(place(from).head<2>());
  ends.extend(place(to).head<2>().eval());
  const auto guide = steering_.guide(
      place(from), place(to), sampler_.bounds().intersection(grown(ends, kFirstMargin)),
      [&] { return limits.stopped(); }, limits.threads);
  if (guide) followWays(*guide, from, to, limits, scratches);
}

// Each piece once, with the nearest of the others, there and back: with more of them few more are
// joined, and the stances of ways in vain are many.
void SampledRoadmap::joinPieces(const SearchLimits& limits, Scratches& scratches) {
  std::vector<int> first;  // node of each piece
  const std::vector<int> piece = roadmap_.components();
  for (int node = 0; node < roadmap_.size(); ++node)
    if (piece[node] == static_cast<int>(first.size())) first.push_back(node);
  for (const int node : first) {
    const auto pair = nearestOutside(node);
    if (!pair || limits.stopped()) return;
    followWaysNear(pair->first, pair->second, limits, scratches);
    followWaysNear(pair->second, pair->first, limits, scratches);
  }
}

}  // namespace amble
