#include "animation/grafting/kinematic_chains.h"

#include <algorithm>

#include "base/error.h"
#include "base/strict_yaml.h"
#include "base/text.h"

namespace amble {
namespace {

// A limb, by the joint that it begins with.
struct Limb {
  std::string name;
  int top = -1;
};

// One joint that only this limb has.
std::vector<Limb> limbEnds(const JointRoles& roles) {
  return {{"left_leg", roles.legs[kLeft].up_leg},
          {"right_leg", roles.legs[kRight].up_leg},
          {"left_arm", roles.arms[kLeft].arm},
          {"right_arm", roles.arms[kRight].arm},
          {"head", roles.head}};
}

// A limb begins as high up as nothing else hangs there that is one.
std::vector<Limb> limbsOf(const Skeleton& skeleton, const JointRoles& roles) {
  const std::vector<Limb> ends = limbEnds(roles);
  std::vector<Limb> limbs;
  for (const Limb& end : ends) {
    if (end.top < 0) continue;
    const auto isShared = [&](int joint) {
      return std::any_of(ends.begin(), ends.end(), [&](const Limb& other) {
        return other.name != end.name && other.top >= 0 && skeleton.isAncestor(joint, other.top);
      });
    };
    int top = end.top;
    for (int above = skeleton.joint(top).parent; above >= 0 && !isShared(above);
         above = skeleton.joint(above).parent) {
      top = above;
    }
    limbs.push_back({end.name, top});
  }
  return limbs;
}

bool isLeg(const Limb& limb) { return limb.name.ends_with("_leg"); }

// By joint: the limb that it is a part of; the trunk is what the arms and the head hang on.
std::vector<std::string> limbOfJoints(const Skeleton& skeleton, const JointRoles& roles) {
  const std::vector<Limb> limbs = limbsOf(skeleton, roles);
  std::vector<std::string> names(skeleton.size());
  const auto isAbove = [&](int joint, bool legs) {
    return std::any_of(limbs.begin(), limbs.end(), [&](const Limb& limb) {
      return isLeg(limb) == legs && joint != limb.top && skeleton.isAncestor(joint, limb.top);
    });
  };
  for (int j = 0; j < skeleton.size(); ++j) {
    for (const Limb& limb : limbs) {
      if (skeleton.isAncestor(limb.top, j)) names[j] = limb.name;
    }
    if (!names[j].empty()) continue;
    if (isAbove(j, true) || j == 0) {
      names[j] = "root";
    } else if (isAbove(j, false)) {
      names[j] = "trunk";
    }
  }
  return names;
}

std::vector<int> childCounts(const Skeleton& skeleton) {
  std::vector<int> counts(skeleton.size(), 0);
  for (int j = 1; j < skeleton.size(); ++j) ++counts[skeleton.joint(j).parent];
  return counts;
}

// The first joint of a limb gives its chain the limb's name; the limb's other chains have their
// own.
void nameChains(const Skeleton& skeleton, const std::vector<std::string>& limb_of,
                std::vector<KinematicChain>& chains) {
  std::vector<std::string> taken;
  for (KinematicChain& chain : chains) {
    const int first = chain.joints.front();
    chain.limb = limb_of[first];
    chain.name = skeleton.joint(first).name;
    if (chain.limb.empty() || std::count(taken.begin(), taken.end(), chain.limb) > 0) continue;
    chain.name = chain.limb;
    taken.push_back(chain.limb);
  }
}

}  // namespace

std::vector<KinematicChain> kinematicChains(const Skeleton& skeleton, const JointRoles& roles) {
  const std::vector<int> children = childCounts(skeleton);
  const std::vector<std::string> limb_of = limbOfJoints(skeleton, roles);
  std::vector<KinematicChain> chains;
  std::vector<int> chain_of(skeleton.size(), -1);
  for (int j = 0; j < skeleton.size(); ++j) {
    const int parent = skeleton.joint(j).parent;
    const bool goes_on = parent > 0 && children[parent] == 1 && limb_of[parent] == limb_of[j];
    if (goes_on) {
      chain_of[j] = chain_of[parent];
      chains[chain_of[j]].joints.push_back(j);
      continue;
    }
    chain_of[j] = static_cast<int>(chains.size());
    KinematicChain chain;
    chain.hangs_on = parent;
    chain.joints = {j};
    chains.push_back(std::move(chain));
  }
  nameChains(skeleton, limb_of, chains);
  return chains;
}

std::vector<bool> lowerBody(const Skeleton& skeleton, const JointRoles& roles) {
  std::vector<bool> lower;
  for (const std::string& limb : limbOfJoints(skeleton, roles)) {
    lower.push_back(limb == "root" || limb.ends_with("_leg"));
  }
  return lower;
}

std::vector<std::string> graftableChains(const Skeleton& skeleton, const JointRoles& roles) {
  const std::vector<bool> lower = lowerBody(skeleton, roles);
  std::vector<std::string> names = {"upper"};
  for (const KinematicChain& chain : kinematicChains(skeleton, roles)) {
    if (!lower[chain.joints.front()]) names.push_back(chain.name);
  }
  return names;
}

std::vector<int> graftedJoints(const Skeleton& skeleton, const JointRoles& roles,
                               const std::vector<std::string>& chains, const std::string& file) {
  const std::vector<bool> lower = lowerBody(skeleton, roles);
  const std::vector<std::string> limb_of = limbOfJoints(skeleton, roles);
  const std::vector<KinematicChain> all = kinematicChains(skeleton, roles);
  const std::vector<std::string> names = graftableChains(skeleton, roles);
  std::vector<bool> taken(skeleton.size(), false);
  for (const std::string& wanted : chains) {
    if (std::find(names.begin(), names.end(), wanted) == names.end()) {
      const bool is_lower = std::any_of(all.begin(), all.end(), [&](const KinematicChain& chain) {
        return chain.name == wanted && lower[chain.joints.front()];
      });
      throw InputError(file, 0,
                       is_lower ? "the chain " + wanted + " is of the lower body, which stays"
                                : "has no chain '" + wanted + "'",
                       "one of " + joined(names));
    }
    for (int j = 0; j < skeleton.size(); ++j) {
      if (!lower[j] && (wanted == "upper" || limb_of[j] == wanted)) taken[j] = true;
    }
    for (const KinematicChain& chain : all) {
      for (const int j : chain.joints) {
        if (chain.name == wanted) taken[j] = true;
      }
    }
  }
  std::vector<int> joints;
  for (int j = 0; j < skeleton.size(); ++j) {
    if (taken[j]) joints.push_back(j);
  }
  return joints;
}

}  // namespace amble
