#include "animation/body/joint_roles.h"

#include <array>
#include <cctype>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace amble {
namespace {

/// What the joint of a limb is called in the common rigs, without its side, lower case. Earlier
/// names win: longer ones before those that they end in (`lowerleg` before `leg`), and where a rig
/// has both a `Shoulder` and an `Arm` the first is the clavicle, where it has a `Collar` and a
/// `Shoulder` the second is the arm.
struct LimbNames {
  const char* role;
  std::vector<const char*> names;
};

const std::array<LimbNames, 8>& limbNames() {
  static const std::array<LimbNames, 8> kNames = {{
      {"up_leg", {"upperleg", "legupper", "upleg", "thigh", "femur", "hip"}},
      {"leg", {"lowerleg", "leglower", "lowleg", "loleg", "shin", "calf", "tibia", "knee", "leg"}},
      {"foot", {"foot", "ankle", "talocrural"}},
      {"toe",
       {"toebase", "toes", "toe0", "toe", "ball", "metatarsophalangeal", "metatarsal",
        "midtarsal"}},
      {"fore_arm",
       {"forearm", "lowerarm", "armlower", "lowarm", "loarm", "farm", "radius", "elbow"}},
      {"arm", {"upperarm", "armupper", "uparm", "uarm", "shldr", "humerus", "arm", "shoulder"}},
      {"shoulder", {"collar", "clavicle", "clav", "sternoclavicular", "shoulder"}},
      {"hand", {"wrist", "hand", "radiocarpal"}},
  }};
  return kNames;
}

const std::array<const char*, 2> kSideNames = {"left", "right"};

bool isUpper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool isLetterOrDigit(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// The words of a name, lower case: parted by anything that is no letter or digit and by capitals
/// (`Bip01 L Thigh`, `mixamorig:LeftUpLeg` and `LHipJoint` have 3, 4 and 3).
std::vector<std::string> wordsOf(const std::string& name) {
  std::vector<std::string> words;
  bool fresh = true;
  for (size_t i = 0; i < name.size(); ++i) {
    if (!isLetterOrDigit(name[i])) {
      fresh = true;
      continue;
    }
    const bool after_small = i > 0 && !isUpper(name[i - 1]);
    const bool before_small = i + 1 < name.size() && isLetterOrDigit(name[i + 1]) &&
                              !isUpper(name[i + 1]) &&
                              !std::isdigit(static_cast<unsigned char>(name[i + 1]));
    if (fresh || (isUpper(name[i]) && (after_small || before_small))) words.emplace_back();
    words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
    fresh = false;
  }
  return words;
}

/// Words that say nothing of whose joint it is: numbers (`toes_01.l`), that it is one
/// (`L_hip_jnt`), which of the two that share a bone it is (Daz's `lThighBend`, `lThighTwist`;
/// Auto-Rig Pro's `thigh_stretch.l`), that it lies in the middle (`head.x`).
bool saysNothing(const std::string& word) {
  if (word.find_first_not_of("0123456789") == word.npos) return true;
  for (const char* const empty : {"joint", "jnt", "bone", "bend", "stretch", "x"}) {
    if (word == empty) return true;
  }
  return false;
}

/// The words without those that say nothing and without the numbers that programs put behind names
/// which are there already: `LeftFoot.001`, `L_Foot_2`, `LeftFoot1`.
std::vector<std::string> bareWords(std::vector<std::string> words) {
  const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  std::erase_if(words, saysNothing);
  while (!words.empty()) {
    std::string& last = words.back();
    while (!last.empty() && digit(last.back())) last.pop_back();
    if (!last.empty()) break;
    words.pop_back();
  }
  return words;
}

/// The words of each joint's name.
using JointWords = std::vector<std::vector<std::string>>;

class RoleGuess {
 public:
  explicit RoleGuess(const Skeleton& skeleton)
      : skeleton_(skeleton), taken_(skeleton.size(), false) {
    for (const Joint& joint : skeleton.joints()) {
      words_.push_back(wordsOf(joint.name));
      bare_words_.push_back(bareWords(words_.back()));
    }
  }
  JointRoles guess();

 private:
  int named(const std::string& name) const;
  std::vector<int> endingIn(const std::string& name, const JointWords& words) const;
  int sided(Side side, const std::string& name) const;
  void guessLimbs(Side side);
  void settleAnkle(Side side);
  void guessTrunk();
  int commonAncestor(int a, int b) const;
  int childTowards(int ancestor, int joint) const;

  const Skeleton& skeleton_;
  JointWords words_, bare_words_;
  std::vector<bool> taken_;  // by joint: it has a role in a limb
  JointRoles roles_;
};

JointRoles RoleGuess::guess() {
  roles_.hips = -1;
  guessLimbs(kLeft);
  guessLimbs(kRight);
  guessTrunk();
  return roles_;
}

/// Joints without a role whose last words are `name`, with the fewest words before them.
std::vector<int> RoleGuess::endingIn(const std::string& name, const JointWords& words) const {
  std::vector<int> joints;
  size_t best_left = std::numeric_limits<size_t>::max();
  for (int j = 0; j < skeleton_.size(); ++j) {
    std::string tail;
    for (size_t left = words[j].size(); left-- > 0 && tail.size() < name.size();) {
      tail.insert(0, words[j][left]);
      if (tail != name || left > best_left || taken_[j]) continue;
      if (left < best_left) joints.clear();
      best_left = left;
      joints.push_back(j);
    }
  }
  return joints;
}

/// The first joint of that name; else the only one that has it with a number behind. -1 for none.
int RoleGuess::named(const std::string& name) const {
  const std::vector<int> exact = endingIn(name, words_);
  if (!exact.empty()) return exact[0];
  const std::vector<int> numbered = endingIn(name, bare_words_);
  return numbered.size() == 1 ? numbered[0] : -1;
}

/// The joint of that name on a side. -1 for none.
int RoleGuess::sided(Side side, const std::string& name) const {
  const std::string whole = kSideNames[side];
  const std::string letter = whole.substr(0, 1);
  for (const std::string& full : {whole + name, letter + name, name + whole, name + letter}) {
    const int joint = named(full);
    if (joint >= 0) return joint;
  }
  return -1;
}

void RoleGuess::guessLimbs(Side side) {
  for (const LimbNames& limb : limbNames()) {
    int joint = -1;
    for (size_t i = 0; joint < 0 && i < limb.names.size(); ++i) joint = sided(side, limb.names[i]);
    setRole(roles_, std::string(kSideNames[side]) + "_" + limb.role, joint);
    if (joint >= 0) taken_[joint] = true;
  }
  settleAnkle(side);
}

// SMPL and Kinect call the ball of the foot `Foot`: it hangs on an `Ankle`, and nothing is a toe.
void RoleGuess::settleAnkle(Side side) {
  LegJoints& leg = roles_.legs[side];
  const int ankle = sided(side, "ankle");
  if (ankle < 0 || leg.foot < 0 || !skeleton_.isAncestor(ankle, leg.foot)) return;
  if (leg.toe < 0) leg.toe = leg.foot;
  leg.foot = ankle;
  taken_[ankle] = true;
}

// The trunk is known from the tree once the limbs are: names of its joints differ more than its
// shape does.
void RoleGuess::guessTrunk() {
  for (const char* const name : {"head", "skullbase", "skull"}) {
    if (roles_.head < 0) roles_.head = named(name);
  }
  const int left = roles_.legs[kLeft].up_leg, right = roles_.legs[kRight].up_leg;
  if (left >= 0 && right >= 0) {
    roles_.hips = commonAncestor(left, right);
    // H-Anim's legs hang on a joint of their own beside the spine.
    if (roles_.head >= 0) roles_.hips = commonAncestor(roles_.hips, roles_.head);
    for (const char* const name : {"hips", "hip", "pelvis"}) {
      const int joint = named(name);
      if (joint >= 0 && skeleton_.isAncestor(joint, roles_.hips)) {
        roles_.hips = joint;
        break;
      }
    }
  }
  const int left_arm = roles_.arms[kLeft].arm, right_arm = roles_.arms[kRight].arm;
  if (roles_.head < 0 || roles_.hips < 0 || left_arm < 0 || right_arm < 0) return;
  roles_.spine = childTowards(roles_.hips, roles_.head);
  const int chest = commonAncestor(left_arm, right_arm);
  if (chest == roles_.hips || !skeleton_.isAncestor(roles_.hips, chest)) return;
  roles_.chest = chest;
  const int neck = childTowards(chest, roles_.head);
  if (neck != roles_.head) roles_.neck = neck;
}

int RoleGuess::commonAncestor(int a, int b) const {
  while (a != b) {
    int& later = a > b ? a : b;
    later = skeleton_.joint(later).parent;
  }
  return a;
}

/// The child of `ancestor` on the way to `joint`; -1 where `joint` does not hang below it.
int RoleGuess::childTowards(int ancestor, int joint) const {
  while (joint > ancestor && skeleton_.joint(joint).parent != ancestor)
    joint = skeleton_.joint(joint).parent;
  return joint > ancestor ? joint : -1;
}

/// Where a role's joint is kept; null where the name is no role.
int* roleSlot(JointRoles& roles, std::string_view role) {
  if (role == "hips") return &roles.hips;
  if (role == "spine") return &roles.spine;
  if (role == "chest") return &roles.chest;
  if (role == "neck") return &roles.neck;
  if (role == "head") return &roles.head;
  for (const int side : {kLeft, kRight}) {
    const std::string_view name = kSideNames[side];
    if (!role.starts_with(name) || role.size() <= name.size() || role[name.size()] != '_') continue;
    const std::string_view limb = role.substr(name.size() + 1);
    LegJoints& leg = roles.legs[side];
    ArmJoints& arm = roles.arms[side];
    if (limb == "up_leg") return &leg.up_leg;
    if (limb == "leg") return &leg.leg;
    if (limb == "foot") return &leg.foot;
    if (limb == "toe") return &leg.toe;
    if (limb == "shoulder") return &arm.shoulder;
    if (limb == "arm") return &arm.arm;
    if (limb == "fore_arm") return &arm.fore_arm;
    if (limb == "hand") return &arm.hand;
  }
  return nullptr;
}

}  // namespace

double JointRoles::meanLeg(const Skeleton& skeleton) const {
  return 0.5 * (legLength(skeleton, kLeft) + legLength(skeleton, kRight));
}

double JointRoles::legLength(const Skeleton& skeleton, Side side) const {
  double length = 0.0;
  for (int j = legs[side].foot; j > legs[side].up_leg; j = skeleton.joint(j).parent) {
    length += skeleton.joint(j).offset.norm();
  }
  return length;
}

JointRoles rolesByName(const Skeleton& skeleton) { return RoleGuess(skeleton).guess(); }

std::string missingRole(const JointRoles& roles) {
  for (const char* const side : kSideNames) {
    for (const char* const limb : {"up_leg", "leg", "foot", "arm", "fore_arm"}) {
      const std::string role = std::string(side) + "_" + limb;
      if (roleJoint(roles, role) < 0) return role;
    }
  }
  if (roles.hips < 0) return "hips";
  return roles.head < 0 ? "head" : "";
}

JointRoles guessJointRoles(const Skeleton& skeleton, const std::string& file) {
  if (skeleton.size() == 0) throw InputError(file, 0, "a skeleton without joints", "a person's");
  const JointRoles roles = rolesByName(skeleton);
  const std::string missing = missingRole(roles);
  if (missing.empty()) return roles;
  throw InputError(file, 0, "no joint looks like " + missing,
                   "names as of MotionBuilder, Biped, Daz, Acclaim, Mixamo, Rokoko, H-Anim, VRM or "
                   "Unreal");
}

bool setRole(JointRoles& roles, std::string_view role, int joint) {
  int* const slot = roleSlot(roles, role);
  if (slot != nullptr) *slot = joint;
  return slot != nullptr;
}

int roleJoint(const JointRoles& roles, std::string_view role) {
  JointRoles copy = roles;
  const int* const slot = roleSlot(copy, role);
  return slot != nullptr ? *slot : -1;
}

const std::vector<std::string>& roleNames() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names = {"hips", "spine", "chest", "neck", "head"};
    for (const char* const side : kSideNames) {
      for (const char* const limb :
           {"up_leg", "leg", "foot", "toe", "shoulder", "arm", "fore_arm", "hand"}) {
        names.push_back(std::string(side) + "_" + limb);
      }
    }
    return names;
  }();
  return kNames;
}

double guessUnit(const Skeleton& skeleton_in_file_units, const JointRoles& roles) {
  // Thigh + shank of an adult of 1.7 m [m] (Winter: 0.491 of the stature)
  constexpr double kUsualLeg = 0.83;
  constexpr std::array<double, 5> kUnits = {1.0, 0.01, 0.0254, 0.056444,
                                            0.001};  // m, cm, inch, CMU, mm [m]
  const double leg = 0.5 * (roles.legLength(skeleton_in_file_units, kLeft) +
                            roles.legLength(skeleton_in_file_units, kRight));
  if (!(leg > 0.0)) return 1.0;
  double best = kUnits[0];
  for (const double unit : kUnits) {
    if (std::abs(std::log(leg * unit / kUsualLeg)) < std::abs(std::log(leg * best / kUsualLeg)))
      best = unit;
  }
  return best;
}

}  // namespace amble
