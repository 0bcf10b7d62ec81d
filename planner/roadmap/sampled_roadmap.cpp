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
// How much farther from a passage its ends are tried [m]: shares of a step.
constexpr std::array<double, 5> kPassageShifts = {0.0, 0.1, -0.1, 0.2, -0.2};

// The stance moved along its heading.
Stance ahead(Stance stance, double by) {
  stance.position += by * Eigen::Vector3d(std::cos(stance.heading), std::sin(stance.heading), 0.0);
  return stance;
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
  const SteerResult& answer = candidate.answers.answer(question.from(), question.to(), [&] {
    const Waypoint& node = roadmap_.nodes()[question.node].at;
    if (const SteerResult* known = candidate.known.find(question.from(), question.to()))
      return *known;
    return question.to_node ? steering_.steer(candidate.at, node, scratch)
                            : steering_.steer(node, candidate.at, scratch);
  });
  return answer.edge.has_value();
}

int SampledRoadmap::commit(Candidate& candidate, SteeringScratch& scratch) {
  const Verdict verdict = judge(candidate, scratch);
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
      if (stands_for >= 0) refused_.push_back({from, to, answer.failure});
    } else if (verdict.keep) {
      roadmap_.addEdge(from, to, *answer.edge);
    }
  }
  return node;
}

int SampledRoadmap::insert(const Waypoint& at, bool enter, bool leave) {
  const SteeringScratchPtr scratch = steering_.makeScratch();
  return insert({.at = at, .enter = enter, .leave = leave, .end = true}, *scratch);
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
  samples_ = 0;
  failures_ = 0;
  has_passages_ = false;
}

// Both ends become nodes if walks lead between them. Where steps fall on a flight depends on how
// far before it a walk begins: a few such places are tried for each direction.
void SampledRoadmap::insertPassages(const SearchLimits& limits) {
  if (std::exchange(has_passages_, true)) return;
  const SteeringScratchPtr scratch = steering_.makeScratch();
  for (const StancePair& pair : steering_.passages()) {
    bool up = false, down = false;
    for (const double shift : kPassageShifts) {
      if (limits.stopped()) return;
      Stance first = ahead(pair.first, -shift), second = ahead(pair.second, shift);
      if (steering_.stand(first, *scratch) || steering_.stand(second, *scratch)) continue;
      SteerResult rising, falling;
      if (!up) rising = steer({first}, {second}, *scratch);
      if (!down) falling = steer({second}, {first}, *scratch);
      if (rising.edge || falling.edge) {
        Candidate end{.at = {second}, .end = true};
        const PlaceId begin = insert({.at = {first}, .end = true}, *scratch);
        if (!up) end.known.learn(begin, kCandidate, rising);
        if (!down) end.known.learn(kCandidate, begin, falling);
        insert(std::move(end), *scratch);
      }
      up = up || rising.edge;
      down = down || falling.edge;
      if (up && down) break;
    }
  }
}

SteerResult SampledRoadmap::steer(const Waypoint& from, const Waypoint& to,
                                  SteeringScratch& scratch) {
  SteerResult result = steering_.steer(from, to, scratch);
  count_.add(result);
  return result;
}

std::vector<SampledRoadmap::Draft> SampledRoadmap::draft(
    const SearchLimits& limits, std::vector<SteeringScratchPtr>& scratches) const {
  const int count = limits.threads > 1 ? kAheadPerThread * limits.threads : 1;
  std::vector<Draft> drafts(count);
  parallelFor(count, limits.threads, [&](int i, int thread) {
    if (limits.stopped()) return;
    drafts[i].index = samples_ + i;
    const auto sample = sampler_.draw(limits.seed, drafts[i].index, *scratches[thread]);
    if (!sample) return;
    const bool counted = StanceSampler::isUniform(drafts[i].index);
    drafts[i].candidate =
        Candidate{.at = {sample->stance}, .all_round = sample->all_round, .counted = counted};
    judge(*drafts[i].candidate, *scratches[thread]);  // for its answers
  });
  return drafts;
}

bool SampledRoadmap::connect(int from, int to, const SearchLimits& limits) {
  std::vector<SteeringScratchPtr> scratches(limits.threads);
  for (SteeringScratchPtr& scratch : scratches) scratch = steering_.makeScratch();
  if (!roadmap_.reachableFrom(from)[to]) insertPassages(limits);
  while (!roadmap_.reachableFrom(from)[to]) {
    if (exhausted(limits) || limits.stopped()) return false;
    for (Draft& draft : draft(limits, scratches)) {
      if (limits.stopped()) return false;
      ++samples_;
      if (StanceSampler::isUniform(draft.index)) ++failures_;  // a guard sets it back
      if (draft.candidate) commit(*draft.candidate, *scratches[0]);
      if (limits.progress) {
        limits.progress({"roadmap", effort(), limits.max_failures, roadmap_.count(NodeKind::kGuard),
                         roadmap_.count(NodeKind::kConnector)});
      }
      if (exhausted(limits) || roadmap_.reachableFrom(from)[to]) break;
    }
  }
  return true;
}

}  // namespace amble
