#include "animation/synthesis/walk_synthesizer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

#include "animation/body/reference_pose.h"
#include "animation/steps/slope_gait.h"
#include "animation/steps/start_and_stop.h"
#include "animation/steps/step_placer.h"
#include "animation/synthesis/action.h"
#include "animation/synthesis/foot_controller.h"
#include "animation/synthesis/gait_blend.h"
#include "animation/synthesis/turn_on_spot.h"
#include "animation/synthesis/walk_controller.h"
#include "base/ease.h"
#include "base/rotation.h"

namespace amble {
namespace {

void checkSettings(const CharacterSettings& s) {
  const GroundLimits& g = s.limits;
  if (!(s.speed >= 0.3 && s.speed <= 2.0)) throw std::invalid_argument("speed: 0.3 to 2.0 m/s");
  if (s.height != 0.0 && !(s.height >= 0.5 && s.height <= 2.5)) {
    throw std::invalid_argument("height: 0.5 to 2.5 m");
  }
  if (!(s.frame_time >= 1.0 / 240.0 && s.frame_time <= 1.0 / 24.0)) {
    throw std::invalid_argument("frame time: 1/240 to 1/24 s");
  }
  if (!(g.max_slope >= 0.0 && g.max_slope <= 0.25 * kPi)) {
    throw std::invalid_argument("steepest slope: 0 to 45 degrees");
  }
  if (!(g.max_climb >= 0.0 && g.max_climb <= 1.0 && g.max_drop >= 0.0 && g.max_drop <= 1.0)) {
    throw std::invalid_argument("highest steps: 0 to 1 m");
  }
}

}  // namespace

struct WalkSynthesizer::Impl {
  Impl(const MotionLibrary& the_library, const Ground& ground,
       const CharacterSettings& the_settings)
      : library(the_library),
        settings(the_settings),
        scale((the_settings.height > 0.0 ? the_settings.height : library.stature) /
              library.stature),
        stature(library.stature * scale),
        skeleton(library.skeleton.scaled(scale)),
        roles(library.roles),
        shapes(makeFootShapes(skeleton, roles, stature)),
        reference(library.stand().rotations),
        blend(library, scale, the_settings.speed),
        feet(skeleton, roles, shapes, blend,
             kneeAxes(roles, referenceOf(skeleton, roles, library.stand().rotations))),
        placement(placementOf(library.stand())),
        turns(library, scale),
        walk(blend, turns, reference, standChannels(library.stand().root_height * scale),
             placement.forward - blend.footForward()),
        placer(ground, shapes, blend.feet(), stepSettings()),
        captured_lift(0.5 * (capturedLift(kLeft) + capturedLift(kRight))) {}

  FootPlacement placementOf(const Posture& stand) const {
    FootPlacement placed;
    placed.walk_width = blend.stepWidth();
    placed.stand_width = stand.step_width * scale;
    placed.forward = -stand.root_forward * scale;
    placed.stagger = blend.stagger();
    placed.step_length = blend.law().stepLength(settings.speed);
    placed.walk_toe_out = blend.toeOut();
    placed.stand_toe_out = 0.5 * (stand.toe_out[kLeft] - stand.toe_out[kRight]);
    placed.supports = blend.law().supports(settings.speed, 0.0);
    placed.first = blend.transitions().firstSwings();
    placed.last = blend.transitions().lastSwings();
    return placed;
  }

  Eigen::VectorXd standChannels(double height) const {
    Eigen::VectorXd channels = Eigen::VectorXd::Zero(3 + 3 * skeleton.size());
    channels[2] = height;
    return channels;
  }

  // Of a swing over a step of the captured length on the level.
  double capturedLift(Side side) const {
    FootState swing;
    swing.to.position.x() = 2.0 * blend.law().capturedStep();
    return swingLift(swing, blend.foot(side), shapes[side]);
  }

  StepSettings stepSettings() const {
    StepSettings steps;
    steps.placement = placement;
    steps.limits.law = blend.law();
    steps.limits.speed = settings.speed;
    steps.limits.max_turn_rate = blend.maxTurnRate();
    steps.limits.frame_time = settings.frame_time;
    steps.footholds = settings.limits;
    steps.scale = scale;
    steps.captured_lift = {capturedLift(kLeft), capturedLift(kRight)};
    return steps;
  }

