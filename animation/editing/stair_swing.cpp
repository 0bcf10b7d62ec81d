#include "animation/editing/stair_swing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "animation/editing/least_curve.h"
#include "base/ease.h"
#include "base/statistics.h"

namespace amble {
namespace {

// How far the sole goes on behind the ankle and beyond the toe joint, in leg lengths: a foot is
// 0.152 of the stature (Drillis & Contini 1966), of which two thirds lie between the two in our
// captures.
constexpr double kBehindAnkle = 0.055, kBeyondToe = 0.07;
constexpr double kFlatAt = 0.4;       // of a plant: the heel is down, and not up again yet
constexpr double kCurveWidth = 0.07;  // of what is added to clear the stairs [s]
constexpr double kLeaves = 0.1;       // of a swing, at both ends, in which a foot leaves or lands
constexpr double kEarly = 8.0;        // what it costs that a foot which stands would have to rise

// What it costs to go later and rise faster; 0.5 of the time is as bad as 1.0 of the power [m].
constexpr double kHurry = 0.02;

/// When a foot goes ahead, and when it rises or falls.
struct SwingTiming {
  double power = 1.0;  // of the progress: above 1, later going up, earlier going down
  double share = 1.0;  // of the swing's time in which it rises, from its begin; falls, to its end
};

/// A swing between two prints, as it was captured.
struct StairSwing {
  const FootPrint *from, *to;
  const FootTrack& foot;
  const std::array<Eigen::Vector3d, 3>& sole;  // in the foot joint's frame
  const Stairs& stairs;
  Eigen::Vector2d origin, heading;
  double frame_time;

