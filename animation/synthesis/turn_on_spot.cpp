#include "animation/synthesis/turn_on_spot.h"

#include <algorithm>
#include <cmath>

#include "base/ease.h"
#include "base/parts.h"
#include "base/rotation.h"

namespace amble {

namespace {

constexpr int kPartsOfStep = 8;  // of one time, in which the captured clock is told
// A foot that is about to land is ahead of the pelvis by so much more, and the pelvis sways.
constexpr double kSlack = 3.5 * kDegree;

// By formula: steps of one time, over which the pelvis turns evenly.
void timeByFormula(const SpotTurnRequest& request, SpotTurn& turn) {
  turn.frames =
      std::max(2, static_cast<int>(std::lround(turn.steps * turn.step_time / request.frame_time)));
  std::vector<double> nodes, done;
  for (int i = 0; i <= turn.steps; ++i) {
    nodes.push_back(i);
    done.push_back(static_cast<double>(i) / turn.steps);
  }
  turn.done = CubicSpline(std::move(nodes), std::move(done), 0.0, 0.0);
}

// The first moment at which so much is done.
double momentOf(const CubicSpline& done, double share) {
  constexpr int kLooks = 200, kHalvings = 40;
  double before = 0.0, after = 1.0;
  for (int i = 1; i < kLooks; ++i) {
    const double clock = static_cast<double>(i) / kLooks;
    if (done.at(clock) < share) continue;
    after = clock;
    break;
  }
  before = std::max(0.0, after - 1.0 / kLooks);
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (before + after);
    (done.at(middle) < share ? before : after) = middle;
  }
  return after;
}

// The most that a pair of steps turns. One foot is put down half of a pair and its toe out ahead of
// the pelvis, a little early, as the other, which is as far behind, has still to leave.
double mostOfPair(const FootPlacement& placement) {
  const double toe_out = std::abs(placement.stand_toe_out);
  return std::clamp(2.0 * (SpotTurnGait::kTwist - toe_out - kSlack) /
                        (1.0 + placement.supports.col(0).maxCoeff()),
                    SpotTurnGait::kLeastPair, SpotTurnGait::kPair);
}

// As captured: a foot is put down whenever the pelvis has turned by a step's share of the angle.
// Beside the steps, and where they are quick enough, time is the captured one; that of a larger
// angle is longer, as its accelerations ask.
void timeAsCaptured(const SpotTurnRequest& request, SpotTurn& turn) {
  const TurnSequence& sequence = *request.sequence;
  const double larger = std::max(1.0, request.angle / sequence.angle);
  const double pace = 1.0 / (std::sqrt(larger) * sequence.duration);  // of the clock [1/s]
  const double quick = SpotTurnGait::kQuickStep * std::sqrt(request.scale) / kPartsOfStep;
  turn.done = shareTurned(sequence);
  CapturedTurnTime& captured = turn.captured.emplace();
  captured.turn = request.captured;
  const int parts = kPartsOfStep * turn.steps;
  std::vector<double> clocks = {0.0}, times = {0.0};
  for (int i = 1; i <= parts; ++i) {
    clocks.push_back(i == parts ? 1.0 : momentOf(turn.done, static_cast<double>(i) / parts));
    times.push_back(times.back() + std::max((clocks[i] - clocks[i - 1]) / pace, quick));
  }
  turn.frames = static_cast<int>(std::ceil(times.back() / request.frame_time - 1e-9));
  times.back() = turn.frames * request.frame_time;
  for (int i = 0; i <= turn.steps; ++i) captured.nodes.push_back(times[kPartsOfStep * i]);
  captured.nodes.front() = std::max(0.0, captured.nodes[1] - turn.step_time);
  captured.nodes.back() = std::min(times.back(), captured.nodes[turn.steps - 1] + turn.step_time);
  captured.clock = CubicSpline(std::move(times), std::move(clocks), pace, pace);
  captured.clock.keepRising();
}

// Steps made at a time of a captured turn; both feet stand at whole ones, where their pace changes.
double progressAt(const std::vector<double>& nodes, double time) {
  if (time <= nodes.front()) return 0.0;
  if (time >= nodes.back()) return static_cast<double>(nodes.size() - 1);
  const auto next = std::upper_bound(nodes.begin(), nodes.end(), time);
  const double whole = static_cast<double>(next - nodes.begin() - 1);
  return whole + (time - *(next - 1)) / (*next - *(next - 1));
}

// How far a turn is.
struct SpotTurnPlace {
  double progress = 0.0;  // [steps]
  double done = 0.0;      // share of the angle
  double rate = 0.0;      // of that [1/s]
  SpotTurnMoment moment;
};

SpotTurnPlace placeAt(const SpotTurn& turn, int frame) {
  if (!turn.captured) {
    const double progress = turn.steps * (static_cast<double>(frame) / turn.frames);
    const double pace = turn.steps / (turn.frames * turn.frame_time);  // [steps/s]
    return {progress, turn.done.at(progress), turn.done.slope(progress) * pace, {}};
  }
  const CapturedTurnTime& captured = *turn.captured;
  const double time = frame * turn.frame_time, clock = captured.clock.at(time);
  return {progressAt(captured.nodes, time),
          turn.done.at(clock),
          turn.done.slope(clock) * captured.clock.slope(time),
          {captured.turn, clock}};
}

}  // namespace