  FrameState stanceState(const Stance& stance, const StanceFeet& stood, double arc) const {
    FrameState state;
    state.position = stance.position;
    state.position.z() = stood.height;
    state.heading = stance.heading;
    state.arc = arc;
    state.standing = state.posture = stance.standing ? 1.0 : 0.0;
    state.speed = stance.standing ? 0.0 : settings.speed * stance.pace;
    state.phase = stance.standing || stance.leading == kLeft ? 0.0 : 0.5;
    state.step_length = placement.step_length;
    if (!stance.standing) {
      state.step_length = stood.placement.step_length;
      state.lean = slopeLean(stood.rise / state.step_length);
    }
    state.slower = stood.placement.slower;
    state.feet = Footsteps::atStance(stood.placement, stance);
    for (const Side side : {kLeft, kRight}) {
      FootState& foot = state.feet[side];
      foot.from = foot.to = stood.feet[side];
      if (!stance.standing) foot.strike_roll = slopeStrike(foot.from);
    }
    return state;
  }

  // As one stands at the origin on the level.
  JointFrame standingHead() const {
    AnimationBuffer buffer;
    buffer.poses = PoseArray(skeleton.size());
    buffer.states.resize(1);
    buffer.states[0].standing = buffer.states[0].posture = 1.0;
    buffer.states[0].step_length = placement.step_length;
    buffer.poses.resize(1);
    walk.apply(buffer);
    std::vector<JointFrame> joints(skeleton.size());
    forwardKinematics(skeleton, buffer.poses[0], joints);
    return joints[roles.head];
  }

  // Between two stances, in a frame of the walk; `state` is a new one.
  void setWalkingState(const WalkSteps& steps, const WalkRequest& request, int frame,
                       FrameState& state) const {
    const SpeedProfile::Sample at = steps.at(frame);
    const RootPath::Sample on = request.path.at(at.arc);
    const double begin = at.steps, left = steps.steps - at.steps;
    state.position << on.position, steps.heightAt(at, request.path.length());
    state.arc = at.arc;
    state.heading = on.heading;
    state.speed = at.speed;
    state.turn_rate = on.curvature * at.speed;
    state.blended_turn_rate = smoothstep(begin) * smoothstep(left) * state.turn_rate;
    state.slower = slowerAt(steps, request.wishes, at);
    // Phase is that of the foot in front, 0 or 0.5 at every node: the first step lands `first`.
    state.phase = 0.5 * at.steps + (steps.first == kLeft ? 0.5 : 0.0);
    state.phase -= std::floor(state.phase);
    state.step_length = at.step_length;
    state.lean = slopeLean(steps.slopeAt(at));
    standAtEnds(steps, request, at, state);
    state.feet = steps.feet->at(at.steps);
  }

  // How much slower than the plan's; beside a walking stance as that is.
  double slowerAt(const WalkSteps& steps, const GaitWishes& wishes,
                  const SpeedProfile::Sample& at) const {
    double slower = wishes.stride ? 0.0 : blend.feet().departures.slowerBy(at.speed);
    const auto beside = [&](const Stance& stance, const StanceFeet& stood, double away) {
      const double stances = stood.placement.slower;
      if (!stance.standing) slower = stances + smoothstep(away) * (slower - stances);
    };
    beside(steps.from, steps.from_feet, at.steps);
    beside(steps.end, steps.end_feet, steps.steps - at.steps);
    return slower;
  }

  // One turn on the spot, that ends at `to` [m, World] to the bit.
  WalkResult turn(const SpotTurnRequest& request, const Eigen::Vector3d& to,
                  AnimationBuffer& out) const {
    SpotTurn turn = planSpotTurn(placer, request);
    turn.end.position = to;
    if (turn.refused != WalkRule::kNone) return {turn.refused, turn.steps, turn.first};
    out.states.clear();
    out.states.push_back(stanceState(request.at, turn.from_feet, 0.0));
    for (int k = 1; k < turn.frames; ++k)
      out.states.push_back(spotTurnState(turn, out.states.front(), k));
    out.states.push_back(stanceState(turn.end, turn.end_feet, request.shift.head<2>().norm()));
    return pose(out, turn.steps, turn.first);
  }

  // What is left of standing at the ends, and which captured start and stop the frame is in.
  void standAtEnds(const WalkSteps& steps, const WalkRequest& request,
                   const SpeedProfile::Sample& at, FrameState& state) const {
    constexpr double kShare = StartAndStop::kStandingShare, kEnd = TransitionSequence::kEnd;
    const auto stands = [&](double steps_away, double clock, Side side,
                            const TransitionBlend::Joined* captured, TransitionMoment& moment) {
      const double share = 1.0 - smoothstep(steps_away / kShare);
      state.standing = std::max(state.standing, share);
      if (captured == nullptr) state.posture = std::max(state.posture, share);
      moment = {captured != nullptr && clock < kEnd, side, clock};
    };
    const TransitionBlend& captured = blend.transitions();
    const double left = steps.steps - at.steps;
    const Side last = steps.feet->side(steps.steps);
    if (request.from.standing) {
      stands(at.steps, at.steps + std::min(at.sway, 0.0), steps.first, captured.start(steps.first),
             state.start);
    }
    if (request.to.standing)
      stands(left, left - std::max(at.sway, 0.0), last, captured.stop(last), state.stop);
  }

