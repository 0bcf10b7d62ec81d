#include "animation/library/motion_library_writer.h"

#include "animation/library/library_parts_writer.h"
#include "base/error.h"
#include "base/rotation.h"
#include "base/strict_yaml.h"

namespace amble {
namespace {

void putFoot(YamlWriter& out, const char* side, const FootCycle& foot) {
  out.key(side).beginMap();
  put(out, "strike", foot.strike);
  put(out, "lift_off", foot.lift_off);
  put(out, "slip", foot.slip);
  putList(out, "progress", foot.progress);
  putList(out, "height", foot.height);
  putList(out, "sideways", foot.sideways);
  putList(out, "roll", foot.roll);
  putList(out, "yaw", foot.yaw);
  putList(out, "pitch", foot.pitch, kDegree);
  if (foot.toes != FootCycle().toes) putList(out, "toes", foot.toes, kDegree);
  out.end();
}

void putCycle(YamlWriter& out, const WalkCycle& cycle) {
  const FourierSeries& series = cycle.series;
  out.key("cycle").beginMap();
  put(out, "speed", cycle.speed);
  put(out, "turn_rate", cycle.turn_rate / kDegree);
  put(out, "period", cycle.period);
  out.key("cycles").whole(cycle.cycles);
  put(out, "closure", cycle.closure);
  put(out, "residual", cycle.residual / kDegree);
  put(out, "slide", cycle.slide);
  put(out, "step_width", cycle.step_width);
  if (cycle.prints_left != 0.0) put(out, "prints_left", cycle.prints_left);
  putList(out, "foot_forward", cycle.foot_forward);
  putList(out, "toe_out", cycle.toe_out, kDegree);
  if (cycle.foot_drops) putList(out, "foot_drops", *cycle.foot_drops, kDegree);
  putCapture(out, cycle.capture);
  putFoot(out, "left", cycle.feet[kLeft]);
  putFoot(out, "right", cycle.feet[kRight]);
  out.key("harmonics").whole(series.harmonics());
  putMatrix(out, "alpha", series.alpha);
  putMatrix(out, "beta", series.beta.rightCols(series.harmonics()));
  out.end();
}

void putSequence(YamlWriter& out, const TransitionSequence& sequence) {
  constexpr int kStanding = TransitionSequence::kStanding;
  out.key("sequence").beginMap();
  out.key("side").text(sequence.side == kLeft ? "left" : "right");
  put(out, "sway", sequence.sway);
  put(out, "step_time", sequence.step_time);
  put(out, "advance", sequence.advance);
  putFoot(out, "swing", sequence.swing);
  putMatrix(out, "spline", sequence.spline.rightCols(sequence.spline.cols() - kStanding));
  out.end();
}

void putTransition(YamlWriter& out, const Transition& transition) {
  out.key("transition").beginMap();
  put(out, "speed", transition.speed);
  put(out, "first_speed", transition.first_speed);
  put(out, "acceleration", transition.acceleration);
  if (!transition.sequence.empty()) putSequence(out, transition.sequence);
  out.end();
}

void putTurn(YamlWriter& out, const TurnSequence& turn) {
  constexpr int kStanding = TurnSequence::kStanding;
  const Eigen::Index inner = turn.spline.cols() - 2 * kStanding;
  out.key("turn").beginMap();
  put(out, "angle", turn.angle / kDegree);
  put(out, "duration", turn.duration);
  out.key("first").text(turn.first == kLeft ? "left" : "right");
  out.key("steps").whole(turn.steps);
  put(out, "twist", turn.twist / kDegree);
  const Eigen::VectorXd turned = turn.turned.row(0).segment(kStanding, inner);
  putList(out, "turned", {turned.data(), static_cast<size_t>(inner)});
  putMatrix(out, "spline", turn.spline.middleCols(kStanding, inner));
  out.end();
}

void putValidity(YamlWriter& out, const Validity& valid) {
  using When = Validity::When;
  out.key("valid");
  if (valid.when == When::kAlways) out.text("always");
  if (valid.when == When::kAtStart) out.text("at_start");
  if (valid.when == When::kAtEnd) out.text("at_end");
  if (valid.when == When::kBetween || valid.when == When::kClearanceAbove) {
    out.beginMap(YamlWriter::kFlow);
    if (valid.when == When::kBetween) {
      put(out, "from", valid.from);
      put(out, "to", valid.to);
    } else {
      put(out, "clearance_above", valid.clearance);
    }
    out.end();
  }
}

void putChains(YamlWriter& out, const std::vector<std::string>& chains) {
  out.key("joints");
  if (chains.empty()) {
    out.text("all");
  } else {
    out.beginList(YamlWriter::kFlow);
    for (const std::string& chain : chains) out.text(chain);
    out.end();
  }
}

void putMotion(YamlWriter& out, const Motion& motion) {
  out.beginMap().key("name").text(motion.name);
  out.key("kind").text(motionKindNames()[static_cast<size_t>(motion.kind)]);
  if (motion.kind == MotionKind::kWalk) {
    out.key("turning").text(motion.turning ? "turn" : "straight");
  }
  if (!motion.style.empty()) out.key("style").quoted(motion.style);
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
    case MotionKind::kTurnOnSpot:
      putTurn(out, motion.turn);
      break;
  }
  out.end();
}

void writeLibrary(std::ostream& stream, const MotionLibrary& library) {
  stream << "# Made by `amble library build` from the captures that are named below; not edited by "
            "hand.\n"
         << "# Metres, seconds, degrees; rotation vectors (from channel 3 on) in radians.\n";
  YamlWriter out(stream);
  out.beginMap().key("skeleton").text(library.skeleton_file);
  put(out, "stature", library.stature);
  putRoles(out, library.skeleton, library.roles);
  out.key("motions").beginList();
  for (const Motion& motion : library.motions) putMotion(out, motion);
  out.end().end();
  stream << '\n';
}

// @throws InputError where the file is there and no library
void requireNothingLost(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return;
  const YamlNode root = readYaml(file);
  if (root.isMap() && root.has("skeleton") && root.has("stature") && root.has("motions")) return;
  throw InputError(file.string(), 0, "is no motion library; one is not written over it",
                   "a new file, or a library");
}

}  // namespace

void writeMotionLibrary(const MotionLibrary& library, const std::filesystem::path& file) {
  requireNothingLost(file);
  writeWithSkeleton(library.skeleton, library.skeleton_file, file,
                    [&](std::ostream& out) { writeLibrary(out, library); });
}

}  // namespace amble
