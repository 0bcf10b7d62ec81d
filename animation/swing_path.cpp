#include "animation/swing_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "animation/foot_cycle_fit.h"

namespace amble {
namespace {

constexpr int kSamples = 32;      // of a swing
constexpr double kCell = 0.005;   // along the swing, for which heights are asked [m]
constexpr double kCoarse = 0.08;  // the same for a first look [m]
constexpr double kLowest = 0.4;   // so much below the prints what lies between is looked for [m]
constexpr double kSame = 0.005;   // heights within so much of a print's plane are its plane [m]
constexpr double kNear = 0.12;    // of a print: margins over its own ground grow from 0 [m]
constexpr double kBeside = 0.03;  // that a foot moves before what lay beside it is in its way [m]
// What the captured swing clears by itself: things no higher over the line between prints [m].
constexpr double kCleared = 0.006;

// Shares of the swing that are tried; by trial, finer ones gain nothing.
constexpr std::array<double, 4> kDelays = {0.0, 0.1, 0.2, 0.3};
constexpr std::array<double, 4> kRamps = {0.6, 0.5, 0.4, 0.3};
constexpr double kLiftCost = 20.0;  // of height, against accelerations; by trial

double smoothstep(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// Minimum jerk from 0 to 1.
double ramp(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * t * (10.0 + t * (-15.0 + 6.0 * t));
}

double bump(const SwingShape& shape, double tau) {
  return ramp(tau / shape.rise) * ramp((1.0 - tau) / shape.fall);
}

// Height of a plane through a point of it.
double planeAt(const FootPlace& place, const Eigen::Vector2d& at) {
  const Eigen::Vector2d d = at - place.position.head<2>();
  return place.position.z() - place.normal.head<2>().dot(d) / place.normal.z();
}

}  // namespace

double swingAlong(const SwingShape& shape, const FootCycle& cycle, double tau) {
  const double t = (tau - shape.delay) / (1.0 - shape.delay - shape.early);
  return swingProgress(cycle, std::clamp(t, 0.0, 1.0));
}

double swingHeight(const SwingShape& shape, const FootCycle& cycle, double tau) {
  const double height = shape.lift * swingPolynomial(cycle.height, tau);
  return shape.extra > 0.0 ? height + shape.extra * bump(shape, tau) : height;
}

double swingLift(const SwingShape& shape, const FootCycle& cycle, const FootShape& foot) {
  constexpr int kPoints = 100;
  double highest = 0.0;
  for (int i = 0; i <= kPoints; ++i) {
    const double tau = static_cast<double>(i) / kPoints;
    const double roll = swingPolynomial(cycle.roll, tau);
    highest = std::max(highest,
                       swingHeight(shape, cycle, tau) + foot.ankle_height * (1.0 - std::cos(roll)));
  }
  return highest;
}

double liftFactor(double lift, const FootCycle& cycle, const FootShape& foot) {
  double low = 0.0, high = 20.0;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    (swingLift({.lift = middle}, cycle, foot) < lift ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// What lies along a swing: cells of it, by distance from where the foot stood.
struct SwingClearance::Strip {
  double length = 0.0;                    // from print to print [m]
  double begin = 0.0;                     // of the first cell [m]
  double keep = kAhead;                   // that the tip keeps from what stands before it [m]
  double back = 0.0, ahead = 0.0;         // of the sole's ends from its middle [m, > 0]
  double rise = 0.0;                      // of the second print over the first [m]
  double from_tilt = 0.0, to_tilt = 0.0;  // of the soles along the swing [1]
  std::vector<double> height;  // crest of each cell over the first print [m]; -infinity: none
  std::vector<bool> own;       // whether that is the plane of a print
};

SwingClearance::Strip SwingClearance::strip(const FootPlace& from, const FootPlace& to,
                                            Side side) const {
  Strip strip;
  const FootShape& foot = feet_[side];
  const Eigen::Vector2d a = from.position.head<2>(), line = to.position.head<2>() - a;
  strip.length = line.norm();
  const Eigen::Vector2d unit = line / strip.length;
  strip.rise = to.position.z() - from.position.z();
  strip.back = foot.radius - foot.heel_x;
  strip.ahead = foot.tip_x + foot.radius;
  strip.from_tilt = -from.normal.head<2>().dot(unit) / from.normal.z();
  strip.to_tilt = -to.normal.head<2>().dot(unit) / to.normal.z();
  strip.begin = -strip.back;
  const int cells =
      static_cast<int>(std::ceil((strip.length + strip.back + strip.ahead + kAhead) / kCell));
  const double low = std::min(from.position.z(), to.position.z()) - kLowest;
  const double high = std::max(from.position.z(), to.position.z()) + highest_;
  for (int i = 0; i < cells; ++i) {
    const double s = strip.begin + i * kCell;
    const Eigen::Vector2d p = a + s * unit, q = p + kCell * unit;
    const double z = ground_.crest(p, q, foot.half_width, low, high);
    const double own = std::max({planeAt(from, p), planeAt(from, q)});
    const double next = std::max({planeAt(to, p), planeAt(to, q)});
    const bool same = std::abs(z - own) < kSame || std::abs(z - next) < kSame;
    strip.height.push_back(z - from.position.z());
    strip.own.push_back(same);
  }
  // A foot that stands nearer to a riser goes up half as far from it.
  for (int i = 0; i < cells; ++i) {
    const double before = strip.begin + i * kCell - strip.ahead;
    if (strip.own[i] || before < 0.0) continue;
    if (strip.height[i] > strip.rise * (before / strip.length) + kOver) {
      strip.keep = std::min(strip.keep, 0.5 * before);
      break;
    }
  }
  return strip;
}

// What must be added at each moment of the swing is a curve; the bump is scaled to lie over it.
double SwingClearance::extraNeeded(const Strip& strip, const FootCycle& cycle,
                                   const SwingShape& shape) const {
  double extra = 0.0;
  for (int k = 1; k < kSamples; ++k) {
    const double tau = static_cast<double>(k) / kSamples;
    const double along = swingAlong(shape, cycle, tau);
    const double s = along * strip.length;
    // Over the ground that it stands on a foot's margin grows as it goes on.
    const double near = std::min(s, strip.length - s) / kNear;
    const double own = kOver * std::clamp(near, 0.0, 1.0);
    const double sole = along * strip.rise + swingHeight(shape, cycle, tau);
    const double tilt = strip.from_tilt + smoothstep(tau) * (strip.to_tilt - strip.from_tilt);
    const int cells = static_cast<int>(strip.height.size());
    const int first = static_cast<int>(std::floor((s - strip.back - strip.begin) / kCell));
    const int last =
        static_cast<int>(std::floor((s + strip.ahead + strip.keep - strip.begin) / kCell));
    double needed = 0.0;
    for (int i = std::max(first, 0); i <= std::min(last, cells - 1); ++i) {
      const double x = strip.begin + (i + 0.5) * kCell;
      // Beside a print, not under it: a foot that goes up or comes down there passes it by.
      const bool beside = (x < strip.ahead && s < kBeside) ||
                          (x > strip.length - strip.back && strip.length - s < kBeside);
      if (beside && !strip.own[i]) continue;
      const double at = std::clamp(x - s, -strip.back, strip.ahead);
      needed = std::max(needed, strip.height[i] + (strip.own[i] ? own : kOver) - sole - tilt * at);
    }
    // A share of a millimetre is a cell's coarseness.
    if (needed > 0.001) extra = std::max(extra, needed / std::max(bump(shape, tau), 1e-3));
  }
  return extra;
}

bool SwingClearance::clear(const FootPlace& from, const FootPlace& to, Side side,
                           const FootCycle& cycle, SwingShape& shape) const {
  const FootShape& foot = feet_[side];
  const Eigen::Vector2d a = from.position.head<2>(), line = to.position.head<2>() - a;
  const double length = line.norm();
  if (length < kCell) return true;
  const Eigen::Vector2d unit = line / length;
  // A first look: where nothing rises over the line from print to print the captured swing will do.
  const double back = foot.radius - foot.heel_x, ahead = foot.tip_x + foot.radius;
  const int parts = static_cast<int>(std::ceil((length + back + ahead) / kCoarse));
  const double step = (length + back + ahead) / parts;
  const double rise = to.position.z() - from.position.z(), slope = rise / length;
  const double low = std::min(from.position.z(), to.position.z()) - kLowest;
  const double high = std::max(from.position.z(), to.position.z()) + highest_;
  const bool level = rise == 0.0 && from.normal.z() == 1.0 && to.normal.z() == 1.0;
  bool free = true;
  if (level) {
    free = ground_.crest(a - back * unit, a + (length + ahead) * unit, foot.half_width, low,
                         high) <= from.position.z() + kCleared;
  } else {
    for (int i = 0; i < parts && free; ++i) {
      const double s = -back + i * step;
      const double z =
          ground_.crest(a + s * unit, a + (s + step) * unit, foot.half_width, low, high);
      const double on_line = from.position.z() + slope * (slope > 0.0 ? s + step : s) + kCleared;
      free = z <= on_line;
    }
  }
  if (free) return true;
  const Strip between = strip(from, to, side);
  double least = std::numeric_limits<double>::infinity();
  SwingShape best = shape;
  for (const double delay : kDelays) {
    for (const double early : kDelays) {
      for (const double up : kRamps) {
        for (const double down : kRamps) {
          SwingShape tried = shape;
          tried.extra = 0.0;
          tried.delay = delay, tried.early = early, tried.rise = up, tried.fall = down;
          const double extra = extraNeeded(between, cycle, tried);
          if (extra > highest_ + std::abs(between.rise)) continue;
          // Accelerations, of the foot going up, coming down and going on.
          const double on = length / std::pow(1.0 - delay - early, 2);
          const double cost =
              std::pow(extra / (up * up), 2) + std::pow(extra / (down * down), 2) + on * on;
          if (cost >= least) continue;
          least = cost;
          tried.extra = extra;
          best = tried;
        }
      }
    }
  }
  shape = best;
  return std::isfinite(least);
}

}  // namespace amble
