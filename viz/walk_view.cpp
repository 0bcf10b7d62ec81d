#include "viz/walk_view.h"

#include <algorithm>
#include <cmath>

namespace amble {

using Eigen::Vector2d;
using Eigen::Vector3d;

std::vector<JointFrame> jointFramesAt(const WalkView& view, int frame) {
  std::vector<JointFrame> joints(view.skeleton->size());
  forwardKinematics(*view.skeleton, view.animation->poses[frame], joints);
  return joints;
}

PlacedBody placeBodyAt(const WalkView& view, int frame) {
  const std::vector<JointFrame> joints = jointFramesAt(view, frame);
  PlacedBody placed;
  placed.from.resize(view.body->parts.size());
  placed.to.resize(view.body->parts.size());
  placeBody(*view.body, joints, placed.from, placed.to);
  return placed;
}

std::vector<Vector2d> pathLine(const WalkView& view) {
  std::vector<Vector2d> line;
  if (view.path == nullptr || view.path->empty()) return line;
  const int pieces = std::max(1, static_cast<int>(std::ceil(view.path->length() / 0.02)));
  for (int i = 0; i <= pieces; ++i)
    line.push_back(view.path->at(view.path->length() * i / pieces).position);
  return line;
}

double soleLength(const WalkView& view) {
  constexpr double kUsual = 0.27;  // an adult's shoe [m]
  if (!view.hasBody()) return kUsual;
  // In the first frame somebody stands: the spread of one foot's sole capsules is the sole.
  const PlacedBody placed = placeBodyAt(view, 0);
  double length = 0;
  const auto& parts = view.body->parts;
  for (size_t i = 0; i < parts.size(); ++i) {
    for (size_t k = 0; k < parts.size(); ++k) {
      if (parts[i].sole < 0 || parts[k].sole != parts[i].sole) continue;
      for (const Vector3d& a : {placed.from[i], placed.to[i]})
        for (const Vector3d& b : {placed.from[k], placed.to[k]})
          length = std::max(length, (a - b).head<2>().norm() + parts[i].radius + parts[k].radius);
    }
  }
  return length > 0.1 && length < 0.5 ? length : kUsual;
}

std::vector<Vector2d> shoeOutline(Side side, double length) {
  // A right sole, counter-clockwise from the middle of the heel, as (share of the length, share of
  // the width); left is +.
  static constexpr double kShape[][2] = {
      {-0.50, 0.00}, {-0.47, -0.24}, {-0.40, -0.36}, {-0.28, -0.38}, {-0.10, -0.34},
      {0.08, -0.42}, {0.22, -0.50},  {0.33, -0.46},  {0.42, -0.32},  {0.475, -0.12},
      {0.50, 0.12},  {0.475, 0.32},  {0.40, 0.44},   {0.28, 0.48},   {0.16, 0.42},
      {0.02, 0.26},  {-0.12, 0.18},  {-0.28, 0.26},  {-0.40, 0.30},  {-0.47, 0.22}};
  const double width = 0.37 * length;
  std::vector<Vector2d> outline;
  for (const auto& p : kShape)
    outline.emplace_back(p[0] * length, (side == kRight ? 1 : -1) * p[1] * width);
  if (side == kLeft) std::reverse(outline.begin(), outline.end());  // mirrored: wound the other way
  return outline;
}

std::vector<Vector2d> placedShoe(const Footprint& footprint, double length) {
  const double c = std::cos(footprint.heading), s = std::sin(footprint.heading);
  std::vector<Vector2d> outline = shoeOutline(footprint.side, length);
  for (Vector2d& p : outline)
    p = footprint.position.head<2>() + Vector2d(c * p.x() - s * p.y(), s * p.x() + c * p.y());
  return outline;
}

}  // namespace amble
