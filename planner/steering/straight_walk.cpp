#include "planner/steering/straight_walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "base/rotation.h"

namespace amble {
namespace {

constexpr int kPlaces = 7;       // a side of the ground's extent
constexpr int kDirections = 8;   // from each
constexpr double kSlice = 0.02;  // of a path, in which breadths are told apart [m]
// How nearly steps fall into a short gap as suits best, of those that a search tries; by trial [m].
constexpr double kNeverQuite = 0.01;
constexpr double kBesideEnds = 0.5;  // of a walk: there it is no walk yet [m]
constexpr int kOnAxis = 4;           // parts of a capsule's axis, at whose ends it is looked at
constexpr std::array<double, 4> kTurns = {0.5 * kPi, -0.5 * kPi, kPi, -kPi};

// Lifts differ by so much from step to step without anything to step over [m].
constexpr double kNoLift = 0.01;

bool isLevel(const AnimationBuffer& buffer) {
  Eigen::AlignedBox1d heights;
  for (const FrameState& state : buffer.states)
    heights.extend(Eigen::AlignedBox1d::VectorType(state.position.z()));
  return heights.sizes()[0] <= SceneGround::kLevel;
}

}  // namespace

StraightWalk straightWalk(const WalkSynthesizer& synthesizer, const SceneGround& ground,
                          double length) {
  const Eigen::AlignedBox2d extent = ground.extent();
  StraightWalk walk;
  if (extent.isEmpty()) return walk;
  // On level ground with nothing to step over: legs that are lifted over furniture measure nothing.
  for (int i = 0; i < kPlaces * kPlaces * kDirections; ++i) {
    const int place = i / kDirections;
    const Eigen::Vector2d share((place % kPlaces + 0.5) / kPlaces,
                                (place / kPlaces + 0.5) / kPlaces);
    Stance from;
    const double lowest = ground.heights().min()[0];
    from.position << extent.min() + share.cwiseProduct(extent.sizes()), lowest;
    if (!ground.isLevel()) {
      const auto under = ground.stand(from.position.x(), from.position.y(), lowest,
                                      std::numeric_limits<double>::infinity());
      if (!under) continue;
      from.position.z() = under->height;
    }
    from.heading = 2.0 * kPi * (i % kDirections) / kDirections;
    Stance to = from;
    to.position += length * Eigen::Vector3d(std::cos(from.heading), std::sin(from.heading), 0.0);
    walk.path = RootPath({makeBezier(from.position.head<2>(), from.heading, to.position.head<2>(),
                                     to.heading, 1.0 / 3.0)});
    const WalkResult made = synthesizer.walk(
        from, to, walk.path, true, walk.buffer, {},
        [&](int, Side, std::span<const GaitParameters> gait) {
          return std::none_of(gait.begin(), gait.end(), [&](const GaitParameters& step) {
            return step.lift > synthesizer.capturedLift() + kNoLift;
          });
        });
    if (made.refused != WalkRule::kNone || made.unwanted || !isLevel(walk.buffer)) continue;
    for (const double angle : kTurns) {
      AnimationBuffer turn;
      if (synthesizer.turnOnSpot(from, angle, turn).refused == WalkRule::kNone)
        walk.turns.push_back(std::move(turn));
    }
    return walk;
  }
  return {};
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
