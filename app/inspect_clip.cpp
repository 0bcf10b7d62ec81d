// What `amble inspect` says of clips and motion libraries.

#include <fmt/format.h>

#include <algorithm>

#include "animation/library/library_style.h"
#include "animation/library/motion_library_reader.h"
#include "app/findings.h"
#include "app/read_options.h"
#include "base/rotation.h"
#include "base/text.h"

namespace amble {
namespace {

std::string orderText(const RotationOrder& order) { return {order.begin(), order.end()}; }

Eigen::AlignedBox3d extentAt(const Clip& clip, int frame) {
  std::vector<JointFrame> frames(clip.skeleton.size());
  forwardKinematics(clip, frame, frames);
  Eigen::AlignedBox3d box;
  for (const JointFrame& joint : frames) box.extend(joint.p_WJ);
  return box;
}

/// The joints of some roles in a row, `-` where there is none.
std::string rowOf(const CapturedMotion& motion, const std::string& side,
                  std::initializer_list<const char*> roles) {
  std::string row;
  for (const char* const role : roles) {
    const int joint = roleJoint(motion.roles, side + role);
    row += (row.empty() ? "" : " > ") +
           (joint < 0 ? std::string("-") : motion.clip.skeleton.joint(joint).name);
  }
  return row;
}

/// The order of turns of each joint, every one once.
std::string ordersOf(const Skeleton& skeleton) {
  std::string orders;
  for (const Joint& joint : skeleton.joints()) {
    const std::string order = orderText(joint.order);
    if (orders.find(order) == std::string::npos) orders += (orders.empty() ? "" : ", ") + order;
  }
  return orders;
}

void describeClip(const Clip& clip, Findings& out) {
  const Skeleton& skeleton = clip.skeleton;
  out.facts = {{"frames", fmt::format("{} of {:.7g} s ({:.4g} a second), {:.3f} s", clip.frames(),
                                      clip.frame_time, 1.0 / clip.frame_time, clip.duration())},
               {"joints", fmt::format("{}, root {}", skeleton.size(), skeleton.joint(0).name)},
               {"rotations", ordersOf(skeleton)}};
  out.data = {{"frames", clip.frames()},
              {"frame_time", clip.frame_time},
              {"duration", clip.duration()},
              {"joints", skeleton.size()}};
}

void describeJoints(const Clip& clip, Findings& out) {
  const std::vector<Joint>& joints = clip.skeleton.joints();
  const auto zero = std::count_if(joints.begin(), joints.end(), [](const Joint& joint) {
    return joint.parent >= 0 && joint.offset.isZero(0.0);
  });
  if (zero > 0)
    out.facts.emplace_back("zero-length", fmt::format("{} joints at their parent", zero));
  if (!clip.joint_positions.empty()) {
    out.warnings.push_back("joints other than the root move; a written BVH has them fixed");
  }
}

void describeRoles(const CapturedMotion& motion, Findings& out) {
  if (!motion.no_person.empty()) return;
  out.facts.emplace_back("trunk", rowOf(motion, "", {"hips", "spine", "chest", "neck", "head"}));
  for (const std::string side : {"left", "right"}) {
    out.facts.emplace_back(side + " leg",
                           rowOf(motion, side + "_", {"up_leg", "leg", "foot", "toe"}));
    out.facts.emplace_back(side + " arm",
                           rowOf(motion, side + "_", {"shoulder", "arm", "fore_arm", "hand"}));
  }
}

void describeMotion(const Clip& clip, Findings& out) {
  if (clip.frames() == 0) {
    out.warnings.push_back("there are no frames");
    return;
  }
  const Eigen::AlignedBox3d first = extentAt(clip, 0);
  double travelled = 0.0;
  for (int i = 1; i < clip.frames(); ++i) {
    travelled += (clip.poses.p_WR(i) - clip.poses.p_WR(i - 1)).norm();
  }
  out.facts.emplace_back("height", fmt::format("{:.4g} m from lowest to highest joint, first frame",
                                               first.sizes().z()));
  out.facts.emplace_back(
      "root", fmt::format("travels {:.4g} m, begins at ({:.4g}, {:.4g}, {:.4g})", travelled,
                          clip.poses.p_WR(0).x(), clip.poses.p_WR(0).y(), clip.poses.p_WR(0).z()));
  out.data["root_travel"] = travelled;
  out.data["joint_height"] = first.sizes().z();
}

}  // namespace

std::optional<Findings> inspectClip(const std::filesystem::path& file,
                                    const MotionReadOptions& options) {
  MotionReadOptions any = options;
  any.person = false;
  const std::optional<CapturedMotion> motion = readMotionIfAny(file, any);
  if (!motion) return {};
  Findings out{file.string(), "clip", {}, {}, {}};
  describeClip(motion->clip, out);
  addReadings(*motion, out);
  describeRoles(*motion, out);
  out.data["guessed_unit"] = motion->metres_per_unit.value;
  describeMotion(motion->clip, out);
  describeJoints(motion->clip, out);
  return out;
}

namespace {

// What there is of a start or a stop: a sequence, or numbers that formulas are fed with.
std::string describeTransition(const Motion& motion, nlohmann::ordered_json& entry) {
  const Transition& transition = motion.transition;
  const TransitionSequence& sequence = transition.sequence;
  const char* kind = motion.kind == MotionKind::kStart ? "start" : "stop";
  entry["speed"] = transition.speed;
  entry["captured"] = !sequence.empty();
  if (sequence.empty())
    return fmt::format("{}, {:.2f} m/s, its speeds only: bodies by formula; ", kind,
                       transition.speed);
  const char* side = sequence.side == kLeft ? "left" : "right";
  const char* order = motion.kind == MotionKind::kStart ? "first" : "last";
  entry["foot"] = side;
  entry["sway"] = sequence.sway * sequence.step_time;
  return fmt::format("{}, {:.2f} m/s, {} foot {}, weight shifts for {:.2f} s; ", kind,
                     transition.speed, side, order, sequence.sway * sequence.step_time);
}

std::string describeTurn(const Motion& motion, nlohmann::ordered_json& entry) {
  const TurnSequence& turn = motion.turn;
  const char* side = turn.first == kLeft ? "left" : "right";
  entry["angle"] = turn.angle / kDegree;
  entry["duration"] = turn.duration;
  entry["foot"] = side;
  entry["steps"] = turn.steps;
  entry["twist"] = turn.twist / kDegree;
  return fmt::format(
      "turn on the spot, {:+.0f} degrees in {:.2f} s and {} steps, {} foot first, feet turned by "
      "up "
      "to {:.0f} degrees against the pelvis; ",
      turn.angle / kDegree, turn.duration, turn.steps, side, turn.twist / kDegree);
}

// What goes as captured: starts and stops, whichever foot steps beside standing, and turns on the
// spot.
void addFormulas(const MotionLibrary& library, Findings& out) {
  std::vector<std::string> formulas;
  for (const MotionKind kind : {MotionKind::kStart, MotionKind::kStop}) {
    for (const Side side : {kLeft, kRight}) {
      const bool captured =
          std::any_of(library.motions.begin(), library.motions.end(), [&](const Motion& motion) {
            const TransitionSequence& sequence = motion.transition.sequence;
            return motion.kind == kind && !sequence.empty() && sequence.side == side;
          });
      if (captured) continue;
      formulas.push_back(std::string(kind == MotionKind::kStart ? "starts" : "stops") +
                         " with the " + (side == kLeft ? "left" : "right") + " foot");
    }
  }
  for (const Side side : {kLeft, kRight}) {
    const bool captured =
        std::any_of(library.motions.begin(), library.motions.end(), [&](const Motion& motion) {
          return motion.kind == MotionKind::kTurnOnSpot &&
                 (motion.turn.angle > 0.0) == (side == kLeft);
        });
    if (!captured)
      formulas.push_back(std::string("turns on the spot to the ") +
                         (side == kLeft ? "left" : "right"));
  }
  out.data["by_formula"] = formulas;
  if (!formulas.empty()) out.facts.emplace_back("by formula", joined(formulas));
}

}  // namespace

Findings inspectLibrary(const std::filesystem::path& file) {
  const MotionLibrary library = readMotionLibrary(file);
  Findings out{file.string(), "motion library", {}, {}, {}};
  out.facts = {{"skeleton", fmt::format("{} joints, stature {:.2f} m", library.skeleton.size(),
                                        library.stature)}};
  out.data = {{"joints", library.skeleton.size()},
              {"stature", library.stature},
              {"motions", nlohmann::ordered_json::array()}};
  for (const Motion& motion : library.motions) {
    const MotionSource& source = motion.source;
    const std::string from = fmt::format("{}{} ({})", partText(source),
                                         source.mirrored ? ", mirrored" : "", source.licence);
    nlohmann::ordered_json entry = {{"name", motion.name}};
    std::string text = motionKindNames()[static_cast<size_t>(motion.kind)] + "; ";
    entry["kind"] = motionKindNames()[static_cast<size_t>(motion.kind)];
    if (motion.kind == MotionKind::kWalk) {
      const WalkCycle& cycle = motion.cycle;
      text =
          fmt::format("walk, {:.3f} m/s, {:+.1f} degrees/s, period {:.3f} s, closure {:.1f} mm; ",
                      cycle.speed, cycle.turn_rate / kDegree, cycle.period, 1000.0 * cycle.closure);
      if (!motion.style.empty()) text = "style " + motion.style + ", " + text;
      entry["style"] = motion.style;
      entry["speed"] = cycle.speed;
      entry["turn_rate"] = cycle.turn_rate / kDegree;
      entry["period"] = cycle.period;
      entry["closure"] = cycle.closure;
    }
    if (isTransition(motion.kind)) text = describeTransition(motion, entry);
    if (motion.kind == MotionKind::kTurnOnSpot) text = describeTurn(motion, entry);
    entry["source"] = {{"clip", source.clip},
                       {"frames", {source.frames[0], source.frames[1]}},
                       {"mirrored", source.mirrored},
                       {"licence", source.licence},
                       {"credit", source.credit}};
    if (source.speed) entry["source"]["speed"] = *source.speed;
    out.facts.emplace_back(motion.name, text + from);
    out.data["motions"].push_back(std::move(entry));
  }
  addFormulas(library, out);
  const std::vector<std::string> styles = stylesOf(library);
  out.data["styles"] = styles;
  if (!styles.empty()) out.facts.emplace_back("styles", joined(styles));
  if (const MotionLack lack = whatItLacks(library); !lack.problem.empty()) {
    out.warnings.push_back(lack.problem + ": it cannot walk; expected " + lack.expected);
  }
  return out;
}

}  // namespace amble
