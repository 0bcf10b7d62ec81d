/// ASF reader: bones by name, then the hierarchy by a stack (no recursion).
#include <array>
#include <cmath>
#include <map>

#include "animation/captures/asf_skeleton.h"
#include "animation/captures/capture_file.h"
#include "animation/captures/text_cursor.h"
#include "base/error.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr std::array<const char*, 7> kDofNames = {"rx", "ry", "rz", "tx", "ty", "tz", "l"};

/// A bone as :bonedata has it.
struct BoneEntry {
  std::string name;
  int line = 0;  // of its name
  AsfBone bone;
  int parent = -1;  // entry
  int parent_line = 0;
  std::vector<int> children;  // entries, in the order of :hierarchy
};

class AsfReader {
 public:
  AsfReader(std::string_view text, const std::string& name, AsfAmcNotes& notes)
      : in_(text, name), notes_(notes) {
    entries_.emplace_back();
    entries_[0].name = "root";
    by_name_["root"] = 0;
  }

  AsfSkeleton read();

 private:
  void readSection(std::string_view keyword);
  bool inSection();
  void skipSection();
  void readUnits();
  void readRoot();
  void readBones();
  void readBone();
  void readBoneKey(std::string_view key, BoneEntry& entry);
  void readLimits();
  std::vector<AsfDof> readDofs();
  Eigen::Vector3d readVector();
  Eigen::Quaterniond turned(const Eigen::Vector3d& angles, std::string_view order) const;
  void readHierarchy();
  int entryOf(std::string_view name) const;
  void hang(int parent, int child);
  static RotationOrder orderOf(const std::vector<AsfDof>& dofs);
  AsfSkeleton build() const;
  void requireTree(size_t reached) const;

  TextCursor in_;
  AsfAmcNotes& notes_;
  bool degrees_ = true;
  bool has_root_ = false, has_hierarchy_ = false;
  std::vector<BoneEntry> entries_;  // the root first
  std::map<std::string, int, std::less<>> by_name_;
};

AsfSkeleton AsfReader::read() {
  while (in_.skipBlankLines()) {
    const std::string_view keyword = in_.word();
    if (keyword[0] != ':') in_.failAt(keyword, "a section: a word that begins with ':'");
    readSection(keyword);
  }
  if (!has_root_) in_.fail("the file ends here", ":root");
  if (!has_hierarchy_) in_.fail("the file ends here", ":hierarchy");
  return build();
}

void AsfReader::readSection(std::string_view keyword) {
  if (sameWord(keyword, ":units")) return readUnits();
  if (sameWord(keyword, ":root")) return readRoot();
  if (sameWord(keyword, ":bonedata")) return readBones();
  if (sameWord(keyword, ":hierarchy")) return readHierarchy();
  bool known = false;
  for (const char* const passed : {":version", ":name", ":documentation", ":skin"}) {
    known = known || sameWord(keyword, passed);
  }
  if (!known) {
    notes_.warnings.push_back(in_.name() + ":" + std::to_string(in_.line()) + ": section '" +
                              std::string(keyword.substr(0, 40)) + "' is passed over");
  }
  skipSection();
}

bool AsfReader::inSection() {
  const std::string_view next = in_.peekWord();
  return !next.empty() && next[0] != ':';
}

void AsfReader::skipSection() {
  for (in_.restOfLine(); inSection(); in_.restOfLine()) {
  }
}

void AsfReader::readUnits() {
  while (inSection()) {
    const std::string_view key = in_.word();
    if (sameWord(key, "mass")) {
      in_.number(kMaxCaptureNumber);
    } else if (sameWord(key, "length")) {
      notes_.length_unit = in_.number(kMaxCaptureNumber);
      if (!(notes_.length_unit > 0.0)) in_.fail("a unit of no length", "more than 0");
    } else if (sameWord(key, "angle")) {
      const std::string_view unit = in_.word();
      degrees_ = sameWord(unit, "deg") || sameWord(unit, "degrees");
      if (!degrees_ && !sameWord(unit, "rad") && !sameWord(unit, "radians")) {
        in_.failAt(unit, "deg or rad");
      }
    } else {
      in_.failAt(key, "mass, length or angle");
    }
  }
}

