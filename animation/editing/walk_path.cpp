#include "animation/editing/walk_path.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "animation/analysis/motion_measures.h"

namespace amble {
namespace {

// A cycle of two steps, over which the root sways to both sides [s].
constexpr double kSway = 1.0;
constexpr double kNearEnd = 0.3;  // over which the path is straight at its ends [s]
// A foot is put down, or stands, so long before or after the root passes it [s].
constexpr double kPassing = 0.5;
constexpr double kBeyond = 1.0;  // how far beyond the clip's ends that may be [s]

// Of points a frame apart, between frames and straight on beyond the ends.
Eigen::Vector2d pointAt(const std::vector<Eigen::Vector2d>& points, double frame, int near_end) {
  const int last = static_cast<int>(points.size()) - 1;
  if (last == 0) return points[0];
  const int span = std::min(near_end, last);
  if (frame < 0.0) return points[0] + frame / span * (points[span] - points[0]);
  if (frame > last) {
    return points[last] + (frame - last) / span * (points[last] - points[last - span]);
  }
  const int i = std::min(static_cast<int>(frame), last - 1);
  return points[i] + (frame - i) * (points[i + 1] - points[i]);
}

}  // namespace

WalkPath::WalkPath(const std::vector<Eigen::Vector3d>& root, double frame_time) {
  assert(!root.empty());
  near_end_ = std::max(1, static_cast<int>(std::lround(kNearEnd / frame_time)));
  for (const Eigen::Vector3d& p : smoothed(root, frame_time, kSway)) {
    arcs_.push_back(points_.empty() ? 0.0 : arcs_.back() + (p.head<2>() - points_.back()).norm());
    points_.emplace_back(p.head<2>());
  }
}

double WalkPath::share(int frame) const { return length() > 0.0 ? arcs_[frame] / length() : 0.0; }

double WalkPath::passing(const Eigen::Vector2d& point, int first, int last) const {
  const double second = near_end_ / kNearEnd;  // [frames]
  const int reach = static_cast<int>(kPassing * second),
            beyond = static_cast<int>(kBeyond * second);
  const int end = frames() - 1;
  const int from = first - reach <= 0 ? -beyond : first - reach;
  const int to = last + reach >= end ? end + beyond : last + reach;
  double nearest = from, least = 1e300;
  for (int i = from; i < to; ++i) {
    const Eigen::Vector2d a = pointAt(points_, i, near_end_);
    const Eigen::Vector2d way = pointAt(points_, i + 1, near_end_) - a;
    const double squared = way.squaredNorm();
    const double share = squared > 0.0 ? std::clamp((point - a).dot(way) / squared, 0.0, 1.0) : 0.0;
    const double distance = (a + share * way - point).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    nearest = i + share;
  }
  return nearest;
}

std::vector<Eigen::Vector2d> WalkPath::scaled(
    const std::function<double(double share)>& factor) const {
  std::vector<Eigen::Vector2d> shifts(points_.size(), Eigen::Vector2d::Zero());
  for (int i = 1; i < frames(); ++i) {
    const double middle = 0.5 * (share(i - 1) + share(i));
    shifts[i] = shifts[i - 1] + (factor(middle) - 1.0) * (points_[i] - points_[i - 1]);
  }
  return shifts;
}

Eigen::Vector2d WalkPath::between(const std::vector<Eigen::Vector2d>& shifts, double frame) const {
  return pointAt(shifts, frame, near_end_);
}

}  // namespace amble
