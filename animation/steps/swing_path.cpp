#include "animation/steps/swing_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "animation/steps/unevenness.h"
#include "base/ease.h"
#include "base/range_maximum.h"

namespace amble {

using Search = SwingSearch;
using Margins = SwingMargins;

namespace {

constexpr double kDearer = 1.0 + 1e-9;  // against rounding of costs

// Share of the extra lift that a ramp has added at tau, or has left so long before the end [0, 1].
double risen(double ramp, double tau) { return minimumJerk(tau / ramp); }

double bump(const SwingShape& shape, double tau) {
  return risen(shape.rise, tau) * risen(shape.fall, 1.0 - tau);
}

// Highest point of the plane that a foot stands in over a strip from p to q, `half_width` wide to
// either side.
double highestOf(const FootPlace& place, const Eigen::Vector2d& p, const Eigen::Vector2d& q,
                 double half_width) {
  if (place.normal == Eigen::Vector3d::UnitZ()) return place.position.z();
  const Eigen::Vector2d origin = place.position.head<2>();
  const Eigen::Vector2d along = (q - p).normalized();
  const double across = std::abs(tiltAlong(place, {-along.y(), along.x()}));
  return place.position.z() + std::max(tiltAlong(place, p - origin), tiltAlong(place, q - origin)) +
         half_width * across;
}

}  // namespace

double swingAlong(const SwingShape& shape, const FootBlend& cycle, double tau) {
  const double t = (tau - shape.delay) / (1.0 - shape.delay - shape.early);
  return cycle.progress(std::clamp(t, 0.0, 1.0));
}

double swingHeight(const SwingShape& shape, const FootBlend& cycle, double tau) {
  const double height = shape.lift * cycle.polynomial(&FootCycle::height, tau);
  return shape.extra > 0.0 ? height + shape.extra * bump(shape, tau) : height;
}

// What lies along a swing: cells of it, by distance from where the foot stood.
struct SwingClearance::Strip {
  double length = 0.0;             // from print to print [m]
  double begin = 0.0;              // of the first cell [m]
  double keep = Margins::kAhead;   // that the tip keeps from what stands before it [m]
  double back = 0.0, ahead = 0.0;  // of the sole's ends from its middle [m, > 0]
  double rise = 0.0;               // of the second print over the first [m]
  double uneven = 0.0;             // Unevenness::kUneven where a print is not on the level [m]
  double from_side = 0.0, to_side = 0.0;  // of a sole's higher side over its middle [m]
  double from_tilt = 0.0, to_tilt = 0.0;  // of the soles along the swing [1]
  std::vector<double> height;  // crest of each cell over the first print [m]; -infinity: none
  std::vector<char> own;       // whether that is the plane of a print
  RangeMaximum own_height, other_height;  // of the cells that are, and that are not

  // The first cell that is not beside the first print, and the last that is not beside the second.
  int first_before = 0, last_behind = -1;

