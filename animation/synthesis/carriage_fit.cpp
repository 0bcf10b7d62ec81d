#include "animation/synthesis/carriage_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "animation/steps/slope_gait.h"
#include "animation/synthesis/leg_reach.h"

namespace amble {
namespace {

constexpr int kSteps = 4, kFramesPerStep = 24;  // of the walks that are measured

// Feet of a few steps straight on along +x, each so much higher than the one before.
Footsteps steadySteps(const FootPlacement& placement, double rise) {
  const double step_length = placement.step_length;
  const Stance from{Eigen::Vector3d::Zero(), 0.0, false, kLeft};
  Stance to = from;
  to.position.x() = kSteps * step_length;
  Footsteps steps(placement, from, to, kSteps, kRight);
  steps.place([&](int i) {
    return GroundPoint{{(i + 0.5) * step_length + placement.forward, 0.0, 0.0}, 0.0};
  });
  if (rise == 0.0) return steps;
  for (FootPlace& place : steps.places()) {
    place.position.z() = rise / step_length * (place.position.x() - placement.forward);
    place.normal = Eigen::Vector3d(-rise, 0.0, step_length).normalized();
  }
  for (auto& landing : steps.landings()) {
    landing.strike_roll = slopeStrike(steps.places().front());
  }
  return steps;
}

// States of such a walk; on a slope without its ends, which are stances of level ground.
AnimationBuffer steadyWalk(const CarriageBody& body, double step_length, double rise) {
  FootPlacement placement = body.placement;
  placement.step_length = step_length;
  const Footsteps steps = steadySteps(placement, rise);
  AnimationBuffer buffer;
  buffer.poses = PoseArray(body.joints());
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

// How much lower the root must walk at a step length for the legs to reach, with such a lead.
double loweringAt(const CarriageBody& body, double step_length, double lead) {
  if (!(step_length > 0.0)) return 0.0;
  const WalkController plain(body.blend, body.reference,
                             Eigen::VectorXd::Zero(3 + 3 * body.joints()), {lead, {}, 1.0});
  AnimationBuffer buffer = steadyWalk(body, step_length, 0.0);
  plain.apply(buffer);
  const std::vector<double> missing = body.feet.missingHeights(buffer, LegReach::kStraight);
  double lowest = 0.0;
  for (int i = 0; i < buffer.size(); ++i) {
    lowest = std::max(lowest, missing[i] / WalkController::loweringShare(buffer.states[i].phase));
  }
  return lowest;
}

// How much farther ahead of its feet the root walks than captured: a striking leg is nearly
// straight and a long step would lower the hips onto bent knees, while the leg behind still has
// room. The least lean that spares most of the lowering.
double leanForStep(const CarriageBody& body, double captured_lead) {
  double best = 0.0, least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= CarriageTuning::kLeanSteps; ++i) {
    const double lean = CarriageTuning::kLongestLean * body.scale * i / CarriageTuning::kLeanSteps;
    const double cost = loweringAt(body, body.placement.step_length, captured_lead + lean) +
                        CarriageTuning::kLeanCost * lean;
    if (cost < least) least = cost, best = lean;
  }
  return best;
}

// How much lower than captured the standing root is for its knees to bend [m].
double standingCrouch(const CarriageBody& body, const WalkController& walk) {
  AnimationBuffer buffer;
  buffer.poses = PoseArray(body.joints());
  FrameState state;
  state.standing = 1.0;
  state.feet = Footsteps::atStance(body.placement, {});
  buffer.states.push_back(state);
  buffer.poses.resize(1);
  walk.apply(buffer);
  return body.feet.missingHeights(buffer, LegReach::kStanding)[0];
}

}  // namespace

CarriageFit fitCarriage(const CarriageBody& body, double stand_height) {
  CarriageFit fit;
  fit.stand_channels = Eigen::VectorXd::Zero(3 + 3 * body.joints());
  fit.stand_channels[2] = stand_height;
  // Standing, the root is over the stance's position to the bit; walking, it leads as captured, and
  // leans.
  WalkController::Carriage& carriage = fit.carriage;
  carriage.lead = body.placement.forward - body.blend.footForward();
  carriage.lead += leanForStep(body, carriage.lead);
  carriage.longest = StrideLaw::kLongestStep * body.blend.law().capturedStep();
  for (int i = 0; i <= CarriageTuning::kLoweringSteps; ++i) {
    carriage.lowering.push_back(
        loweringAt(body, carriage.longest * i / CarriageTuning::kLoweringSteps, carriage.lead));
  }
  const WalkController walk(body.blend, body.reference, fit.stand_channels, carriage);
  fit.stand_channels[2] -= standingCrouch(body, walk);
  return fit;
}

double stanceCrouch(const CarriageBody& body, const WalkController& walk, const Stance& stance,
                    const StanceFeet& stood, const FrameState& state) {
  AnimationBuffer buffer;
  buffer.poses = PoseArray(body.joints());
  if (!stance.standing && stood.rise != 0.0) {
    buffer = steadyWalk(body, stood.placement.step_length, stood.rise);
  }
  buffer.states.push_back(state);
  buffer.poses.resize(static_cast<int>(buffer.states.size()));
  walk.apply(buffer);
  return std::ranges::max(body.feet.missingHeights(buffer, LegReach::kUneven, HipDip::kUnevenHeel));
}

double strideCrouch(const WalkController& walk, const FrameState& state, double scale) {
  constexpr int kPhases = 24;
  double lowest = std::numeric_limits<double>::infinity(), highest = 0.0;
  for (int i = 0; i < kPhases; ++i) {
    const double height = walk.height(static_cast<double>(i) / kPhases, state.step_length);
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  const double rise = highest - lowest, height = walk.height(state.phase, state.step_length);
  const double wanted =
      std::clamp(rise, CarriageTuning::kLeastRise * scale, CarriageTuning::kMostRise * scale);
  // Less rise: lower over the standing leg. More: lower between the legs.
  const double crouch = wanted < rise ? (1.0 - wanted / rise) * (height - lowest)
                                      : (wanted / rise - 1.0) * (highest - height);
  return crouch * (1.0 - state.standing);
}

}  // namespace amble
