#include "animation/synthesis/leg_lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "animation/library/motion_library_reader.h"
#include "animation/steps/foot_target.h"
#include "tests/animation/default_library.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

// The left leg alone, hung on the root: thigh, shank and foot of the library's.
struct Leg {
  static constexpr int kJoints = 4;
  int joint[kJoints] = {0, 1, 2, 3}, parent[kJoints] = {-1, 0, 1, 2};
  double offset[3 * kJoints] = {};
  FootShape shape = defaultLibrary().feet()[kLeft];
  LaneLegs legs;

  Leg() {
    const LegJoints& roles = defaultLibrary().roles.legs[kLeft];
    const int bones[] = {roles.up_leg, roles.leg, roles.foot};
    for (int i = 0; i < 3; ++i)
      std::copy_n(defaultLibrary().skeleton.joint(bones[i]).offset.data(), 3, offset + 3 * (i + 1));
    LaneLeg leg = {};
    leg.up_leg = {1, 1, 0}, leg.leg = {2, 2, 1}, leg.foot = {3, 3, 2}, leg.toe = 4;
    leg.knee_axis[0] = 1.0;
    leg.longest = 0.9995;
    leg.radius = shape.radius, leg.ankle_height = shape.ankle_height;
    leg.ankle_x = shape.ankle_x, leg.heel_x = shape.heel_x, leg.ball_x = shape.ball_x;
    std::copy_n(shape.q_SF.coeffs().data(), 4, leg.q_SF);
    std::copy_n(shape.q_FT.coeffs().data(), 4, leg.q_FT);
    std::copy_n(shape.lateral_T.data(), 3, leg.lateral_T);
    legs = {kJoints, joint, parent, offset, {leg, leg}};
    legs.legs[kRight].side = kRight;
  }
};

// Four random poses of it over random soles on tilted ground.
struct Frames {
  double position[12], rotations[4][20], joints[kLaneJoint * Leg::kJoints], missing[4];
  bool reached[4];
  FootState states[4];
  LaneSoles soles;
  LaneLegFrames frames{joints, {}};

  explicit Frames(Generator& generator) {
    const FootCycle& cycle = defaultLibrary().motions[2].cycle.feet[kLeft];
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 5; ++j)
        std::copy_n(randomRotation(generator).coeffs().data(), 4, rotations[i] + 4 * j);
      for (int k = 0; k < 3; ++k) position[3 * i + k] = uniform(generator, -0.3, 0.3);
      position[3 * i + 2] += 0.9;
      FootState& state = states[i];
      state.at = uniform(generator, 0.0, 2.0);
      for (FootPlace* place : {&state.from, &state.to}) {
        place->position = randomVector(generator, 0.3);
        place->heading = uniform(generator, -4.0, 4.0);
        place->normal = (Eigen::Vector3d::UnitZ() + randomVector(generator, 0.2)).normalized();
      }
      const Sole sole = soleOf(state, cycle, defaultLibrary().feet()[kLeft]);
      for (int k = 0; k < 3; ++k) {
        soles.position[4 * k + i] = sole.place.position[k];
        soles.normal[4 * k + i] = sole.place.normal[k];
      }
      soles.heading[i] = sole.place.heading;
      soles.pitch[i] = sole.pitch;
      soles.roll[i] = sole.roll;
      soles.toes[i] = sole.toes;
    }
  }

  void make(const LegKernel& kernel, const Leg& leg) {
    const double* p[4];
    double* q[4];
    for (int i = 0; i < 4; ++i) p[i] = position + 3 * i, q[i] = rotations[i];
    kernel.placeChain(leg.legs, p, q, frames);
    for (const LaneLeg& each : leg.legs.legs) kernel.aim(each, soles, frames);
    for (const LaneLeg& each : leg.legs.legs)
      std::fill_n(frames.targets[each.side].longest, 4, 0.8);
    kernel.lower(leg.legs, frames, missing);
    kernel.reach(leg.legs, frames, q, reached);
  }
};

