#include "batch/labels/passages.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "base/rotation.h"
#include "batch/labels/frame_labels.h"
#include "scenarios/problem.h"

namespace amble {
namespace {

constexpr double kEvery = 0.1;              // of the way, between looks to the sides [m]
constexpr double kSideStep = 0.05;          // sides are felt so finely [m]
constexpr double kPost = 0.02;              // radius of what they are felt with [m]
constexpr double kHips = 0.5, kHead = 1.0;  // heights, as shares of the stature
constexpr double kAskew = 35.0 * kDegree;   // [rad]
constexpr int kAskewLooks = 3;              // to either side: a post at arm's length is not missed
constexpr double kRounding = 1e-9;          // of a heading that does not turn [rad]
constexpr double kSameGap = 0.4;            // looks of one gap are no farther apart [m]

struct FeltSide {
  double distance = 0.0;  // [m]
  int object = -1;
};

// Feels to the sides of a way.
class SideProbe {
 public:
  explicit SideProbe(const Problem& problem)
      : problem_(problem), scratch_(problem.world.makeScratch()) {}

  // The nearest thing at that height to the left (+1) or right (-1), somewhat before and behind
  // too: ways lead askew through doors.
  std::optional<FeltSide> nearest(const FrameState& state, double side, double height) const {
    std::optional<FeltSide> found;
    for (int look = -kAskewLooks; look <= kAskewLooks; ++look) {
      FrameState turned = state;
      turned.heading += kAskew * look / kAskewLooks;
      const auto felt = feel(turned, side, height);
      if (felt && (!found || felt->distance < found->distance)) found = felt;
    }
    return found;
  }

 private:
  std::optional<FeltSide> feel(const FrameState& state, double side, double height) const {
    const Eigen::Vector3d up(0.0, 0.0, height);
    const Eigen::Vector3d across(-side * std::sin(state.heading), side * std::cos(state.heading),
                                 0.0);
    const Eigen::Vector3d from = state.position + up;
    int object = problem_.world.touched(from, from + kSideReach * across, kPost, *scratch_);
    if (object < 0) return std::nullopt;
    double low = 0.0, high = kSideReach;  // free to low, not free to high
    while (high - low > kSideStep) {
      const double middle = 0.5 * (low + high);
      const int there = problem_.world.touched(from, from + middle * across, kPost, *scratch_);
      (there < 0 ? low : high) = middle;
      if (there >= 0) object = there;
    }
    return FeltSide{high, object};
  }

  const Problem& problem_;
  CollisionScratchPtr scratch_;
};

struct Look {
  double arc = 0.0, width = 0.0;  // [m]
  int frame = 0;
  bool high = false;
  int left = -1, right = -1;  // objects
};

std::vector<Look> lookAside(const RunResult& run) {
  const SideProbe probe(*run.problem);
  const double stature = run.problem->synthesizer.stature();
  const AnimationBuffer& walk = run.outcome.walk.buffer;
  std::vector<Look> looks;
  double next = 0.0;
  for (int frame = 0; frame < walk.size(); ++frame) {
    const FrameState& state = walk.states[static_cast<size_t>(frame)];
    if (state.arc < next) continue;
    next = state.arc + kEvery;
    const auto left = probe.nearest(state, 1.0, kHips * stature);
    if (!left) continue;
    const auto right = probe.nearest(state, -1.0, kHips * stature);
    if (!right || left->distance + right->distance > kWidestGap) continue;
    const bool high =
        probe.nearest(state, 1.0, kHead * stature) && probe.nearest(state, -1.0, kHead * stature);
    looks.push_back(
        {state.arc, left->distance + right->distance, frame, high, left->object, right->object});
  }
  return looks;
}

// Of the way, between what the narrowest place is between [m].
double lengthOf(std::span<const Look> looks, size_t narrowest) {
  const auto same = [&](size_t i) {
    return looks[i].left == looks[narrowest].left && looks[i].right == looks[narrowest].right;
  };
  size_t first = narrowest, last = narrowest;
  while (first > 0 && same(first - 1)) --first;
  while (last + 1 < looks.size() && same(last + 1)) ++last;
  return looks[last].arc - looks[first].arc;
}

PassedGap gapOf(const RunResult& run, std::span<const Look> looks, size_t at) {
  const AnimationBuffer& walk = run.outcome.walk.buffer;
  const auto& objects = run.problem->scene.objects;
  const Look& narrowest = looks[at];
  PassedGap gap;
  gap.door = narrowest.high && lengthOf(looks, at) <= kLongestDoor;
  gap.left = objectName(objects.at(static_cast<size_t>(narrowest.left)));
  gap.right = objectName(objects.at(static_cast<size_t>(narrowest.right)));
  gap.width = narrowest.width;
  gap.time = narrowest.frame * walk.frame_time;
  gap.at = walk.states[static_cast<size_t>(narrowest.frame)].position;
  return gap;
}

std::vector<PassedGap> findGaps(const RunResult& run) {
  const std::vector<Look> looks = lookAside(run);
  std::vector<PassedGap> gaps;
  for (size_t first = 0; first < looks.size();) {
    size_t last = first, narrowest = first;
    while (last + 1 < looks.size() && looks[last + 1].arc - looks[last].arc <= kSameGap) {
      ++last;
      if (looks[last].width < looks[narrowest].width) narrowest = last;
    }
    gaps.push_back(
        gapOf(run, std::span(looks).subspan(first, last + 1 - first), narrowest - first));
    first = last + 1;
  }
  return gaps;
}

// On stairs both feet land on every tread once: a print over the other foot's is a step.
std::vector<int> findFlights(const std::vector<StepMeasure>& steps) {
  std::vector<int> flights;
  int before = 0;
  for (const StepMeasure& step : steps) {
    const int way = step.climb > kStairStep ? 1 : step.climb < -kStairStep ? -1 : 0;
    if (way != 0 && way == before) {
      flights.back() += way;
    } else if (way != 0) {
      flights.push_back(way);
    }
    before = way;
  }
  return flights;
}

}  // namespace

PassedThings findPassed(const RunResult& run) {
  PassedThings passed;
  passed.gaps = findGaps(run);
  passed.flights = findFlights(run.report.steps);
  const auto& states = run.outcome.walk.buffer.states;
  bool on_spot = false;
  for (size_t i = 1; i < states.size(); ++i) {
    const double turn = wrapAngle(states[i].heading - states[i - 1].heading);
    (turn > 0.0 ? passed.turned_left : passed.turned_right) += std::abs(turn);
    const bool turns = std::abs(turn) > kRounding && states[i].arc == states[i - 1].arc;
    if (turns && !on_spot) ++passed.turns_on_spot;
    on_spot = turns;
  }
  return passed;
}

}  // namespace amble