  int cells() const { return static_cast<int>(height.size()); }
  double middleOf(int cell) const { return begin + (cell + 0.5) * Search::kCell; }
  void raiseNosing();
};

// The edge of the tread that the foot comes down on, before its heel, is passed over while the
// foot is all but down.
void SwingClearance::Strip::raiseNosing() {
  int edge = last_behind;
  while (edge > 0 && own[edge - 1]) --edge;
  if (edge <= 0 || height[edge] - height[edge - 1] < Margins::kOver) return;
  const double behind = length - back - (begin + edge * Search::kCell);  // the heel's end
  const double margin = std::min(Margins::kNosing, Margins::kNosingOfWay * behind);
  for (int i = edge; i <= std::min(edge + Margins::kNosingCells - 1, last_behind); ++i)
    height[i] += margin;
}

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
  const Eigen::Vector2d left(-unit.y(), unit.x());
  strip.from_tilt = tiltAlong(from, unit);
  strip.to_tilt = tiltAlong(to, unit);
  strip.from_side = std::abs(tiltAlong(from, left)) * foot.half_width;
  strip.to_side = std::abs(tiltAlong(to, left)) * foot.half_width;
  strip.begin = -strip.back;
  if (from.normal.z() < 1.0 || to.normal.z() < 1.0) strip.uneven = Unevenness::kUneven;
  const int cells = static_cast<int>(
      std::ceil((strip.length + strip.back + strip.ahead + Margins::kAhead) / Search::kCell));
  const double low = std::min(from.position.z(), to.position.z()) - Search::kLowest;
  const double high = std::max(from.position.z(), to.position.z()) + highest_ + Search::kSeen;
  std::vector<PlanSegment> pieces(cells);
  for (int i = 0; i < cells; ++i) {
    pieces[i].from = a + (strip.begin + i * Search::kCell) * unit;
    pieces[i].to = pieces[i].from + Search::kCell * unit;
  }
  const std::vector<double> crests = ground_.crests(pieces, foot.half_width, low, high);
  for (int i = 0; i < cells; ++i) {
    const double s = strip.begin + i * Search::kCell, z = crests[i];
    const auto& [p, q] = pieces[i];
    const double own = highestOf(from, p, q, foot.half_width);
    const double next = highestOf(to, p, q, foot.half_width);
    const double from_foot = std::max(0.0, s - strip.ahead);
    const double to_foot = std::max(0.0, strip.length - strip.back - s - Search::kCell);
    // On level prints nothing bends.
    const auto leeway = [&](double distance) {
      return Unevenness::kSame +
             (strip.uneven > 0.0
                  ? std::min(Margins::kBend * distance * distance, Margins::kMostBent)
                  : 0.0);
    };
    const bool same = from_foot < to_foot ? std::abs(z - own) < leeway(from_foot)
                                          : std::abs(z - next) < leeway(to_foot);
    strip.height.push_back(z - from.position.z());
    strip.own.push_back(same);
  }
  strip.last_behind = cells - 1;
  while (strip.first_before < cells &&
         strip.middleOf(strip.first_before) < strip.ahead + Search::kCell)
    ++strip.first_before;
  while (strip.last_behind >= 0 &&
         strip.middleOf(strip.last_behind) > strip.length - strip.back - Search::kCell)
    --strip.last_behind;
  strip.raiseNosing();
  std::vector<double> own_height(cells, -HUGE_VAL), other_height(cells, -HUGE_VAL);
  for (int i = 0; i < cells; ++i) (strip.own[i] ? own_height : other_height)[i] = strip.height[i];
  strip.own_height = RangeMaximum(std::move(own_height));
  strip.other_height = RangeMaximum(std::move(other_height));
  // A foot that stands nearer to a riser goes up nearer to it.
  for (int i = 0; i < cells; ++i) {
    const double before = strip.begin + i * Search::kCell - strip.ahead;
    if (strip.own[i] || before < 0.0) continue;
    if (strip.height[i] > strip.rise * (before / strip.length) + Margins::kOver) {
      strip.keep = std::min(strip.keep, Margins::kKeep * before);
      break;
    }
  }
  return strip;
}

// A sole over a strip at one moment of a swing.
struct SwingClearance::Moment {
  double s = 0.0;       // its middle, along the swing [m]
  double height = 0.0;  // of its middle over the first print [m]
  double tilt = 0.0;    // along the swing [1]
  double own = 0.0;     // margin over the ground that it stands on [m]
};

// What of each moment of a swing is the same however it is delayed and cut short.
struct SwingClearance::Course {
  std::array<double, kSamples> ease, height;  // [1]; over the line from print to print [m]

  Course(const FootBlend& cycle, const SwingShape& shape) {
    for (int k = 0; k < kSamples; ++k) {
      const double tau = static_cast<double>(k) / kSamples;
      ease[k] = smoothstep(tau);
      height[k] = swingHeight(shape, cycle, tau);
    }
  }
};

