#include "animation/synthesis/walk_synthesizer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "animation/body/reference_pose.h"
#include "animation/steps/footsteps.h"
#include "animation/steps/speed_profile.h"
#include "animation/steps/step_placer.h"
#include "animation/synthesis/foot_controller.h"
#include "animation/synthesis/gait_blend.h"
#include "animation/synthesis/movement_controller.h"
#include "animation/synthesis/walk_controller.h"
#include "base/ease.h"
#include "base/rotation.h"

namespace amble {
namespace {

// Legs are not stretched farther than this share of their length by the straight walk, a knee bent
// by 8 degrees: captured walkers reach 0.999.
constexpr double kStraightReach = 0.9975;
constexpr double kStandingReach = 0.995;
constexpr double kLongestLean = 0.03;  // of the root before its feet, beyond the captured [m]
constexpr double kLeanCost = 0.2;      // metres of lowering that a metre of lean is worth; by trial
constexpr int kLeanSteps = 12;
constexpr int kLoweringSteps = 16;  // step lengths for which the root's lowering is prepared
// Real walkers' hips rise by 15 to 45 mm a step; of a captured subject [m].
constexpr double kLeastRise = 0.016, kMostRise = 0.042;

constexpr double kBlendTime = 0.12;  // half of the moment over which a blend changes; by trial [s]

// The standing posture is left within this share of the first step, before its foot lands, and
// taken on within as much of the last.
constexpr double kStandingShare = 0.85;

// Turning on the spot: one pair of steps an angle; a pair's time keeps the peak turn rate near the
// 84 degrees/s that people reach.
constexpr double kTurnPair = 45.0 * kDegree;  // [rad]
constexpr double kTurnStepTime = 0.45;  // [s], for a captured subject; grows with the root of scale
constexpr double kTurnSway = 0.02;      // of the root towards the standing foot [m]

void checkSettings(const CharacterSettings& s) {
  if (!(s.speed >= 0.3 && s.speed <= 2.0)) throw std::invalid_argument("speed: 0.3 to 2.0 m/s");
  if (s.height != 0.0 && !(s.height >= 0.5 && s.height <= 2.5)) {
    throw std::invalid_argument("height: 0.5 to 2.5 m");
  }
  if (!(s.frame_time >= 1.0 / 240.0 && s.frame_time <= 1.0 / 24.0)) {
    throw std::invalid_argument("frame time: 1/240 to 1/24 s");
  }
  if (!(s.max_slope >= 0.0 && s.max_slope <= 0.25 * kPi)) {
    throw std::invalid_argument("steepest slope: 0 to 45 degrees");
  }
  if (!(s.max_climb >= 0.0 && s.max_climb <= 1.0 && s.max_drop >= 0.0 && s.max_drop <= 1.0)) {
    throw std::invalid_argument("highest steps: 0 to 1 m");
  }
}

std::unique_ptr<const SubController> controllerOf(const MotionLibrary& library,
                                                  const std::string& action) {
  const Motion* motion = library.find(action);
  if (motion != nullptr && motion->kind == MotionKind::kMovement) {
    return std::make_unique<MovementController>(library, *motion);
  }
  if (motion != nullptr && motion->kind == MotionKind::kPosture) {
    return std::make_unique<PostureController>(library, *motion);
  }
  throw std::invalid_argument("the library has no movement or posture " + action);
}

}  // namespace

struct WalkSynthesizer::Impl {
  Impl(const MotionLibrary& library, const Ground& the_ground,
       const CharacterSettings& the_settings)
      : settings(the_settings),
        scale((the_settings.height > 0.0 ? the_settings.height : library.stature) /
              library.stature),
        stature(library.stature * scale),
        skeleton(library.skeleton.scaled(scale)),
        roles(library.roles),
        shapes{makeFootShape(skeleton, roles, kLeft, stature),
               makeFootShape(skeleton, roles, kRight, stature)},
        reference(library.stand().rotations),
        blend(library, scale, the_settings.speed),
        feet(skeleton, roles, shapes, blend,
             kneeAxes(roles, referenceOf(skeleton, roles, library.stand().rotations))) {
    const Posture& stand = library.stand();
    placement.walk_width = blend.stepWidth();
    placement.stand_width = stand.step_width * scale;
    placement.forward = -stand.root_forward * scale;
    placement.step_length = blend.law().stepLength(settings.speed);
    placement.walk_toe_out = blend.toeOut();
    placement.stand_toe_out = 0.5 * (stand.toe_out[kLeft] - stand.toe_out[kRight]);
    placement.half_support = 0.5 * doubleSupport(settings.speed, roles.legLength(skeleton, kLeft));
    stand_channels = Eigen::VectorXd::Zero(3 + 3 * skeleton.size());
    stand_channels[2] = stand.root_height * scale;
    // Over a step of the captured length on the level.
    FootState swing;
    swing.to.position.x() = 2.0 * blend.law().capturedStep();
    for (const Side side : {kLeft, kRight}) {
      captured_lift[side] = swingLift(swing, blend.foot(side), shapes[side]);
    }
    limits.law = blend.law();
    limits.speed = settings.speed;
    limits.max_turn_rate = blend.maxTurnRate();
    limits.frame_time = settings.frame_time;
    // Standing, the root is over the stance's position to the bit; walking, it leads as captured,
    // and leans.
    lead = placement.forward - blend.footForward();
    lead += leanForStep();
    prepareLowering();
    bendStandingKnees();
    StepPlacer::Settings steps;
    steps.placement = placement;
    steps.limits = limits;
    steps.footholds = {settings.max_slope, settings.max_climb, settings.max_drop};
    steps.scale = scale;
    steps.leg_length = roles.legLength(skeleton, kLeft);
    steps.captured_lift = captured_lift;
    placer = std::make_unique<StepPlacer>(the_ground, shapes, blend.law(), blend.feet(), steps);
  }

