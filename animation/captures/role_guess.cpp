#include "animation/captures/role_guess.h"

#include <algorithm>
#include <set>

#include "animation/captures/role_tree.h"
#include "base/error.h"
#include "base/strict_yaml.h"

namespace amble {
namespace {

/// The roles that the file names are set; they are returned.
std::set<std::string> applyOverrides(const std::filesystem::path& file, const Skeleton& skeleton,
                                     JointRoles& roles) {
  std::set<std::string> set;
  const YamlNode root = readYaml(file);
  root.requireKeys(roleNames());
  for (const auto& [role, node] : root.entries()) {
    const std::string name = node.asString();
    const int joint = name == "none" ? -1 : skeleton.find(name);
    if (joint < 0 && name != "none") {
      std::vector<std::string> names;
      for (const Joint& each : skeleton.joints()) names.push_back(each.name);
      const std::string near = nearestWord(name, names);
      node.fail("no joint is called '" + name + "'",
                near.empty() ? "a joint of the capture, or none" : "'" + near + "'?");
    }
    setRole(roles, role, joint);
    set.insert(role);
  }
  return set;
}

/// Two roles of one joint: a name that fits both. A trunk of one joint is spine and chest.
void noteDoubles(const JointRoles& roles, const Skeleton& skeleton, RoleGuess& guess) {
  const std::vector<std::string>& names = roleNames();
  for (size_t i = 0; i < names.size(); ++i) {
    const int joint = roleJoint(roles, names[i]);
    for (size_t k = 0; joint >= 0 && k < i; ++k) {
      if (roleJoint(roles, names[k]) != joint || names[i] == "chest") continue;
      guess.unsure.push_back(names[i] + ": is " + names[k] + " too, " + skeleton.joint(joint).name);
    }
  }
}

/// A limb whose joints do not hang on one another in order, from the body outwards.
void noteBrokenLimbs(const JointRoles& roles, const Skeleton& skeleton, RoleGuess& guess) {
  for (const char* const side : {"left_", "right_"}) {
    for (const std::vector<std::string>& limb :
         {std::vector<std::string>{"up_leg", "leg", "foot", "toe"},
          std::vector<std::string>{"arm", "fore_arm", "hand"}}) {
      for (size_t i = 1; i < limb.size(); ++i) {
        const int upper = roleJoint(roles, side + limb[i - 1]);
        const int lower = roleJoint(roles, side + limb[i]);
        if (upper < 0 || lower < 0 || (upper != lower && skeleton.isAncestor(upper, lower)))
          continue;
        guess.unsure.push_back(side + limb[i] + ": does not hang below " + side + limb[i - 1]);
      }
    }
  }
}

bool anotherHas(const JointRoles& roles, const std::string& role, int joint) {
  const std::vector<std::string>& names = roleNames();
  return std::any_of(names.begin(), names.end(), [&](const std::string& each) {
    return each != role && roleJoint(roles, each) == joint;
  });
}

/// A limb whose joints a person needs are not all told by names is forgotten: half of it by names
/// and half by the tree would give one joint two roles (`LShoulder` is an arm by its name where
/// nothing else is called one).
void forgetHalfLimbs(const std::set<std::string>& said, JointRoles& roles) {
  for (const std::string side : {"left_", "right_"}) {
    for (const std::vector<std::string>& limb :
         {std::vector<std::string>{"up_leg", "leg", "foot", "toe"},
          std::vector<std::string>{"arm", "fore_arm", "hand", "shoulder"}}) {
      const size_t needed = limb[0] == "arm" ? 2 : 3;
      const bool whole = std::all_of(limb.begin(), limb.begin() + needed, [&](const auto& role) {
        return roleJoint(roles, side + role) >= 0;
      });
      for (size_t i = 0; !whole && i < limb.size(); ++i) {
        if (!said.contains(side + limb[i])) setRole(roles, side + limb[i], -1);
      }
    }
  }
}

/// Roles that nothing has told yet, by the shape of the tree; joints that have a role keep it, but
/// that a trunk of one joint is spine and chest.
void fillByTree(const Clip& clip, const std::set<std::string>& said, RoleGuess& guess) {
  const JointRoles tree = rolesByTree(clip);
  if (missingRole(tree).empty()) forgetHalfLimbs(said, guess.roles);
  for (const std::string& role : roleNames()) {
    const int joint = roleJoint(tree, role);
    if (joint < 0 || roleJoint(guess.roles, role) >= 0 || said.contains(role)) continue;
    if (role != "chest" && anotherHas(guess.roles, role, joint)) continue;
    setRole(guess.roles, role, joint);
    guess.unsure.push_back(role + ": by the shape of the skeleton, " +
                           clip.skeleton.joint(joint).name);
  }
}

}  // namespace

RoleGuess guessRoles(const Clip& clip, const std::string& file,
                     const std::filesystem::path& overrides) {
  if (clip.skeleton.size() == 0) {
    throw InputError(file, 0, "a skeleton without joints", "a person's");
  }
  RoleGuess guess;
  guess.roles = rolesByName(clip.skeleton);
  std::set<std::string> said;
  if (!overrides.empty()) said = applyOverrides(overrides, clip.skeleton, guess.roles);
  if (!missingRole(guess.roles).empty()) fillByTree(clip, said, guess);
  guess.missing = missingRole(guess.roles);
  for (const std::string& role : roleNames()) {
    if (roleJoint(guess.roles, role) < 0 && !said.contains(role)) {
      guess.unsure.push_back(role + ": no joint fits");
    }
  }
  noteDoubles(guess.roles, clip.skeleton, guess);
  noteBrokenLimbs(guess.roles, clip.skeleton, guess);
  return guess;
}

}  // namespace amble
