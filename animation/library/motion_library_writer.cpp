#include "animation/library/motion_library_writer.h"

#include <yaml-cpp/yaml.h>

#include <array>
#include <charconv>
#include <fstream>
#include <sstream>

#include "animation/captures/bvh.h"
#include "base/error.h"
#include "base/output_file.h"
#include "base/rotation.h"
#include "base/strict_yaml.h"

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

void put(YAML::Emitter& out, const char* key, double value) {
  out << Key << key << Value << number(value);
}

template <typename Numbers>
void putList(YAML::Emitter& out, const Numbers& values, double unit = 1.0) {
  out << Flow << BeginSeq;
  for (const double v : values) out << number(v / unit);
  out << EndSeq;
}

template <typename Numbers>
void putList(YAML::Emitter& out, const char* key, const Numbers& values, double unit = 1.0) {
  out << Key << key << Value;
  putList(out, values, unit);
}

void putQuoted(YAML::Emitter& out, const char* key, const std::string& text) {
  out << Key << key << Value << YAML::DoubleQuoted << text;
}

void putFoot(YAML::Emitter& out, const char* side, const FootCycle& foot) {
  out << Key << side << Value << BeginMap;
  put(out, "strike", foot.strike);
  put(out, "lift_off", foot.lift_off);
  put(out, "slip", foot.slip);
  putList(out, "progress", foot.progress);
  putList(out, "height", foot.height);
  putList(out, "sideways", foot.sideways);
  putList(out, "roll", foot.roll);
  putList(out, "yaw", foot.yaw);
  putList(out, "pitch", foot.pitch, kDegree);
  out << EndMap;
}

void putMatrix(YAML::Emitter& out, const char* name, const Eigen::MatrixXd& matrix) {
  out << Key << name << Value << BeginSeq;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) putList(out, Eigen::VectorXd(matrix.row(i)));
  out << EndSeq;
}

void putCapture(YAML::Emitter& out, const CaptureQuality& capture) {
  out << Key << "capture" << Value << Flow << BeginMap;
  put(out, "toe_skate", capture.toe_skate);
  put(out, "root_acceleration", capture.root_acceleration);
  put(out, "joint_jerk", capture.joint_jerk);
  put(out, "pops", capture.pops);
  out << EndMap;
}

void putCycle(YAML::Emitter& out, const WalkCycle& cycle) {
  const FourierSeries& series = cycle.series;
  out << Key << "cycle" << Value << BeginMap;
  put(out, "speed", cycle.speed);
  put(out, "turn_rate", cycle.turn_rate / kDegree);
  put(out, "period", cycle.period);
  out << Key << "cycles" << Value << cycle.cycles;
  put(out, "closure", cycle.closure);
  put(out, "residual", cycle.residual / kDegree);
  put(out, "slide", cycle.slide);
  put(out, "step_width", cycle.step_width);
  put(out, "foot_forward", cycle.foot_forward);
  putList(out, "toe_out", cycle.toe_out, kDegree);
  putCapture(out, cycle.capture);
  putFoot(out, "left", cycle.feet[kLeft]);
  putFoot(out, "right", cycle.feet[kRight]);
  out << Key << "harmonics" << Value << series.harmonics();
  putMatrix(out, "alpha", series.alpha);
  putMatrix(out, "beta", series.beta.rightCols(series.harmonics()));
  out << EndMap;
}

void putPosture(YAML::Emitter& out, const Posture& posture) {
  out << Key << "posture" << Value << BeginMap;
  put(out, "root_height", posture.root_height);
  put(out, "root_forward", posture.root_forward);
  put(out, "step_width", posture.step_width);
  putList(out, "toe_out", posture.toe_out, kDegree);
  out << Key << "rotations" << Value << BeginSeq;
  for (const Eigen::Quaterniond& q : posture.rotations) {
    putList(out, std::array<double, 4>{q.w(), q.x(), q.y(), q.z()});
  }
  out << EndSeq << EndMap;
}

void putTransition(YAML::Emitter& out, const Transition& transition) {
  out << Key << "transition" << Value << Flow << BeginMap;
  put(out, "speed", transition.speed);
  put(out, "first_speed", transition.first_speed);
  put(out, "acceleration", transition.acceleration);
  out << EndMap;
}