// @param shape  with the lift, and without an extra one, that the course was made for
SwingClearance::Moment SwingClearance::momentAt(const Strip& strip, const FootBlend& cycle,
                                                const SwingShape& shape, const Course& course,
                                                int k) {
  Moment sole;
  const double along = swingAlong(shape, cycle, static_cast<double>(k) / kSamples);
  const double ease = course.ease[k];
  sole.s = along * strip.length;
  // Over the ground that it stands on a foot's margin grows as it goes on.
  const double away = std::clamp(
      std::min(sole.s / Margins::kLeaving, (strip.length - sole.s) / Margins::kNear), 0.0, 1.0);
  sole.own = away * Margins::kOver - (1.0 - away) * strip.uneven;
  const double side = strip.from_side + ease * (strip.to_side - strip.from_side);
  sole.height = along * strip.rise + course.height[k] + side;
  sole.tilt = strip.from_tilt + ease * (strip.to_tilt - strip.from_tilt);
  return sole;
}

// That a sole is too low over the cells from first to last, of which it stands on some [m, >= 0].
double SwingClearance::needOver(const Strip& strip, const Moment& sole, int first, int last) {
  // Beside a print, not under it: a foot that goes up or comes down there passes it by.
  int from = first, to = last;
  if (sole.s < Margins::kBeside) from = std::max(from, strip.first_before);
  if (strip.length - sole.s < Margins::kBeside) to = std::min(to, strip.last_behind);
  const double most = std::max(strip.own_height.over(first, last) + sole.own,
                               strip.other_height.over(from, to) + Margins::kOver) -
                      sole.height;
  // Of a level sole that is all; of a tilted one no cell asks for more than this.
  if (sole.tilt == 0.0) return std::max(0.0, most);
  if (most + std::abs(sole.tilt) * std::max(strip.back, strip.ahead) < 0.0) return 0.0;
  double need = 0.0;
  for (int i = first; i <= last; ++i) {
    if (!strip.own[i] && (i < from || i > to)) continue;
    const double at = std::clamp(strip.middleOf(i) - sole.s, -strip.back, strip.ahead);
    const double margin = strip.own[i] ? sole.own : Margins::kOver;
    need = std::max(need, strip.height[i] + margin - sole.height - sole.tilt * at);
  }
  return need;
}

// What must be added to the swing's height at each of kSamples moments [m].
SwingClearance::Needs SwingClearance::needs(const Strip& strip, const FootBlend& cycle,
                                            const SwingShape& shape, const Course& course) {
  Needs needs = {};
  for (int k = 1; k < kSamples; ++k) {
    const Moment sole = momentAt(strip, cycle, shape, course, k);
    const auto cellAt = [&](double s) {
      return static_cast<int>(std::floor((s - strip.begin) / Search::kCell));
    };
    const int first = std::max(cellAt(sole.s - strip.back), 0);
    const int last = std::min(cellAt(sole.s + strip.ahead + strip.keep), strip.cells() - 1);
    const double need = needOver(strip, sole, first, last);
    if (need >= Search::kCoarseness) needs[k] = need;
  }
  return needs;
}

// Whether nothing rises over the line from print to print: then the captured swing will do.
bool SwingClearance::isFree(const FootPlace& from, const FootPlace& to,
                            const FootShape& foot) const {
  const Eigen::Vector2d a = from.position.head<2>(), line = to.position.head<2>() - a;
  const double length = line.norm();
  const Eigen::Vector2d unit = line / length, left(-unit.y(), unit.x());
  const double back = foot.radius - foot.heel_x, ahead = foot.tip_x + foot.radius;
  const double z = from.position.z(), rise = to.position.z() - z, slope = rise / length;
  const double high = std::max(z, z + rise) + highest_ + Search::kSeen;
  const auto rises = [&](double s0, double s1, double over) {
    return ground_.risesAbove(a + s0 * unit, a + s1 * unit, foot.half_width, over, high);
  };
  if (rise == 0.0 && from.normal.z() == 1.0 && to.normal.z() == 1.0)
    return !rises(-back, length + ahead, z + Unevenness::kCleared);
  const double side =
      foot.half_width * std::min(std::abs(tiltAlong(from, left)), std::abs(tiltAlong(to, left)));
  const int parts = static_cast<int>(std::ceil((length + back + ahead) / Search::kCoarse));
  const double step = (length + back + ahead) / parts;
  for (int i = 0; i < parts; ++i) {
    const double s = -back + i * step, end = s + step;
    if (rises(s, end, z + slope * (slope > 0.0 ? end : s) + side + Unevenness::kCleared))
      return false;
  }
  return true;
}

