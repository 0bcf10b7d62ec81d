/// AMC reader: a number alone opens a frame, then one line a bone. No count is in the file.
#include <algorithm>
#include <map>

#include "animation/captures/asf_skeleton.h"
#include "animation/captures/capture_file.h"
#include "animation/captures/text_cursor.h"
#include "base/error.h"
#include "base/rotation.h"

namespace amble {
namespace {

bool isFrameNumber(std::string_view word) {
  return !word.empty() &&
         std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
}

class AmcReader {
 public:
  AmcReader(std::string_view text, const std::string& name, AsfSkeleton skeleton,
            std::optional<double> frame_time, AsfAmcNotes& notes);
  Clip read();

 private:
  void readHeader();
  void readFrame(int frame);
  int boneOf(std::string_view name, size_t place);
  void readBone(int joint);
  void requireAll(int frame_line) const;
  void setPose(int frame);
  void setJoint(int joint, Eigen::Quaterniond& q);

  TextCursor in_;
  AsfSkeleton asf_;
  std::optional<double> asked_time_;  // [s]
  AsfAmcNotes& notes_;
  Clip clip_;
  bool fully_specified_ = false, degrees_ = true;
  double frame_time_ = kAmcFrameTime;
  bool moving_joints_ = false;  // a joint other than the root has tx, ty, tz or l
  std::map<std::string, int, std::less<>> by_name_;
  std::vector<int> usual_;                   // joints in the order of the first frame's lines
  std::vector<std::vector<double>> values_;  // of the frame being read, by joint and dof
  std::vector<int> seen_;                    // by joint: the last frame that has it
  std::vector<Eigen::Vector3d> positions_;   // joints in their parents, of this frame [file units]
  int frame_ = 0;                            // being read
};

AmcReader::AmcReader(std::string_view text, const std::string& name, AsfSkeleton skeleton,
                     std::optional<double> frame_time, AsfAmcNotes& notes)
    : in_(text, name),
      asf_(std::move(skeleton)),
      asked_time_(frame_time),
      notes_(notes),
      degrees_(asf_.degrees) {
  const size_t joints = asf_.joints.size();
  values_.resize(joints);
  seen_.assign(joints, -1);
  for (size_t j = 0; j < joints; ++j) {
    by_name_[asf_.joints[j].name] = static_cast<int>(j);
    values_[j].assign(asf_.bones[j].dofs.size(), 0.0);
    positions_.push_back(asf_.joints[j].offset);
    for (const AsfDof dof : asf_.bones[j].dofs) {
      moving_joints_ = moving_joints_ || !isRotation(dof);
    }
  }
}

Clip AmcReader::read() {
  readHeader();
  clip_.name = in_.name();
  clip_.poses = PoseArray(static_cast<int>(asf_.joints.size()));
  long long number = 0;  // of the frame before: it may be the largest count that there is
  for (; in_.skipBlankLines(); ++frame_) {
    const int frame = in_.count();
    if (frame_ > 0 && frame != number + 1) {
      in_.fail("frame " + std::to_string(frame),
               "frame " + std::to_string(number + 1) + ", after " + std::to_string(number));
    }
    number = frame;
    in_.expectLineEnd();
    readFrame(frame_);
  }
  if (frame_ == 0) in_.fail("the file ends here", "a frame: its number alone on a line");
  clip_.skeleton = Skeleton(std::move(asf_.joints));
  clip_.frame_time = asked_time_.value_or(frame_time_);
  return std::move(clip_);
}

void AmcReader::readHeader() {
  while (!in_.peekWord().empty() && in_.peekWord()[0] == ':') {
    const std::string_view keyword = in_.word();
    if (sameWord(keyword, ":fully-specified")) {
      fully_specified_ = true;
    } else if (sameWord(keyword, ":degrees")) {
      degrees_ = true;
    } else if (sameWord(keyword, ":radians")) {
      degrees_ = false;
    } else if (sameWord(keyword, ":samples-per-second")) {
      const double rate = in_.number(kMaxCaptureNumber);
      if (!(rate > 0.0) || !isFrameTime(1.0 / rate)) {
        in_.fail("no rate of frames", "1 to 10000 a second");
      }
      frame_time_ = 1.0 / rate;
      notes_.frame_time_said = true;
    } else {
      notes_.warnings.push_back(in_.name() + ":" + std::to_string(in_.line()) + ": '" +
                                std::string(keyword.substr(0, 40)) + "' is passed over");
      in_.restOfLine();
    }
  }
}

void AmcReader::readFrame(int frame) {
  const int line = in_.line();
  // Bones without a line take memory but no text.
  if ((static_cast<size_t>(frame) + 1) * asf_.joints.size() >
      kMaxJointPosesPerByte * (in_.size() + asf_.joints.size())) {
    in_.fail("too many bones without numbers for so many frames", "numbers for most bones");
  }
  for (size_t place = 0; !in_.peekWord().empty() && !isFrameNumber(in_.peekWord()); ++place) {
    const int joint = boneOf(in_.word(), place);
    readBone(joint);
    if (frame == 0) usual_.push_back(joint);
  }
  if (fully_specified_) requireAll(line);
  clip_.poses.resize(frame + 1);
  setPose(frame);
}

int AmcReader::boneOf(std::string_view name, size_t place) {
  if (place < usual_.size() && asf_.joints[usual_[place]].name == name) return usual_[place];
  const auto found = by_name_.find(name);
  if (found == by_name_.end()) in_.failAt(name, "a frame's number or a bone of the ASF");
  return found->second;
}

void AmcReader::readBone(int joint) {
  const std::string& name = asf_.joints[joint].name;
  if (seen_[joint] == frame_) in_.fail("'" + name + "' twice in a frame", "each bone once");
  seen_[joint] = frame_;
  for (size_t i = 0; i < values_[joint].size(); ++i) {
    if (!in_.numberInLine(kMaxCaptureNumber, values_[joint][i])) {
      in_.fail(std::to_string(i) + " numbers of '" + name + "'",
               std::to_string(values_[joint].size()) + ", its degrees of freedom");
    }
  }
  if (!in_.atLineEnd()) {
    in_.fail("too many numbers of '" + name + "'",
             std::to_string(values_[joint].size()) + ", its degrees of freedom");
  }
}

void AmcReader::requireAll(int frame_line) const {
  for (size_t j = 0; j < seen_.size(); ++j) {
    if (values_[j].empty() || seen_[j] == frame_) continue;
    throw InputError(
        in_.name(), in_.line(),
        "the frame of line " + std::to_string(frame_line) + " lacks '" + asf_.joints[j].name + "'",
        "every bone: the file is :fully-specified");
  }
}

void AmcReader::setPose(int frame) {
  const std::span<Eigen::Quaterniond> q = clip_.poses.rotations(frame);
  for (size_t j = 0; j < q.size(); ++j) setJoint(static_cast<int>(j), q[j]);
  clip_.poses.p_WR(frame) = positions_[0];
  if (!moving_joints_) return;
  clip_.joint_positions.insert(clip_.joint_positions.end(), positions_.begin(), positions_.end());
  clip_.joint_positions[frame * q.size()].setZero();
}

void AmcReader::setJoint(int joint, Eigen::Quaterniond& q) {
  const AsfBone& bone = asf_.bones[joint];
  Eigen::Quaterniond motion = Eigen::Quaterniond::Identity();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  for (size_t i = 0; i < bone.dofs.size(); ++i) {
    const double value = values_[joint][i];
    const int axis = static_cast<int>(bone.dofs[i]) % 3;
    if (isRotation(bone.dofs[i])) {
      const double angle = degrees_ ? value * kDegree : value;
      motion = Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis)) * motion;
    } else if (bone.dofs[i] != AsfDof::kLength) {
      shift[axis] = value;
    }
  }
  if (joint == 0) {
    q = motion * bone.q_axis;
    positions_[0] = bone.preset_position + shift;
    return;
  }
  q = bone.q_axis * motion * bone.q_axis.conjugate();
  if (!moving_joints_) return;
  // A bone begins where its parent ends, however long that is now.
  const AsfBone& parent = asf_.bones[asf_.joints[joint].parent];
  double length = parent.length;
  for (size_t i = 0; i < parent.dofs.size(); ++i) {
    if (parent.dofs[i] == AsfDof::kLength) length += values_[asf_.joints[joint].parent][i];
  }
  positions_[joint] = length * parent.direction + bone.q_axis * shift;
}

}  // namespace

