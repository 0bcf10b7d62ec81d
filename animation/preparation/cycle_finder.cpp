#include "animation/preparation/cycle_finder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "animation/clips/loop_clip.h"
#include "animation/preparation/foot_cycle_fit.h"
#include "animation/preparation/walk_cycle_fit.h"
#include "base/error.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr double kShortestPeriod = 0.7;  // of two steps of a walk [s]
constexpr double kLongestPeriod = 2.1;   // of those who creep or drag themselves along [s]

// What walks like the most cyclic stretch; by trial on lab walks, whose steps differ by 5 %.
constexpr double kSlowestWalk = 0.2;           // [m/s]
constexpr double kMostAside = 45.0 * kDegree;  // of travel from the pelvis' heading: ahead still
constexpr double kSameSpeed = 0.08;            // of the speed
constexpr double kSameTurn = 0.2;              // of the turn rate of a turn,
constexpr double kSameHeading = 0.1;           // but always [rad a cycle]
constexpr double kSameClosure = 2.0;           // of the closure,
constexpr double kWellClosed = 0.015;          // but always [m]
constexpr double kLargestClosure = 0.10;       // rms over the joints: more is no cycle [m]

// Middles of the double supports in which `leading` has just struck and the other foot is about to
// leave.
std::vector<double> doubleSupports(const GaitTrack& track, Side leading) {
  std::vector<double> middles;
  const Side trailing = other(leading);
  for (const Plant& front : track.plants(leading)) {
    for (const Plant& rear : track.plants(trailing)) {
      if (rear.strike < front.strike && rear.lift_off > front.strike - 2.0 &&
          rear.lift_off < front.lift_off) {
        middles.push_back(0.5 * (front.strike + rear.lift_off));
        break;
      }
    }
  }
  return middles;
}

double closureOf(const GaitTrack& track, double a, double b) {
  const std::vector<JointFrame> from = track.jointsAt(a);
  return poseGap(from, track.jointsAt(b), track.roles());
}

Stretch stretchOf(const GaitTrack& track, double begin, double middle, double end, Side leading) {
  Stretch s{begin, middle, end, leading, closureOf(track, begin, end), 0.0, 0.0, 0.0};
  s.turn = wrapAngle(track.headingAt(end) - track.headingAt(begin));
  const Eigen::Vector2d from = track.jointsAt(begin)[0].p_WJ.head<2>();
  const Eigen::Vector2d to = track.jointsAt(end)[0].p_WJ.head<2>();
  s.speed = (to - from).norm() / ((end - begin) * track.clip().frame_time);
  const double travel = std::atan2(to.y() - from.y(), to.x() - from.x());
  const double heading = track.headingAt(begin) + 0.5 * s.turn;
  s.aside = std::abs(wrapAngle(travel - heading));
  return s;
}

bool within(const CycleOptions& options, double begin, double end) {
  return !options.frames || (begin >= options.frames->first && end <= options.frames->second);
}

}  // namespace

std::vector<Stretch> wholeCycles(const GaitTrack& track, const CycleOptions& options) {
  std::vector<Stretch> found;
  for (const Side leading : {kLeft, kRight}) {
    const auto own = doubleSupports(track, leading);
    const auto others = doubleSupports(track, other(leading));
    for (size_t i = 0; i + 1 < own.size(); ++i) {
      const double begin = own[i], end = own[i + 1];
      const double period = (end - begin) * track.clip().frame_time;
      const auto middle = std::upper_bound(others.begin(), others.end(), begin);
      if (period < kShortestPeriod || period > kLongestPeriod) continue;
      if (middle == others.end() || *middle >= end || !within(options, begin, end)) continue;
      if (!hasSwing(track, kLeft, begin, end) || !hasSwing(track, kRight, begin, end)) continue;
      found.push_back(stretchOf(track, begin, *middle, end, leading));
    }
  }
  return found;
}

namespace {

// Of stretches for a straight walk, those that turn are no choice.
void keepStraight(std::vector<Stretch>& found, const CycleOptions& options, double frame_time) {
  if (options.turning) return;
  double least = std::numeric_limits<double>::infinity();
  for (const Stretch& s : found) {
    least = std::min(least, std::abs(s.turn) / ((s.end - s.begin) * frame_time));
  }
  if (least > kStraightTurnRate) {
    throw InputError(options.clip, 0,
                     "is called straight and turns by " +
                         std::to_string(std::lround(least / kDegree)) + " degrees/s",
                     "a straight walk");
  }
  std::erase_if(found, [&](const Stretch& s) {
    return std::abs(s.turn) / ((s.end - s.begin) * frame_time) > kStraightTurnRate;
  });
}

bool walksLike(const Stretch& s, const Stretch& best, bool turning) {
  const double turn =
      turning ? std::max(kSameTurn * std::abs(best.turn), kSameHeading) : kSameHeading;
  return std::abs(s.speed / best.speed - 1.0) <= kSameSpeed &&
         std::abs(s.turn - best.turn) <= turn &&
         s.closure <= std::max(kSameClosure * best.closure, kWellClosed);
}

}  // namespace

std::vector<Stretch> findStretches(const GaitTrack& track, const CycleOptions& options) {
  std::vector<Stretch> found = wholeCycles(track, options);
  if (found.empty()) {
    throw InputError(options.clip, 0, "no whole cycle of a walk was found",
                     "two steps in a row, each foot planted before and after");
  }
  std::erase_if(found, [](const Stretch& s) { return s.speed < kSlowestWalk; });
  if (found.empty()) throw InputError(options.clip, 0, "steps on the spot", "a walk");
  std::erase_if(found, [](const Stretch& s) { return s.aside > kMostAside; });
  if (found.empty()) {
    throw InputError(options.clip, 0, "walks backwards or sideways", "a walk ahead");
  }
  keepStraight(found, options, track.clip().frame_time);
  const auto cost = [&](const Stretch& s) {
    return options.turning ? s.closure / std::max(std::abs(s.turn), 1e-3) : s.closure;
  };
  std::stable_sort(found.begin(), found.end(),
                   [&](const Stretch& a, const Stretch& b) { return cost(a) < cost(b); });
  const Stretch best = found.front();
  if (best.closure > kLargestClosure) {
    throw InputError(options.clip, 0,
                     "no steady walk: the ends of its best cycle differ by " +
                         std::to_string(std::lround(1000.0 * best.closure)) + " mm",
                     "at most " + std::to_string(std::lround(1000.0 * kLargestClosure)) + " mm");
  }
  std::erase_if(found, [&](const Stretch& s) { return !walksLike(s, best, options.turning); });
  return found;
}

}  // namespace amble