  // How much lower the root must walk at each step length for the legs to reach: long steps lower
  // the hips.
  void prepareLowering() {
    WalkController::Carriage carriage;
    carriage.lead = lead;
    carriage.longest = StrideLaw::kLongestStep * blend.law().capturedStep();
    for (int i = 0; i <= kLoweringSteps; ++i) {
      carriage.lowering.push_back(loweringAt(carriage.longest * i / kLoweringSteps, lead));
    }
    walk = std::make_unique<WalkController>(blend, reference, stand_channels, carriage);
  }

  // How much farther ahead of its feet the root walks than captured: a striking leg is nearly
  // straight and a long step would lower the hips onto bent knees, while the leg behind still has
  // room. The least lean that spares most of the lowering.
  double leanForStep() const {
    double best = 0.0, least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kLeanSteps; ++i) {
      const double lean = kLongestLean * scale * i / kLeanSteps;
      const double cost = loweringAt(placement.step_length, lead + lean) + kLeanCost * lean;
      if (cost < least) least = cost, best = lean;
    }
    return best;
  }

  // Captured people stand on straight legs, with no room to turn on the spot or to step off from.
  void bendStandingKnees() {
    AnimationBuffer buffer;
    buffer.poses = PoseArray(skeleton.size());
    buffer.states.push_back(levelStance({}, 0.0));
    buffer.poses.resize(1);
    walk->apply(buffer);
    std::vector<JointFrame> joints(skeleton.size());
    stand_channels[2] -= feet.missingHeight(buffer, 0, kStandingReach, joints);
    prepareLowering();
  }

  double loweringAt(double step_length, double with_lead) const {
    if (!(step_length > 0.0)) return 0.0;
    const WalkController plain(blend, reference, stand_channels, {with_lead, {}, 1.0});
    AnimationBuffer buffer = steadyWalk(step_length, 0.0);
    plain.apply(buffer);
    std::vector<JointFrame> joints(skeleton.size());
    double lowest = 0.0;
    for (int i = 0; i < buffer.size(); ++i) {
      lowest = std::max(lowest, feet.missingHeight(buffer, i, kStraightReach, joints) /
                                    WalkController::loweringShare(buffer.states[i].phase));
    }
    return lowest;
  }

  // States of a few steps straight on, each so much higher than the one before.
  AnimationBuffer steadyWalk(double step_length, double rise) const {
    FootPlacement p = placement;
    p.step_length = step_length;
    const Stance from{Eigen::Vector3d::Zero(), 0.0, false, kLeft};
    constexpr int kSteps = 4, kFramesPerStep = 24;
    Stance to = from;
    to.position.x() = kSteps * step_length;
    Footsteps steps(p, from, to, kSteps, kRight);
    steps.place([&](int i) {
      return GroundPoint{{(i + 0.5) * step_length + p.forward, 0.0, 0.0}, 0.0};
    });
    if (rise != 0.0) {
      for (FootPlace& place : steps.places()) {
        place.position.z() = rise / step_length * (place.position.x() - p.forward);
        place.normal = Eigen::Vector3d(-rise, 0.0, step_length).normalized();
      }
      for (auto& landing : steps.landings()) {
        landing.strike_roll = slopeStrike(steps.places().front());
      }
    }
    AnimationBuffer buffer;
    buffer.poses = PoseArray(skeleton.size());
    for (int k = 0; k <= kSteps * kFramesPerStep; ++k) {
      const double progress = static_cast<double>(k) / kFramesPerStep;
      if (rise != 0.0 && (k == 0 || k == kSteps * kFramesPerStep)) continue;
      FrameState state;
      state.position.x() = progress * step_length;
      state.position.z() = progress * rise;
      state.phase = std::fmod(0.5 * progress, 1.0);
      state.step_length = step_length;
      state.lean = slopeLean(rise / step_length);
      state.feet = steps.at(progress);
      buffer.states.push_back(state);
    }
    buffer.poses.resize(static_cast<int>(buffer.states.size()));
    return buffer;
  }

