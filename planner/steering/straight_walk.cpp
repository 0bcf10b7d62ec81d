#include "planner/steering/straight_walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "animation/ground/ground.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr double kSlice = 0.02;  // of a path, in which breadths are told apart [m]
// How nearly steps fall into a short gap as suits best, of those that a search tries; by trial [m].
constexpr double kNeverQuite = 0.01;
constexpr double kBesideEnds = 0.5;  // of a walk: there it is no walk yet [m]
constexpr int kOnAxis = 4;           // parts of a capsule's axis, at whose ends it is looked at
constexpr std::array<double, 4> kTurns = {0.5 * kPi, -0.5 * kPi, kPi, -kPi};

}  // namespace

StraightWalk straightWalk(const WalkSynthesizer& synthesizer, double length) {
  const FlatGround level;
  const std::unique_ptr<WalkSynthesizer> walker = synthesizer.on(level);
  const Stance from;
  Stance to;
  to.position.x() = length;
  StraightWalk walk;
  walk.path =
      RootPath({makeBezier(from.position.head<2>(), 0.0, to.position.head<2>(), 0.0, 1.0 / 3.0)});
  if (walker->walk(from, to, walk.path, true, walk.buffer).refused != WalkRule::kNone) return {};
  for (const double angle : kTurns) {
    AnimationBuffer turn;
    if (walker->turnOnSpot(from, angle, turn).refused == WalkRule::kNone)
      walk.turns.push_back(std::move(turn));
  }
  return walk;
}

Eigen::AlignedBox1d walkingBreadth(const StraightWalk& walk, const Skeleton& skeleton,
                                   const Body& body, const Eigen::AlignedBox1d& heights) {
  std::vector<JointFrame> joints(skeleton.size());
  std::vector<Eigen::Vector3d> from(body.parts.size()), to(body.parts.size());
  Eigen::AlignedBox1d breadth;
  for (int frame = 0; frame < walk.buffer.size(); ++frame) {
    forwardKinematics(skeleton, walk.buffer.poses[frame], joints);
    placeBody(body, joints, from, to);
    const FrameState& state = walk.buffer.states[frame];
    const Eigen::Vector3d left(-std::sin(state.heading), std::cos(state.heading), 0.0);
    for (size_t i = 0; i < body.parts.size(); ++i) {
      for (int k = 0; k <= kOnAxis; ++k) {
        const Eigen::Vector3d p = from[i] + (to[i] - from[i]) * k / kOnAxis - state.position;
        const double offset = left.dot(p), r = body.parts[i].radius;
        if (heights.intersects(Eigen::AlignedBox1d(p.z() - r, p.z() + r)))
          breadth.extend(Eigen::AlignedBox1d(offset - r, offset + r));
      }
    }
  }
  return breadth;
}

Eigen::AlignedBox1d walkingBreadth(const StraightWalk& walk, const Skeleton& skeleton,
                                   const Body& body) {
  return walkingBreadth(walk, skeleton, body, Eigen::AlignedBox1d(-HUGE_VAL, HUGE_VAL));
}

double passableBreadth(const StraightWalk& walk, const Skeleton& skeleton, const Body& body,
                       double depth) {
  if (walk.buffer.size() == 0) return 0.0;
  const Eigen::Vector3d begin = walk.buffer.states.front().position;
  const double length = walk.path.length(), heading = walk.buffer.states.front().heading;
  const Eigen::Vector3d ahead(std::cos(heading), std::sin(heading), 0.0);
  const Eigen::Vector3d left(-ahead.y(), ahead.x(), 0.0);
  // By slices across the path, what the body sweeps of each.
  std::vector<Eigen::AlignedBox1d> slices(static_cast<size_t>(length / kSlice) + 1);
  std::vector<JointFrame> joints(skeleton.size());
  std::vector<Eigen::Vector3d> from(body.parts.size()), to(body.parts.size());
  for (int frame = 0; frame < walk.buffer.size(); ++frame) {
    forwardKinematics(skeleton, walk.buffer.poses[frame], joints);
    placeBody(body, joints, from, to);
    for (size_t i = 0; i < body.parts.size(); ++i) {
      for (int k = 0; k <= 2 * kOnAxis; ++k) {
        const Eigen::Vector3d p = from[i] + (to[i] - from[i]) * k / (2 * kOnAxis) - begin;
        const double r = body.parts[i].radius, x = ahead.dot(p), y = left.dot(p);
        const int first = std::max(0, static_cast<int>(std::ceil((x - r) / kSlice)));
        for (int j = first; j < static_cast<int>(slices.size()) && j * kSlice <= x + r; ++j) {
          const double off = j * kSlice - x, half = std::sqrt(std::max(0.0, r * r - off * off));
          slices[j].extend(Eigen::AlignedBox1d(y - half, y + half));
        }
      }
    }
  }
  const int count = 1 + static_cast<int>(depth / kSlice);
  const int beside = static_cast<int>(kBesideEnds / kSlice);
  const double most = walkingBreadth(walk, skeleton, body).sizes()[0];
  double least = most;
  for (int j = beside; j + count + beside <= static_cast<int>(slices.size()); ++j) {
    Eigen::AlignedBox1d breadth;
    for (int k = 0; k < count; ++k) breadth.extend(slices[j + k]);
    least = std::min(least, breadth.sizes()[0]);
  }
  return std::min(most, least + kNeverQuite);
}

std::vector<PartWay> waysOfParts(const StraightWalk& walk, const Skeleton& skeleton,
                                 const Body& body) {
  std::vector<PartWay> ways(body.parts.size());
  std::vector<JointFrame> joints(skeleton.size());
  std::vector<Eigen::Vector3d> from(body.parts.size()), to(body.parts.size());
  for (int frame = 0; frame < walk.buffer.size(); ++frame) {
    forwardKinematics(skeleton, walk.buffer.poses[frame], joints);
    placeBody(body, joints, from, to);
    const Eigen::Vector3d& path = walk.buffer.states[frame].position;
    for (size_t part = 0; part < ways.size(); ++part) {
      PartWay& way = ways[part];
      const Eigen::Vector3d a = from[part] - path, b = to[part] - path;
      way.middle.extend(Eigen::Matrix<double, 1, 1>(0.5 * (a.z() + b.z())));
      way.upper.extend(Eigen::Matrix<double, 1, 1>(std::max(a.z(), b.z())));
      way.aside = std::max({way.aside, a.head<2>().norm(), b.head<2>().norm()});
    }
  }
  return ways;
}

}  // namespace amble
