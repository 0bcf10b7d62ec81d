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
constexpr double kShortestRun = 0.45;    // period of a sprint [s]
constexpr double kLongestFlight = 0.4;   // of a run; longer is a leap [s]

// What walks like the most cyclic stretch; by trial on lab walks, whose steps differ by 5 %.
constexpr double kSlowestWalk = 0.2;           // [m/s]
constexpr double kMostAside = 45.0 * kDegree;  // of travel from the pelvis' heading: ahead still
constexpr double kSameSpeed = 0.08;            // of the speed
constexpr double kSameTurn = 0.2;              // of the turn rate of a turn,
constexpr double kSameHeading = 0.1;           // but always [rad a cycle]
constexpr double kSameClosure = 2.0;           // of the closure,
constexpr double kWellClosed = 0.015;          // but always [m]
constexpr double kLargestClosure = 0.10;       // rms over the joints: more is no cycle [m]

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

std::vector<double> middles(const std::vector<FootChange>& changes) {
  std::vector<double> found;
  for (const FootChange& change : changes) found.push_back(change.middle());
  return found;
}

bool within(const CycleOptions& options, double begin, double end) {
  return !options.frames || (begin >= options.frames->first && end <= options.frames->second);
}

}  // namespace

std::vector<FootChange> footChanges(const GaitTrack& track, Side leading, Gait gait) {
  std::vector<FootChange> changes;
  const double longest = kLongestFlight / track.clip().frame_time;  // [frames]
  for (const Plant& front : track.plants(leading)) {
    for (const Plant& rear : track.plants(other(leading))) {
      const double flight = front.strike - rear.lift_off;  // [frames]
      const bool changes_so = gait == Gait::kWalk
                                  ? rear.strike < front.strike && flight < 2.0
                                  : rear.strike < front.strike && flight > 0.0 && flight < longest;
      if (!changes_so || rear.lift_off >= front.lift_off) continue;
      changes.push_back({front.strike, rear.lift_off});
      break;
    }
  }
  return changes;
}

std::vector<Stretch> wholeCycles(const GaitTrack& track, const CycleOptions& options, Gait gait) {
  std::vector<Stretch> found;
  const double shortest = gait == Gait::kWalk ? kShortestPeriod : kShortestRun;
  for (const Side leading : {kLeft, kRight}) {
    const std::vector<double> own = middles(footChanges(track, leading, gait));
    const std::vector<double> others = middles(footChanges(track, other(leading), gait));
    for (size_t i = 0; i + 1 < own.size(); ++i) {
      const double begin = own[i], end = own[i + 1];
      const double period = (end - begin) * track.clip().frame_time;
      const auto middle = std::upper_bound(others.begin(), others.end(), begin);
      // What is known to be steps may be as slow as it is.
      const bool likely = period >= shortest && period <= kLongestPeriod;
      if (!likely && options.plants == nullptr) continue;
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

std::vector<Stretch> findStretches(const GaitTrack& track, const CycleOptions& options, Gait gait) {
  std::vector<Stretch> found = wholeCycles(track, options, gait);
  const std::string what = gait == Gait::kWalk ? "a walk" : "a run";
  if (found.empty()) {
    throw InputError(options.clip, 0, "no whole cycle of " + what + " was found",
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

double frameAt(const Stretch& stretch, double phase) {
  const double period = stretch.end - stretch.begin;
  const double late = (stretch.middle - stretch.begin) / period - 0.5;
  const double bump = std::sin(kPi * phase);
  return stretch.begin + period * (phase + late * bump * bump);
}

}  // namespace amble
