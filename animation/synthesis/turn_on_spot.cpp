#include "animation/synthesis/turn_on_spot.h"

#include <algorithm>
#include <cmath>

#include "base/ease.h"
#include "base/parts.h"
#include "base/rotation.h"

namespace amble {

SpotTurn planSpotTurn(const StepPlacer& placer, const Stance& at, double angle, double scale,
                      double frame_time, const Eigen::Vector3d& shift) {
  SpotTurn turn;
  const int pairs = partsOf(std::abs(angle), SpotTurnGait::kPair);
  turn.steps = 2 * pairs;
  turn.step_time = SpotTurnGait::kStepTime * std::sqrt(scale);
  turn.frames =
      std::max(2, static_cast<int>(std::lround(turn.steps * turn.step_time / frame_time)));
  turn.first = angle > 0.0 ? kLeft : kRight;
  turn.angle = angle;
  turn.scale = scale;
  turn.from = turn.end = at;
  turn.shift = shift;
  turn.end.position += shift;
  turn.end.heading = at.heading + angle;
  turn.from_feet = placer.stanceFeet(at);
  turn.end_feet = placer.stanceFeet(turn.end);
  for (const StanceFeet* feet : {&turn.from_feet, &turn.end_feet}) {
    turn.refused = feet->refused;
    if (turn.refused != WalkRule::kNone) return turn;
  }
  FootPlacement placement = placer.placement();
  placement.first = placement.last = {};  // captured starts and stops are those of walks
  placement.swings = SwingKind::kSpot;
  std::vector<double> nodes, done;
  for (int i = 0; i <= turn.steps; ++i) {
    nodes.push_back(i);
    done.push_back(static_cast<double>(i) / turn.steps);
  }
  turn.done = CubicSpline(std::move(nodes), std::move(done), 0.0, 0.0);
  turn.feet.emplace(placement, at, turn.end, turn.steps, turn.first);
  for (int i = 1; i <= turn.steps; ++i) {
    Stance turned = at;
    turned.heading = at.heading + angle * ((i + 1) / 2) / pairs;
    turned.position += shift * ((i + 1) / 2) / pairs;
    const Side side = i % 2 != 0 ? turn.first : other(turn.first);
    turn.feet->places()[i + 1] = Footsteps::atStance(placement, turned)[side].from;
  }
  turn.feet->setStances(turn.from_feet.feet, turn.end_feet.feet);
  turn.refused = placer.standOnGround(*turn.feet);
  return turn;
}

FrameState spotTurnState(const SpotTurn& turn, const FrameState& standing, int frame) {
  const double share = static_cast<double>(frame) / turn.frames, progress = turn.steps * share;
  FrameState state = standing;
  const double done = turn.done.at(progress);
  state.position.head<2>() += done * turn.shift.head<2>();
  state.position.z() += smoothstep(share) * (turn.end_feet.height - turn.from_feet.height);
  state.arc = done * turn.shift.head<2>().norm();
  state.heading = turn.from.heading + turn.angle * done;
  state.turn_rate = turn.angle * turn.done.slope(progress) / turn.step_time;
  state.feet = turn.feet->at(progress);
  for (FootState& foot : state.feet) foot.strike_roll = foot.lift_roll = 1.0;  // all of SpotStep's
  // Towards the foot that stands: to the right while the left one swings.
  const double into = progress - std::floor(progress);
  const bool left_swings = (static_cast<int>(progress) % 2 == 0) == (turn.first == kLeft);
  state.sway = (left_swings ? -1.0 : 1.0) * SpotTurnGait::kSway * turn.scale *
               std::pow(std::sin(kPi * into), 2);
  return state;
}

}  // namespace amble
