#include "animation/editing/stair_climb.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "animation/body/pelvis.h"
#include "animation/editing/stair_swing.h"
#include "base/cubic_spline.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr double kStraight = 25.0 * kDegree;  // a way that turns farther is no flight of stairs'
// A pelvis sways by 20 degrees; one that is turned farther is of somebody who turns about, or who
// walks sideways or backwards.
constexpr double kFacesAhead = 60.0 * kDegree;
constexpr double kDirectionOver = 0.3;  // as its directions are read [m]
constexpr double kBeside = 0.5;         // of the mean step: a shorter one stays on its tread
// Going up, the forefoot is what stands on a tread: its tip stays away from the next riser, and the
// heel may stand over the last [m]. Going down, toes may stand over the nosing.
constexpr double kBackUp = 0.035, kAheadDown = 0.02;

/// The line of the stairs, and where along it the walk's places go.
struct Flight {
  Eigen::Vector2d origin, heading;
  CubicSpline along;                            // from the captured to the new, through the prints
  double first = 0.0, last = 0.0, slope = 1.0;  // its ends, and how it goes on beyond
  double begin = 0.0;                           // of `along` where the walk begins

  double captured(const Eigen::Vector2d& p) const { return (p - origin).dot(heading); }
  /// Where that goes, 0 where the walk begins [m].
  double moved(double captured) const {
    const double inside = std::clamp(captured, first, last);
    return along.at(inside) + slope * (captured - inside) - begin;
  }
};

/// The largest angle between the walk's way and its direction as a whole [rad].
double bentBy(const WalkPath& path, const Eigen::Vector2d& heading) {
  double most = 0.0;
  int from = 0;
  for (int i = 1; i < path.frames(); ++i) {
    const Eigen::Vector2d way = path.at(i) - path.at(from);
    if (way.norm() < kDirectionOver) continue;
    most = std::max(most, std::acos(std::clamp(way.normalized().dot(heading), -1.0, 1.0)));
    from = i;
  }
  return most;
}

/// The largest angle between where the pelvis faces and the walk's direction as a whole, turned so
/// far since its first frame [rad].
double turnedAbout(const CapturedWalk& walk, const Eigen::Vector2d& heading) {
  const double ahead = std::atan2(heading.y(), heading.x());
  std::vector<double> facing = pelvisHeadings(walk.clip, walk.roles);
  const double off = facing.front() - wrapAngle(facing.front() - ahead);
  double most = 0.0;
  for (const double angle : facing) most = std::max(most, std::abs(angle - off));
  return most;
}

/// All prints that stand, in order of time.
std::vector<FootPrint*> standing(FootPrints& prints) {
  std::vector<FootPrint*> all;
  for (std::vector<FootPrint>& foot : prints) {
    for (FootPrint& print : foot) {
      if (!print.in_air) all.push_back(&print);
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const FootPrint* a, const FootPrint* b) { return a->first < b->first; });
  return all;
}

/// Puts each print on its tread, numbered from 0: `height` is the number. @return the flight, none
/// where no two treads are gone to
std::optional<Flight> putOnTreads(const std::vector<FootPrint*>& prints, double step, double going,
                                  Flight flight) {
  std::vector<double> captured, wanted;
  double tread = 0.0;
  for (FootPrint* print : prints) {
    const double at = flight.captured(print->at);
    const bool first = captured.empty();
    const bool goes_on = first || at - captured.back() > kBeside * step;
    if (goes_on && !first) tread += 1.0;
    if (goes_on) captured.push_back(at), wanted.push_back(going * tread);
    print->height = tread;
  }
  if (captured.size() < 2) return std::nullopt;
  flight.slope = going / step;
  flight.first = captured.front();
  flight.last = captured.back();
  flight.along = CubicSpline(captured, wanted, flight.slope, flight.slope);
  flight.along.keepRising();
  flight.begin = flight.moved(0.0);
  return flight;
}

/// Where the prints come to lie, and on what height.
void placePrints(const Flight& flight, const StairSize& size, FootPrints& prints) {
  for (std::vector<FootPrint>& foot : prints) {
    for (FootPrint& print : foot) {
      const double at = flight.captured(print.at);
      const double to = print.in_air ? flight.moved(at) : size.going * print.height - flight.begin;
      print.shift = (to - at) * flight.heading;
      print.height = size.rise * (print.in_air ? (to + flight.begin) / size.going : print.height);
    }
  }
}

void moveRoot(const Flight& flight, const WalkPath& path, const StairSize& size,
              WalkTracks& tracks) {
  for (int i = 0; i < path.frames(); ++i) {
    const double at = flight.captured(path.at(i)), to = flight.moved(at);
    tracks.root[i].head<2>() += (to - at) * flight.heading;
    tracks.root[i].z() += size.rise / size.going * (to + flight.begin);
  }
}

}  // namespace

StairClimb climbStairs(const CapturedWalk& walk, const WalkPath& path, const StairSize& size,
                       FootPrints& prints, WalkTracks& tracks) {
  StairClimb climb;
  Flight line;
  line.origin = path.at(0);
  line.heading = path.at(path.frames() - 1) - line.origin;
  const double bent = bentBy(path, line.heading.normalized());
  if (bent > kStraight) {
    climb.refused = fmt::format("it turns by {:.0f} degrees, and stairs are for straight walks",
                                bent / kDegree);
    return climb;
  }
  const double turned = turnedAbout(walk, line.heading);
  if (turned > kFacesAhead) {
    climb.refused =
        fmt::format("it faces up to {:.0f} degrees off its way, and stairs are for who walks ahead",
                    turned / kDegree);
    return climb;
  }
  line.heading.normalize();
  const std::vector<FootPrint*> all = standing(prints);
  const std::optional<Flight> flight =
      putOnTreads(all, walk.analysis.gait.step_length, size.going, line);
  if (!flight) {
    climb.refused = "no foot goes on by a step in it";
    return climb;
  }
  const int treads = static_cast<int>(all.back()->height);
  placePrints(*flight, size, prints);
  Stairs& stairs = climb.stairs;
  stairs.rise = size.rise;
  stairs.going = size.going;
  stairs.count = treads + 2;  // for a foot that is on its way at the end
  stairs.start = 0.5 * size.going + (size.rise > 0.0 ? kBackUp : -kAheadDown) - flight->begin;
  stairs.heading = std::atan2(flight->heading.y(), flight->heading.x());
  moveRoot(*flight, path, size, tracks);
  climb.origin = line.origin;
  swingOver(walk, stairs, line.origin, prints, tracks);
  return climb;
}

}  // namespace amble
