#include "animation/library/library_parts_writer.h"

#include <yaml-cpp/yaml.h>

#include <charconv>
#include <fstream>
#include <sstream>

#include "animation/captures/bvh.h"
#include "base/error.h"
#include "base/output_file.h"
#include "base/rotation.h"

namespace amble {
namespace {

using YAML::BeginMap;
using YAML::BeginSeq;
using YAML::EndMap;
using YAML::EndSeq;
using YAML::Flow;
using YAML::Key;
using YAML::Value;

// Digits after the point: a tenth of a micrometre or of a microradian, far below what a capture
// knows.
constexpr int kDigits = 7;
constexpr double kOne = 1e7;  // in units of the last of them

// Of offsets that a BVH rounded: closer is the same joint [m].
constexpr double kSameOffset = 1e-5;

// Not the emitter's own, which knows significant digits only.
std::string number(double value) {
  char text[64];
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, kDigits);
  std::string s(text, end.ptr);
  while (s.back() == '0') s.pop_back();
  if (s.back() == '.') s.pop_back();
  return s == "-0" ? "0" : s;
}

void putRow(YAML::Emitter& out, const Eigen::VectorXd& row) {
  putList(out, {row.data(), static_cast<size_t>(row.size())});
}

// The skeleton as a clip of one frame, in its rest pose.
Clip restClip(const Skeleton& skeleton) {
  Clip clip;
  clip.name = "rest";
  clip.skeleton = skeleton;
  clip.poses = PoseArray(skeleton.size());
  clip.poses.resize(1);
  clip.poses.rotations(0)[0] = yUpToWorld();
  return clip;
}

bool sameHierarchy(const Skeleton& a, const Skeleton& b) {
  const std::vector<std::string> names = bvhJointNames(a), others = bvhJointNames(b);
  if (names != others) return false;
  for (int i = 0; i < a.size(); ++i) {
    const Joint &x = a.joint(i), &y = b.joint(i);
    if (x.parent != y.parent) return false;
    if (i > 0 && (x.offset - y.offset).norm() > kSameOffset) return false;
  }
  return true;
}

std::string restBvh(const Skeleton& skeleton) {
  std::ostringstream text;
  writeBvh(text, restClip(skeleton));
  return text.str();
}

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// Whether the file holds this skeleton already. @throws InputError where it holds anything else but
// the skeleton of some library
bool holdsSkeleton(const std::filesystem::path& file, const Skeleton& skeleton) {
  if (!std::filesystem::exists(file)) return false;
  if (sameHierarchy(readBvh(file).skeleton, skeleton)) return true;
  if (isLibrarySkeleton(file)) return false;
  throw InputError(file.string(), 0, "is a capture; the library's skeleton is not written over it",
                   "another name for `skeleton`");
}

// To the digits that are written, such that they stay when a reader, who makes it a rotation again,
// writes it: a file that is read and written does not change.
Eigen::Quaterniond asReadAgain(const Eigen::Quaterniond& rotation) {
  constexpr int kMost = 10;  // times; one or two are enough
  Eigen::Vector4d written, now = rotation.coeffs();
  for (int i = 0; i < kMost; ++i) {
    written = (now * kOne).array().round() / kOne;
    now = written.normalized();
    if (((now * kOne).array().round() / kOne == written.array()).all()) break;
  }
  return Eigen::Quaterniond(written);
}

void makeFolder(const std::filesystem::path& folder) {
  if (folder.empty()) return;
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) {
    throw InputError(folder.string(), 0, "cannot be made: " + failed.message(),
                     "a folder that can be written");
  }
}

}  // namespace

void put(YAML::Emitter& out, const char* key, double value) {
  out << Key << key << Value << number(value);
}

void putList(YAML::Emitter& out, std::span<const double> values, double unit) {
  out << Flow << BeginSeq;
  for (const double v : values) out << number(v / unit);
  out << EndSeq;
}

void putList(YAML::Emitter& out, const char* key, std::span<const double> values, double unit) {
  out << Key << key << Value;
  putList(out, values, unit);
}