  bool up() const { return stairs.rise > 0.0; }
  int begin() const { return from->last; }
  int end() const { return to->first; }
  /// 0 when it begins, 1 when it ends.
  double time(int frame) const {
    const double length = std::max(1, end() - begin());
    return std::clamp((frame - begin()) / length, 0.0, 1.0);
  }
};

double treadHeight(const Stairs& stairs, double along) {
  const double risers = std::floor((along - stairs.start) / stairs.going) + 1.0;
  return stairs.rise * std::clamp(risers, 0.0, static_cast<double>(stairs.count));
}

/// The highest ground from one place to another and kAheadOfRiser beyond.
double highestBetween(const Stairs& stairs, double a, double b) {
  return std::max(treadHeight(stairs, std::min(a, b) - kAheadOfRiser),
                  treadHeight(stairs, std::max(a, b) + kAheadOfRiser));
}

/// How far the foot is moved at a frame.
Eigen::Vector3d moveAt(const StairSwing& swing, const SwingTiming& timing, int frame) {
  const FootPrint &from = *swing.from, &to = *swing.to;
  const double share = progress({from, to}, swing.foot, frame);
  const double inside = std::clamp(share, 0.0, 1.0);
  const double eased =
      swing.up() ? std::pow(inside, timing.power) : 1.0 - std::pow(1.0 - inside, timing.power);
  const Eigen::Vector2d way = to.toe + to.shift - from.toe - from.shift;
  const double time = swing.time(frame);
  const double risen = swing.up() ? minimumJerk(time / timing.share)
                                  : 1.0 - minimumJerk((1.0 - time) / timing.share);
  Eigen::Vector3d move;
  move << from.shift + share * (to.shift - from.shift) + (eased - inside) * way,
      from.height + risen * (to.height - from.height);
  return move;
}

/// How far a sole's point has to stay over the ground, whose height over the floor was captured.
/// While the foot leaves and lands, what it was captured to do over the floor is enough.
double wantedOver(double captured, double time) {
  const double swings = smoothstep(std::min(time, 1.0 - time) / kLeaves);
  return swings * kOverNosing + (1.0 - swings) * std::min(kOverNosing, captured);
}

/// Where a point of the sole is at a frame of the swing.
struct SoleAt {
  double along;     // the stairs [m]
  double height;    // as it is moved [m]
  double captured;  // over the floor [m]
};

SoleAt soleAt(const StairSwing& swing, const SwingTiming& timing, const Eigen::Vector3d& point,
              int frame) {
  const Eigen::Vector3d p = swing.foot.ankle[frame] + swing.foot.q_WF[frame] * point;
  const Eigen::Vector3d moved = p + moveAt(swing, timing, frame);
  return {(moved.head<2>() - swing.origin).dot(swing.heading), moved.z(), p.z()};
}

/// How much higher the foot has to be at each frame of the clip [m, >= 0]: over all that it passes
/// from the frame before to the one behind.
std::vector<double> missing(const StairSwing& swing, const SwingTiming& timing) {
  std::vector<double> missing(swing.foot.toe.size(), 0.0);
  for (const Eigen::Vector3d& point : swing.sole) {
    SoleAt before = soleAt(swing, timing, point, swing.begin());
    SoleAt now = before;
    for (int i = swing.begin() + 1; i < swing.end(); ++i) {
      const SoleAt next = soleAt(swing, timing, point, i + 1);
      if (i == swing.begin() + 1) now = soleAt(swing, timing, point, i);
      const double ground = highestBetween(swing.stairs, before.along, next.along);
      const double needed = ground + wantedOver(now.captured, swing.time(i)) - now.height;
      missing[i] = std::max(missing[i], needed);
      before = now;
      now = next;
    }
  }
  return missing;
}

/// What is added to a swing, and how much that is for its choice.
struct AddedHeight {
  std::vector<double> curve;
  double cost = 0.0;
};

AddedHeight added(const StairSwing& swing, const SwingTiming& timing) {
  AddedHeight result;
  result.curve = curveOver(missing(swing, timing), swing.frame_time, kCurveWidth);
  for (int i = 0; i < static_cast<int>(result.curve.size()); ++i) {
    const bool stands = i <= swing.begin() || i >= swing.end();
    result.cost = std::max(result.cost, (stands ? kEarly : 1.0) * result.curve[i]);
  }
  return result;
}

SwingTiming bestTiming(const StairSwing& swing) {
  SwingTiming best;
  double least = std::numeric_limits<double>::infinity();
  for (const double power : {1.0, 1.5, 2.0, 2.5, 3.0}) {
    for (const double share : {1.0, 0.8, 0.65, 0.5}) {
      const double hurry = power - 1.0 + 1.0 / share - 1.0;
      const double cost = added(swing, {power, share}).cost + kHurry * hurry;
      if (cost >= least - 1e-6) continue;
      least = cost;
      best = {power, share};
    }
  }
  return best;
}

/// Moves one foot of the tracks, print after print.
void swingFoot(const std::vector<FootPrint>& prints, StairSwing swing, FootTrack& foot) {
  const int frames = static_cast<int>(foot.toe.size());
  std::vector<Eigen::Vector3d> moves(frames);
  std::vector<double> raised(frames, 0.0);
  for (int i = 0; i < frames; ++i) {
    const FootPrint& only = i < prints.front().middle ? prints.front() : prints.back();
    moves[i] << only.shift, only.height;
  }
  for (size_t k = 0; k + 1 < prints.size(); ++k) {
    swing.from = &prints[k];
    swing.to = &prints[k + 1];
    const SwingTiming timing = bestTiming(swing);
    const AddedHeight add = added(swing, timing);
    for (int i = swing.from->middle; i < swing.to->middle; ++i) moves[i] = moveAt(swing, timing, i);
    for (int i = 0; i < frames; ++i) raised[i] = std::max(raised[i], add.curve[i]);
  }
  for (int i = 0; i < frames; ++i) foot.move(i, moves[i] + Eigen::Vector3d(0.0, 0.0, raised[i]));
}

}  // namespace

std::array<Eigen::Vector3d, 3> solePoints(const CapturedWalk& walk, const FootTrack& foot,
                                          Side side) {
  int flattest = 0;
  for (const FootPlant& plant : walk.analysis.plants.plants[side]) {
    const int flat = plant.first + static_cast<int>(kFlatAt * (plant.last - plant.first));
    if (plant.first > 0 || flattest == 0) flattest = flat;
    if (plant.first > 0) break;
  }
  const Eigen::Vector3d ankle = foot.ankle[flattest], toe = foot.toe[flattest];
  const Eigen::Quaterniond back = foot.q_WF[flattest].conjugate();
  const double leg = walk.analysis.gait.leg_length;
  Eigen::Vector3d ahead = toe - ankle;
  ahead.z() = 0.0;
  ahead.normalize();
  std::array<Eigen::Vector3d, 3> points = {ankle - kBehindAnkle * leg * ahead, toe,
                                           toe + kBeyondToe * leg * ahead};
  for (Eigen::Vector3d& point : points) {
    point.z() = 0.0;
    point = back * (point - ankle);
  }
  return points;
}

void swingOver(const CapturedWalk& walk, const Stairs& stairs, const Eigen::Vector2d& origin,
               const FootPrints& prints, WalkTracks& tracks) {
  for (const Side side : {kLeft, kRight}) {
    const FootTrack captured = tracks.feet[side];
    const std::array<Eigen::Vector3d, 3> sole = solePoints(walk, captured, side);
    const Eigen::Vector2d heading(std::cos(stairs.heading), std::sin(stairs.heading));
    swingFoot(prints[side],
              {nullptr, nullptr, captured, sole, stairs, origin, heading, walk.clip.frame_time},
              tracks.feet[side]);
  }
}

}  // namespace amble
