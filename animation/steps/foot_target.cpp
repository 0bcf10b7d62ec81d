#include "animation/steps/foot_target.h"

#include <algorithm>
#include <cmath>

#include "animation/steps/leg_reach.h"
#include "animation/steps/swing_path.h"
#include "base/ease.h"
#include "base/rotation.h"

namespace amble {
namespace {

double rolled(double pitch, double strike_roll, double lift_roll) {
  return pitch * (pitch < 0.0 ? strike_roll : lift_roll);
}

// How a sole is rolled in its swing [rad].
struct SwingRoll {
  double pitch, roll;
};

SwingRoll swingRoll(const FootState& state, const FootBlend& cycle) {
  const double tau = state.at - 1.0;
  const double share = state.lift_roll + smoothstep(tau) * (state.strike_roll - state.lift_roll);
  return {rolled(cycle.pitch(state.at), share, share), cycle.polynomial(&FootCycle::roll, tau)};
}

// From a pitch of as much before a swinging sole passes flat until as much behind the sole is
// higher. By trial: over less, knees are seen to jerk in slow walks; over more, the sole is so much
// higher that one sees it [rad].
constexpr double kPassing = 0.1;
constexpr double kEnds = 0.25;  // of a swing, in which the sole becomes and ceases to be so

// How much higher a swinging sole is where it passes flat, so that the ankle, which turns about the
// ball before and about the heel after it, goes on without a corner: its height goes with |pitch|,
// which is rounded here by a polynomial that has its value, slope and curvature where it ends.
// Nothing at a swing's ends, where the sole is that of the stance [m, >= 0].
double passingRise(const FootShape& shape, double pitch, double tau) {
  const double x = std::abs(pitch) / kPassing;
  if (x >= 1.0) return 0.0;
  const double rounded = 0.375 + x * (-1.0 + x * (0.75 - 0.125 * x * x));
  const double window = smoothstep(tau / kEnds) * smoothstep((1.0 - tau) / kEnds);
  return window * rounded * kPassing * 0.5 * (shape.ball_x - shape.heel_x);
}

// Share of the toes' roll that is made, as of ToesDown.
double toesShare(const FootState& state) {
  const FootPlace& place = state.from;
  if (place.normal.x() == 0.0 && place.normal.y() == 0.0) return 1.0;
  const double fall =
      -tiltAlong(place, Eigen::Vector2d(std::cos(place.heading), std::sin(place.heading)));
  const double late = smoothstep((state.at - ToesDown::kUntil) / ToesDown::kOver);
  return 1.0 - (1.0 - late) * smoothstep(fall / ToesDown::kSteep);
}

// How far the toes are rolled over their tip as captured [rad, >= 0].
double toesOf(const FootState& state, const FootBlend& cycle) {
  constexpr double kSamples = FootCycle::kStanceSamples;
  constexpr double kFrom = (FootCycle::kToesFrom - 2) / kSamples,
                   kUntil = (FootCycle::kToesFrom + FootCycle::kToeSplines + 1) / kSamples;
  if (state.at <= kFrom || state.at >= kUntil) return 0.0;
  return state.lift_roll > 0.0 ? state.lift_roll * cycle.toeRoll(state.at) : 0.0;
}

Sole swingingSole(const FootState& state, const FootBlend& cycle, const FootShape& shape) {
  const SwingShape& swing = state.swing;
  const double tau = state.at - 1.0, ease = smoothstep(tau);
  const Eigen::Vector3d line = state.to.position - state.from.position;
  Sole sole;
  FootPlace& place = sole.place;
  place.position = state.from.position + swingAlong(swing, cycle, tau) * line;
  place.position.z() += swingHeight(swing, cycle, tau);
  place.heading = state.from.heading + ease * wrapAngle(state.to.heading - state.from.heading) +
                  cycle.polynomial(&FootCycle::yaw, tau);
  place.normal = state.from.normal + ease * (state.to.normal - state.from.normal);
  const double span = line.head<2>().norm();
  if (span > 1e-9) {
    const double sideways = cycle.polynomial(&FootCycle::sideways, tau) / span;
    const Eigen::Vector2d left(-line.y(), line.x());
    place.position.head<2>() += sideways * left;
    // As high over a hillside as beside the line.
    place.position.z() += sideways * tiltAlong(place, left);
  }
  const SwingRoll turned = swingRoll(state, cycle);
  sole.pitch = turned.pitch;
  sole.roll = turned.roll;
  // As high over a hillside, here too, and as far from it.
  place.position += passingRise(shape, turned.pitch, tau) * place.normal.z() * place.normal;
  return sole;
}

FootTarget targetOf(const FootShape& shape, const Sole& sole) {
  const Eigen::Quaterniond q_WS = soleFrame(sole.place.heading, sole.place.normal);
  FootTarget target;
  target.ankle = sole.place.position + q_WS * rolledAnkle(shape, sole.pitch);
  target.q_WF = q_WS * Eigen::Quaterniond(Eigen::AngleAxisd(sole.pitch, Eigen::Vector3d::UnitY())) *
                Eigen::Quaterniond(Eigen::AngleAxisd(sole.roll, Eigen::Vector3d::UnitX())) *
                shape.q_SF;
  // Toes stay as they lie while the heel is up.
  target.toe_bend = std::max(sole.pitch, 0.0) - sole.toes;
  return target;
}

// The pitch from low to high at which the ankle is so far from a point in the sole's frame; the
// largest that still helps where even that is too far. @pre it is at `low`, and farther there.
// About heel or ball the ankle moves on a circle, so that the squared distance is a cosine of the
// pitch; of its two solutions the one at which it falls, and `yield` before its least at most.
double pitchAtDistance(const FootShape& shape, const Eigen::Vector3d& p, double distance,
                       double yield, double low, double high) {
  const auto squared = [&](double pitch) { return (rolledAnkle(shape, pitch) - p).squaredNorm(); };
  const double wanted = distance * distance;
  // About the heel below 0, about the ball above.
  if (low < 0.0 && high > 0.0) (squared(0.0) > wanted ? low : high) = 0.0;
  if (high <= 0.0 && squared(high) > wanted) return high;
  const double pivot = high <= 0.0 ? shape.heel_x : shape.ball_x;
  const Eigen::Vector2d arm(shape.ankle_x - pivot, shape.ankle_height - shape.radius);
  const Eigen::Vector2d away(pivot - p.x(), shape.radius - p.z());
  const double a = away.dot(arm), b = away.x() * arm.y() - away.y() * arm.x();
  const double c = 0.5 * (wanted - away.squaredNorm() - p.y() * p.y() - arm.squaredNorm());
  const double share = std::clamp(c / std::hypot(a, b), -std::cos(yield), 1.0);
  return std::clamp(wrapAngle(std::atan2(b, a) + std::acos(share)), low, high);
}

}  // namespace

Sole soleOf(const FootState& state, const FootBlend& cycle, const FootShape& shape) {
  Sole sole;
  if (state.planted()) {
    sole.place = state.from;
    sole.pitch = rolled(cycle.pitch(state.at), state.strike_roll, state.lift_roll);
  } else {
    sole = swingingSole(state, cycle, shape);
  }
  sole.unloaded = unloaded(state.at);
  sole.toes = toesOf(state, cycle);
  if (sole.toes > 0.0) {
    const double kept = (1.0 - toesShare(state)) * sole.toes;
    sole.pitch += kept * (shape.tip_x - shape.ball_x) / (shape.ball_x - shape.ankle_x);
    sole.toes -= kept;
    const Eigen::Vector3d ball = rolledBall(shape, sole.toes);
    const FootPlace& place = sole.place;
    const bool level = place.normal.x() == 0.0 && place.normal.y() == 0.0;
    const double ahead = std::cos(place.heading), left = std::sin(place.heading);
    sole.place.position += level ? Eigen::Vector3d(ahead * ball.x(), left * ball.x(), ball.z())
                                 : soleFrame(place.heading, place.normal) * ball;
  }
  return sole;
}

double raisedPitch(const Sole& sole, const FootShape& shape, const Eigen::Vector3d& hip,
                   double distance, double longest) {
  if (distance < longest - kHeelRests) return sole.pitch;
  const Eigen::Quaterniond q_WS = soleFrame(sole.place.heading, sole.place.normal);
  Eigen::Vector3d ahead = q_WS * Eigen::Vector3d::UnitX();
  ahead.z() = 0.0;
  const Eigen::Vector3d away = hip - sole.place.position;
  const HipOverSole over = {q_WS.conjugate() * away, (away - shape.ball_x * ahead).dot(ahead),
                            sole.unloaded};
  return raisedPitch(sole.pitch, shape, over, distance, longest);
}

double raisedPitch(double pitch, const FootShape& shape, const HipOverSole& hip, double distance,
                   double longest) {
  using Rise = HeelRise;
  const double soft = Rise::kSoftReach + hip.unloaded * (Rise::kSoftSwinging - Rise::kSoftReach);
  if (distance < longest - Rise::kRests * soft) return pitch;
  const double freedom = smoothstep(hip.behind / HeelRise::kBehind);
  if (freedom == 0.0) return pitch;  // as of every foot that strikes
  // A smooth minimum of what it is and what it may be.
  const double wanted = distance - soft * std::log1p(std::exp((distance - longest) / soft));
  const double yield =
      Rise::kLeastYield + hip.unloaded * (Rise::kYieldSwinging - Rise::kLeastYield);
  return pitchAtDistance(shape, hip.p_S, wanted, yield, pitch, pitch + Rise::kMost * freedom);
}

FootTarget footTarget(const FootState& state, const FootBlend& cycle, const FootShape& shape,
                      const Eigen::Vector3d& hip, double longest) {
  Sole sole = soleOf(state, cycle, shape);
  const FootTarget target = targetOf(shape, sole);
  const double distance = (target.ankle - hip).norm();
  if (distance < longest - kHeelRests) return target;
  sole.pitch = raisedPitch(sole, shape, hip, distance, longest);
  return targetOf(shape, sole);
}

namespace {

// Of a swing at which its height is measured: every kLiftStride-th first, then those around the
// highest of them.
constexpr int kLiftPoints = 100, kLiftStride = 4;

// Height of the lower of heel and ball over level prints, whatever the heading: of the sole turned
// by pitch about y after roll about x.
double levelHeight(const FootState& state, const FootBlend& cycle, const FootShape& shape) {
  const SwingRoll turned = swingRoll(state, cycle);
  const double s = std::sin(turned.pitch), c = std::cos(turned.pitch);
  const double under = c * std::cos(turned.roll) * (shape.radius - shape.ankle_height);
  const double lower = s > 0.0 ? shape.ball_x : shape.heel_x;
  const double toes = toesOf(state, cycle), ball = toes > 0.0 ? rolledBall(shape, toes).z() : 0.0;
  const double tau = state.at - 1.0;
  return swingHeight(state.swing, cycle, tau) + passingRise(shape, turned.pitch, tau) + ball +
         rolledAnkle(shape, turned.pitch).z() - shape.radius + under - s * (lower - shape.ankle_x);
}

}  // namespace

bool isLevelSwing(const FootState& state) {
  const auto upright = [](const FootPlace& place) {
    return place.normal.x() == 0.0 && place.normal.y() == 0.0;
  };
  return upright(state.from) && upright(state.to) &&
         state.from.position.z() == state.to.position.z();
}

double swingLift(FootState state, const FootBlend& cycle, const FootShape& shape) {
  const auto endsOf = [&](const FootState& s) {
    const FootTarget target = targetOf(shape, soleOf(s, cycle, shape));
    return soleEnds(shape, target.ankle, target.q_WF);
  };
  const auto flat = [&](const FootPlace& place) {
    FootState stood;
    stood.from = stood.to = place;
    stood.at = 0.5;
    stood.strike_roll = stood.lift_roll = 0.0;
    return endsOf(stood);
  };
  const bool level = isLevelSwing(state);
  const SoleEnds from = flat(state.from), to = flat(state.to);
  const auto heightAt = [&](int i) {
    state.at = 1.0 + static_cast<double>(i) / kLiftPoints;
    return level ? levelHeight(state, cycle, shape) : heightOver(from, to, endsOf(state));
  };
  double highest = 0.0;
  int where = 0;
  const auto look = [&](int i) {
    const double height = heightAt(i);
    if (height > highest) highest = height, where = i;
  };
  for (int i = kLiftStride; i < kLiftPoints; i += kLiftStride) look(i);
  const int coarse = where;
  for (int i = std::max(1, coarse - kLiftStride + 1);
       i < std::min(kLiftPoints, coarse + kLiftStride); ++i)
    if (i != coarse) look(i);
  return highest;
}

double liftFactor(double lift, FootState state, const FootBlend& cycle, const FootShape& shape) {
  double low = 0.0, high = 20.0;
  for (int i = 0; i < 30; ++i) {
    state.swing.lift = 0.5 * (low + high);
    (swingLift(state, cycle, shape) < lift ? low : high) = state.swing.lift;
  }
  return 0.5 * (low + high);
}

}  // namespace amble
