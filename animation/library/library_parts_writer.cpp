#include "animation/library/library_parts_writer.h"

#include <fstream>
#include <sstream>
#include <system_error>

#include "animation/captures/bvh.h"
#include "base/error.h"
#include "base/output_file.h"
#include "base/rotation.h"
#include "base/strict_yaml.h"
#include "base/text.h"

namespace amble {
namespace {

// Digits after the point: a tenth of a micrometre or of a microradian, far below what a capture
// knows.
constexpr int kDigits = 7;
constexpr double kOne = 1e7;  // in units of the last of them

// Of offsets that a BVH rounded: closer is the same joint [m].
constexpr double kSameOffset = 1e-6;

std::string number(double value) { return plainNumber(value, kDigits); }

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

// Whether it is a library or engine whose skeleton is kept under this name beside it.
bool isKeptBeside(const std::filesystem::path& file, const std::string& skeleton) {
  if (file.extension() != ".yaml" && file.extension() != ".yml") return false;
  try {
    const YamlNode root = readYaml(file);
    return root.isMap() && root.has("stature") && root.has("skeleton") &&
           root.at("skeleton").asString() == skeleton;
  } catch (const InputError&) {
    return false;
  }
}

// Whether another library or engine of the folder has its skeleton there, too.
bool isShared(const std::filesystem::path& library, const std::string& skeleton) {
  const std::filesystem::path folder = std::filesystem::absolute(library).parent_path();
  std::error_code unreadable;  // there is nothing beside it then
  for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
    if (entry.path().filename() != library.filename() && isKeptBeside(entry.path(), skeleton))
      return true;
  }
  return false;
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

void putFrames(YamlWriter& out, const char* key, const std::array<int, 2>& frames) {
  out.key(key).beginList(YamlWriter::kFlow);
  for (const int frame : frames) out.whole(frame);
  out.end();
}

}  // namespace

void put(YamlWriter& out, const char* key, double value) { out.key(key).plain(number(value)); }

void putList(YamlWriter& out, std::span<const double> values, double unit) {
  out.beginList(YamlWriter::kFlow);
  for (const double v : values) out.plain(number(v / unit));
  out.end();
}

void putList(YamlWriter& out, const char* key, std::span<const double> values, double unit) {
  putList(out.key(key), values, unit);
}

void putMatrix(YamlWriter& out, const char* name, const Eigen::MatrixXd& matrix) {
  out.key(name).beginList();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const Eigen::VectorXd row = matrix.row(i);
    putList(out, {row.data(), static_cast<size_t>(row.size())});
  }
  out.end();
}

void putRotations(YamlWriter& out, const char* name,
                  const std::vector<Eigen::Quaterniond>& rotations) {
  out.key(name).beginList();
  for (const Eigen::Quaterniond& rotation : rotations) {
    const Eigen::Quaterniond q = asReadAgain(rotation);
    putList(out, std::array<double, 4>{q.w(), q.x(), q.y(), q.z()});
  }
  out.end();
}

void putPosture(YamlWriter& out, const Posture& posture) {
  out.key("posture").beginMap();
  put(out, "root_height", posture.root_height);
  put(out, "root_forward", posture.root_forward);
  put(out, "step_width", posture.step_width);
  putList(out, "toe_out", posture.toe_out, kDegree);
  putRotations(out, "rotations", posture.rotations);
  out.end();
}

void putSource(YamlWriter& out, const MotionSource& source) {
  out.key("source").beginMap();
  out.key("clip").quoted(source.clip);
  if (source.speed) {
    put(out, "speed", *source.speed);
  } else {
    putFrames(out, "frames", source.frames);
    if (source.within) putFrames(out, "within", *source.within);
  }
  out.key("mirrored").truth(source.mirrored);
  out.key("licence").quoted(source.licence);
  out.key("credit").quoted(source.credit);
  out.end();
}

void putCapture(YamlWriter& out, const CaptureQuality& capture) {
  out.key("capture").beginMap(YamlWriter::kFlow);
  put(out, "toe_skate", capture.toe_skate);
  put(out, "root_acceleration", capture.root_acceleration);
  put(out, "joint_jerk", capture.joint_jerk);
  put(out, "pops", capture.pops);
  out.end();
}

// Joints are called what the BVH beside the library calls them.
void putRoles(YamlWriter& out, const Skeleton& skeleton, const JointRoles& roles) {
  const std::vector<std::string> names = bvhJointNames(skeleton);
  out.key("joints").beginMap();
  for (const std::string& role : roleNames()) {
    const int joint = roleJoint(roles, role);
    if (joint >= 0) out.key(role).text(names[joint]);
  }
  out.end();
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
    // That of another, whose name was changed or ends otherwise, may lie there.
    const bool own = std::filesystem::exists(file) && isLibrarySkeleton(skeleton) &&
                     !isShared(file, skeleton.filename().string());
    if (own || !std::filesystem::exists(skeleton)) return name + ".bvh";
  }
}

std::string skeletonNameFor(const Skeleton& skeleton, const std::string& name,
                            const std::filesystem::path& library) {
  const std::filesystem::path beside = library.parent_path() / name;
  if (!std::filesystem::exists(beside) || sameHierarchy(readBvh(beside).skeleton, skeleton))
    return name;
  return skeletonNameBeside(library);
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