Clip parseAsfAmcAsWritten(const NamedText& asf, const NamedText& amc,
                          std::optional<double> frame_time, AsfAmcNotes& notes) {
  notes = {};
  AsfSkeleton skeleton = parseAsf(asf, notes);
  std::string mended;
  const std::string text =
      withoutAcclaimComments(plainText(amc.text, amc.name, mended, notes.warnings));
  return AmcReader(text, amc.name, std::move(skeleton), frame_time, notes).read();
}

Clip parseAsfAmc(const NamedText& asf, const NamedText& amc, const AsfAmcOptions& options,
                 AsfAmcNotes* notes) {
  AsfAmcNotes ignored;
  Clip clip = parseAsfAmcAsWritten(asf, amc, options.frame_time, notes ? *notes : ignored);
  turnUpright(options.up, clip);
  scaleToMetres(options.metres_per_unit, clip);
  return clip;
}

Clip readAsfAmc(const std::filesystem::path& asf, const std::filesystem::path& amc,
                const AsfAmcOptions& options, AsfAmcNotes* notes) {
  const std::string skeleton = readWholeFile(asf, kAsfFile);
  const std::string motion = readWholeFile(amc, kAmcFile);
  return parseAsfAmc({skeleton, asf.string()}, {motion, amc.string()}, options, notes);
}

}  // namespace amble