SpotTurn planSpotTurn(const StepPlacer& placer, const SpotTurnRequest& request) {
  const Stance& at = request.at;
  const double angle = request.angle;
  SpotTurn turn;
  const int pairs = partsOf(std::abs(angle), mostOfPair(placer.placement()));
  turn.steps = 2 * pairs;
  turn.step_time = SpotTurnGait::stepTime(std::abs(angle) / pairs) * std::sqrt(request.scale);
  turn.first = angle > 0.0 ? kLeft : kRight;
  turn.angle = angle;
  turn.scale = request.scale;
  turn.frame_time = request.frame_time;
  turn.from = turn.end = at;
  turn.shift = request.shift;
  turn.end.position += request.shift;
  turn.end.heading = request.end_heading;
  if (request.sequence != nullptr) {
    timeAsCaptured(request, turn);
  } else {
    timeByFormula(request, turn);
  }
  turn.from_feet = placer.stanceFeet(at);
  turn.end_feet = placer.stanceFeet(turn.end);
  for (const StanceFeet* feet : {&turn.from_feet, &turn.end_feet}) {
    turn.refused = feet->refused;
    if (turn.refused != WalkRule::kNone) return turn;
  }
  FootPlacement placement = placer.placement();
  placement.first = placement.last = {};  // captured starts and stops are those of walks
  placement.swings = SwingKind::kSpot;
  turn.feet.emplace(placement, at, turn.end, turn.steps, turn.first);
  for (int i = 1; i <= turn.steps; ++i) {
    Stance turned = at;
    turned.heading = at.heading + angle * ((i + 1) / 2) / pairs;
    turned.position += request.shift * ((i + 1) / 2) / pairs;
    const Side side = i % 2 != 0 ? turn.first : other(turn.first);
    if (turn.captured) turn.feet->landings()[i + 1].swing.lift = SpotTurnGait::kQuickLift;
    turn.feet->places()[i + 1] = Footsteps::atStance(placement, turned)[side].from;
  }
  turn.feet->setStances(turn.from_feet.feet, turn.end_feet.feet);
  turn.refused = placer.standOnGround(*turn.feet);
  return turn;
}

FrameState spotTurnState(const SpotTurn& turn, const FrameState& standing, int frame) {
  const double share = static_cast<double>(frame) / turn.frames;
  const SpotTurnPlace place = placeAt(turn, frame);
  const double progress = place.progress;
  FrameState state = standing;
  state.spot = place.moment;
  state.position.head<2>() += place.done * turn.shift.head<2>();
  state.position.z() += smoothstep(share) * (turn.end_feet.height - turn.from_feet.height);
  state.arc = place.done * turn.shift.head<2>().norm();
  state.heading = turn.from.heading + turn.angle * place.done;
  state.turn_rate = turn.angle * place.rate;
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
