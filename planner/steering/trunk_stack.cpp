#include "planner/steering/trunk_stack.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace amble {

namespace {

int partNamed(const Body& body, std::string_view name) {
  const auto found = std::ranges::find(body.parts, name, &BodyPart::name);
  return found == body.parts.end() ? -1 : static_cast<int>(found - body.parts.begin());
}

// Of these parts, none of them -1; the second is the middle one.
TrunkStack stackOf(const std::array<int, 3>& parts, const StraightWalk& walk,
                   const Skeleton& skeleton, const Body& body, double margin) {
  const int frames = walk.buffer.size();
  std::vector<JointFrame> joints(skeleton.size());
  std::vector<Eigen::Vector3d> from(body.parts.size()), to(body.parts.size());
  std::array<std::vector<Eigen::Vector3d>, 3> seen;  // from the middle part
  double height = 0.0;
  Eigen::AlignedBox1d heights;
  for (int frame = 0; frame < frames; ++frame) {
    forwardKinematics(skeleton, walk.buffer.poses[frame], joints);
    placeBody(body, joints, from, to);
    const auto middleOf = [&](int part) -> Eigen::Vector3d {
      return 0.5 * (from[part] + to[part]);
    };
    const Eigen::Vector3d middle = middleOf(parts[1]);
    const double over = middle.z() - walk.buffer.states[frame].position.z();
    height += over / frames;
    heights.extend(Eigen::AlignedBox1d(over, over));
    for (int i = 0; i < 3; ++i) seen[i].emplace_back(middleOf(parts[i]) - middle);
  }
  TrunkStack stack{{}, height - heights.min()[0], heights.max()[0] - height};
  for (int i = 0; i < 3; ++i) {
    double mean = 0.0, farthest = 0.0;
    for (const Eigen::Vector3d& at : seen[i]) mean += at.z() / frames;
    for (const Eigen::Vector3d& at : seen[i])
      farthest = std::max(farthest, (at - Eigen::Vector3d(0.0, 0.0, mean)).norm());
    const double radius = body.parts[parts[i]].radius - margin - farthest;
    if (radius > 0.0) stack.balls.push_back({height + mean, radius, parts[i]});
  }
  std::ranges::sort(stack.balls, {}, &StackedBall::height);
  return stack;
}

}  // namespace

std::vector<TrunkStack> trunkStacks(const StraightWalk& walk, const Skeleton& skeleton,
                                    const JointRoles& roles, const Body& body, double margin) {
  const auto hips = std::ranges::find(body.parts, roles.hips, &BodyPart::joint);
  const int pelvis = hips == body.parts.end() ? -1 : static_cast<int>(hips - body.parts.begin());
  const int chest = partNamed(body, "chest");
  std::vector<TrunkStack> stacks;
  for (const std::array<int, 3>& parts : {std::array{pelvis, partNamed(body, "abdomen"), chest},
                                          std::array{chest, partNamed(body, "neck"), body.head}}) {
    if (walk.buffer.size() == 0 || std::ranges::min(parts) < 0) continue;
    TrunkStack stack = stackOf(parts, walk, skeleton, body, margin);
    if (!stack.balls.empty()) stacks.push_back(std::move(stack));
  }
  return stacks;
}

}  // namespace amble
