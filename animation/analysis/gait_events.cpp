#include "animation/analysis/gait_events.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "animation/analysis/low_pass.h"
#include "animation/body/foot_shape.h"
#include "animation/clips/floor_fit.h"
#include "base/statistics.h"

namespace amble {
namespace {

// Johansen's rules: the lift is before the point has this share of its greatest height, and before
// it moves faster along the ground than this share of the walk. Both by trial, he says.
constexpr double kRisen = 0.1;
constexpr double kMoving = 0.5;

// Share of a plant at both ends in which the foot rolls, and does not stand flat.
constexpr double kRolling = 0.3;

constexpr double kUnseen = std::numeric_limits<double>::quiet_NaN();

/// Median of `values` over the flat middles of all plants; the least value where there is none.
double standing(const Eigen::VectorXd& values, const std::vector<FootPlant>& plants) {
  std::vector<double> flat;
  for (const FootPlant& plant : plants) {
    const int trim = static_cast<int>(kRolling * (plant.last - plant.first));
    for (int i = plant.first + trim; i <= plant.last - trim; ++i) flat.push_back(values[i]);
  }
  return flat.empty() ? values.minCoeff() : median(std::move(flat));
}

/// Speed across the normal of the point in columns first .. first + 2 of `velocity` [m/s].
Eigen::VectorXd alongFloor(const Eigen::MatrixXd& velocity, int first,
                           const Eigen::Vector3d& normal) {
  const auto v = velocity.middleCols(first, 3);
  return (v.rowwise().squaredNorm() - (v * normal).cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
}

/// A point of the foot followed from where it stands, in steps of +1 or -1 frame.
struct Way {
  int from, to, step;
  double speed_limit;  // [m/s]
};

/// The frame at which the point leaves the ground on that way (backwards: at which it has come
/// down). Heights count from where it stands at the way's start: no two stands are equally high.
int leaves(const Eigen::VectorXd& heights, const Eigen::VectorXd& speed, const Way& way) {
  const double ground = heights[way.from];
  const auto height = [&](int i) { return heights[i] - ground; };
  double highest = 0.0;
  for (int i = way.from; i != way.to + way.step; i += way.step) {
    highest = std::max(highest, height(i));
  }
  int risen = way.from;
  while (risen != way.to && height(risen) < kRisen * highest) risen += way.step;
  const int last = static_cast<int>(heights.size()) - 1;
  int sharpest = risen;
  double most = 0.0;
  for (int i = way.from; i != risen; i += way.step) {
    if (i == 0 || i == last) continue;
    const double slope = way.step * (heights[i + 1] - heights[i - 1]);
    const double curvature = heights[i + 1] - 2.0 * heights[i] + heights[i - 1];
    // Johansen's rules 3 and 4; a point that sinks counts where it has come up again.
    if (slope < 0.0 || height(i) < 0.0 || curvature <= most) continue;
    most = curvature;
    sharpest = i;
  }
  for (int i = way.from; i != sharpest; i += way.step) {
    if (speed[i] > way.speed_limit) return i;
  }
  return sharpest;
}

int middleOf(const FootPlant& plant) { return (plant.first + plant.last) / 2; }

// How fast the foot travels from one stand to the next [m/s].
double travelSpeed(const Eigen::MatrixXd& path, int from, int to, double frame_time) {
  if (to <= from) return 0.0;
  return (path.row(to).head<3>() - path.row(from).head<3>()).norm() / ((to - from) * frame_time);
}

/// The swing from `before` to `after`; either may be missing, but not both.
SwingEvents swingEvents(const FootCurves& curves, const FootPlant* before, const FootPlant* after,
                        const Eigen::MatrixXd& path, double frame_time) {
  const int frames = static_cast<int>(path.rows());
  const int from = before != nullptr ? middleOf(*before) : 0;
  const int to = after != nullptr ? middleOf(*after) : frames - 1;
  const double limit = kMoving * travelSpeed(path, from, to, frame_time);
  SwingEvents events;
  events.lift = events.lift_off = events.strike = events.landing = kUnseen;
  events.heel = events.toe = {kUnseen, kUnseen};
  if (before != nullptr) {
    const Way way{from, to, 1, limit};
    events.lift_off = before->lift_off;
    events.heel.lift =
        std::min<double>(leaves(curves.heel_height, curves.heel_speed, way), events.lift_off);
    events.toe.lift =
        std::min<double>(leaves(curves.toe_height, curves.toe_speed, way), events.lift_off);
    events.lift = std::min(events.heel.lift, events.toe.lift);
  }
  if (after != nullptr) {
    const Way way{to, from, -1, limit};
    events.strike = after->strike;
    events.heel.landing =
        std::max<double>(leaves(curves.heel_height, curves.heel_speed, way), events.strike);
    events.toe.landing =
        std::max<double>(leaves(curves.toe_height, curves.toe_speed, way), events.strike);
    events.landing = std::max(events.heel.landing, events.toe.landing);
  }
  return events;
}

}  // namespace

std::array<FootCurves, 2> footCurves(const FootPaths& paths, const std::array<double, 2>& legs,
                                     double frame_time, const FootPlants& plants) {
  assert(plants.frames == paths[kLeft].rows() && plants.frames > 0);
  const FloorFit floor = fitFloor(paths, legs, frame_time);
  std::array<FootCurves, 2> curves;
  for (const Side side : {kLeft, kRight}) {
    Eigen::MatrixXd path = paths[side];
    lowPass(path, 1.0 / frame_time, PlantOptions{}.cutoff);
    const Eigen::MatrixXd velocity = derivative(path, 1.0 / frame_time);
    const Eigen::VectorXd ankle = path.leftCols<3>() * floor.normal;
    const Eigen::VectorXd toe = path.rightCols<3>() * floor.normal;
    const Eigen::VectorXd length = (path.rightCols<3>() - path.leftCols<3>()).rowwise().norm();
    const Eigen::VectorXd pitch =
        ((ankle - toe).array() / length.array().max(1e-9)).max(-1.0).min(1.0).asin();
    const double flat = standing(pitch, plants.plants[side]);
    FootCurves& out = curves[side];
    out.toe_height = toe.array() - standing(toe, plants.plants[side]);
    out.heel_height = ankle.array() - standing(ankle, plants.plants[side]) +
                      kAnkleHeightOfLeg * legs[side] * (1.0 - (pitch.array() - flat).cos());
    out.heel_speed = alongFloor(velocity, 0, floor.normal);
    out.toe_speed = alongFloor(velocity, 3, floor.normal);
  }
  return curves;
}

GaitEvents findGaitEvents(const std::array<FootCurves, 2>& curves, double frame_time,
                          const FootPlants& plants, const FootPaths& paths) {
  GaitEvents events;
  for (const Side side : {kLeft, kRight}) {
    const std::vector<FootPlant>& stands = plants.plants[side];
    const auto add = [&](const FootPlant* before, const FootPlant* after) {
      events.swings[side].push_back(
          swingEvents(curves[side], before, after, paths[side], frame_time));
    };
    if (stands.empty()) continue;
    if (stands.front().first > 0) add(nullptr, &stands.front());
    for (size_t i = 1; i < stands.size(); ++i) add(&stands[i - 1], &stands[i]);
    if (stands.back().last < plants.frames - 1) add(&stands.back(), nullptr);
  }
  return events;
}

GaitEvents findGaitEvents(const Clip& clip, const JointRoles& roles, const FootPlants& plants) {
  if (clip.frames() == 0) return {};
  const FootPaths paths = footPaths(clip, roles);
  const auto curves = footCurves(paths, legLengths(clip, roles), clip.frame_time, plants);
  return findGaitEvents(curves, clip.frame_time, plants, paths);
}

}  // namespace amble