  // A stance on level ground at its own height.
  FrameState levelStance(const Stance& stance, double arc) const {
    FrameState state;
    state.position = stance.position;
    state.heading = stance.heading;
    state.arc = arc;
    state.standing = stance.standing ? 1.0 : 0.0;
    state.speed = stance.standing ? 0.0 : settings.speed;
    state.phase = stance.standing || stance.leading == kLeft ? 0.0 : 0.5;
    state.step_length = placement.step_length;
    state.feet = Footsteps::atStance(placement, stance);
    return state;
  }

  FrameState stanceState(const Stance& stance, const StanceFeet& stood, double arc) const {
    FrameState state = levelStance(stance, arc);
    state.position.z() = stood.height;
    state.feet = Footsteps::atStance(stood.placement, stance);
    if (!stance.standing) {
      state.step_length = stood.placement.step_length;
      state.lean = slopeLean(stood.rise / state.step_length);
    }
    for (const Side side : {kLeft, kRight}) {
      FootState& foot = state.feet[side];
      foot.from = foot.to = stood.feet[side];
      if (!stance.standing) foot.strike_roll = slopeStrike(foot.from);
    }
    if (!stood.level) state.crouch = crouchOf(stance, stood, state);
    return state;
  }

  // How much lower than on the level the root is for the legs to reach [m]: standing where it
  // stands, walking on as it does on a slope like this.
  double crouchOf(const Stance& stance, const StanceFeet& stood, const FrameState& state) const {
    AnimationBuffer buffer;
    buffer.poses = PoseArray(skeleton.size());
    if (!stance.standing && stood.rise != 0.0) {
      buffer = steadyWalk(stood.placement.step_length, stood.rise);
    }
    buffer.states.push_back(state);
    buffer.poses.resize(static_cast<int>(buffer.states.size()));
    walk->apply(buffer);
    std::vector<JointFrame> joints(skeleton.size());
    double crouch = 0.0;
    for (int i = 0; i < buffer.size(); ++i) {
      crouch = std::max(crouch, feet.missingHeight(buffer, i, FootController::kUnevenReach, joints,
                                                   FootController::kUnevenHeel));
    }
    return crouch;
  }

  // Long steps would throw the hips up and down, short ones hardly move them: what they do is
  // scaled to what hips do, over knees that stay bent.
  double askedStepCrouch(const FrameState& state) const {
    constexpr int kPhases = 24;
    double lowest = std::numeric_limits<double>::infinity(), highest = 0.0;
    for (int i = 0; i < kPhases; ++i) {
      const double height = walk->height(static_cast<double>(i) / kPhases, state.step_length);
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    }
    const double rise = highest - lowest, height = walk->height(state.phase, state.step_length);
    const double wanted = std::clamp(rise, kLeastRise * scale, kMostRise * scale);
    // Less rise: lower over the standing leg. More: lower between the legs.
    const double crouch = wanted < rise ? (1.0 - wanted / rise) * (height - lowest)
                                        : (wanted / rise - 1.0) * (highest - height);
    return crouch * (1.0 - state.standing);
  }

  WalkResult pose(AnimationBuffer& out, bool level, int steps, Side leading) const {
    out.frame_time = settings.frame_time;
    if (out.poses.joints() != skeleton.size()) out.poses = PoseArray(skeleton.size());
    out.poses.resize(static_cast<int>(out.states.size()));
    walk->apply(out);
    for (const auto& action : actions) action->apply(out);
    if (!(level ? feet.apply(out) : feet.applyUneven(out)))
      return {WalkRule::kReach, steps, leading};
    out.markFootprints();
    return {WalkRule::kNone, steps, leading};
  }

