#include "animation/library/motion_library_reader.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "animation/body/rest_feet.h"
#include "animation/captures/bvh.h"
#include "animation/library/harmonics.h"
#include "animation/library/library_parts_reader.h"
#include "animation/library/library_style.h"
#include "animation/library/statures.h"
#include "base/data_directory.h"
#include "base/error.h"
#include "base/rotation.h"
#include "base/strict_yaml.h"
#include "base/text.h"

namespace amble {
namespace {

SwingTerms coefficients(const YamlNode& node) {
  SwingTerms terms;
  const Eigen::VectorXd v = node.asVec(static_cast<int>(terms.size()), "coefficients");
  std::copy(v.begin(), v.end(), terms.begin());
  return terms;
}

FootCycle readFoot(const YamlNode& node) {
  node.requireKeys({"strike", "lift_off", "slip", "progress", "height", "sideways", "roll", "yaw",
                    "pitch", "toes"});
  FootCycle foot;
  foot.strike = node.at("strike").asDouble(0.0, 1.0, "phase [cycles]");
  foot.lift_off = node.at("lift_off").asDouble(0.0, 1.0, "phase [cycles]");
  foot.slip = node.at("slip").asDouble(0.0, 1.0, "slip [m]");
  foot.progress = coefficients(node.at("progress"));
  foot.height = coefficients(node.at("height"));
  foot.sideways = coefficients(node.at("sideways"));
  foot.roll = coefficients(node.at("roll"));
  foot.yaw = coefficients(node.at("yaw"));
  const Eigen::VectorXd pitch =
      node.at("pitch").asVec(FootCycle::kStanceSamples + FootCycle::kSwingSamples,
                             "pitch of the sole [degrees]", -180, 180);
  for (const double p : pitch) foot.pitch.push_back(p * kDegree);
  if (const YamlNode rolled = node["toes"]) {  // libraries that were built before have none
    // Or fewer, from later in the stance on: the last of them are the same.
    constexpr int kFewer = 16;
    const int count = rolled.size() == kFewer ? kFewer : FootCycle::kToeSplines;
    const Eigen::VectorXd toes = rolled.asVec(count, "roll of the toes [degrees]", 0, 90);
    std::copy(toes.begin(), toes.end(), foot.toes.end() - count);
    for (double& t : foot.toes) t *= kDegree;
  }
  return foot;
}

WalkCycle readCycle(const YamlNode& node, int joints) {
  node.requireKeys({"speed", "turn_rate", "period", "cycles", "closure", "capture", "residual",
                    "slide", "step_width", "prints_left", "foot_forward", "toe_out", "foot_drops",
                    "left", "right", "harmonics", "alpha", "beta"});
  WalkCycle cycle;
  cycle.speed = node.at("speed").asPositive("speed [m/s]", 5.0);
  cycle.turn_rate = node.at("turn_rate").asDouble(-360, 360, "turn rate [degrees/s]") * kDegree;
  cycle.period = node.at("period").asDouble(0.2, 5.0, "period [s]");
  cycle.cycles = node.at("cycles").asInt(1, 1000, "cycles");
  cycle.capture = readCapture(node.at("capture"));
  cycle.closure = node.at("closure").asDouble(0.0, 10.0, "closure [m]");
  cycle.residual = node.at("residual").asDouble(0.0, 360.0, "residual [degrees]") * kDegree;
  cycle.slide = node.at("slide").asDouble(0.0, 10.0, "slide [m]");
  cycle.step_width = node.at("step_width").asDouble(-0.5, 1.0, "step width [m]");
  if (const YamlNode left = node["prints_left"])
    cycle.prints_left = left.asDouble(-1.0, 1.0, "distance [m]");
  const Eigen::VectorXd forward = node.at("foot_forward").asVec(2, "distances [m]", -1.0, 1.0);
  cycle.foot_forward = {forward[kLeft], forward[kRight]};
  cycle.toe_out = degreePair(node.at("toe_out"));
  if (const YamlNode drops = node["foot_drops"]) {
    cycle.foot_drops = degreePair(drops);
    for (const double drop : *cycle.foot_drops)
      if (std::abs(drop) > kHangingFoot)
        drops.fail("feet that stand on no sole", "-63 to 63 degrees");
  }
  cycle.feet = {readFoot(node.at("left")), readFoot(node.at("right"))};
  const int harmonics = node.at("harmonics").asInt(1, kMaxHarmonics, "harmonics");
  const int channels = 3 + 3 * joints;
  const std::string what = "three of the root and three a joint";
  cycle.series.alpha = readMatrix(node.at("alpha"), channels, harmonics + 1, what);
  cycle.series.beta = Eigen::MatrixXd::Zero(channels, harmonics + 1);
  cycle.series.beta.rightCols(harmonics) = readMatrix(node.at("beta"), channels, harmonics, what);
  return cycle;
}

// A sequence begins as the posture `stand`, which must have been read.
void requireStand(const YamlNode& node, const Motion* stand) {
  if (stand == nullptr) node.fail("a sequence from a posture that is not there", "`stand` before");
}

// Channels that a library keeps: all columns but those that are the posture `stand`.
Eigen::MatrixXd readSpline(const YamlNode& node, int joints, double standing_height) {
  constexpr int kStanding = TransitionSequence::kStanding;
  const int rows = 3 + 3 * joints;
  const int columns = node.items().empty() ? 0 : static_cast<int>(node.items()[0].items().size());
  Eigen::MatrixXd spline = Eigen::MatrixXd::Zero(rows, kStanding + std::max(columns, 1));
  spline.row(2).head(kStanding).setConstant(standing_height);
  spline.rightCols(std::max(columns, 1)) =
      readMatrix(node, rows, std::max(columns, 1), "three of the root and three a joint");
  return spline;
}

TransitionSequence readSequence(const YamlNode& node, int joints, const Motion* stand) {
  node.requireKeys({"side", "sway", "step_time", "advance", "swing", "spline"});
  requireStand(node, stand);
  TransitionSequence sequence;
  sequence.side = node.at("side").asEnum<Side>({{"left", kLeft}, {"right", kRight}});
  sequence.sway = node.at("sway").asDouble(0.0, 5.0, "sway [steps]");
  sequence.step_time = node.at("step_time").asDouble(0.2, 2.0, "time of a step [s]");
  sequence.advance = node.at("advance").asDouble(0.05, 1.0, "advance [m]");
  sequence.swing = readFoot(node.at("swing"));
  sequence.spline = readSpline(node.at("spline"), joints, stand->posture.root_height);
  return sequence;
}

Transition readTransition(const YamlNode& node, int joints, const Motion* stand) {
  node.requireKeys({"speed", "first_speed", "acceleration", "sequence"});
  Transition transition;
  transition.speed = node.at("speed").asPositive("speed [m/s]", 10.0);
  transition.first_speed = node.at("first_speed").asPositive("speed [m/s]", 10.0);
  transition.acceleration = node.at("acceleration").asPositive("acceleration [m/s^2]", 100.0);
  if (const YamlNode sequence = node["sequence"])
    transition.sequence = readSequence(sequence, joints, stand);
  return transition;
}

// The same of a turn, which ends as `stand` too; `turned` says how many columns there are.
TurnSequence readTurn(const YamlNode& node, int joints, const Motion* stand) {
  constexpr int kStanding = TurnSequence::kStanding;
  node.requireKeys({"angle", "duration", "first", "steps", "twist", "turned", "spline"});
  requireStand(node, stand);
  TurnSequence turn;
  turn.angle = node.at("angle").asDouble(-720.0, 720.0, "angle [degrees]") * kDegree;
  if (std::abs(turn.angle) < TurnSequence::kLeastAngle)
    node.at("angle").fail("hardly a turn", "10 to 720 degrees to the left, or negative");
  turn.duration =
      node.at("duration").asDouble(TurnSequence::kShortest, TurnSequence::kLongest, "duration [s]");
  turn.first = node.at("first").asEnum<Side>({{"left", kLeft}, {"right", kRight}});
  turn.steps = node.at("steps").asInt(1, TurnSequence::kMostSteps, "steps");
  turn.twist = node.at("twist").asDouble(0.0, 180.0, "yaw [degrees]") * kDegree;
  const int inner = std::max(1, static_cast<int>(node.at("turned").items().size()));
  const int rows = 3 + 3 * joints, columns = inner + 2 * kStanding;
  turn.turned = Eigen::MatrixXd::Zero(1, columns);
  turn.turned.rightCols(kStanding).setOnes();
  turn.turned.middleCols(kStanding, inner) =
      node.at("turned").asVec(inner, "shares of the angle", -2.0, 3.0).transpose();
  turn.spline = Eigen::MatrixXd::Zero(rows, columns);
  turn.spline.row(2).setConstant(stand->posture.root_height);
  turn.spline.middleCols(kStanding, inner) =
      readMatrix(node.at("spline"), rows, inner, "three of the root and three a joint");
  return turn;
}

void readTurning(const YamlNode& node, Motion& motion) {
  motion.turning = node.at("turning").asEnum<bool>({{"straight", false}, {"turn", true}});
  const double rate = std::abs(motion.cycle.turn_rate);
  if (motion.turning == (rate > kStraightTurnRate)) return;
  node.at("turning").fail("a walk of " + std::to_string(rate / kDegree) + " degrees/s is called " +
                              (motion.turning ? "a turn" : "straight"),
                          motion.turning ? "more than 8.6 degrees/s" : "less than 8.6 degrees/s");
}

Motion readLibraryMotion(const YamlNode& node, int joints, const Motion* stand) {
  node.requireKeys({"name", "kind", "turning", "style", "valid", "joints", "cycle", "posture",
                    "transition", "turn", "source"});
  Motion motion;
  motion.name = node.at("name").asString();
  motion.kind = static_cast<MotionKind>(node.at("kind").indexIn(motionKindNames()));
  if (const YamlNode style = node["style"]) motion.style = readStyle(style, motion.kind);
  if (const YamlNode valid = node["valid"]) motion.valid = readValidity(valid, motion.kind);
  if (const YamlNode which = node["joints"]) motion.chains = readChains(which);
  motion.source = readSource(node.at("source"), motion.kind);
  switch (motion.kind) {
    case MotionKind::kWalk:
    case MotionKind::kMovement:
      motion.cycle = readCycle(node.at("cycle"), joints);
      if (motion.kind == MotionKind::kWalk) readTurning(node, motion);
      break;
    case MotionKind::kPosture:
    case MotionKind::kBlocking:
      motion.posture = readPosture(node.at("posture"), joints);
      break;
    case MotionKind::kStart:
    case MotionKind::kStop:
      motion.transition = readTransition(node.at("transition"), joints, stand);
      break;
    case MotionKind::kTurnOnSpot:
      motion.turn = readTurn(node.at("turn"), joints, stand);
      break;
  }
  return motion;
}

}  // namespace

Validity readValidity(const YamlNode& node, MotionKind kind) {
  using When = Validity::When;
  if (kind == MotionKind::kWalk && (node.isMap() || node.asString() != "always")) {
    node.fail("a walk that is not always valid",
              "always: every walk of a library is blended with the others");
  }
  if (!node.isMap()) {
    constexpr std::array<When, 3> kWhen = {When::kAlways, When::kAtStart, When::kAtEnd};
    return {kWhen[node.indexIn({"always", "at_start", "at_end"})]};
  }
  node.requireKeys({"from", "to", "clearance_above"});
  Validity valid;
  if (node.has("clearance_above")) {
    valid.when = When::kClearanceAbove;
    valid.clearance = node.at("clearance_above").asDouble(0.0, 100.0, "clearance [m]");
    return valid;
  }
  valid.when = When::kBetween;
  valid.from = node.at("from").asDouble(0.0, 1e6, "time [s]");
  valid.to = node.at("to").asDouble(valid.from, 1e6, "time [s] after `from`");
  return valid;
}

std::string readStyle(const YamlNode& node, MotionKind kind) {
  const std::string style = node.asString();
  if (style.empty()) node.fail("an empty style", "a name, or no style");
  if (!hasStyle(kind)) {
    node.fail("a style of what nobody walks by",
              "one of a walk, a start, a stop or a turn on the spot");
  }
  return style;
}

std::vector<std::string> readChains(const YamlNode& node) {
  std::vector<std::string> chains;
  if (node.isScalar()) {
    node.indexIn({"all"});
    return chains;
  }
  for (const YamlNode& item : node.items()) {
    const std::string& name = item.asString();
    if (name == "left_leg" || name == "right_leg") {
      item.fail("moves a leg; the steps say where feet go", "arms, trunk or head");
    }
    item.indexIn(chainNames());
    chains.push_back(name);
  }
  return chains;
}

MotionLibrary readMotionLibrary(const std::filesystem::path& file) {
  const YamlNode root = readYaml(file);
  root.requireKeys({"skeleton", "stature", "joints", "motions"});
  MotionLibrary library;
  library.file = file;
  library.skeleton_file = root.at("skeleton").asString();
  library.skeleton = readBvh(root.at("skeleton").asPath()).skeleton;
  library.roles = readRoles(root.at("joints"), library.skeleton);
  library.stature = root.at("stature").asDouble(kShortestStature, kTallestStature, "stature [m]");
  for (const YamlNode& node : root.at("motions").items()) {
    library.motions.push_back(
        readLibraryMotion(node, library.skeleton.size(), library.find("stand")));
    const std::string& name = library.motions.back().name;
    if (library.find(name) != &library.motions.back()) {
      node.fail("motion " + name + " is there twice", "names that differ");
    }
  }
  return library;
}

std::filesystem::path motionLibraryFile(const std::string& name,
                                        const std::filesystem::path& relative_to) {
  if (name == "default") return dataDirectory() / "animation/motions/default.yaml";
  return relative_to / std::filesystem::path(name);
}

MotionLibrary openMotionLibrary(const std::string& name, const std::filesystem::path& relative_to,
                                const std::string& style) {
  return openMotionLibrary(readMotionLibrary(motionLibraryFile(name, relative_to)), style);
}

MotionLibrary openMotionLibrary(const MotionLibrary& all, const std::string& style) {
  const std::vector<std::string> styles = stylesOf(all);
  if (!style.empty() && std::find(styles.begin(), styles.end(), style) == styles.end()) {
    throw InputError(all.file.string(), 0, "nobody in it walks in the style '" + style + "'",
                     styles.empty() ? "no style: its walks have none" : "one of " + joined(styles));
  }
  MotionLibrary library = inStyle(all, style);
  const MotionLack lack = whatItLacks(library);
  if (lack.problem.empty()) return library;
  const bool styled = style.empty() && !styles.empty() && whatItLacks(all).problem.empty();
  throw InputError(library.file.string(), 0, lack.problem,
                   styled ? "a style to walk in, one of " + joined(styles) : lack.expected);
}

}  // namespace amble