void putQuoted(YAML::Emitter& out, const char* key, const std::string& text) {
  out << Key << key << Value << YAML::DoubleQuoted << text;
}

void putMatrix(YAML::Emitter& out, const char* name, const Eigen::MatrixXd& matrix) {
  out << Key << name << Value << BeginSeq;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) putRow(out, matrix.row(i));
  out << EndSeq;
}

void putRotations(YAML::Emitter& out, const char* name,
                  const std::vector<Eigen::Quaterniond>& rotations) {
  out << Key << name << Value << BeginSeq;
  for (const Eigen::Quaterniond& rotation : rotations) {
    const Eigen::Quaterniond q = asReadAgain(rotation);
    putList(out, std::array<double, 4>{q.w(), q.x(), q.y(), q.z()});
  }
  out << EndSeq;
}

void putPosture(YAML::Emitter& out, const Posture& posture) {
  out << Key << "posture" << Value << BeginMap;
  put(out, "root_height", posture.root_height);
  put(out, "root_forward", posture.root_forward);
  put(out, "step_width", posture.step_width);
  putList(out, "toe_out", posture.toe_out, kDegree);
  putRotations(out, "rotations", posture.rotations);
  out << EndMap;
}

void putSource(YAML::Emitter& out, const MotionSource& source) {
  out << Key << "source" << Value << BeginMap;
  putQuoted(out, "clip", source.clip);
  if (source.speed) {
    put(out, "speed", *source.speed);
  } else {
    out << Key << "frames" << Value << Flow << BeginSeq << source.frames[0] << source.frames[1]
        << EndSeq;
  }
  out << Key << "mirrored" << Value << (source.mirrored ? "true" : "false");
  putQuoted(out, "licence", source.licence);
  putQuoted(out, "credit", source.credit);
  out << EndMap;
}

void putCapture(YAML::Emitter& out, const CaptureQuality& capture) {
  out << Key << "capture" << Value << Flow << BeginMap;
  put(out, "toe_skate", capture.toe_skate);
  put(out, "root_acceleration", capture.root_acceleration);
  put(out, "joint_jerk", capture.joint_jerk);
  put(out, "pops", capture.pops);
  out << EndMap;
}

// Joints are called what the BVH beside the library calls them.
void putRoles(YAML::Emitter& out, const Skeleton& skeleton, const JointRoles& roles) {
  const std::vector<std::string> names = bvhJointNames(skeleton);
  out << Key << "joints" << Value << BeginMap;
  for (const std::string& role : roleNames()) {
    const int joint = roleJoint(roles, role);
    if (joint >= 0) out << Key << role << Value << names[joint];
  }
  out << EndMap;
}

bool isLibrarySkeleton(const std::filesystem::path& file) {
  try {
    return contentOf(file) == restBvh(readBvh(file).skeleton);
  } catch (const InputError&) {
    return false;
  }
}

std::string skeletonNameBeside(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  for (int i = 1;; ++i) {
    std::string name = stem;
    if (i > 1) name += "-skeleton";
    if (i > 2) name += "-" + std::to_string(i - 1);
    const std::filesystem::path skeleton = file.parent_path() / (name + ".bvh");
    if (!std::filesystem::exists(skeleton) || isLibrarySkeleton(skeleton)) return name + ".bvh";
  }
}

void writeWithSkeleton(const Skeleton& skeleton, const std::string& skeleton_file,
                       const std::filesystem::path& file,
                       const std::function<void(std::ostream&)>& write) {
  const std::filesystem::path folder = file.parent_path(), beside = folder / skeleton_file;
  const bool there = holdsSkeleton(beside, skeleton);
  makeFolder(folder);
  std::vector<ResultFile> files;
  if (!there) {
    files.push_back({beside, [&](std::ostream& out) { writeBvh(out, restClip(skeleton)); }});
  }
  files.push_back({file, write});
  writeFiles(files);
}

}  // namespace amble
