#include "planner/steering/straight_walk.h"

#include <cmath>
#include <limits>

#include "base/rotation.h"

namespace amble {
namespace {

constexpr int kPlaces = 7;      // a side of the ground's extent
constexpr int kDirections = 8;  // from each
constexpr int kOnAxis = 4;      // parts of a capsule's axis, at whose ends it is looked at

// Lifts differ by so much from step to step without anything to step over [m].
constexpr double kUsualLift = 0.01;

// On level ground with nothing to step over: legs that are lifted over furniture measure nothing.
bool isPlain(const AnimationBuffer& buffer, double captured_lift) {
  Eigen::AlignedBox1d heights;
  for (const Footprint& print : buffer.footprints)
    if (print.gait.lift > captured_lift + kUsualLift) return false;
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
    if (synthesizer.walk(from, to, walk.path, true, walk.buffer).refused == WalkRule::kNone &&
        isPlain(walk.buffer, synthesizer.capturedLift()))
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

}  // namespace amble
