#include "animation/captures/role_tree.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace amble {
namespace {

constexpr int kLimb = 3;          // joints of an arm or a leg, at least
constexpr double kAlike = 0.1;    // bones of twins differ by no more than that share; by trial [1]
constexpr int kFramesSeen = 64;   // frames that are looked at, spread over the clip [1, >= 1]
constexpr size_t kMaxTwins = 64;  // children of a joint that are compared: no body has more limbs

/// A chain of joints, from the body outwards.
using Chain = std::vector<int>;

struct TwinLimbs {
  int parent = -1;
  std::array<int, 2> tops = {-1, -1};
  double length = 0.0;  // of the longest chain of bones below, mean of both
};

class TreeGuess {
 public:
  explicit TreeGuess(const Clip& clip);
  JointRoles guess();

 private:
  bool alike(int a, int b) const;
  void findTwins();
  bool chooseLimbs();
  Chain mainChain(int top) const;
  int longBones(const Chain& chain) const;
  void setLeg(int side, const Chain& chain);
  void setArm(int side, const Chain& chain);
  void setTrunk();
  void settleSides();
  double leftness(std::span<const JointFrame> joints) const;

  const Clip& clip_;
  const Skeleton& skeleton_;
  std::vector<std::vector<int>> children_;
  std::vector<double> bone_;   // by joint: length of the bone that leads to it
  std::vector<double> reach_;  // by joint: the longest way from its parent down to an end
  std::vector<int> height_;    // by joint: joints on the longest chain below, itself included
  std::vector<TwinLimbs> twins_;
  TwinLimbs legs_, arms_;
  JointRoles roles_;
};

TreeGuess::TreeGuess(const Clip& clip) : clip_(clip), skeleton_(clip.skeleton) {
  const int count = skeleton_.size();
  children_.resize(count);
  bone_.assign(count, 0.0);
  reach_.assign(count, 0.0);
  height_.assign(count, 1);
  for (int j = 1; j < count; ++j) {
    children_[skeleton_.joint(j).parent].push_back(j);
    bone_[j] = skeleton_.joint(j).offset.norm();
  }
  for (int j = count; j-- > 0;) {
    reach_[j] += bone_[j];
    if (j == 0) break;
    const int parent = skeleton_.joint(j).parent;
    reach_[parent] = std::max(reach_[parent], reach_[j]);
    height_[parent] = std::max(height_[parent], height_[j] + 1);
  }
}

/// Bone for bone as long, as far as the longest way down goes.
bool TreeGuess::alike(int a, int b) const {
  if (height_[a] != height_[b] || height_[a] < kLimb) return false;
  const Chain one = mainChain(a), other = mainChain(b);
  if (one.size() != other.size()) return false;
  double difference = 0.0;
  for (size_t i = 0; i < one.size(); ++i) difference += std::abs(bone_[one[i]] - bone_[other[i]]);
  return difference <= kAlike * std::max(reach_[a], reach_[b]);
}

void TreeGuess::findTwins() {
  for (int j = 0; j < skeleton_.size(); ++j) {
    const std::vector<int>& children = children_[j];
    TwinLimbs best;
    for (size_t a = 0; a < std::min(children.size(), kMaxTwins); ++a) {
      for (size_t b = 0; b < a; ++b) {
        const double length = 0.5 * (reach_[children[a]] + reach_[children[b]]);
        if (length > best.length && alike(children[b], children[a])) {
          best = {j, {children[b], children[a]}, length};
        }
      }
    }
    if (best.parent >= 0) twins_.push_back(best);
  }
}

/// The longest twins, and the longest that hang above or below them, but not in them.
bool TreeGuess::chooseLimbs() {
  const auto inLimb = [this](const TwinLimbs& limbs, int joint) {
    return skeleton_.isAncestor(limbs.tops[0], joint) || skeleton_.isAncestor(limbs.tops[1], joint);
  };
  TwinLimbs first, second;
  for (const TwinLimbs& twins : twins_) {
    if (twins.length > first.length) first = twins;
  }
  for (const TwinLimbs& twins : twins_) {
    const bool apart = twins.parent != first.parent && !inLimb(first, twins.parent) &&
                       !inLimb(twins, first.parent);
    if (apart && twins.length > second.length) second = twins;
  }
  if (second.parent < 0) return false;
  const bool legs_first = skeleton_.isAncestor(first.parent, second.parent);
  legs_ = legs_first ? first : second;
  arms_ = legs_first ? second : first;
  return skeleton_.isAncestor(legs_.parent, arms_.parent);
}

/// Down the longest way.
Chain TreeGuess::mainChain(int top) const {
  Chain chain = {top};
  while (!children_[chain.back()].empty()) {
    const std::vector<int>& next = children_[chain.back()];
    chain.push_back(*std::max_element(next.begin(), next.end(),
                                      [this](int a, int b) { return reach_[a] < reach_[b]; }));
  }
  return chain;
}

/// Place in the chain of the joint from which a limb's two bones go out: long ones in a row, with a
/// short one after them, as foot or hand is. A clavicle may be as long as a forearm. -1: none.
int TreeGuess::longBones(const Chain& chain) const {
  int best = -1;
  double most = 0.0;
  for (size_t i = 0; i + 2 < chain.size(); ++i) {
    const double next = i + 3 < chain.size() ? bone_[chain[i + 3]] : 0.0;
    const double score = bone_[chain[i + 1]] + bone_[chain[i + 2]] - next;
    if (score <= most) continue;
    best = static_cast<int>(i);
    most = score;
  }
  return best;
}

void TreeGuess::setLeg(int side, const Chain& chain) {
  const int i = longBones(chain);
  if (i < 0) return;
  LegJoints& leg = roles_.legs[side];
  leg = {chain[i], chain[i + 1], chain[i + 2], -1};
  if (static_cast<size_t>(i) + 3 < chain.size()) leg.toe = chain[i + 3];
}

void TreeGuess::setArm(int side, const Chain& chain) {
  const int i = longBones(chain);
  if (i < 0) return;
  roles_.arms[side] = {i > 0 ? chain[i - 1] : -1, chain[i], chain[i + 1], chain[i + 2]};
}

void TreeGuess::setTrunk() {
  roles_.hips = legs_.parent;
  roles_.chest = arms_.parent;
  for (int j = roles_.chest; j != roles_.hips; j = skeleton_.joint(j).parent) roles_.spine = j;
  int top = -1;
  for (const int child : children_[roles_.chest]) {
    if (child == arms_.tops[0] || child == arms_.tops[1]) continue;
    if (top < 0 || reach_[child] > reach_[top]) top = child;
  }
  if (top < 0) return;
  // The head is where jaw and eyes hang, or else the last joint.
  const Chain chain = mainChain(top);
  size_t head = 0;
  while (head + 1 < chain.size() && children_[chain[head]].size() == 1) ++head;
  roles_.head = chain[head];
  if (head > 0) roles_.neck = chain[0];
}

/// How far joint up_leg of legs[kLeft] lies to the left of the other's, in a pose; and its arms.
double TreeGuess::leftness(std::span<const JointFrame> joints) const {
  Eigen::Vector3d forward = Eigen::Vector3d::Zero(), feet = forward;
  for (const LegJoints& leg : roles_.legs) {
    const Eigen::Vector3d hip = joints[leg.up_leg].p_WJ, knee = joints[leg.leg].p_WJ;
    const Eigen::Vector3d foot = joints[leg.foot].p_WJ;
    feet += 0.5 * foot;
    if (leg.toe >= 0) {
      forward += joints[leg.toe].p_WJ - foot;
    } else {
      const Eigen::Vector3d way = (foot - hip).normalized();
      forward += knee - hip - (knee - hip).dot(way) * way;
    }
  }
  const Eigen::Vector3d up = joints[roles_.head].p_WJ - feet;
  const Eigen::Vector3d left = up.cross(forward);
  if (!(left.norm() > 0.0)) return 0.0;
  const Eigen::Vector3d across =
      joints[roles_.legs[kLeft].up_leg].p_WJ - joints[roles_.legs[kRight].up_leg].p_WJ;
  return across.dot(left.normalized());
}

void TreeGuess::settleSides() {
  std::vector<JointFrame> joints(skeleton_.size());
  double left = 0.0, arms_left = 0.0;
  const auto add = [&] {
    left += leftness(joints);
    const Eigen::Vector3d legs =
        joints[roles_.legs[kLeft].up_leg].p_WJ - joints[roles_.legs[kRight].up_leg].p_WJ;
    arms_left +=
        legs.dot(joints[roles_.arms[kLeft].arm].p_WJ - joints[roles_.arms[kRight].arm].p_WJ);
  };
  const int step = std::max(1, clip_.frames() / kFramesSeen);
  for (int i = 0; i < clip_.frames(); i += step) {
    forwardKinematics(clip_, i, joints);
    add();
  }
  if (clip_.frames() == 0) {
    const Pose rest{Eigen::Vector3d::Zero(),
                    std::vector<Eigen::Quaterniond>(joints.size(), Eigen::Quaterniond::Identity())};
    forwardKinematics(skeleton_, rest, joints);
    add();
  }
  if (arms_left < 0.0) std::swap(roles_.arms[kLeft], roles_.arms[kRight]);
  if (left >= 0.0) return;
  std::swap(roles_.legs[kLeft], roles_.legs[kRight]);
  std::swap(roles_.arms[kLeft], roles_.arms[kRight]);
}

JointRoles TreeGuess::guess() {
  roles_.hips = -1;
  findTwins();
  if (!chooseLimbs()) return roles_;
  for (const int side : {kLeft, kRight}) {
    setLeg(side, mainChain(legs_.tops[side]));
    setArm(side, mainChain(arms_.tops[side]));
  }
  setTrunk();
  if (missingRole(roles_).empty()) settleSides();
  return roles_;
}

}  // namespace

JointRoles rolesByTree(const Clip& clip) { return TreeGuess(clip).guess(); }

}  // namespace amble
