#include "environments/collision/sunk_parts.h"

#include <algorithm>

#include "environments/collision/collision_world.h"

namespace amble {

std::vector<SunkPart> sunkParts(const Body& body, const Skeleton& skeleton, PoseView pose) {
  std::vector<JointFrame> joints(skeleton.size());
  forwardKinematics(skeleton, pose, joints);
  std::vector<Eigen::Vector3d> from(body.parts.size()), to(body.parts.size());
  placeBody(body, joints, from, to);
  std::vector<SunkPart> sunk;
  for (size_t i = 0; i < body.parts.size(); ++i) {
    const BodyPart& part = body.parts[i];
    const double depth = part.radius - std::min(from[i].z(), to[i].z());
    if (depth > (part.sole >= 0 ? kSoleDepth : 0.0)) sunk.push_back({part.name, depth});
  }
  std::stable_sort(sunk.begin(), sunk.end(),
                   [](const SunkPart& a, const SunkPart& b) { return a.depth > b.depth; });
  return sunk;
}

}  // namespace amble
