#include "animation/body/skeleton.h"

#include <cassert>
#include <stdexcept>

namespace amble {
namespace {

bool isOrder(const RotationOrder& order) {
  int seen = 0;
  for (const char axis : order) {
    if (axis < 'X' || axis > 'Z') return false;
    seen |= 1 << (axis - 'X');
  }
  return seen == 7;
}

void checkJoint(const Joint& joint, int index) {
  const std::string who = "Skeleton: joint " + std::to_string(index) + " (" + joint.name + ")";
  if (index == 0 ? joint.parent != -1 : (joint.parent < 0 || joint.parent >= index)) {
    throw std::invalid_argument(who + ": its parent does not precede it");
  }
  if (!isOrder(joint.order))
    throw std::invalid_argument(who + ": rotation order is no permutation of XYZ");
  bool finite = joint.offset.allFinite();
  for (const Eigen::Vector3d& tip : joint.end_sites) finite = finite && tip.allFinite();
  if (!finite) throw std::invalid_argument(who + ": an offset is not finite");
}

}  // namespace

Skeleton::Skeleton(std::vector<Joint> joints) : joints_(std::move(joints)) {
  if (joints_.empty()) throw std::invalid_argument("Skeleton: no joints");
  for (int i = 0; i < size(); ++i) checkJoint(joints_[i], i);
}

int Skeleton::find(std::string_view name) const {
  for (int i = 0; i < size(); ++i) {
    if (joints_[i].name == name) return i;
  }
  return -1;
}

bool Skeleton::isAncestor(int ancestor, int joint) const {
  assert(joint >= 0 && joint < size());
  // Parents precede their children, so an ancestor's index is never above its descendant's.
  while (joint > ancestor) joint = joints_[joint].parent;
  return joint == ancestor;
}

Skeleton Skeleton::scaled(double factor) const {
  assert(factor > 0.0);
  Skeleton result = *this;
  for (Joint& joint : result.joints_) {
    joint.offset *= factor;
    for (Eigen::Vector3d& tip : joint.end_sites) tip *= factor;
  }
  return result;
}

}  // namespace amble