void putValidity(YAML::Emitter& out, const Validity& valid) {
  using When = Validity::When;
  out << Key << "valid" << Value;
  if (valid.when == When::kAlways) out << "always";
  if (valid.when == When::kAtStart) out << "at_start";
  if (valid.when == When::kAtEnd) out << "at_end";
  if (valid.when == When::kBetween || valid.when == When::kClearanceAbove) {
    out << Flow << BeginMap;
    if (valid.when == When::kBetween) {
      put(out, "from", valid.from);
      put(out, "to", valid.to);
    } else {
      put(out, "clearance_above", valid.clearance);
    }
    out << EndMap;
  }
}

void putChains(YAML::Emitter& out, const std::vector<std::string>& chains) {
  out << Key << "joints" << Value;
  if (chains.empty()) {
    out << "all";
  } else {
    out << Flow << chains;
  }
}

void putSource(YAML::Emitter& out, const MotionSource& source) {
  out << Key << "source" << Value << BeginMap;
  putQuoted(out, "clip", source.clip);
  out << Key << "frames" << Value << Flow << BeginSeq << source.frames[0] << source.frames[1]
      << EndSeq;
  out << Key << "mirrored" << Value << (source.mirrored ? "true" : "false");
  putQuoted(out, "licence", source.licence);
  putQuoted(out, "credit", source.credit);
  out << EndMap;
}

void putMotion(YAML::Emitter& out, const Motion& motion) {
  out << BeginMap << Key << "name" << Value << motion.name;
  out << Key << "kind" << Value << motionKindNames()[static_cast<size_t>(motion.kind)];
  if (motion.kind == MotionKind::kWalk) {
    out << Key << "turning" << Value << (motion.turning ? "turn" : "straight");
  }
  putValidity(out, motion.valid);
  putChains(out, motion.chains);
  putSource(out, motion.source);
  switch (motion.kind) {
    case MotionKind::kWalk:
    case MotionKind::kMovement:
      putCycle(out, motion.cycle);
      break;
    case MotionKind::kPosture:
    case MotionKind::kBlocking:
      putPosture(out, motion.posture);
      break;
    case MotionKind::kStart:
    case MotionKind::kStop:
      putTransition(out, motion.transition);
      break;
  }
  out << EndMap;
}

// Joints are called what the BVH beside the library calls them.
void putRoles(YAML::Emitter& out, const MotionLibrary& library) {
  const std::vector<std::string> names = bvhJointNames(library.skeleton);
  out << Key << "joints" << Value << BeginMap;
  for (const std::string& role : roleNames()) {
    const int joint = roleJoint(library.roles, role);
    if (joint >= 0) out << Key << role << Value << names[joint];
  }
  out << EndMap;
}

void writeLibrary(std::ostream& stream, const MotionLibrary& library) {
  stream << "# Made by `amble library build` from the captures that are named below; not edited by "
            "hand.\n"
         << "# Metres, seconds, degrees; rotation vectors (from channel 3 on) in radians.\n";
  YAML::Emitter out(stream);
  out << BeginMap << Key << "skeleton" << Value << library.skeleton_file;
  put(out, "stature", library.stature);
  putRoles(out, library);
  out << Key << "motions" << Value << BeginSeq;
  for (const Motion& motion : library.motions) putMotion(out, motion);
  out << EndSeq << EndMap;
  stream << '\n';
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

// @throws InputError where the file is there and no library
void requireNothingLost(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return;
  const YamlNode root = readYaml(file);
  if (root.isMap() && root.has("skeleton") && root.has("stature") && root.has("motions")) return;
  throw InputError(file.string(), 0, "is no motion library; one is not written over it",
                   "a new file, or a library");
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

bool isLibrarySkeleton(const std::filesystem::path& file) {
  try {
    return contentOf(file) == restBvh(readBvh(file).skeleton);
  } catch (const InputError&) {
    return false;
  }
}

void writeMotionLibrary(const MotionLibrary& library, const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path();
  const std::filesystem::path skeleton = folder / library.skeleton_file;
  requireNothingLost(file);
  const bool there = holdsSkeleton(skeleton, library.skeleton);
  makeFolder(folder);
  std::vector<ResultFile> files;
  if (!there) {
    files.push_back(
        {skeleton, [&](std::ostream& out) { writeBvh(out, restClip(library.skeleton)); }});
  }
  files.push_back({file, [&](std::ostream& out) { writeLibrary(out, library); }});
  writeFiles(files);
}

}  // namespace amble
