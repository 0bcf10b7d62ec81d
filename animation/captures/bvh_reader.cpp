/// BVH reader: the hierarchy by a stack (no recursion), then one line a frame. No count in the file
/// is trusted: memory grows with what is really there.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "animation/captures/bvh.h"
#include "animation/captures/capture_file.h"
#include "animation/captures/text_cursor.h"
#include "base/error.h"
#include "base/rotation.h"
#include "base/trigonometry.h"

namespace amble {
namespace {

enum class Quantity { kPosition, kRotation };

// A column of the motion table.
struct Column {
  int joint;  // -1: a column of an End Site, which is passed over
  Quantity quantity;
  int axis;  // 0 x, 1 y, 2 z; of a rotation: place in the joint's order
};

// Frames a second that some exporters write in place of a frame time [1/s].
constexpr double kMinRate = 10.0, kMaxRate = 480.0;

struct Hierarchy {
  std::vector<Joint> joints;  // offsets in file units
  std::vector<Column> columns;
  std::vector<bool> has_channels;  // by joint: CHANNELS was read
};

class BvhReader {
 public:
  BvhReader(std::string_view text, const std::string& name, std::optional<double> frame_time,
            BvhNotes& notes)
      : in_(text, name), frame_time_(frame_time), notes_(notes) {}

  Clip read();

 private:
  void readHierarchy();
  void openJoint(int parent);
  void openEndSite(int parent);
  void readOffset(Eigen::Vector3d& offset);
  void readChannels(int joint);
  Column readChannel(int joint);
  void completeOrder(RotationOrder& order, int rotations) const;
  void readMotion(Clip& clip);
  int readFrameCount();
  double readFrameTime();
  void makeRoom(Clip& clip, size_t frames) const;
  void readFrame(Clip& clip, int frame);
  void setPose(Clip& clip, int frame);

