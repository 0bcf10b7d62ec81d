/// BVH writer. Every number is a whole count of its last digit before it is printed, and everything
/// that is chosen (the Euler solution, the turn, gimbal lock) is chosen on those whole numbers:
/// reading them back gives the same choice, so that a second writing gives the same bytes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <set>
#include <stdexcept>

#include "animation/captures/bvh.h"
#include "base/error.h"
#include "base/output_file.h"
#include "base/rotation.h"
#include "base/trigonometry.h"

namespace amble {
namespace {

constexpr RotationOrder kOrder = {'Z', 'X', 'Y'};  // a turn of x, y, z with Z first: parity +1

// Angles are written in millionths of a degree, lengths in millionths of the file's unit, times in
// 1e-7 s.
constexpr int kDecimals = 6;
constexpr int kTimeDecimals = 7;
constexpr double kTicks = 1e6;
constexpr double kTimeTicks = 1e7;

constexpr int64_t kHalfTurn = 180'000'000;    // [1e-6 degrees]
constexpr int64_t kQuarterTurn = 90'000'000;  // [1e-6 degrees]

// Closer than this to 90 degrees the outer angles are not told apart: there they are known to eps /
// cos(angle), which has to stay far below half of the last digit (here 1e-15 / 8.7e-7 rad = 7e-8
// degrees). Costs 5e-5 degrees at most in the pose. [1e-6 degrees]
constexpr int64_t kGimbal = 50;

// Numbers above it would not fit their digits; no walk is that long. [written units]
constexpr double kMaxLength = 1e9;

using Ticks = std::array<int64_t, 3>;

int64_t toTicks(double value, double ticks_per_unit) {
  if (!(std::abs(value) <= kMaxLength)) {
    throw std::invalid_argument("writeBvh: a number is not finite or above 1e9");
  }
  // To the nearest, halves away from zero: std::llround in line.
  const double scaled = value * ticks_per_unit;
  const int64_t whole = static_cast<int64_t>(scaled);
  const double rest = scaled - static_cast<double>(whole);
  return whole + (rest >= 0.5) - (rest <= -0.5);
}

// Two digits at a time: "00" to "99".
constexpr std::array<char, 200> kPairs = [] {
  std::array<char, 200> pairs{};
  for (int i = 0; i < 100; ++i) {
    pairs[2 * i] = static_cast<char>('0' + i / 10);
    pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
  }
  return pairs;
}();

char* putPair(uint64_t number, char* at) {
  std::memcpy(at, kPairs.data() + 2 * number, 2);
  return at + 2;
}

/// All digits of a number, none before the first.
char* putWhole(uint64_t number, char* at) {
  if (number >= 100) {
    at = putWhole(number / 100, at);
  } else if (number < 10) {
    *at++ = static_cast<char>('0' + number);
    return at;
  }
  return putPair(number % 100, at);
}

constexpr size_t kLongest = 24;  // of a number's text: sign, 19 digits, point

/// Fixed point, never in an exponent, never "-0.000000", the same in every locale. Returns its end.
template <int kPlaces>
char* putFixed(int64_t ticks, char* at) {
  constexpr uint64_t kWhole = [] {
    uint64_t power = 1;
    for (int i = 0; i < kPlaces; ++i) power *= 10;
    return power;
  }();
  const uint64_t magnitude =
      ticks < 0 ? static_cast<uint64_t>(-ticks) : static_cast<uint64_t>(ticks);
  if (ticks < 0) *at++ = '-';
  at = putWhole(magnitude / kWhole, at);
  *at++ = '.';
  uint64_t left = magnitude % kWhole, power = kWhole;
// So that it is divided by constants.
#pragma GCC unroll 4
  for (int place = 0; place + 2 <= kPlaces; place += 2) {
    power /= 100;
    at = putPair(left / power, at);
    left %= power;
  }
  if (kPlaces % 2 > 0) *at++ = static_cast<char>('0' + left);
  return at;
}

template <int kPlaces>
void appendFixed(std::string& out, int64_t ticks) {
  char text[kLongest];
  out.append(text, putFixed<kPlaces>(ticks, text));
}

int64_t nearestTurn(int64_t angle, int64_t target) {
  // Floor division of (target - angle) by a turn, rounded to the nearest.
  const int64_t turn = 2 * kHalfTurn, difference = target - angle + kHalfTurn;
  if (difference >= 0 && difference < turn) return angle;
  const int64_t turns = difference / turn - (difference % turn < 0 ? 1 : 0);
  return angle + turns * turn;
}

double squaredDistance(const Ticks& a, const Ticks& b) {
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
    sum += static_cast<double>(a[i] - b[i]) * static_cast<double>(a[i] - b[i]);
  return sum;
}

/// The Z X Y angles of many rotations at once: for each three quotients of its matrix's entries,
/// which whatever it is scaled by leaves the same. With a, b, c the angles,
///   R01 = -sin a cos b,  R11 = cos a cos b,  R21 = sin b,  R20 = -cos b sin c,  R22 = cos b cos c.
class ManyAngles {
 public:
  explicit ManyAngles(size_t rotations)
      : y_(3 * rotations), x_(3 * rotations), angle_(3 * rotations) {}