  CharacterSettings settings;
  double scale, stature;
  Skeleton skeleton;
  JointRoles roles;
  std::array<FootShape, 2> shapes;
  std::vector<Eigen::Quaterniond> reference;
  GaitBlend blend;
  FootController feet;
  FootPlacement placement;
  Eigen::VectorXd stand_channels;
  std::array<double, 2> captured_lift;  // by Side [m]
  double lead = 0.0;                    // of the walking root over the path's point [m]
  SpeedLimits limits;
  std::unique_ptr<WalkController> walk;
  std::vector<std::unique_ptr<const SubController>> actions;
  std::unique_ptr<StepPlacer> placer;
};

WalkSynthesizer::WalkSynthesizer(const MotionLibrary& library, const Ground& ground,
                                 const CharacterSettings& settings) {
  checkSettings(settings);
  impl_ = std::make_unique<Impl>(library, ground, settings);
  for (const std::string& action : settings.actions) {
    impl_->actions.push_back(controllerOf(library, action));
  }
}

WalkSynthesizer::~WalkSynthesizer() = default;

const CharacterSettings& WalkSynthesizer::settings() const { return impl_->settings; }
const Skeleton& WalkSynthesizer::skeleton() const { return impl_->skeleton; }
const JointRoles& WalkSynthesizer::roles() const { return impl_->roles; }
const std::array<FootShape, 2>& WalkSynthesizer::feet() const { return impl_->shapes; }
double WalkSynthesizer::capturedStep() const { return impl_->blend.law().capturedStep(); }
double WalkSynthesizer::capturedLift() const {
  return 0.5 * (impl_->captured_lift[kLeft] + impl_->captured_lift[kRight]);
}
double WalkSynthesizer::stature() const { return impl_->stature; }
double WalkSynthesizer::ankleHeight() const { return impl_->shapes[kLeft].ankle_height; }
double WalkSynthesizer::toeHeight() const { return impl_->shapes[kLeft].radius; }
double WalkSynthesizer::stepLength() const { return impl_->placement.step_length; }
double WalkSynthesizer::maxTurnRate() const { return impl_->blend.maxTurnRate(); }
double WalkSynthesizer::shortestWalk() const {
  // Two steps of half a step's length each.
  const StrideLaw& law = impl_->blend.law();
  const double wanted = law.stepLength(std::min(impl_->settings.speed, law.onset().first_speed));
  return std::max(StrideLaw::kShortestStep * law.capturedStep(),
                  SpeedProfile::kLeastStretch * wanted);
}

namespace {

// Where curves join and bend the other way the turn rate jumps; people lean into a turn over a
// moment. The mean over that moment, which shrinks towards the ends: there it is 0 and stays so.
void smoothBlending(std::vector<FrameState>& states, double frame_time) {
  const int n = static_cast<int>(states.size());
  const int widest = static_cast<int>(std::lround(kBlendTime / frame_time));
  std::vector<double> sums(n + 1, 0.0);
  for (int pass = 0; pass < 2; ++pass) {  // a mean of means has no corners
    for (int i = 0; i < n; ++i) sums[i + 1] = sums[i] + states[i].blended_turn_rate;
    for (int i = 0; i < n; ++i) {
      const int half = std::min({widest, i, n - 1 - i});
      states[i].blended_turn_rate = (sums[i + half + 1] - sums[i - half]) / (2 * half + 1);
    }
  }
}

// From stance to stance; what is missing in between is for the feet to find.
void spreadCrouch(std::vector<FrameState>& states) {
  const double first = states.front().crouch, last = states.back().crouch;
  const auto n = static_cast<double>(states.size() - 1);
  for (size_t i = 1; i + 1 < states.size(); ++i) {
    states[i].crouch += first + smoothstep(static_cast<double>(i) / n) * (last - first);
  }
}

// What each footprint but the two of the begin was asked to be.
void setGait(const std::vector<GaitParameters>& gait, AnimationBuffer& buffer) {
  size_t next = 0;
  for (Footprint& print : buffer.footprints) {
    if (print.first_frame > 0 && next < gait.size()) print.gait = gait[next++];
  }
}

}  // namespace