// What bump() multiplies for each ramp up, and for each ramp down, at each moment.
struct SwingClearance::Ramps {
  std::array<std::array<double, kSamples>, Search::kRamps.size()> up, down;

  double lift(const Needs& needs, size_t rise, size_t fall, double most) const;
  Ramps() {
    for (size_t i = 0; i < Search::kRamps.size(); ++i) {
      for (int k = 0; k < kSamples; ++k) {
        const double tau = static_cast<double>(k) / kSamples;
        up[i][k] = risen(Search::kRamps[i], tau);
        down[i][k] = risen(Search::kRamps[i], 1.0 - tau);
      }
    }
  }
};

// The least extra lift by which a swing with these ramps meets all needs, infinity where it is more
// than `most`.
double SwingClearance::Ramps::lift(const Needs& needs, size_t rise, size_t fall,
                                   double most) const {
  double extra = 0.0;
  for (int k = 1; k < kSamples && extra <= most; ++k) {
    if (needs[k] == 0.0) continue;
    const double share = up[rise][k] * down[fall][k];
    extra = std::max(extra, needs[k] / std::max(share, 1e-3));
  }
  return extra > most ? std::numeric_limits<double>::infinity() : extra;
}

bool SwingClearance::clear(const FootPlace& from, const FootPlace& to, Side side,
                           const FootBlend& cycle, SwingShape& shape) const {
  const double length = (to.position - from.position).head<2>().norm();
  if (length < Search::kCell || isFree(from, to, feet_[side])) return true;
  static const Ramps ramps;
  const Strip between = strip(from, to, side);
  double least = std::numeric_limits<double>::infinity();
  SwingShape best = shape, tried = shape;
  tried.extra = 0.0;
  const Course course(cycle, tried);
  for (const double delay : Search::kDelays) {
    for (const double early : Search::kDelays) {
      tried.delay = delay, tried.early = early;
      // Accelerations, of the foot going on, and below going up and coming down.
      const double on = length / std::pow(1.0 - delay - early, 2);
      if (on * on >= least) continue;
      const Needs curve = needs(between, cycle, tried, course);
      for (size_t i = 0; i < Search::kRamps.size(); ++i) {
        for (size_t j = 0; j < Search::kRamps.size(); ++j) {
          const double up = Search::kRamps[i], down = Search::kRamps[j];
          // A higher lift than this costs more than the best so far by itself, rounding included.
          const double dear = kDearer * std::sqrt(least) / Search::kLiftCost;
          const double extra =
              ramps.lift(curve, i, j, std::min(highest_ + std::abs(between.rise), dear));
          if (std::isinf(extra)) continue;
          const double cost = std::pow(extra / (up * up), 2) + std::pow(extra / (down * down), 2) +
                              on * on + std::pow(Search::kLiftCost * extra, 2);
          if (cost >= least) continue;
          least = cost;
          best = tried;
          best.rise = up, best.fall = down, best.extra = extra;
        }
      }
    }
  }
  shape = best;
  return std::isfinite(least);
}

// At the moment at which that is most, by the steepest ramps, than which none adds more. What is
// between the prints is under the sole, or before its tip, at one of the moments that are looked
// at: from one to the next it goes on by less than it is long.
double SwingClearance::highestCleared(const FootBlend& cycle) const {
  SwingShape shape;
  shape.rise = shape.fall = *std::ranges::min_element(Search::kRamps);
  shape.extra = highest_;
  double highest = 0.0;
  for (int k = 1; k < kSamples; ++k)
    highest = std::max(highest, swingHeight(shape, cycle, static_cast<double>(k) / kSamples));
  return highest + Search::kCoarseness - Margins::kOver;
}

}  // namespace amble
