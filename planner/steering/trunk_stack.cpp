#include "planner/steering/trunk_stack.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

namespace amble {

namespace {

int partNamed(const Body& body, std::string_view name) {
  const auto found = std::ranges::find(body.parts, name, &BodyPart::name);
  return found == body.parts.end() ? -1 : static_cast<int>(found - body.parts.begin());
}

// Of a part's axis.
struct Point {
  int part = -1;  // of the body
  double along = 0.5;
};

// Of balls about these points, as they are seen from one of them.
TrunkStack stackOf(const std::vector<Point>& points, size_t seen_from, const StraightWalk& walk,
                   const Skeleton& skeleton, const Body& body, double margin) {
  std::vector<JointFrame> joints(skeleton.size());
  std::vector<Eigen::Vector3d> from(body.parts.size()), to(body.parts.size());
  std::vector<std::vector<Eigen::Vector3d>> seen(points.size());
  Eigen::AlignedBox1d heights;
  const auto look = [&](const AnimationBuffer& buffer) {
    for (int frame = 0; frame < buffer.size(); ++frame) {
      forwardKinematics(skeleton, buffer.poses[frame], joints);
      placeBody(body, joints, from, to);
      const auto at = [&](const Point& point) -> Eigen::Vector3d {
        return from[point.part] + point.along * (to[point.part] - from[point.part]);
      };
      const Eigen::Vector3d eye = at(points[seen_from]);
      const double over = eye.z() - buffer.states[frame].position.z();
      heights.extend(Eigen::AlignedBox1d(over, over));
      for (size_t i = 0; i < points.size(); ++i) seen[i].emplace_back(at(points[i]) - eye);
    }
  };
  look(walk.buffer);
  for (const AnimationBuffer& turn : walk.turns) look(turn);
  const double height = heights.center()[0];
  std::vector<StackedBall> balls;
  for (size_t i = 0; i < points.size(); ++i) {
    Eigen::AlignedBox1d over;
    for (const Eigen::Vector3d& at : seen[i]) over.extend(Eigen::AlignedBox1d(at.z(), at.z()));
    const Eigen::Vector3d middle(0.0, 0.0, over.center()[0]);
    double farthest = 0.0;
    for (const Eigen::Vector3d& at : seen[i]) farthest = std::max(farthest, (at - middle).norm());
    const double radius = body.parts[points[i].part].radius - margin - farthest;
    if (radius > 0.0) balls.push_back({height + middle.z(), radius, points[i].part});
  }
  std::ranges::sort(balls, {}, &StackedBall::height);
  TrunkStack stack{{}, 0.5 * heights.sizes()[0]};
  std::ranges::copy_if(balls, std::back_inserter(stack.balls), [&](const StackedBall& own) {
    return std::ranges::none_of(balls, [&](const StackedBall& other) {
      return other.radius > own.radius &&
             std::abs(other.height - own.height) <= other.radius - own.radius;
    });
  });
  return stack;
}

}  // namespace

std::vector<TrunkStack> trunkStacks(const StraightWalk& walk, const Skeleton& skeleton,
                                    const JointRoles& roles, const Body& body, double margin) {
  const auto hips = std::ranges::find(body.parts, roles.hips, &BodyPart::joint);
  const int pelvis = hips == body.parts.end() ? -1 : static_cast<int>(hips - body.parts.begin());
  const int chest = partNamed(body, "chest");
  const int abdomen = partNamed(body, "abdomen"), neck = partNamed(body, "neck");
  std::vector<TrunkStack> stacks;
  const auto add = [&](const std::vector<Point>& points, size_t seen_from) {
    if (walk.buffer.size() == 0 || std::ranges::min(points, {}, &Point::part).part < 0) return;
    TrunkStack stack = stackOf(points, seen_from, walk, skeleton, body, margin);
    if (!stack.balls.empty()) stacks.push_back(std::move(stack));
  };
  add({{pelvis}, {abdomen}, {chest}}, 1);
  add({{chest}, {neck, 0.0}, {neck, 0.5}, {neck, 1.0}, {body.head}}, 1);
  return stacks;
}

}  // namespace amble
