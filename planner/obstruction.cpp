#include "planner/obstruction.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace amble {
namespace {

// The key that is there most often, the first of equal ones.
template <typename Key>
std::pair<Key, long long> best(const std::map<Key, long long>& counts) {
  return *std::max_element(counts.begin(), counts.end(),
                           [](const auto& a, const auto& b) { return a.second < b.second; });
}

// Of the places of refusals the one nearest to their mean.
const SteeringFailure& middleOf(const std::vector<const SteeringFailure*>& refusals) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const SteeringFailure* failure : refusals)
    mean += failure->at / static_cast<double>(refusals.size());
  return **std::min_element(refusals.begin(), refusals.end(),
                            [&](const SteeringFailure* a, const SteeringFailure* b) {
                              return (a->at - mean).squaredNorm() < (b->at - mean).squaredNorm();
                            });
}

}  // namespace

std::string nameOf(const SceneObject& object) {
  return object.part.empty() ? object.name : object.name + ": " + object.part;
}

std::optional<Obstruction> mostOften(const std::vector<SteeringFailure>& refusals,
                                     const Scene& scene, const Body& body) {
  if (refusals.empty()) return std::nullopt;
  std::map<std::pair<std::string_view, int>, long long> by_object;
  for (const SteeringFailure& failure : refusals)
    ++by_object[{walkRuleName(failure.rule), failure.object}];
  const auto [most, count] = best(by_object);
  std::map<int, long long> by_part;
  std::vector<const SteeringFailure*> these;
  for (const SteeringFailure& failure : refusals) {
    if (walkRuleName(failure.rule) != most.first || failure.object != most.second) continue;
    ++by_part[failure.part];
    these.push_back(&failure);
  }
  const SteeringFailure& middle = middleOf(these);
  Obstruction why;
  why.rule = these.front()->rule;
  why.count = count;
  why.at = middle.at;
  why.body = middle.body;
  why.heading = middle.heading;
  why.gap = HUGE_VAL;
  for (const SteeringFailure* failure : these) why.gap = std::min(why.gap, failure->gap);
  if (most.second >= 0) why.object = nameOf(scene.objects[most.second]);
  const int part = best(by_part).first;
  if (part >= 0) why.part = body.parts[part].name;
  return why;
}

}  // namespace amble