void AsfReader::readRoot() {
  has_root_ = true;
  AsfBone& root = entries_[0].bone;
  std::string axis = "XYZ";
  Eigen::Vector3d orientation = Eigen::Vector3d::Zero();
  while (inSection()) {
    const std::string_view key = in_.word();
    if (sameWord(key, "order")) {
      root.dofs = readDofs();
    } else if (sameWord(key, "axis")) {
      axis = in_.word();
      turned(orientation, axis);  // refuses here what is no order
    } else if (sameWord(key, "position")) {
      root.preset_position = readVector();
    } else if (sameWord(key, "orientation")) {
      orientation = readVector();
    } else {
      in_.failAt(key, "order, axis, position or orientation");
    }
  }
  root.q_axis = turned(orientation, axis);
  if (root.dofs.empty()) in_.fail("a root without an order", "order TX TY TZ RX RY RZ");
}

void AsfReader::readBones() {
  while (inSection()) {
    const std::string_view word = in_.word();
    if (!sameWord(word, "begin")) in_.failAt(word, "begin");
    readBone();
  }
}

void AsfReader::readBone() {
  if (entries_.size() >= static_cast<size_t>(kMaxJoints)) {
    in_.fail("too many bones", "at most 10,000");
  }
  BoneEntry entry;
  entry.line = in_.line();
  for (std::string_view key = in_.word(); !sameWord(key, "end"); key = in_.word()) {
    readBoneKey(key, entry);
  }
  if (entry.name.empty()) in_.fail("a bone without a name", "a name");
  const int index = static_cast<int>(entries_.size());
  if (!by_name_.emplace(entry.name, index).second) {
    in_.fail("a second bone '" + entry.name.substr(0, 40) + "'", "each name once");
  }
  entries_.push_back(std::move(entry));
}

void AsfReader::readBoneKey(std::string_view key, BoneEntry& entry) {
  AsfBone& bone = entry.bone;
  if (sameWord(key, "id")) {
    in_.word();
  } else if (sameWord(key, "name")) {
    entry.name = in_.word();
    entry.line = in_.line();
  } else if (sameWord(key, "direction")) {
    const Eigen::Vector3d direction = readVector();
    const double size = direction.norm();
    bone.direction = size > 0.0 ? Eigen::Vector3d(direction / size) : direction;
  } else if (sameWord(key, "length")) {
    bone.length = in_.number(kMaxCaptureNumber);
    if (bone.length < 0.0) in_.fail("a bone of negative length", "0 or more");
  } else if (sameWord(key, "axis")) {
    const Eigen::Vector3d angles = readVector();
    bone.q_axis = turned(angles, in_.word());
  } else if (sameWord(key, "dof")) {
    bone.dofs = readDofs();
  } else if (sameWord(key, "limits")) {
    readLimits();
  } else if (sameWord(key, "bodymass") || sameWord(key, "cofmass")) {
    in_.number(kMaxCaptureNumber);
  } else {
    in_.failAt(key, "id, name, direction, length, axis, dof, limits or end");
  }
}

// Pairs over any number of lines; `inf` is open.
void AsfReader::readLimits() {
  for (;;) {
    const std::string_view next = in_.peekWord();
    const bool open = sameWord(next, "inf") || sameWord(next, "-inf") || sameWord(next, "+inf");
    if (!open && (next.empty() || std::string_view("+-.0123456789").find(next[0]) == next.npos)) {
      return;
    }
    open ? static_cast<void>(in_.word()) : static_cast<void>(in_.number(kMaxCaptureNumber));
  }
}

std::vector<AsfDof> AsfReader::readDofs() {
  std::vector<AsfDof> dofs;
  while (!in_.atLineEnd()) {
    const std::string_view word = in_.word();
    size_t dof = 0;
    while (dof < kDofNames.size() && !sameWord(word, kDofNames[dof])) ++dof;
    if (dof == kDofNames.size()) in_.failAt(word, "rx, ry, rz, tx, ty, tz or l");
    for (const AsfDof earlier : dofs) {
      if (earlier == static_cast<AsfDof>(dof)) in_.failAt(word, "each degree of freedom once");
    }
    dofs.push_back(static_cast<AsfDof>(dof));
  }
  return dofs;
}

Eigen::Vector3d AsfReader::readVector() {
  Eigen::Vector3d v;
  for (int i = 0; i < 3; ++i) v[i] = in_.number(kMaxCaptureNumber);
  return v;
}

// XYZ: about x first, then y, then z, about fixed axes.
Eigen::Quaterniond AsfReader::turned(const Eigen::Vector3d& angles, std::string_view order) const {
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  std::array<bool, 3> seen = {false, false, false};
  for (const char letter : order) {
    const int axis = (letter | 0x20) - 'x';
    if (axis < 0 || axis > 2 || seen[axis] || order.size() != 3) {
      in_.failAt(order, "an order of axes, as XYZ");
    }
    seen[axis] = true;
    const double angle = degrees_ ? angles[axis] * kDegree : angles[axis];
    q = Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis)) * q;
  }
  if (order.size() != 3) in_.failAt(order, "an order of axes, as XYZ");
  return q;
}