  TextCursor in_;
  std::optional<double> frame_time_;
  BvhNotes& notes_;
  Hierarchy tree_;
  std::vector<Eigen::Vector3d> positions_;        // of the frame being read, by joint, file units
  std::vector<Eigen::Vector3d> half_angles_;      // half of the same, in each joint's order [rad]
  std::vector<Eigen::Vector3d> sines_, cosines_;  // of these
  bool moving_joints_ = false;  // a joint other than the root has position channels
};

Clip BvhReader::read() {
  in_.expectWord("HIERARCHY");
  readHierarchy();
  Clip clip;
  clip.name = in_.name();
  clip.poses = PoseArray(static_cast<int>(tree_.joints.size()));
  readMotion(clip);
  tree_.joints[0].offset.setZero();
  clip.skeleton = Skeleton(std::move(tree_.joints));
  return clip;
}

void BvhReader::readHierarchy() {
  in_.expectWord("ROOT");
  openJoint(-1);
  std::vector<int> open = {0};
  while (!open.empty()) {
    const std::string_view word = in_.word();
    const int parent = open.back();
    if (word == "}") {
      open.pop_back();
    } else if (sameWord(word, "OFFSET")) {
      readOffset(tree_.joints[parent].offset);
    } else if (sameWord(word, "CHANNELS")) {
      readChannels(parent);
    } else if (sameWord(word, "JOINT")) {
      if (open.size() >= kMaxDepth) in_.fail("joints nested too deep", "at most 1,000 levels");
      openJoint(parent);
      open.push_back(static_cast<int>(tree_.joints.size()) - 1);
    } else if (sameWord(word, "End") || sameWord(word, "EndSite") || sameWord(word, "End_Site")) {
      openEndSite(parent);
    } else {
      in_.failAt(word, "OFFSET, CHANNELS, JOINT, End Site or }");
    }
  }
}

void BvhReader::openJoint(int parent) {
  if (tree_.joints.size() >= kMaxJoints) in_.fail("too many joints", "at most 10,000");
  Joint joint;
  joint.parent = parent;
  // A name is the rest of its line, spaces and all; some exporters put the brace behind it.
  std::string_view name = in_.restOfLine();
  const bool opened = !name.empty() && name.back() == '{';
  if (opened) name.remove_suffix(1);
  joint.name = trimmed(name);
  tree_.joints.push_back(std::move(joint));
  tree_.has_channels.push_back(false);
  if (!opened) in_.expectWord("{");
}

void BvhReader::openEndSite(int parent) {
  const std::string_view name = in_.restOfLine();
  if (name.empty() || name.back() != '{') in_.expectWord("{");
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  for (std::string_view word = in_.word(); word != "}"; word = in_.word()) {
    if (sameWord(word, "OFFSET")) {
      readOffset(tip);
    } else if (sameWord(word, "CHANNELS")) {
      readChannels(-1);
    } else {
      in_.failAt(word, "OFFSET or } in an End Site");
    }
  }
  tree_.joints[parent].end_sites.push_back(tip);
}

void BvhReader::readOffset(Eigen::Vector3d& offset) {
  for (int i = 0; i < 3; ++i) offset[i] = in_.number(kMaxCaptureNumber);
}

void BvhReader::readChannels(int joint) {
  const int count = in_.count();
  if (count > 6) in_.fail("a joint with more than 6 channels", "0 to 6");
  if (joint >= 0) {
    if (tree_.has_channels[joint]) in_.fail("a second CHANNELS of one joint", "one");
    tree_.has_channels[joint] = true;
  }
  const size_t first = tree_.columns.size();
  int rotations = 0;
  for (int i = 0; i < count; ++i) {
    Column column = readChannel(joint);
    for (size_t c = first; c < tree_.columns.size(); ++c) {
      if (tree_.columns[c].quantity == column.quantity && tree_.columns[c].axis == column.axis) {
        in_.fail("a channel twice in one joint", "each once");
      }
    }
    tree_.columns.push_back(column);
  }
  if (joint < 0) return;
  // From here on a rotation's axis is its place in the joint's order.
  RotationOrder& order = tree_.joints[joint].order;
  for (size_t c = first; c < tree_.columns.size(); ++c) {
    Column& column = tree_.columns[c];
    if (column.quantity == Quantity::kPosition) {
      moving_joints_ = moving_joints_ || joint > 0;
    } else {
      order[rotations] = static_cast<char>('X' + column.axis);
      column.axis = rotations++;
    }
  }
  completeOrder(order, rotations);
}

Column BvhReader::readChannel(int joint) {
  const std::string_view word = in_.word();
  const int axis = (word[0] | 0x20) - 'x';
  const bool rotation = sameWord(word.substr(1), "rotation");
  if (axis < 0 || axis > 2 || (!rotation && !sameWord(word.substr(1), "position"))) {
    in_.failAt(word, "Xposition, Yposition, Zposition, Xrotation, Yrotation or Zrotation");
  }
  return {joint, rotation ? Quantity::kRotation : Quantity::kPosition, axis};
}

// Axes without a channel are zero, wherever they stand in the order: they come last.
void BvhReader::completeOrder(RotationOrder& order, int rotations) const {
  if (rotations == 0) {
    order = Joint().order;
    return;
  }
  for (const char axis : {'Z', 'X', 'Y'}) {
    const auto end = order.begin() + rotations;
    if (rotations < 3 && std::find(order.begin(), end, axis) == end) order[rotations++] = axis;
  }
}

void BvhReader::readMotion(Clip& clip) {
  in_.expectWord("MOTION");
  const int frames = readFrameCount();
  const int count_line = in_.line();
  clip.frame_time = readFrameTime();
  if (frames > 0 && tree_.columns.empty())
    in_.fail("frames of joints without a channel", "a channel");
  // A number takes two bytes at least, so this is room enough whatever the file says.
  const size_t room = in_.remaining() / (2 * std::max<size_t>(1, tree_.columns.size())) + 1;
  makeRoom(clip, std::min<size_t>(frames, room));
  positions_.resize(tree_.joints.size());
  half_angles_.assign(tree_.joints.size(), Eigen::Vector3d::Zero());
  sines_ = cosines_ = half_angles_;
  for (size_t j = 0; j < tree_.joints.size(); ++j) positions_[j] = tree_.joints[j].offset;
  const std::string promised =
      std::to_string(frames) + " as line " + std::to_string(count_line) + " says";
  int frame = 0;
  for (; in_.skipBlankLines(); ++frame) {
    if (frame >= clip.frames()) makeRoom(clip, frame + 1);
    readFrame(clip, frame);
  }
  if (frame < frames) in_.fail("the file ends after frame " + std::to_string(frame), promised);
  if (frame > frames) {
    notes_.warnings.push_back(fmt::format("holds {} frames, not {}", frame, promised));
  }
}

void BvhReader::makeRoom(Clip& clip, size_t frames) const {
  if (frames * tree_.joints.size() > kMaxJointPosesPerByte * in_.size()) {
    in_.fail("too many joints without channels for so many frames", "channels on most joints");
  }
  clip.poses.resize(static_cast<int>(frames));
}

int BvhReader::readFrameCount() {
  in_.expectLabel("Frames");
  return in_.count();
}

double BvhReader::readFrameTime() {
  in_.expectLabel("Frame Time");
  const double seconds = in_.number(kMaxCaptureNumber);
  if (!(seconds > 0.0)) in_.fail(fmt::format("frame time {:g}", seconds), "seconds above 0");
  const int line = in_.line();
  in_.expectLineEnd();
  if (frame_time_) return *frame_time_;
  if (isFrameTime(seconds)) return seconds;
  if (!(seconds >= kMinRate && seconds <= kMaxRate)) {
    in_.fail(
        fmt::format("frame time {:g} s", seconds),
        fmt::format("{:g} to {:g} s, or a rate given by --file-fps", kMinFrameTime, kMaxFrameTime));
  }
  notes_.frame_time_guessed = true;
  notes_.warnings.push_back(
      fmt::format("line {}: frame time {:g} s is taken as {:g} frames a second; --file-fps sets it",
                  line, seconds, seconds));
  return 1.0 / seconds;
}

void BvhReader::readFrame(Clip& clip, int frame) {
  for (size_t i = 0; i < tree_.columns.size(); ++i) {
    const Column& column = tree_.columns[i];
    double value = 0.0;
    if (!in_.numberInLine(kMaxCaptureNumber, value)) {
      in_.fail(std::to_string(i) + " numbers in a frame", std::to_string(tree_.columns.size()));
    }
    if (column.joint < 0) continue;
    if (column.quantity == Quantity::kPosition) {
      positions_[column.joint][column.axis] = value;
    } else {
      half_angles_[column.joint][column.axis] = 0.5 * kDegree * value;
    }
  }
  if (!in_.atLineEnd()) {
    in_.fail("too many numbers in a frame", std::to_string(tree_.columns.size()));
  }
  setPose(clip, frame);
}

void BvhReader::setPose(Clip& clip, int frame) {
  const std::span<Eigen::Quaterniond> q = clip.poses.rotations(frame);
  const auto numbers = [](std::vector<Eigen::Vector3d>& vectors) {
    return std::span(vectors.front().data(), 3 * vectors.size());
  };
  sinesAndCosines(numbers(half_angles_), numbers(sines_), numbers(cosines_));
  for (size_t j = 0; j < q.size(); ++j)
    q[j] = fromHalfEuler(sines_[j], cosines_[j], tree_.joints[j].order);
  clip.poses.p_WR(frame) = positions_[0];
  if (!moving_joints_) return;
  clip.joint_positions.insert(clip.joint_positions.end(), positions_.begin(), positions_.end());
  clip.joint_positions[frame * q.size()].setZero();
}

}  // namespace

Clip parseBvhAsWritten(std::string_view text, const std::string& name,
                       std::optional<double> frame_time, BvhNotes& notes) {
  notes = {};
  std::string mended;
  return BvhReader(plainText(text, name, mended, notes.warnings), name, frame_time, notes).read();
}

Clip parseBvh(std::string_view text, const std::string& name, const BvhReadOptions& options,
              BvhNotes* notes) {
  BvhNotes ignored;
  Clip clip = parseBvhAsWritten(text, name, options.frame_time, notes ? *notes : ignored);
  turnUpright(options.up, clip);
  scaleToMetres(options.metres_per_unit, clip);
  return clip;
}

Clip readBvh(std::istream& in, const std::string& name, const BvhReadOptions& options,
             BvhNotes* notes) {
  return parseBvh(readWholeStream(in, name, kBvhFile), name, options, notes);
}

Clip readBvh(const std::filesystem::path& file, const BvhReadOptions& options, BvhNotes* notes) {
  return parseBvh(readWholeFile(file, kBvhFile), file.string(), options, notes);
}

}  // namespace amble
