#include "animation/editing/edit_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

#include "animation/editing/foot_lift.h"
#include "animation/editing/foot_lock.h"
#include "animation/editing/foot_prints.h"
#include "animation/editing/root_rise.h"
#include "animation/editing/walk_path.h"
#include "animation/ground/placed_ground.h"
#include "animation/ground/slope_ground.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr double kAnywhere = 1e6;  // how far from z = 0 ground may be [m]
// A walk that ends nearer to where it began has no way to be turned and scaled [m].
constexpr double kGoesSomewhere = 0.3;
constexpr double kArrives = 1e-4;  // nearer to where it shall be a walk has arrived [m]
// Legs that stay farther from their prints are too short for what is asked; hips that go down more
// are a crouch, not a walk [m].
constexpr double kMostMissed = 0.005, kMostLowered = 0.2;

// A foot that is to be held may drift by less [m]: QUALITY.md's bar is 0.002. What is held once
// more is seldom found to stand elsewhere again.
constexpr double kStays = 0.0015;
constexpr int kHeldAgain = 3;

using FactorAt = std::function<double(double share)>;

/// The clip turned about where its root begins.
CapturedWalk turned(const CapturedWalk& walk, double angle) {
  CapturedWalk result = walk;
  const Eigen::Quaterniond turn = aboutZ(angle);
  const Eigen::Vector3d start = walk.clip.poses.p_WR(0);
  for (int i = 0; i < walk.clip.frames(); ++i) {
    Eigen::Vector3d& p = result.clip.poses.p_WR(i);
    const Eigen::Vector3d to = start + turn * (p - start);
    p.head<2>() = to.head<2>();
    Eigen::Quaterniond& q = result.clip.poses.rotations(i)[0];
    q = turn * q;
  }
  result.analysis.gait = measureGait(result.clip, result.roles, result.analysis.plants);
  return result;
}

/// What an arrival asks for.
struct Arrival {
  double angle = 0.0;   // by which the walk is turned [rad]
  double factor = 1.0;  // of its stride
  std::string refused;
};

Arrival arrivalAt(const CapturedWalk& walk, const Eigen::Vector2d& at) {
  const PoseArray& poses = walk.clip.poses;
  const Eigen::Vector2d begin = poses.p_WR(0).head<2>();
  const Eigen::Vector2d way = poses.p_WR(walk.clip.frames() - 1).head<2>() - begin;
  const Eigen::Vector2d wanted = at - begin;
  Arrival arrival;
  if (way.norm() < kGoesSomewhere) {
    arrival.refused = fmt::format("it ends {:.2f} m from where it begins", way.norm());
    return arrival;
  }
  arrival.factor = wanted.norm() / way.norm();
  arrival.angle = std::atan2(wanted.y(), wanted.x()) - std::atan2(way.y(), way.x());
  if (arrival.factor < EditLimits::kShortest || arrival.factor > EditLimits::kLongest) {
    arrival.refused = fmt::format(
        "{:.2f} m away is {:.2f} of the {:.2f} m that it goes from ({:.2f}, {:.2f}); strides are "
        "scaled by {:g} to {:g}",
        wanted.norm(), arrival.factor, way.norm(), begin.x(), begin.y(), EditLimits::kShortest,
        EditLimits::kLongest);
  }
  return arrival;
}

/// Prints, feet and root go along with the path.
void moveAlong(const CapturedWalk& walk, const WalkPath& path, const FactorAt& factor,
               FootPrints& prints, WalkTracks& tracks) {
  const std::vector<Eigen::Vector2d> shifts = path.scaled(factor);
  for (int i = 0; i < path.frames(); ++i) tracks.root[i].head<2>() += shifts[i];
  for (const Side side : {kLeft, kRight}) {
    for (FootPrint& print : prints[side]) {
      print.shift = path.between(shifts, path.passing(print.at, print.first, print.last));
    }
    const FootTrack captured = tracks.feet[side];
    for (int i = 0; i < walk.clip.frames(); ++i) {
      const PrintPair pair = printsAt(prints[side], i);
      const double share = progress(pair, captured, i);
      const Eigen::Vector2d shift = pair.from.shift + share * (pair.to.shift - pair.from.shift);
      tracks.feet[side].move(i, {shift.x(), shift.y(), 0.0});
    }
  }
}

