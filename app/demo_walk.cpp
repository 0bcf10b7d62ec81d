#include "app/demo_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "animation/ground/slope_ground.h"
#include "animation/ground/stair_ground.h"
#include "animation/steps/slope_gait.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr double kArc = 30.0 * kDegree;  // of a circle, as one Bezier: off it by 1e-6 of its radius
// Lengths that are tried for a duration: as far as one walks at full speed in it, and somewhat
// more, down to what is left when starting and stopping take this long.
constexpr double kLonger = 0.3;        // [m]
constexpr double kStartAndStop = 2.6;  // [s]
constexpr double kLengthStep = 0.05;   // a fifteenth of a step [m]
// Level ground before and behind stairs: two steps [m].
constexpr double kLanding = 1.4;
constexpr double kStairStep = 0.7;  // a step on stairs [s]

// `length` metres of a circle from the origin towards +x, or of a straight line.
RootPath circlePath(double length, double curvature) {
  const double turned = length * curvature;
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(turned) / kArc)));
  const double angle = turned / count;
  const auto at = [&](int i) -> Eigen::Vector2d {
    const double s = length * i / count, a = angle * i;
    if (std::abs(turned) < 1e-9) return {s, 0.0};
    return Eigen::Vector2d(std::sin(a), 1.0 - std::cos(a)) / curvature;
  };
  // A quarter's handles are 4/3 tan(angle / 4) radii long; here in chords.
  const double half = 0.5 * std::abs(angle);
  const double handle = half < 1e-9 ? 1.0 / 3.0 : 2.0 / 3.0 * std::tan(0.5 * half) / std::sin(half);
  std::vector<Bezier> curves;
  for (int i = 0; i < count; ++i) {
    curves.push_back(makeBezier(at(i), angle * i, at(i + 1), angle * (i + 1), handle));
  }
  return RootPath(std::move(curves));
}

int risersFor(const DemoRequest& request, double speed) {
  const double level = 2.0 * kLanding / std::min(speed, 1.0) + 0.5 * kStartAndStop;
  return std::max(2, static_cast<int>(std::lround((request.duration - level) / kStairStep)));
}

// What is asked for over a path so long, by its arc.
GaitWishes wishesOver(const DemoRequest& request, const Ground& ground, double length) {
  GaitWishes wishes;
  if (request.stride) {
    const auto* slope = dynamic_cast<const SlopeGround*>(&ground);
    wishes.stride = [ramp = *request.stride, slope, length](double arc) {
      const double incline = slope != nullptr ? slope->incline(arc) : 0.0;
      return ramp.at(std::clamp(arc / length, 0.0, 1.0)) * std::cos(incline);  // thesis, eq. 6.8
    };
  }
  if (request.lift) {
    wishes.lift = [ramp = *request.lift, length](double arc) {
      return ramp.at(std::clamp(arc / length, 0.0, 1.0));
    };
  }
  return wishes;
}

// Height of the ground after so much of a path, followed from its begin.
double heightAfter(const Ground& ground, const RootPath& path) {
  constexpr double kSpacing = 0.05, kReach = 0.5;  // [m]
  double z = 0.0;
  const int count = std::max(1, static_cast<int>(path.length() / kSpacing));
  for (int i = 0; i <= count; ++i) {
    const Eigen::Vector2d p = path.at(path.length() * i / count).position;
    z = ground.height(p.x(), p.y(), z, kReach).value_or(z);
  }
  return z;
}

WalkResult walkAlong(const WalkSynthesizer& synthesizer, const Ground& ground,
                     const DemoRequest& request, double length, AnimationBuffer& out) {
  const RootPath path = circlePath(length, request.turn_rate / synthesizer.settings().speed);
  const auto end = path.at(path.length());
  Stance from, to;
  to.position << end.position, heightAfter(ground, path);
  to.heading = end.heading;
  return synthesizer.walk(from, to, path, true, out, wishesOver(request, ground, path.length()));
}

// Lengths that may be walked, the longest first. Steps of an asked length fit some lengths only.
std::vector<double> lengthsFor(const WalkSynthesizer& synthesizer, const Ground& ground,
                               const DemoRequest& request) {
  const double speed = synthesizer.settings().speed;
  const double shortest_walk = synthesizer.shortestWalk();
  double longest = std::max(speed * request.duration + kLonger, shortest_walk);
  double pace = 1.0;
  if (request.incline) {
    pace = std::min(slopePace(std::tan(request.incline->from)),
                    slopePace(std::tan(request.incline->to)));
  }
  const double shortest =
      std::max(shortest_walk, pace * speed * (request.duration - kStartAndStop));
  std::vector<double> lengths;
  if (const auto* stairs = dynamic_cast<const StairGround*>(&ground)) {
    const Stairs& flight = stairs->stairs();
    for (double beyond = 0.0; beyond < 0.6; beyond += kLengthStep) {
      lengths.push_back(flight.start + (flight.count - 1) * flight.going + kLanding + beyond);
    }
    return lengths;
  }
  if (!request.stride) {
    for (double length = longest; length >= shortest || length == longest; length -= kLengthStep)
      lengths.push_back(length);
    return lengths;
  }
  // Half a step at either end: n steps are as long as the whole. Over a ramp of strides that is the
  // harmonic mean's.
  constexpr int kPoints = 100;
  const double scale = std::max(1.0, request.stride->to / synthesizer.stepLength());
  longest *= std::max(scale, request.stride->from / synthesizer.stepLength());
  const GaitWishes wishes = wishesOver(request, ground, longest);
  double inverse = 0.0;
  for (int i = 0; i < kPoints; ++i) inverse += 1.0 / wishes.stride((i + 0.5) / kPoints * longest);
  const double step = kPoints / inverse;
  for (int n = static_cast<int>(longest / step); n >= 2; --n) lengths.push_back(n * step);
  return lengths;
}

}  // namespace

std::unique_ptr<Ground> demoGround(const DemoRequest& request, double speed) {
  if (request.stairs) {
    const auto [rise, going] = *request.stairs;
    return std::make_unique<StairGround>(Stairs{
        .rise = rise, .going = going, .count = risersFor(request, speed), .start = kLanding});
  }
  if (request.incline) {
    const double pace = std::min(slopePace(std::tan(request.incline->from)),
                                 slopePace(std::tan(request.incline->to)));
    const double length = std::max(1.0, speed * pace * (request.duration - 0.5 * kStartAndStop));
    return std::make_unique<SlopeGround>(request.incline->from, request.incline->to, length);
  }
  return std::make_unique<FlatGround>();
}

WalkResult demoWalk(const WalkSynthesizer& synthesizer, const Ground& ground,
                    const DemoRequest& request, AnimationBuffer& best, const StopRequest& stop) {
  WalkResult result{WalkRule::kStepLength, 0, kLeft};
  double nearest = std::numeric_limits<double>::infinity();
  AnimationBuffer walk;
  for (const double length : lengthsFor(synthesizer, ground, request)) {
    stop.check();
    const WalkResult tried = walkAlong(synthesizer, ground, request, length, walk);
    if (tried.refused != WalkRule::kNone) {
      if (result.refused != WalkRule::kNone) result = tried;
      continue;
    }
    const double off = std::abs((walk.size() - 1) * walk.frame_time - request.duration);
    if (off >= nearest) continue;
    nearest = off;
    result = tried;
    std::swap(best, walk);
  }
  return result;
}

}  // namespace amble
