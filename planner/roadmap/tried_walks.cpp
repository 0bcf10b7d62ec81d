#include "planner/roadmap/tried_walks.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <utility>

#include "base/parallel.h"

namespace amble {
namespace {

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
// How much farther from a passage its ends are tried [m]: shares of a step.
constexpr std::array<double, 5> kPassageShifts = {0.0, 0.1, -0.1, 0.2, -0.2};

// The stance moved along its heading.
Stance ahead(Stance stance, double by) {
  stance.position += by * Eigen::Vector3d(std::cos(stance.heading), std::sin(stance.heading), 0.0);
  return stance;
}

StancePair shifted(const StancePair& passage, double shift) {
  return {ahead(passage.first, -shift), ahead(passage.second, shift)};
}

// One direction over a passage: a walk for each shift until one is found.
std::vector<SteerResult> overPassage(const Steering& steering, const StancePair& passage, bool back,
                                     const SearchLimits& limits, SteeringScratch& scratch) {
  std::vector<SteerResult> walks;
  for (const double shift : kPassageShifts) {
    if (limits.stopped() || (!walks.empty() && walks.back().edge)) break;
    const StancePair ends = shifted(passage, shift);
    walks.push_back(back ? steering.steer({ends.second}, {ends.first}, scratch)
                         : steering.steer({ends.first}, {ends.second}, scratch));
  }
  return walks;
}

// Where the body can stand, from a narrow place on in a direction [1 or -1].
std::vector<Stance> standing(const Steering& steering, const Stance& middle, double direction,
                             double spacing, SteeringScratch& scratch) {
  std::vector<Stance> stances;
  for (double far = kNearestCrossing; far < kFarthestCrossing; far += spacing) {
    Stance stance = ahead(middle, direction * far);
    if (!steering.stand(stance, scratch)) stances.push_back(stance);
  }
  return stances;
}

// All walks by one line through a narrow place, not tried yet.
std::vector<TriedWalk> walksAlong(const Steering& steering, const WayGuide::Narrow& narrow,
                                  const std::pair<double, double>& line, const SearchLimits& limits,
                                  const std::vector<SteeringScratchPtr>& scratches) {
  const auto& [aside, turned] = line;
  Stance middle;
  middle.heading = narrow.heading + turned;
  middle.position =
      narrow.at + aside * Eigen::Vector3d(-std::sin(middle.heading), std::cos(middle.heading), 0.0);
  std::array<std::vector<Stance>, 2> ends;
  parallelFor(2, limits.threads, [&](int end, int thread) {
    ends[end] = standing(steering, middle, end == 0 ? -1.0 : 1.0,
                         end == 0 ? kCrossingsBefore : kCrossingsBeyond, *scratches[thread]);
  });
  std::vector<TriedWalk> walks;
  for (const Stance& first : ends[0])
    for (const Stance& second : ends[1]) walks.push_back({{first, second}, {}, {}});
  return walks;
}

}  // namespace

std::vector<TriedWalk> tryPassages(const Steering& steering,
                                   const std::vector<StancePair>& passages,
                                   const SearchLimits& limits,
                                   const std::vector<SteeringScratchPtr>& scratches) {
  std::vector<std::vector<SteerResult>> ways(2 * passages.size());  // there, back, there, ...
  parallelFor(static_cast<int>(ways.size()), limits.threads, [&](int i, int thread) {
    ways[i] = overPassage(steering, passages[i / 2], i % 2 == 1, limits, *scratches[thread]);
  });
  std::vector<TriedWalk> tried;
  for (size_t i = 0; i < passages.size(); ++i) {
    auto &there = ways[2 * i], &back = ways[2 * i + 1];
    for (size_t k = 0; k < std::max(there.size(), back.size()); ++k) {
      tried.push_back({shifted(passages[i], kPassageShifts[k]), {}, {}});
      if (k < there.size()) tried.back().there = std::move(there[k]);
      if (k < back.size()) tried.back().back = std::move(back[k]);
    }
  }
  return tried;
}

TriedCrossing tryCrossing(const Steering& steering, const WayGuide::Narrow& narrow,
                          const SearchLimits& limits,
                          const std::vector<SteeringScratchPtr>& scratches) {
  TriedCrossing crossing;
  for (const auto& line : kCrossings) {
    std::vector<TriedWalk> walks = walksAlong(steering, narrow, line, limits, scratches);
    std::atomic<bool> stopped{false};
    const int count = static_cast<int>(walks.size());
    const int found = firstOf(count, limits.threads, [&](int i, int thread) {
      if (limits.stopped()) stopped = true;
      if (stopped) return true;
      const StancePair& ends = walks[i].ends;
      walks[i].there = steering.steer({ends.first}, {ends.second}, *scratches[thread]);
      return walks[i].there->edge.has_value();
    });
    for (int i = 0; i < count && i <= found && walks[i].there; ++i)
      crossing.tried.push_back(std::move(walks[i]));
    if (stopped) return crossing;
    if (found < count) {
      crossing.outcome = TriedCrossing::Outcome::kWalked;
      return crossing;
    }
  }
  if (static_cast<int>(crossing.tried.size()) >= kEnoughCrossings)
    crossing.outcome = TriedCrossing::Outcome::kRefused;
  return crossing;
}

}  // namespace amble