  void set(size_t i, const Eigen::Quaterniond& q) {
    const double w = q.w(), x = q.x(), y = q.y(), z = q.z();
    const double r20 = 2.0 * (x * z - w * y), r22 = (w * w + z * z) - (x * x + y * y);
    y_[3 * i] = 2.0 * (w * z - x * y);
    x_[3 * i] = (w * w + y * y) - (x * x + z * z);
    y_[3 * i + 1] = 2.0 * (y * z + w * x);
    x_[3 * i + 1] = std::sqrt(r20 * r20 + r22 * r22);
    y_[3 * i + 2] = -r20;
    x_[3 * i + 2] = r22;
  }
  void solve() { arcTangents(y_, x_, angle_); }

  /// Of q, which was set as i [degrees]. Near gimbal lock the outer angles are so small parts of
  /// the matrix that they are taken one after the other.
  Eigen::Vector3d degrees(size_t i, const Eigen::Quaterniond& q) const {
    constexpr double kSteep = 10.0;  // of the middle angle's tangent: 84 degrees
    if (std::abs(y_[3 * i + 1]) < kSteep * x_[3 * i + 1])
      return Eigen::Vector3d(angle_[3 * i], angle_[3 * i + 1], angle_[3 * i + 2]) / kDegree;
    return toEuler(q.normalized(), kOrder) / kDegree;
  }

 private:
  std::vector<double> y_, x_, angle_;
};

/// The Z X Y angles that mean the same as these and continue `previous` best: unwrapEuler in whole
/// ticks.
Ticks continuedAngles(const Eigen::Vector3d& degrees, const Ticks& previous) {
  Ticks a = {toTicks(degrees[0], kTicks), toTicks(degrees[1], kTicks), toTicks(degrees[2], kTicks)};
  if (std::abs(a[1]) >= kQuarterTurn - kGimbal) {
    // Only the sum (at +90, the difference at -90) of the outer angles is known: the last stays as
    // it was.
    const int sign = a[1] > 0 ? 1 : -1;
    const int64_t sum = toTicks(degrees[0] + sign * degrees[2], kTicks);
    a[2] = previous[2];
    a[0] = nearestTurn(sum - sign * a[2], previous[0]);
    return a;
  }
  Ticks same, other;
  const Ticks mirrored = {a[0] + kHalfTurn, kHalfTurn - a[1], a[2] + kHalfTurn};
  for (int i = 0; i < 3; ++i) {
    same[i] = nearestTurn(a[i], previous[i]);
    other[i] = nearestTurn(mirrored[i], previous[i]);
  }
  return squaredDistance(other, previous) < squaredDistance(same, previous) ? other : same;
}

bool isNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

class BvhWriter {
 public:
  BvhWriter(const Clip& clip, const BvhWriteOptions& options);
  void write(std::ostream& out);

 private:
  void appendHierarchy();
  void openJoint(int joint);
  void closeJoint();
  void appendIndent() { text_.append(depth_, '\t'); }
  void appendOffset(const Eigen::Vector3d& p);
  void appendFrame(int frame);

