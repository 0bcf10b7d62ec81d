#include "animation/steps/foot_target.h"

#include <gtest/gtest.h>

#include <cmath>

#include "animation/library/motion_library_reader.h"
#include "animation/steps/leg_reach.h"
#include "animation/steps/swing_path.h"

namespace amble {
namespace {

struct Foot {
  FootShape shape;
  FootCycle cycle;
};

const Foot& foot() {
  static const Foot kFoot = [] {
    const MotionLibrary library = openMotionLibrary("default");
    for (const Motion& motion : library.motions) {
      if (motion.kind == MotionKind::kWalk) {
        return Foot{library.feet()[kLeft], motion.cycle.feet[kLeft]};
      }
    }
    return Foot{};
  }();
  return kFoot;
}

// From the origin to `step` ahead.
FootState stateAt(double at, const Eigen::Vector3d& step = {1.2, 0.0, 0.0}) {
  FootState state;
  state.at = at;
  if (at > 1.0) state.to.position = step;
  return state;
}

const Eigen::Vector3d kHip(0.1, 0.0, 0.85);

FootTarget targetAt(const FootState& state, double longest = 9.0) {
  return footTarget(state, foot().cycle, foot().shape, kHip, longest);
}

SoleEnds endsOf(const FootTarget& target) {
  return soleEnds(foot().shape, target.ankle, target.q_WF);
}

TEST(FootTarget, OfAFlatFootHasTheSoleOnTheGround) {
  FootState state = stateAt(0.5);
  state.strike_roll = state.lift_roll = 0.0;
  const SoleEnds ends = endsOf(targetAt(state));
  EXPECT_NEAR(ends.heel.z(), 0.0, 1e-9);
  EXPECT_NEAR(ends.ball.z(), 0.0, 1e-9);
}

// A planted foot rolls about heel or ball: one of them rests, none is in the ground.
TEST(FootTarget, OfAPlantedFootRestsOnHeelOrBall) {
  for (double at = 0.0; at <= 0.8; at += 0.05) {
    const SoleEnds ends = endsOf(targetAt(stateAt(at)));
    EXPECT_NEAR(std::min(ends.heel.z(), ends.ball.z()), 0.0, 1e-6) << at;
  }
}

// The tip of a foot's toes: their joint lies where the sole's ball does, and they are bent up by
// toe_bend against the foot.
Eigen::Vector3d tipOf(const FootTarget& target) {
  const FootShape& shape = foot().shape;
  const Eigen::Quaterniond q_WS = target.q_WF * shape.q_SF.conjugate();
  const Eigen::Quaterniond q_WT =
      q_WS * Eigen::Quaterniond(Eigen::AngleAxisd(-target.toe_bend, Eigen::Vector3d::UnitY()));
  const Eigen::Vector3d ball(shape.ball_x - shape.ankle_x, 0.0, shape.radius - shape.ankle_height);
  return target.ankle + q_WS * ball + q_WT * Eigen::Vector3d(shape.tip_x - shape.ball_x, 0.0, 0.0);
}

// At last the foot rolls over the tips of its toes, on whatever it stands: these stay, and the toes
// are bent by so much less.
TEST(FootTarget, TheTipOfAPlantedFootStaysAsItsToesRoll) {
  FootCycle rolls = foot().cycle;
  for (int k = 0; k < FootCycle::kToeSplines; ++k) rolls.toes[k] = 0.04 * k;
  for (const Eigen::Vector3d& normal :
       {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(-0.2, -0.1, 1), Eigen::Vector3d(0.2, -0.1, 1)}) {
    FootState state = stateAt(0.74);  // the heel is up
    state.from.normal = state.to.normal = normal.normalized();
    const auto target = [&](const FootCycle& cycle) {
      return footTarget(state, cycle, foot().shape, kHip, 9.0);
    };
    const Eigen::Vector3d tip = tipOf(target(rolls));
    double rolled = 0.0;
    for (state.at = 0.74; state.at <= 1.0; state.at += 0.02) {
      const FootTarget now = target(rolls);
      EXPECT_LT((tipOf(now) - tip).norm(), 1e-9) << state.at;
      FootCycle flat = rolls;
      flat.toes.fill(0.0);
      const bool falls = normal.x() > 0.0 && state.at < 0.96;  // as the next test has it
      if (!falls) {
        EXPECT_NEAR(target(flat).toe_bend - now.toe_bend, toeRoll(rolls, state.at), 1e-9);
      }
      rolled = std::max(rolled, toeRoll(rolls, state.at));
    }
    EXPECT_GT(rolled, 0.1);
  }
}

// A ball that is lifted from a plane that falls goes forward over the floor: it stays down until
// four fifths of the stance, the more the steeper; the ankle is as high by then, of the heel.
TEST(FootTarget, DownhillTheBallStaysDownForLongerAndTheHeelRisesForIt) {
  FootCycle rolls = foot().cycle;
  for (int k = 0; k < FootCycle::kToeSplines; ++k) rolls.toes[k] = 0.02 * k;
  const FootShape& shape = foot().shape;
  FootState state = stateAt(0.79);
  struct Joints {
    Eigen::Vector3d ankle, ball;  // in the sole's plane
  };
  const auto joints = [&](double fall, const FootCycle& cycle) {
    state.from.normal = state.to.normal = Eigen::Vector3d(fall, 0.0, 1.0).normalized();
    const FootTarget target = footTarget(state, cycle, shape, kHip, 9.0);
    const Eigen::Quaterniond to_plane = soleFrame(0.0, state.from.normal).conjugate();
    const Eigen::Vector3d ankle = to_plane * target.ankle;
    const Eigen::Quaterniond q = to_plane * target.q_WF * shape.q_SF.conjugate();
    const Eigen::Vector3d to_ball(shape.ball_x - shape.ankle_x, 0.0,
                                  shape.radius - shape.ankle_height);
    return Joints{ankle, ankle + q * to_ball};
  };
  FootCycle flat = rolls;
  flat.toes.fill(0.0);
  const Joints down = joints(0.0, flat), level = joints(0.0, rolls);
  const double lifted = (level.ball - down.ball).norm(), raised = level.ankle.z() - down.ankle.z();
  ASSERT_GT(lifted, 0.003);
  EXPECT_LT((joints(-0.2, rolls).ball - level.ball).norm(), 1e-9);
  EXPECT_LT((joints(0.2, rolls).ball - down.ball).norm(), 1e-9);
  double before = lifted + 1e-9;
  for (const double fall : {0.02, 0.05, 0.08, 0.11}) {
    const Joints there = joints(fall, rolls);
    const double now = (there.ball - down.ball).norm();
    EXPECT_LT(now, before) << fall;
    EXPECT_NEAR(there.ankle.z() - down.ankle.z(), raised, 0.25 * raised) << fall;
    before = now;
  }
  state.at = 0.96;
  EXPECT_LT((joints(0.2, rolls).ball - joints(0.0, rolls).ball).norm(), 1e-9);
}

TEST(FootTarget, GoesOnWithoutAJumpWhereTheFootIsLiftedAndPutDown) {
  FootState landed = stateAt(0.0);
  landed.from.position = landed.to.position = {1.2, 0.0, 0.0};
  for (const auto& [a, b] : {std::pair(targetAt(stateAt(1.0)), targetAt(stateAt(1.0 + 1e-6))),
                             std::pair(targetAt(stateAt(2.0)), targetAt(landed))}) {
    EXPECT_LT((a.ankle - b.ankle).norm(), 1e-4);
    EXPECT_LT(a.q_WF.angularDistance(b.q_WF), 1e-3);
    EXPECT_NEAR(a.toe_bend, b.toe_bend, 1e-3);
  }
}

// About the ball until its sole passes flat, about the heel from then on: the ankle goes on as fast
// and the same way for all that, and the sole is no lower for it.
TEST(FootTarget, GoesOnWithoutACornerWhereASwingingSolePassesFlat) {
  constexpr double kStep = 1e-4;  // of the swing
  const FootShape& shape = foot().shape;
  for (const Eigen::Vector3d& normal : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(-0.2, 0.1, 1)}) {
    const auto stateOf = [&](double at) {
      FootState state = stateAt(at, {0.9, 0.1, -0.9 * normal.x() - 0.1 * normal.y()});
      state.from.normal = state.to.normal = normal.normalized();
      return state;
    };
    const auto pitch = [&](double at) { return soleOf(stateOf(at), foot().cycle, shape).pitch; };
    const auto ankle = [&](double at) { return targetAt(stateOf(at)).ankle; };
    int passed = 0;
    for (double at = 1.2; at < 1.9; at += kStep) {
      if ((pitch(at) < 0.0) == (pitch(at + kStep) < 0.0)) continue;
      ++passed;
      const double turned = std::abs(pitch(at + kStep) - pitch(at)) / kStep;
      const Eigen::Vector3d before = (ankle(at - kStep) - ankle(at - 2.0 * kStep)) / kStep,
                            after = (ankle(at + 3.0 * kStep) - ankle(at + 2.0 * kStep)) / kStep;
      // What a corner would be.
      const double corner = turned * (shape.ball_x - shape.heel_x);
      ASSERT_GT(corner, 0.3);
      EXPECT_LT((after - before).norm(), 0.1 * corner) << at;
      const Sole sole = soleOf(stateOf(at), foot().cycle, shape);
      EXPECT_GT(sole.place.position.dot(normal.normalized()),
                swingHeight({}, foot().cycle, at - 1.0) * normal.normalized().z())
          << at;
    }
    EXPECT_EQ(passed, 1);
  }
}

TEST(FootTarget, TurnsAndMovesWithTheGroundItStandsOn) {
  const Eigen::Vector3d away(3.0, -2.0, 0.5);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()));
  for (const double at : {0.1, 0.6, 1.3, 1.8}) {
    FootState state = stateAt(at);
    const FootTarget here = targetAt(state);
    for (FootPlace* place : {&state.from, &state.to}) {
      place->position = away + turn * place->position;
      place->heading += 0.7;
    }
    const FootTarget there = footTarget(state, foot().cycle, foot().shape, away + turn * kHip, 9.0);
    EXPECT_LT((there.ankle - (away + turn * here.ankle)).norm(), 1e-9) << at;
    EXPECT_LT(there.q_WF.angularDistance(turn * here.q_WF), 1e-7) << at;
  }
}

