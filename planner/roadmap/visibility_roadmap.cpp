#include "planner/roadmap/visibility_roadmap.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace amble {
namespace {

constexpr double kFarthestGuard = 15.0;  // that a sample asks [m]; by trial

// Nodes that lead to the candidate (to_node == false), or that it leads to.
std::vector<int> neighbours(const Candidate& candidate, const Verdict& verdict, bool to_node) {
  std::vector<int> nodes;
  for (const Question& question : verdict.questions) {
    if (question.to_node != to_node) continue;
    if (candidate.answers.find(question.from(), question.to())->edge)
      nodes.push_back(question.node);
  }
  return nodes;
}

}  // namespace

std::vector<int> VisibilityRoadmap::guardsByDistance(const Candidate& candidate) const {
  const Eigen::Vector3d& at = candidate.at.stance.position;
  const double farthest = candidate.far ? HUGE_VAL : kFarthestGuard * kFarthestGuard;
  std::vector<std::pair<double, int>> order;
  for (int node = 0; node < roadmap().size(); ++node) {
    const RoadmapNode& guard = roadmap().nodes()[node];
    if (guard.kind != NodeKind::kGuard) continue;
    const double distance = (guard.at.stance.position - at).squaredNorm();
    if (distance <= farthest) order.emplace_back(distance, node);
  }
  std::sort(order.begin(), order.end());
  std::vector<int> guards;
  for (const auto& [distance, node] : order) guards.push_back(node);
  return guards;
}

// By node: whether one gets there from the start of the query, and whether to its goal from there.
struct VisibilityRoadmap::Sides {
  std::vector<bool> reached, leads;
};

// The first guard to which, and from which, there looks to be a walk.
void VisibilityRoadmap::askFree(Candidate& candidate, const std::vector<int>& guards,
                                Verdict& verdict, SteeringScratch& scratch) const {
  for (const int guard : guards) {
    const Question out{guard, true}, in{guard, false};
    if (!looksFree(candidate, out, scratch) || !looksFree(candidate, in, scratch)) continue;
    ask(candidate, out, verdict, scratch);
    ask(candidate, in, verdict, scratch);
    verdict.stands_for = guard;
    return;
  }
}

// In each component until one covers the candidate. Returns whether any does; the first that did
// stands for it. Where sides are given only what could join them is asked, and what tells whether
// the candidate is covered: where it looks to be without a walk being made, no more of that.
bool VisibilityRoadmap::askGuards(Candidate& candidate, const Sides* sides, Verdict& verdict,
                                  SteeringScratch& scratch) const {
  const std::vector<int> component = roadmap().components();
  const std::vector<int> guards = guardsByDistance(candidate);
  std::vector<bool> covered(roadmap().size(), false);  // by component
  bool is_reached = false, leads = false;              // the candidate, as far as is known
  if (sides) askFree(candidate, guards, verdict, scratch);
  if (const int guard = verdict.stands_for; guard >= 0) {
    covered[component[guard]] = true;
    is_reached = sides->reached[guard];
    leads = sides->leads[guard];
  }
  for (const int guard : guards) {
    if (covered[component[guard]]) continue;
    const bool may_cover = !sides || verdict.stands_for < 0;
    const bool out_is_of_use = !sides || !(leads || sides->reached[guard]);
    const bool in_is_of_use = !sides || !(is_reached || sides->leads[guard]);
    std::optional<bool> out = false, in = false;
    const auto askOut = [&] {
      if (candidate.leave) out = askRoughly(candidate, {guard, true}, verdict, scratch);
    };
    const auto askIn = [&] {
      if (candidate.enter) in = askRoughly(candidate, {guard, false}, verdict, scratch);
    };
    if (out_is_of_use || (may_cover && !in_is_of_use)) askOut();
    if (in_is_of_use || (may_cover && out.value_or(false))) askIn();
    if (!out_is_of_use && in_is_of_use && may_cover && in.value_or(false)) askOut();
    const bool is_open = !out || !in;
    if (is_open && sides) break;  // what is asked next depends on it
    if (sides) {
      is_reached = is_reached || (*in && sides->reached[guard]);
      leads = leads || (*out && sides->leads[guard]);
    }
    if (!is_open && (!*out || !*in)) continue;
    covered[component[guard]] = true;  // or may be: the next are not asked before that is known
    if (!is_open && verdict.stands_for < 0) verdict.stands_for = guard;
  }
  return verdict.stands_for >= 0;
}

// A terminal is asked unless walks lead between it and the candidate anyway.
void VisibilityRoadmap::askTerminals(Candidate& candidate, Verdict& verdict,
                                     SteeringScratch& scratch) const {
  std::array<bool, 2> open = {false,
                              false};  // by direction: whether the next are asked is not known
  for (int node = 0; node < roadmap().size(); ++node) {
    const RoadmapNode& terminal = roadmap().nodes()[node];
    if (terminal.kind != NodeKind::kTerminal || open[terminal.enter]) continue;
    const bool to_node = terminal.enter;
    if (to_node ? !candidate.leave : !candidate.enter) continue;
    const double distance = (terminal.at.stance.position - candidate.at.stance.position).norm();
    if (distance > kFarthestGuard && !candidate.far) continue;
    const std::vector<bool> known =
        to_node ? roadmap().reaching(node) : roadmap().reachableFrom(node);
    const std::vector<int> between = neighbours(candidate, verdict, to_node);
    if (std::any_of(between.begin(), between.end(), [&](int other) { return known[other]; }))
      continue;
    open[to_node] = !ask(candidate, {node, to_node}, verdict, scratch);
  }
}

// Whether some node could be walked to through the candidate that could not be before.
bool VisibilityRoadmap::joins(const Candidate& candidate, const Verdict& verdict) const {
  const std::vector<int> after = neighbours(candidate, verdict, true);
  for (const int before : neighbours(candidate, verdict, false)) {
    const std::vector<bool> known = roadmap().reachableFrom(before);
    if (std::any_of(after.begin(), after.end(), [&](int node) { return !known[node]; }))
      return true;
  }
  return false;
}

Verdict VisibilityRoadmap::judge(Candidate& candidate, const Sides* sides,
                                 SteeringScratch& scratch) const {
  Verdict verdict;
  const bool covered = askGuards(candidate, sides, verdict, scratch);
  if (!verdict.open.empty()) return verdict;
  askTerminals(candidate, verdict, scratch);
  if (!verdict.open.empty()) return verdict;
  if (candidate.end) {
    verdict.kind = candidate.enter && candidate.leave ? NodeKind::kGuard : NodeKind::kTerminal;
    verdict.keep = true;
  } else {
    verdict.kind = covered || !candidate.all_round ? NodeKind::kConnector : NodeKind::kGuard;
    verdict.keep = covered || !candidate.all_round ? joins(candidate, verdict) : true;
  }
  return verdict;
}

Verdict VisibilityRoadmap::judge(Candidate& candidate, SteeringScratch& scratch) const {
  if (!candidate.end && query().from >= 0) {
    const Sides sides{roadmap().reachableFrom(query().from), roadmap().reaching(query().to)};
    Verdict verdict = judge(candidate, &sides, scratch);
    if (!verdict.open.empty() || !verdict.keep) return verdict;
  }
  return judge(candidate, nullptr, scratch);
}

}  // namespace amble