WalkResult WalkSynthesizer::walk(const Stance& from, const Stance& to, const RootPath& path,
                                 bool any_leading, AnimationBuffer& out,
                                 const GaitWishes& wishes) const {
  const Impl& m = *impl_;
  const WalkSteps walk = m.placer->plan(from, to, path, any_leading, wishes);
  if (walk.refused != WalkRule::kNone) return {walk.refused, walk.steps, walk.end.leading};
  const int n = walk.steps;
  out.states.clear();
  out.states.push_back(m.stanceState(from, walk.from_feet, 0.0));
  // Phase is that of the foot in front: 0 or 0.5 at every node.
  const double phase_offset =
      walk.first == kLeft ? 0.5 : 0.0;  // the first step lands `first` in front
  for (int k = 1; k < walk.frames(); ++k) {
    const SpeedProfile::Sample at = walk.at(k);
    const RootPath::Sample on = path.at(at.arc);
    FrameState state;
    state.position << on.position, walk.heightAt(at, path.length());
    state.arc = at.arc;
    state.heading = on.heading;
    state.speed = at.speed;
    state.turn_rate = on.curvature * at.speed;
    const double begin = at.steps, left = n - at.steps;
    state.blended_turn_rate = smoothstep(begin) * smoothstep(left) * state.turn_rate;
    state.phase = 0.5 * at.steps + phase_offset;
    state.phase -= std::floor(state.phase);
    state.step_length = at.step_length;
    state.lean = slopeLean(walk.slopeAt(at));
    if (from.standing) state.standing = 1.0 - smoothstep(begin / kStandingShare);
    if (to.standing)
      state.standing = std::max(state.standing, 1.0 - smoothstep(left / kStandingShare));
    state.feet = walk.feet->at(at.steps);
    if (wishes.stride) state.crouch = m.askedStepCrouch(state);
    out.states.push_back(state);
  }
  out.states.push_back(m.stanceState(walk.end, walk.end_feet, path.length()));
  if (!walk.level) spreadCrouch(out.states);
  smoothBlending(out.states, m.settings.frame_time);
  const WalkResult result = m.pose(out, walk.level && !walk.timing, n, walk.end.leading);
  if (result.refused == WalkRule::kNone) setGait(walk.gait, out);
  return result;
}

WalkResult WalkSynthesizer::turnOnSpot(const Stance& at, double angle, AnimationBuffer& out) const {
  const Impl& m = *impl_;
  const int pairs = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / kTurnPair - 1e-9)));
  const int n = 2 * pairs;
  const double step_time = kTurnStepTime * std::sqrt(m.scale);
  const int frames =
      std::max(2, static_cast<int>(std::lround(n * step_time / m.settings.frame_time)));
  const Side first = angle > 0.0 ? kLeft : kRight;
  Stance end = at;
  end.heading = at.heading + angle;
  const StanceFeet begin_feet = m.placer->stanceFeet(at), end_feet = m.placer->stanceFeet(end);
  for (const StanceFeet& feet : {begin_feet, end_feet}) {
    if (feet.refused != WalkRule::kNone) return {feet.refused, n, first};
  }
  // The foot on the inside opens, the other closes, pair by pair.
  const auto place = [&](int placing) {
    Stance turned = at;
    turned.heading = at.heading + angle * ((placing + 1) / 2) / pairs;
    return Footsteps::atStance(m.placement, turned)[placing % 2 != 0 ? first : other(first)].from;
  };
  Footsteps steps(m.placement, at, end, n, first);
  for (int i = 1; i <= n; ++i) steps.places()[i + 1] = place(i);
  steps.setStances(begin_feet.feet, end_feet.feet);
  const WalkRule rule = m.placer->standOnGround(steps);
  if (rule != WalkRule::kNone) return {rule, n, first};

  out.states.clear();
  out.states.push_back(m.stanceState(at, begin_feet, 0.0));
  for (int k = 1; k < frames; ++k) {
    const double share = static_cast<double>(k) / frames, progress = n * share;
    FrameState state = out.states.front();
    state.position.z() += smoothstep(share) * (end_feet.height - begin_feet.height);
    state.heading = at.heading + angle * minimumJerk(share);
    state.turn_rate = angle * 30.0 * std::pow(share * (1.0 - share), 2) / (n * step_time);
    state.feet = steps.at(progress);
    for (FootState& foot : state.feet) {
      foot.strike_roll = foot.lift_roll = 0.0;  // small steps are put down flat
    }
    // Towards the foot that stands: to the right while the left one swings.
    const double into = progress - std::floor(progress);
    const bool left_swings = (static_cast<int>(progress) % 2 == 0) == (first == kLeft);
    state.sway =
        (left_swings ? -1.0 : 1.0) * kTurnSway * m.scale * std::pow(std::sin(kPi * into), 2);
    out.states.push_back(state);
  }
  out.states.push_back(m.stanceState(end, end_feet, 0.0));
  return m.pose(out, begin_feet.level && end_feet.level, n, first);
}

WalkResult WalkSynthesizer::stand(const Stance& at, AnimationBuffer& out) const {
  const StanceFeet feet = impl_->placer->stanceFeet(at);
  if (feet.refused != WalkRule::kNone) return {feet.refused, 0, kLeft};
  out.states.assign(1, impl_->stanceState(at, feet, 0.0));
  return impl_->pose(out, true, 0, kLeft);
}

}  // namespace amble