// Behind the walker, a leg that is too short for the captured foot lifts its heel: the ankle comes
// as near as the leg is long, and no farther than HeelRise::kMost; the ball stays.
TEST(FootTarget, AHeelBehindRisesUntilTheLegReaches) {
  FootState state = stateAt(0.8);
  const Eigen::Vector3d hip(0.55, 0.0, 0.80);
  const auto at = [&](double longest) {
    return footTarget(state, foot().cycle, foot().shape, hip, longest);
  };
  const FootTarget captured = at(9.0);
  const double far = (captured.ankle - hip).norm();
  const FootTarget risen = at(far - 0.02);
  EXPECT_LE((risen.ankle - hip).norm(), far - 0.02 + 1e-9);
  EXPECT_GT(risen.toe_bend, captured.toe_bend);
  EXPECT_NEAR(endsOf(risen).ball.z(), endsOf(captured).ball.z(), 1e-6);
  const FootTarget most = at(0.5 * far);
  EXPECT_NEAR(most.toe_bend - captured.toe_bend, HeelRise::kMost, 1e-6);
}

// However short the leg: a heel goes on rising only while that brings the ankle nearer to the hip,
// by kLeastYield's share of its way at least, of a leg that does not bear by kYieldSwinging's, so
// that it never turns over.
TEST(FootTarget, AHeelRisesOnlyWhileThatHelps) {
  const FootShape& shape = foot().shape;
  const double arm = std::hypot(shape.ankle_x - shape.ball_x, shape.ankle_height - shape.radius);
  constexpr double kShorter = 1e-4;  // [m]
  for (const double at : {0.7, 0.9, 1.0, 1.05, 1.15}) {
    const double yield =
        HeelRise::kLeastYield + unloaded(at) * (HeelRise::kYieldSwinging - HeelRise::kLeastYield);
    for (double x = 0.2; x < 0.9; x += 0.1) {
      const Eigen::Vector3d hip(x, 0.0, 0.8);
      const auto bendAt = [&](double longest) {
        return footTarget(stateAt(at), foot().cycle, shape, hip, longest).toe_bend;
      };
      for (double longest = 1.1; longest > 0.5; longest -= kShorter) {
        const double turned = bendAt(longest - kShorter) - bendAt(longest);
        ASSERT_GE(turned, -1e-9) << at << " " << hip.x() << " " << longest;
        ASSERT_LE(turned, 1.5 * kShorter / (arm * std::sin(yield)))
            << at << " " << hip.x() << " " << longest;
      }
    }
  }
}