/// Feet keep their height over the ground and tilt with it, about the toe; the root goes up with
/// the ground below it.
void putOnGround(const Ground& ground, WalkTracks& tracks) {
  for (size_t i = 0; i < tracks.root.size(); ++i) {
    const Eigen::Vector3d& root = tracks.root[i];
    tracks.root[i].z() += ground.height(root.x(), root.y(), 0.0, kAnywhere).value_or(0.0);
    for (FootTrack& foot : tracks.feet) {
      const int frame = static_cast<int>(i);
      const Eigen::Vector3d toe = foot.toe[i];
      const auto below = ground.surface(toe.x(), toe.y(), 0.0, kAnywhere);
      if (!below) continue;
      foot.turn(frame, turnBetween(Eigen::Vector3d::UnitZ(), below->normal));
      const double over = toe.z() / below->normal.z();
      foot.move(frame, {0.0, 0.0, below->height + over - toe.z()});
    }
  }
}

/// Stride, arrival and slope.
void walkOn(const CapturedWalk& walk, const EditRequest& request, double arrival,
            WalkTracks& tracks, EditedWalk& result) {
  const WalkPath path(tracks.root, walk.clip.frame_time);
  const double captured = walk.analysis.gait.step_length;
  const Ramp stride = request.stride ? request.stride->factorOf(captured) : Ramp{arrival, arrival};
  const Ramp incline = request.incline.value_or(Ramp{0.0, 0.0});
  const FactorAt factor = [&](double share) {
    // Eq. 6.8; where one arrives is seen from above.
    const double from_above = request.arrive ? 1.0 : std::cos(incline.at(share));
    return stride.at(share) * from_above;
  };
  FootPrints prints = footPrints(walk, tracks);
  riseWithStride(
      walk, [&](int frame) { return factor(path.share(frame)); }, tracks);
  moveAlong(walk, path, factor, prints, tracks);
  if (!request.incline) {
    result.ground = std::make_unique<FlatGround>();
    return;
  }
  const Eigen::Vector2d way = path.at(path.frames() - 1) - path.at(0);
  const double length = std::max(1e-3, way.norm() * factor(0.5));
  result.place.origin = path.at(0);
  result.place.heading = std::atan2(way.y(), way.x());
  result.ground = std::make_unique<PlacedGround>(
      std::make_unique<SlopeGround>(incline.from, incline.to, length, result.place.heading),
      result.place.origin);
  putOnGround(*result.ground, tracks);
}

void climb(const CapturedWalk& walk, const StairSize& size, WalkTracks& tracks,
           EditedWalk& result) {
  const WalkPath path(tracks.root, walk.clip.frame_time);
  FootPrints prints = footPrints(walk, tracks);
  const double factor = size.going / walk.analysis.gait.step_length;
  riseWithStride(
      walk, [&](int) { return factor; }, tracks);
  StairClimb stairs = climbStairs(walk, path, size, prints, tracks);
  result.refused = stairs.refused;
  if (!result.refused.empty()) return;
  result.place = {stairs.origin, stairs.stairs.heading, stairs.stairs};
  result.ground =
      std::make_unique<PlacedGround>(std::make_unique<StairGround>(stairs.stairs), stairs.origin);
}

void lift(const CapturedWalk& walk, const EditAmount& amount, WalkTracks& tracks) {
  const WalkPath path(tracks.root, walk.clip.frame_time);
  const Ramp factor = amount.factorOf(walk.analysis.gait.lift);
  scaleLift(
      walk, [&](int frame) { return factor.at(path.share(frame)); }, tracks);
}