int AsfReader::entryOf(std::string_view name) const {
  const auto found = by_name_.find(name);
  if (found == by_name_.end()) in_.failAt(name, "a bone of :bonedata, or root");
  return found->second;
}

void AsfReader::readHierarchy() {
  has_hierarchy_ = true;
  in_.expectWord("begin");
  for (std::string_view word = in_.word(); !sameWord(word, "end"); word = in_.word()) {
    const int parent = entryOf(word);
    while (!in_.atLineEnd()) hang(parent, entryOf(in_.word()));
  }
}

void AsfReader::hang(int parent, int child) {
  BoneEntry& entry = entries_[child];
  if (child == 0) in_.fail("the root below a bone", "a bone");
  if (entry.parent >= 0) {
    in_.fail("'" + entry.name + "' hangs on two bones",
             "one, as line " + std::to_string(entry.parent_line) + " says");
  }
  entry.parent = parent;
  entry.parent_line = in_.line();
  entries_[parent].children.push_back(child);
}

// Depth first, children in the order of :hierarchy.
AsfSkeleton AsfReader::build() const {
  struct Open {
    int entry, parent_joint, depth;
  };
  AsfSkeleton result;
  result.degrees = degrees_;
  std::vector<Open> open = {{0, -1, 1}};
  while (!open.empty()) {
    const Open at = open.back();
    open.pop_back();
    const BoneEntry& entry = entries_[at.entry];
    if (at.depth > kMaxDepth) {
      throw InputError(in_.name(), entry.parent_line, "bones nested too deep",
                       "at most 1,000 levels");
    }
    Joint joint;
    joint.name = entry.name;
    joint.parent = at.parent_joint;
    joint.order = orderOf(entry.bone.dofs);
    if (entry.parent >= 0) {
      const AsfBone& parent = entries_[entry.parent].bone;
      joint.offset = parent.length * parent.direction;
    }
    if (entry.children.empty()) {
      joint.end_sites.push_back(entry.bone.length * entry.bone.direction);
    }
    const int index = static_cast<int>(result.joints.size());
    result.joints.push_back(std::move(joint));
    result.bones.push_back(entry.bone);
    for (size_t c = entry.children.size(); c-- > 0;) {
      open.push_back({entry.children[c], index, at.depth + 1});
    }
  }
  requireTree(result.joints.size());
  return result;
}

void AsfReader::requireTree(size_t reached) const {
  if (reached == entries_.size()) return;
  for (const BoneEntry& entry : entries_) {
    if (&entry != &entries_[0] && entry.parent < 0) {
      throw InputError(in_.name(), entry.line,
                       "the bone '" + entry.name.substr(0, 40) + "' hangs on nothing",
                       "a place in :hierarchy");
    }
  }
  // Every bone has a parent and some are not reached from the root: those that are not lie in or
  // below a cycle.
  for (size_t i = 1; i < entries_.size(); ++i) {
    int at = static_cast<int>(i);
    for (size_t steps = 0; at > 0 && steps <= entries_.size(); ++steps) at = entries_[at].parent;
    if (at == 0) continue;
    throw InputError(in_.name(), entries_[i].parent_line,
                     "'" + entries_[i].name.substr(0, 40) + "' hangs on itself, over others",
                     "a tree below root");
  }
}

/// Turned first about fixed axes is the last factor; axes without a degree of freedom come last.
RotationOrder AsfReader::orderOf(const std::vector<AsfDof>& dofs) {
  std::string order;
  for (const AsfDof dof : dofs) {
    if (isRotation(dof)) order.insert(0, 1, static_cast<char>('X' + static_cast<int>(dof)));
  }
  if (order.empty()) return Joint().order;
  for (const char axis : {'Z', 'Y', 'X'}) {
    if (order.find(axis) == order.npos) order += axis;
  }
  return {order[0], order[1], order[2]};
}

}  // namespace

std::string withoutAcclaimComments(std::string_view text) {
  std::string plain(text);
  bool comment = false;
  for (char& c : plain) {
    if (c == '\n') comment = false;
    if (c == '#') comment = true;
    if ((comment && c != '\r' && c != '\n') || c == '(' || c == ')' || c == ',') c = ' ';
  }
  return plain;
}

AsfSkeleton parseAsf(const NamedText& asf, AsfAmcNotes& notes) {
  std::string mended;
  const std::string text =
      withoutAcclaimComments(plainText(asf.text, asf.name, mended, notes.warnings));
  return AsfReader(text, asf.name, notes).read();
}

}  // namespace amble
