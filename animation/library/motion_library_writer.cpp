#include <charconv>
#include <cmath>

#include "animation/captures/bvh.h"
#include "animation/library/motion_library.h"
#include "base/output_file.h"
#include "base/rotation.h"

namespace amble {
namespace {

// Digits after the point: a tenth of a micrometre or of a microradian, far below what a capture
// knows.
constexpr int kDigits = 7;

std::string number(double value) {
  char text[64];
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, kDigits);
  std::string s(text, end.ptr);
  while (s.back() == '0') s.pop_back();
  if (s.back() == '.') s.pop_back();
  return s == "-0" ? "0" : s;
}

template <typename Numbers>
std::string list(const Numbers& values, double unit = 1.0) {
  std::string text = "[";
  for (const double v : values) text += (text.size() > 1 ? ", " : "") + number(v / unit);
  return text + "]";
}

std::string quoted(const std::string& text) {
  std::string s = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') s += '\\';
    s += c;
  }
  return s + "\"";
}

void writeFoot(std::ostream& out, const std::string& side, const FootCycle& foot) {
  out << "      " << side << ":\n"
      << "        strike: " << number(foot.strike) << "\n"
      << "        lift_off: " << number(foot.lift_off) << "\n"
      << "        slip: " << number(foot.slip) << "\n"
      << "        progress: " << list(foot.progress) << "\n"
      << "        height: " << list(foot.height) << "\n"
      << "        sideways: " << list(foot.sideways) << "\n"
      << "        roll: " << list(foot.roll) << "\n"
      << "        yaw: " << list(foot.yaw) << "\n"
      << "        pitch: " << list(foot.pitch, kDegree) << "\n";
}

void writeMatrix(std::ostream& out, const std::string& name, const Eigen::MatrixXd& matrix) {
  out << "      " << name << ":\n";
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const Eigen::VectorXd row = matrix.row(i);
    out << "        - " << list(row) << "\n";
  }
}

void writeCycle(std::ostream& out, const WalkCycle& cycle) {
  out << "    cycle:\n"
      << "      speed: " << number(cycle.speed) << "\n"
      << "      turn_rate: " << number(cycle.turn_rate / kDegree) << "\n"
      << "      period: " << number(cycle.period) << "\n"
      << "      cycles: " << cycle.cycles << "\n"
      << "      closure: " << number(cycle.closure) << "\n"
      << "      residual: " << number(cycle.residual / kDegree) << "\n"
      << "      slide: " << number(cycle.slide) << "\n"
      << "      step_width: " << number(cycle.step_width) << "\n"
      << "      foot_forward: " << number(cycle.foot_forward) << "\n"
      << "      toe_out: " << list(cycle.toe_out, kDegree) << "\n"
      << "      capture: {toe_skate: " << number(cycle.capture.toe_skate)
      << ", root_acceleration: " << number(cycle.capture.root_acceleration)
      << ", joint_jerk: " << number(cycle.capture.joint_jerk)
      << ", pops: " << number(cycle.capture.pops) << "}\n";
  writeFoot(out, "left", cycle.feet[kLeft]);
  writeFoot(out, "right", cycle.feet[kRight]);
  out << "      harmonics: " << cycle.series.harmonics() << "\n";
  writeMatrix(out, "alpha", cycle.series.alpha);
  writeMatrix(out, "beta", cycle.series.beta.rightCols(cycle.series.harmonics()));
}

void writePosture(std::ostream& out, const Posture& posture) {
  out << "    posture:\n"
      << "      root_height: " << number(posture.root_height) << "\n"
      << "      root_forward: " << number(posture.root_forward) << "\n"
      << "      step_width: " << number(posture.step_width) << "\n"
      << "      toe_out: " << list(posture.toe_out, kDegree) << "\n"
      << "      rotations:\n";
  for (const Eigen::Quaterniond& q : posture.rotations) {
    out << "        - " << list(std::array<double, 4>{q.w(), q.x(), q.y(), q.z()}) << "\n";
  }
}

std::string validText(const Validity& valid) {
  switch (valid.when) {
    case Validity::When::kAlways:
      return "always";
    case Validity::When::kAtStart:
      return "at_start";
    case Validity::When::kAtEnd:
      return "at_end";
    case Validity::When::kBetween:
      return "{from: " + number(valid.from) + ", to: " + number(valid.to) + "}";
    case Validity::When::kClearanceAbove:
      return "{clearance_above: " + number(valid.clearance) + "}";
  }
  return "always";
}

std::string chainsText(const std::vector<std::string>& chains) {
  if (chains.empty()) return "all";
  std::string text;
  for (const std::string& chain : chains) text += (text.empty() ? "[" : ", ") + chain;
  return text + "]";
}

void writeTransition(std::ostream& out, const Transition& transition) {
  out << "    transition: {speed: " << number(transition.speed)
      << ", first_speed: " << number(transition.first_speed)
      << ", acceleration: " << number(transition.acceleration) << "}\n";
}

void writeMotion(std::ostream& out, const Motion& motion) {
  out << "  - name: " << motion.name << "\n"
      << "    kind: " << motionKindNames()[static_cast<size_t>(motion.kind)] << "\n";
  if (motion.kind == MotionKind::kWalk) {
    out << "    turning: " << (motion.turning ? "turn" : "straight") << "\n";
  }
  out << "    valid: " << validText(motion.valid) << "\n    joints: " << chainsText(motion.chains)
      << "\n    source:\n"
      << "      clip: " << quoted(motion.source.clip) << "\n"
      << "      frames: [" << motion.source.frames[0] << ", " << motion.source.frames[1] << "]\n"
      << "      mirrored: " << (motion.source.mirrored ? "true" : "false") << "\n"
      << "      licence: " << quoted(motion.source.licence) << "\n"
      << "      credit: " << quoted(motion.source.credit) << "\n";
  switch (motion.kind) {
    case MotionKind::kWalk:
    case MotionKind::kMovement:
      return writeCycle(out, motion.cycle);
    case MotionKind::kPosture:
    case MotionKind::kBlocking:
      return writePosture(out, motion.posture);
    case MotionKind::kStart:
    case MotionKind::kStop:
      return writeTransition(out, motion.transition);
  }
}

void writeLibrary(std::ostream& out, const MotionLibrary& library) {
  out << "# Made by `amble library build` from the captures that are named below; not edited by "
         "hand.\n"
      << "# Metres, seconds, degrees; rotation vectors (from channel 3 on) in radians.\n"
      << "skeleton: " << library.skeleton_file << "\n"
      << "stature: " << number(library.stature) << "\n"
      << "joints:\n";
  for (const std::string& role : roleNames()) {
    const int joint = roleJoint(library.roles, role);
    if (joint >= 0) out << "  " << role << ": " << library.skeleton.joint(joint).name << "\n";
  }
  out << "motions:\n";
  for (const Motion& motion : library.motions) writeMotion(out, motion);
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

}  // namespace

void writeMotionLibrary(const MotionLibrary& library, const std::filesystem::path& file) {
  writeFiles({{file.parent_path() / library.skeleton_file,
               [&](std::ostream& out) { writeBvh(out, restClip(library.skeleton)); }},
              {file, [&](std::ostream& out) { writeLibrary(out, library); }}});
}

}  // namespace amble