  const Clip& clip_;
  double units_per_metre_;
  std::vector<std::vector<int>> children_;  // by joint
  std::vector<int> order_;                  // joints in the order of the file
  std::vector<Ticks> angles_;               // last written, by joint
  std::vector<std::string> names_;
  ManyAngles solved_;             // of a frame, in the order of the file
  std::vector<char> frame_text_;  // room for a frame's numbers
  int depth_ = 0;
  std::string text_;
};

BvhWriter::BvhWriter(const Clip& clip, const BvhWriteOptions& options)
    : clip_(clip),
      units_per_metre_(1.0 / options.metres_per_unit),
      children_(clip.skeleton.size()),
      angles_(clip.skeleton.size(), Ticks{0, 0, 0}),
      names_(bvhJointNames(clip.skeleton)),
      solved_(clip.skeleton.size()),
      frame_text_(3 * (1 + clip.skeleton.size()) * (1 + kLongest)) {
  if (clip.skeleton.size() == 0 || clip.poses.joints() != clip.skeleton.size()) {
    throw std::invalid_argument("writeBvh: the clip's poses are not its skeleton's");
  }
  for (int j = 1; j < clip.skeleton.size(); ++j)
    children_[clip.skeleton.joint(j).parent].push_back(j);
}

void BvhWriter::write(std::ostream& out) {
  appendHierarchy();
  text_ += "MOTION\nFrames: " + std::to_string(clip_.frames()) + "\nFrame Time: ";
  appendFixed<kTimeDecimals>(text_, std::max<int64_t>(1, toTicks(clip_.frame_time, kTimeTicks)));
  text_ += '\n';
  for (int frame = 0; frame < clip_.frames(); ++frame) {
    appendFrame(frame);
    constexpr size_t kFlush = 1 << 16;  // [bytes]
    if (text_.size() > kFlush) {
      out.write(text_.data(), static_cast<std::streamsize>(text_.size()));
      text_.clear();
    }
  }
  out.write(text_.data(), static_cast<std::streamsize>(text_.size()));
}

void BvhWriter::appendHierarchy() {
  text_ = "HIERARCHY\n";
  // Joints open on the way down and close on the way up; a stack in place of recursion, for deep
  // rigs.
  std::vector<std::pair<int, size_t>> open;  // joint, children written
  openJoint(0);
  open.emplace_back(0, 0);
  while (!open.empty()) {
    auto& [joint, next] = open.back();
    if (next == children_[joint].size()) {
      closeJoint();
      open.pop_back();
      continue;
    }
    const int child = children_[joint][next++];
    openJoint(child);
    open.emplace_back(child, 0);
  }
}

void BvhWriter::openJoint(int joint) {
  const Joint& source = clip_.skeleton.joint(joint);
  order_.push_back(joint);
  appendIndent();
  text_ += (joint == 0 ? "ROOT " : "JOINT ") + names_[joint] + "\n";
  appendIndent();
  text_ += "{\n";
  ++depth_;
  appendOffset(joint == 0 ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : source.offset);
  appendIndent();
  text_ += joint == 0 ? "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
                      : "CHANNELS 3 Zrotation Xrotation Yrotation\n";
  // Readers want a joint or an End Site below every joint.
  std::vector<Eigen::Vector3d> tips = source.end_sites;
  if (tips.empty() && children_[joint].empty()) tips.push_back(Eigen::Vector3d::Zero());
  for (const Eigen::Vector3d& tip : tips) {
    appendIndent();
    text_ += "End Site\n";
    appendIndent();
    text_ += "{\n";
    ++depth_;
    appendOffset(tip);
    closeJoint();
  }
}

void BvhWriter::closeJoint() {
  --depth_;
  appendIndent();
  text_ += "}\n";
}

void BvhWriter::appendOffset(const Eigen::Vector3d& p) {
  appendIndent();
  text_ += "OFFSET";
  for (int i = 0; i < 3; ++i) {
    text_ += ' ';
    appendFixed<kDecimals>(text_, toTicks(p[i] * units_per_metre_, kTicks));
  }
  text_ += '\n';
}

void BvhWriter::appendFrame(int frame) {
  const Eigen::Vector3d& p_WR = clip_.poses.p_WR(frame);
  const Eigen::Vector3d p_file = units_per_metre_ * Eigen::Vector3d(p_WR.x(), p_WR.z(), -p_WR.y());
  char* at = frame_text_.data();
  const auto put = [&](int64_t ticks) {
    at = putFixed<kDecimals>(ticks, at);
    *at++ = ' ';
  };
  for (int i = 0; i < 3; ++i) put(toTicks(p_file[i], kTicks));
  const std::span<const Eigen::Quaterniond> rotations = clip_.poses.rotations(frame);
  const auto inFile = [&](int j) {
    return j == 0 ? yUpToWorld().conjugate() * rotations[0] : rotations[j];
  };
  for (size_t i = 0; i < order_.size(); ++i) solved_.set(i, inFile(order_[i]));
  solved_.solve();
  for (size_t i = 0; i < order_.size(); ++i) {
    const int j = order_[i];
    angles_[j] = continuedAngles(solved_.degrees(i, inFile(j)), angles_[j]);
    for (const int64_t angle : angles_[j]) put(angle);
  }
  at[-1] = '\n';
  text_.append(frame_text_.data(), at);
}

}  // namespace

std::vector<std::string> bvhJointNames(const Skeleton& skeleton) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const Joint& joint : skeleton.joints()) {
    std::string name = joint.name.empty() ? "joint" : joint.name;
    for (char& c : name) c = isNameCharacter(c) ? c : '_';
    std::string unique = name;
    for (int i = 2; !taken.insert(unique).second; ++i) unique = name + "_" + std::to_string(i);
    names.push_back(unique);
  }
  return names;
}

void writeBvh(std::ostream& out, const Clip& clip, const BvhWriteOptions& options) {
  BvhWriter(clip, options).write(out);
}

void writeBvh(const std::filesystem::path& file, const Clip& clip, const BvhWriteOptions& options) {
  writeFile(file, [&](std::ostream& out) { writeBvh(out, clip, options); });
}

}  // namespace amble