/// Feet keep their height over the ground where they are moved along it.
void stayOverGround(const Ground& ground, const WalkTracks& before, WalkTracks& tracks) {
  const auto height = [&](const Eigen::Vector3d& p) {
    return ground.height(p.x(), p.y(), 0.0, kAnywhere).value_or(0.0);
  };
  for (const Side side : {kLeft, kRight}) {
    FootTrack& foot = tracks.feet[side];
    for (size_t i = 0; i < foot.toe.size(); ++i) {
      const double up = height(foot.toe[i]) - height(before.feet[side].toe[i]);
      foot.move(static_cast<int>(i), {0.0, 0.0, up});
    }
  }
}

/// Who judges the walk finds its plants anew: a foot that swings lower, or comes down on a tread,
/// stands sooner or longer than the captured one did. Where such drift, all are held.
void holdAsFound(const CapturedWalk& walk, bool on_slope, EditedWalk& result) {
  const double frame_time = walk.clip.frame_time;
  for (int round = 0; round < kHeldAgain; ++round) {
    const FootPlants plants = detectPlants(result.clip, walk.roles);
    if (measureGait(result.clip, walk.roles, plants).largest_drift < kStays) return;
    const WalkTracks before = tracksOf(result.clip, walk.roles);
    WalkTracks tracks = before;
    result.lock_moved += lockTracks(plants, frame_time, tracks);
    if (on_slope) stayOverGround(*result.ground, before, tracks);
    TrackFit fit;
    result.clip = followTracks(result.clip, walk.roles, tracks, &fit);
    result.fit.lowered += fit.lowered;
    result.fit.missed = std::max(result.fit.missed, fit.missed);
  }
}

EditedWalk editOnce(const CapturedWalk& captured, const EditRequest& request) {
  EditedWalk result;
  Arrival arrival;
  if (request.arrive) arrival = arrivalAt(captured, *request.arrive);
  result.refused = arrival.refused;
  if (!result.refused.empty()) return result;
  result.stride = arrival.factor;
  const CapturedWalk walk = request.arrive ? turned(captured, arrival.angle) : captured;
  WalkTracks tracks = tracksOf(walk.clip, walk.roles);
  if (request.foot_lock) {
    result.lock_moved = lockTracks(walk.analysis.plants, walk.clip.frame_time, tracks);
  }
  if (request.lift) lift(walk, *request.lift, tracks);
  if (request.stairs) {
    climb(walk, *request.stairs, tracks, result);
    if (!result.refused.empty()) return result;
  } else if (request.changesWalk()) {
    walkOn(walk, request, arrival.factor, tracks, result);
  } else {
    result.ground = std::make_unique<FlatGround>();
  }
  result.clip = followTracks(walk.clip, walk.roles, tracks, &result.fit);
  if (request.foot_lock) holdAsFound(walk, request.incline.has_value(), result);
  if (result.fit.missed > kMostMissed || result.fit.lowered > kMostLowered) {
    result.refused = fmt::format(
        "the hips would go down by {:.0f} mm, and feet still miss their places by {:.0f} mm; at "
        "most "
        "{:g} and {:g}",
        1e3 * result.fit.lowered, 1e3 * result.fit.missed, 1e3 * kMostLowered, 1e3 * kMostMissed);
  }
  return result;
}

}  // namespace

EditedWalk editWalk(const CapturedWalk& captured, const EditRequest& request) {
  EditedWalk result = editOnce(captured, request);
  if (!request.arrive || !result.refused.empty()) return result;
  // Held feet take the root along by some millimetres: it is aimed as far beside.
  const Eigen::Vector3d& end = result.clip.poses.p_WR(result.clip.frames() - 1);
  const Eigen::Vector2d beside = end.head<2>() - *request.arrive;
  if (beside.norm() < kArrives) return result;
  EditRequest aimed = request;
  *aimed.arrive -= beside;
  EditedWalk again = editOnce(captured, aimed);
  return again.refused.empty() ? std::move(again) : std::move(result);
}

}  // namespace amble