TEST(LegLanes, AnklesAreAimedWhereFootTargetHasThem) {
  Generator generator(51);
  const Leg leg;
  const FootCycle& cycle = defaultLibrary().motions[2].cycle.feet[kLeft];
  for (int trial = 0; trial < 200; ++trial) {
    Frames four(generator);
    four.make(legKernel(), leg);
    const LaneLegFrames::Target& made = four.frames.targets[kLeft];
    for (int i = 0; i < 4; ++i) {
      const FootTarget exact = footTarget(four.states[i], cycle, leg.shape, {0, 0, 0}, 99.0);
      for (int k = 0; k < 3; ++k) ASSERT_NEAR(made.ankle[4 * k + i], exact.ankle[k], 1e-13);
      for (int k = 0; k < 4; ++k) ASSERT_NEAR(made.q_WF[4 * k + i], exact.q_WF.coeffs()[k], 1e-13);
      ASSERT_NEAR(made.toe[i], std::sin(0.5 * exact.toe_bend), 1e-13);
    }
  }
}

TEST(LegLanes, HipsAreOverTheirSolesWhereTheyAreInTheWorld) {
  Generator generator(53);
  const Leg leg;
  for (int trial = 0; trial < 200; ++trial) {
    Frames four(generator);
    four.make(legKernel(), leg);
    const LaneLegFrames::Target& made = four.frames.targets[kLeft];
    for (int i = 0; i < 4; ++i) {
      const auto at = [&](const double* quantity) {
        return Eigen::Vector3d(quantity[i], quantity[4 + i], quantity[8 + i]);
      };
      const Eigen::Quaterniond q_WS = soleFrame(four.soles.heading[i], at(four.soles.normal));
      const Eigen::Vector3d hip(four.frames.hip(leg.legs.legs[kLeft], 0, i),
                                four.frames.hip(leg.legs.legs[kLeft], 1, i),
                                four.frames.hip(leg.legs.legs[kLeft], 2, i));
      const Eigen::Vector3d away = hip - at(four.soles.position);
      EXPECT_NEAR((q_WS * at(made.hip_S) - away).norm(), 0.0, 1e-13);
      const Eigen::Vector3d ball = q_WS * Eigen::Vector3d(leg.shape.ball_x, 0.0, 0.0);
      const Eigen::Vector3d ahead = q_WS * Eigen::Vector3d::UnitX();
      EXPECT_NEAR(made.behind[i], (away - ball).head<2>().dot(ahead.head<2>()), 1e-13);
    }
  }
}

TEST(LegLanes, EveryInstructionSetTurnsLegsAlike) {
  if (avx2Legs() == nullptr) GTEST_SKIP() << "a machine without AVX2";
  Generator generator(52);
  const Leg leg;
  int reaching = 0;
  for (int trial = 0; trial < 200; ++trial) {
    Frames plain(generator);
    Frames quick = plain;
    quick.frames.joints = quick.joints;
    plain.make(kPlainLegs, leg);
    quick.make(*avx2Legs(), leg);
    for (int i = 0; i < 4; ++i) {
      ASSERT_EQ(plain.reached[i], quick.reached[i]);
      ASSERT_EQ(plain.missing[i], quick.missing[i]);
      const auto &one = plain.frames.targets[kLeft], &other = quick.frames.targets[kLeft];
      ASSERT_EQ(one.behind[i], other.behind[i]);
      for (const int k : {i, 4 + i, 8 + i}) ASSERT_EQ(one.hip_S[k], other.hip_S[k]);
      reaching += plain.reached[i];
      if (!plain.reached[i]) continue;
      ASSERT_TRUE(std::equal(plain.rotations[i], plain.rotations[i] + 20, quick.rotations[i]));
    }
  }
  EXPECT_GT(reaching, 50);
}

}  // namespace
}  // namespace amble
