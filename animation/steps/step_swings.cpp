#include "animation/steps/step_swings.h"

#include <algorithm>
#include <cmath>

#include "animation/steps/slope_gait.h"
#include "base/rotation.h"

namespace amble {

double askedLift(const SwingFeet& feet, double lift, Side side, double slower) {
  constexpr double kNear = 0.1;  // of the captured lift: beyond, both feet are lifted alike [1]
  const double captured = 0.5 * (feet.captured_lift[kLeft] + feet.captured_lift[kRight]);
  const double keep = std::max(0.0, 1.0 - std::abs(lift / captured - 1.0) / kNear);
  if (keep == 0.0) return lift;
  double own = feet.captured_lift[side];
  if (slower > 0.0) {
    FootState swing;
    swing.slower = slower;
    own = swingLift(swing, feet.cycles.of(side, swing), feet.shapes[side]);
  }
  return lift * std::pow(own / captured, keep);
}

// Thesis, eq. 6.8: the step's parts along and across the walk's plane. Left and right feet's toeing
// out cancel.
GaitParameters gaitOf(const FootPlace& from, const FootPlace& to, double lift) {
  const Eigen::Vector3d step = to.position - from.position;
  const double heading = from.heading + 0.5 * wrapAngle(to.heading - from.heading);
  return {step.x() * std::cos(heading) + step.y() * std::sin(heading), lift, step.z()};
}

namespace {

// The lift of a swing on the level depends on how it rolls and is shaped, not on where it goes.
bool isCaptured(const FootState& swing) {
  const SwingShape own;
  return swing.kind == SwingKind::kWalk && swing.turn_rate == 0.0 && swing.slower == 0.0 &&
         isLevelSwing(swing) && swing.strike_roll == 1.0 && swing.lift_roll == 1.0 &&
         swing.swing.lift == own.lift && swing.swing.extra == own.extra &&
         swing.swing.delay == own.delay && swing.swing.early == own.early;
}

}  // namespace

bool shapeSwings(const SwingFeet& body, const SwingClearance& clearance, const GaitWishes& wishes,
                 double length, bool to_standing, Footsteps& steps,
                 std::vector<GaitParameters>& gait) {
  const std::vector<FootPlace>& places = steps.places();
  gait.clear();
  FootCycle blended;
  for (int i = 0; i < 2; ++i) steps.landings()[i].strike_roll = slopeStrike(places[i]);
  for (int i = 1; i <= steps.steps(); ++i) {
    const Side side = steps.side(i);
    Footsteps::Landing& landing = steps.landings()[i + 1];
    landing.strike_roll = slopeStrike(places[i + 1]);
    // The last foot of a walking stance lands as every walk's.
    if (to_standing || i < steps.steps()) {
      const double height = stepHeight(places[i], places[i + 1]);
      landing.strike_roll = climbStrike(landing.strike_roll, height, body.scale);
    }
    const auto swinging = [&] { return steps.at(i - 0.5)[side]; };
    const FootBlend cycle = body.cycles.of(side, swinging()).asOne(blended);
    if (wishes.lift) {
      const double lift = wishes.lift(length * (i - 0.5) / steps.steps());
      landing.swing.lift = liftFactor(askedLift(body, lift, side, landing.slower), swinging(),
                                      cycle, body.shapes[side]);
    }
    if (!clearance.clear(places[i - 1], places[i + 1], side, cycle, landing.swing)) return false;
    const FootState swing = swinging();
    const double lift =
        isCaptured(swing) ? body.captured_lift[side] : swingLift(swing, cycle, body.shapes[side]);
    gait.push_back(gaitOf(places[i], places[i + 1], lift));
  }
  return true;
}

}  // namespace amble