  WalkResult pose(AnimationBuffer& out, int steps, Side leading) const {
    out.frame_time = settings.frame_time;
    if (out.poses.joints() != skeleton.size()) out.poses = PoseArray(skeleton.size());
    out.poses.resize(static_cast<int>(out.states.size()));
    walk.apply(out);
    for (const auto& action : actions) action->apply(out);
    if (!feet.apply(out)) return {WalkRule::kReach, steps, leading};
    out.markFootprints();
    return {WalkRule::kNone, steps, leading};
  }

  const MotionLibrary& library;
  CharacterSettings settings;
  double scale, stature;
  Skeleton skeleton;
  JointRoles roles;
  std::array<FootShape, 2> shapes;
  std::vector<Eigen::Quaterniond> reference;
  GaitBlend blend;
  FootController feet;
  FootPlacement placement;
  CapturedTurns turns;
  WalkController walk;
  StepPlacer placer;
  double captured_lift;  // the mean of both feet [m]
  std::vector<std::unique_ptr<const SubController>> actions;
};

WalkSynthesizer::WalkSynthesizer(const MotionLibrary& library, const Ground& ground,
                                 const CharacterSettings& settings) {
  checkSettings(settings);
  impl_ = std::make_unique<Impl>(library, ground, settings);
  for (const std::string& action : settings.actions) {
    impl_->actions.push_back(makeAction(library, action));
  }
}

WalkSynthesizer::~WalkSynthesizer() = default;

std::unique_ptr<WalkSynthesizer> WalkSynthesizer::on(const Ground& ground) const {
  return std::make_unique<WalkSynthesizer>(impl_->library, ground, impl_->settings);
}

const CharacterSettings& WalkSynthesizer::settings() const { return impl_->settings; }
const Skeleton& WalkSynthesizer::skeleton() const { return impl_->skeleton; }
const JointRoles& WalkSynthesizer::roles() const { return impl_->roles; }
const std::array<FootShape, 2>& WalkSynthesizer::feet() const { return impl_->shapes; }
double WalkSynthesizer::capturedStep() const { return impl_->blend.law().capturedStep(); }
double WalkSynthesizer::capturedLift() const { return impl_->captured_lift; }
double WalkSynthesizer::stature() const { return impl_->stature; }
double WalkSynthesizer::scale() const { return impl_->scale; }
JointFrame WalkSynthesizer::standingHead() const { return impl_->standingHead(); }
double WalkSynthesizer::stepLength() const { return impl_->placement.step_length; }
double WalkSynthesizer::maxTurnRate() const { return impl_->blend.maxTurnRate(); }
Eigen::AlignedBox1d WalkSynthesizer::tooHighToSwingOver() const {
  return impl_->placer.tooHighToSwingOver();
}
double WalkSynthesizer::shortestWalk() const {
  // Two steps of half a step's length each.
  const StrideLaw& law = impl_->blend.law();
  const double slowest = std::min(law.onset().first_speed, law.onset().last_speed);
  const double wanted = law.stepLength(std::min(impl_->settings.speed, slowest));
  return std::max(StrideLaw::kShortestStep * law.capturedStep(), StepFit::kLeastStretch * wanted);
}

namespace {

// Where curves join and bend the other way the turn rate jumps; people lean into a turn over a
// moment, and change their gait over one. The mean over that moment, which shrinks towards the
// ends: there it is the stance's and stays so.
void smoothBlending(double FrameState::*blended, double frame_time,
                    std::vector<FrameState>& states) {
  const int n = static_cast<int>(states.size());
  const int widest = static_cast<int>(std::lround(GaitBlend::kBlendTime / frame_time));
  std::vector<double> sums(n + 1, 0.0);
  for (int pass = 0; pass < 2; ++pass) {  // a mean of means has no corners
    for (int i = 0; i < n; ++i) sums[i + 1] = sums[i] + states[i].*blended;
    for (int i = 0; i < n; ++i) {
      const int half = std::min({widest, i, n - 1 - i});
      if (half == 0) continue;  // to the bit
      states[i].*blended = (sums[i + half + 1] - sums[i - half]) / (2 * half + 1);
    }
  }
}

// At a stance the body goes straight on, whatever curves lead there and on: it turns into the
// path's curve, and out of it, over a moment.
void turnIn(const RootPath& path, bool at_end, double frame_time, std::vector<FrameState>& states) {
  const int last = static_cast<int>(states.size()) - 1;
  const double time = std::min(WalkSynthesizer::kTurnIn, 0.5 * last * frame_time);
  const double speed = (at_end ? states.back() : states.front()).speed;
  const double rate = speed * path.at(at_end ? path.length() : 0.0).curvature;
  for (int k = 1; k * frame_time < time; ++k) {
    const double away = k * frame_time, left = 1.0 - away / time;
    states[at_end ? last - k : k].facing += (at_end ? rate : -rate) * away * left * left;
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
                                 bool any_leading, AnimationBuffer& out, const GaitWishes& wishes,
                                 const WalkFilter& is_wanted) const {
  const Impl& m = *impl_;
  const WalkRequest request{from, to, path, any_leading, wishes, is_wanted ? &is_wanted : nullptr};
  const WalkSteps walk = m.placer.plan(request);
  if (walk.refused != WalkRule::kNone) return {walk.refused, walk.steps, walk.end.leading};
  if (walk.unwanted || (is_wanted && !is_wanted(walk.frames(), walk.end.leading, walk.gait)))
    return {WalkRule::kNone, walk.steps, walk.end.leading, true};
  out.states.clear();
  out.states.push_back(m.stanceState(from, walk.from_feet, 0.0));
  for (int k = 1; k < walk.frames(); ++k)
    m.setWalkingState(walk, request, k, out.states.emplace_back());
  out.states.push_back(m.stanceState(walk.end, walk.end_feet, path.length()));
  // Standing comes of as slow a walk as it leads to.
  if (from.standing) out.states.front().slower = out.states[1].slower;
  if (to.standing) out.states.back().slower = out.states[walk.frames() - 1].slower;
  for (const auto blended : {&FrameState::blended_turn_rate, &FrameState::slower})
    smoothBlending(blended, m.settings.frame_time, out.states);
  if (!from.standing) turnIn(path, false, m.settings.frame_time, out.states);
  if (!to.standing) turnIn(path, true, m.settings.frame_time, out.states);
  const WalkResult result = m.pose(out, walk.steps, walk.end.leading);
  if (result.refused == WalkRule::kNone) setGait(walk.gait, out);
  return result;
}

WalkResult WalkSynthesizer::outlook(const Stance& from, const Stance& to, const RootPath& path,
                                    bool any_leading, const WalkFilter& is_wanted) const {
  const GaitWishes none;
  const WalkSteps walk = impl_->placer.plan(
      {from, to, path, any_leading, none, is_wanted ? &is_wanted : nullptr, true});
  return {walk.refused, walk.steps, walk.end.leading, walk.unwanted};
}

WalkResult WalkSynthesizer::turnOnSpot(const Stance& at, double angle, AnimationBuffer& out) const {
  return smallSteps(at, at.position, angle, out);
}

WalkResult WalkSynthesizer::smallSteps(const Stance& at, const Eigen::Vector3d& to, double angle,
                                       AnimationBuffer& out) const {
  const Impl& m = *impl_;
  assert((to - at.position).head<2>().norm() <= kSmallSteps);
  const CapturedTurns::Taken taken = m.turns.take(angle);
  SpotTurnRequest request{at, angle / taken.times, 0.0, m.scale, m.settings.frame_time};
  if (taken.turn >= 0) request.sequence = &m.turns.sequence(taken.turn);
  request.captured = taken.turn;
  request.shift = to - at.position;
  WalkResult all{WalkRule::kNone, 0, angle > 0.0 ? kLeft : kRight};
  AnimationBuffer part;
  for (int i = 1; i <= taken.times; ++i) {
    const bool last = i == taken.times;
    request.end_heading = last ? at.heading + angle : request.at.heading + request.angle;
    const WalkResult turn = m.turn(request, to, i == 1 ? out : part);
    all.steps += turn.steps;
    all.refused = turn.refused;
    if (all.refused != WalkRule::kNone) break;
    if (i > 1) out.append(part);
    request.at.position = to;
    request.at.heading = request.end_heading;
    request.shift.setZero();
  }
  return all;
}

WalkResult WalkSynthesizer::stand(const Stance& at, AnimationBuffer& out) const {
  const StanceFeet feet = impl_->placer.stanceFeet(at);
  if (feet.refused != WalkRule::kNone) return {feet.refused, 0, kLeft};
  out.states.assign(1, impl_->stanceState(at, feet, 0.0));
  return impl_->pose(out, 0, kLeft);
}

}  // namespace amble