TEST(FootTarget, AFootUnderTheHipDoesNotRise) {
  const FootState state = stateAt(0.5);
  const Eigen::Vector3d hip(-0.1, 0.0, 0.8);
  const FootTarget captured = footTarget(state, foot().cycle, foot().shape, hip, 9.0);
  const FootTarget asked = footTarget(state, foot().cycle, foot().shape, hip, 0.5);
  EXPECT_NEAR(asked.toe_bend, captured.toe_bend, 1e-9);
}

// Prints on the level are measured by heights alone, tilted ones with all their turns: a tilt of a
// billionth changes nothing, nor does where the prints lie and face.
TEST(FootTarget, TheLiftOverLevelPrintsIsThatOverPrintsThatHardlyTilt) {
  FootState state = stateAt(1.5, {0.9, 0.1, 0.0});
  state.from.heading = 0.3;
  state.to.heading = -0.2;
  for (const double lift : {0.5, 1.0, 3.0}) {
    state.swing.lift = lift;
    FootState tilted = state;
    tilted.to.normal = Eigen::Vector3d(1e-9, 0.0, 1.0).normalized();
    const double high = swingLift(state, foot().cycle, foot().shape);
    EXPECT_GT(high, 0.03 * lift);
    EXPECT_NEAR(high, swingLift(tilted, foot().cycle, foot().shape), 1e-8);
    FootState elsewhere = state;
    for (FootPlace* place : {&elsewhere.from, &elsewhere.to}) {
      place->position = aboutZ(0.7) * place->position + Eigen::Vector3d(3.0, -2.0, 0.5);
      place->heading += 0.7;
    }
    EXPECT_NEAR(high, swingLift(elsewhere, foot().cycle, foot().shape), 1e-12);
  }
}

