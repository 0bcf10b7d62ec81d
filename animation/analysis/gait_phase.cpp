#include "animation/analysis/gait_phase.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace amble {
namespace {

// A foot comes down, the other leaves: the support or the flight between has its middle there.
struct Change {
  Side in_front;
  double strike;
  double middle;  // [frames]
};

// When the other foot leaves that stood before the strike; NaN where it did not, or is not seen to
// leave.
double otherLeaves(const std::vector<FootPlant>& plants, int frames, double strike) {
  double leaves = std::numeric_limits<double>::quiet_NaN();
  for (const FootPlant& plant : plants) {
    if (plant.strike >= strike) break;
    leaves = plant.last < frames - 1 ? plant.lift_off : std::numeric_limits<double>::quiet_NaN();
  }
  return leaves;
}

std::vector<Change> changesOf(const FootPlants& plants) {
  std::vector<Change> changes;
  for (const Side side : {kLeft, kRight}) {
    for (const FootPlant& plant : plants.plants[side]) {
      if (plant.first == 0) continue;  // it came down before the clip
      const double leaves = otherLeaves(plants.plants[other(side)], plants.frames, plant.strike);
      if (std::isfinite(leaves))
        changes.push_back({side, plant.strike, 0.5 * (plant.strike + leaves)});
    }
  }
  std::sort(changes.begin(), changes.end(),
            [](const Change& a, const Change& b) { return a.strike < b.strike; });
  return changes;
}

// A step that takes longer than this times the one before is a pause, or begins another walk.
constexpr double kPause = 2.0;

// Feet that come down in one moment hop: neither is before the other.
bool together(const std::vector<Change>& changes, size_t i) {
  const auto same = [&](size_t k) {
    return k < changes.size() && changes[k].strike == changes[i].strike;
  };
  return same(i + 1) || (i > 0 && same(i - 1));
}

bool goesOn(const std::vector<Change>& changes, size_t i, size_t begin) {
  const Change &before = changes[i - 1], &here = changes[i];
  if (together(changes, i - 1) || together(changes, i)) return false;
  if (before.in_front == here.in_front || here.middle <= before.middle) return false;
  if (i - begin < 2) return true;
  return here.middle - before.middle <= kPause * (before.middle - changes[i - 2].middle);
}

}  // namespace

std::vector<PhaseMoment> gaitPhase(const FootPlants& plants) {
  const std::vector<Change> changes = changesOf(plants);
  size_t best = 0, most = 0;
  for (size_t begin = 0, end = 0; begin < changes.size(); begin = end) {
    end = begin + 1;
    while (end < changes.size() && goesOn(changes, end, begin)) ++end;
    if (end - begin > most) best = begin, most = end - begin;
  }
  std::vector<PhaseMoment> moments;
  if (most < 2) return moments;
  for (size_t i = best; i < best + most; ++i) {
    const double first = changes[best].in_front == kLeft ? 0.0 : 0.5;
    moments.push_back({changes[i].middle, first + 0.5 * static_cast<double>(i - best)});
  }
  return moments;
}

}  // namespace amble