// Whichever way a step goes over a plane, its foot is as high over that as it is over the level:
// the way to the side goes along the hill, too.
TEST(FootTarget, AFootSwingsAsHighOverAHillsideAsOverTheLevel) {
  for (const double slope : {-0.27, 0.1, 0.27}) {
    for (double way = -3.0; way < 3.2; way += 0.5) {
      FootState hill = stateAt(1.5, 0.9 * Eigen::Vector3d(std::cos(way), std::sin(way), 0.0));
      FootState level = hill;
      for (FootPlace* place : {&hill.from, &hill.to}) {
        place->heading = way;
        place->position.z() = slope * place->position.x();
        place->normal = Eigen::Vector3d(-slope, 0.0, 1.0).normalized();
      }
      level.from.heading = level.to.heading = way;
      for (double at = 1.45; at < 2.0; at += 0.1) {  // toes have left
        hill.at = level.at = at;
        const Eigen::Vector3d p = soleOf(hill, foot().cycle, foot().shape).place.position;
        const Eigen::Vector3d q = soleOf(level, foot().cycle, foot().shape).place.position;
        EXPECT_NEAR(p.z() - slope * p.x(), q.z(), 1e-9) << slope << " " << way << " " << at;
      }
    }
  }
}

TEST(FootTarget, TheLiftFactorGivesTheLiftThatIsAsked) {
  for (const double rise : {0.0, 0.17, -0.1}) {
    FootState state = stateAt(1.5, {0.9, 0.0, rise});
    for (const double lift : {0.05, 0.1, 0.2}) {
      state.swing.lift = liftFactor(lift, state, foot().cycle, foot().shape);
      EXPECT_NEAR(swingLift(state, foot().cycle, foot().shape), lift, 1e-6) << rise << " " << lift;
    }
  }
}

}  // namespace
}  // namespace amble
