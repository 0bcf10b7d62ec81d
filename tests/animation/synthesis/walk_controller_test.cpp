#include "animation/synthesis/walk_controller.h"

#include <gtest/gtest.h>

#include <map>

#include "animation/library/motion_library_reader.h"
#include "base/rotation.h"
#include "tests/animation/default_library.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

const GaitBlend& blend() {
  static const GaitBlend kBlend(defaultLibrary(), 1.0);
  return kBlend;
}

Eigen::VectorXd standChannels() {
  Eigen::VectorXd channels = Eigen::VectorXd::Zero(3 + 3 * defaultLibrary().skeleton.size());
  channels[2] = 0.93;
  return channels;
}

const WalkController& controllerOf(double lead = 0.0) {
  static const Eigen::VectorXd kStand = standChannels();
  static const CapturedTurns kNoTurns;
  static std::map<double, WalkController> controllers;
  const auto& reference = defaultLibrary().stand().rotations;
  return controllers.try_emplace(lead, blend(), kNoTurns, reference, kStand, lead).first->second;
}

/// One frame, posed.
Pose posed(const WalkController& controller, const FrameState& state) {
  AnimationBuffer buffer;
  buffer.poses = PoseArray(defaultLibrary().skeleton.size());
  buffer.poses.resize(1);
  buffer.states = {state};
  EXPECT_TRUE(controller.apply(buffer));
  const PoseView view = buffer.poses[0];
  return {view.p_WR, {view.rotations.begin(), view.rotations.end()}};
}

FrameState walking(double phase) {
  FrameState state;
  state.position = {1, -2, 0.5};
  state.heading = 0.7;
  state.phase = phase;
  state.turn_rate = state.blended_turn_rate = 0.3;
  state.step_length = 0.6;
  return state;
}

/// Channels of one frame, as a pose.
Pose projected(const Eigen::VectorXd& channels, const std::vector<Eigen::Quaterniond>& reference,
               const FrameState& state) {
  PoseArray poses(static_cast<int>(reference.size()));
  poses.resize(1);
  std::vector<double> values;
  for (const double c : channels) values.insert(values.end(), 4, c);
  projectChannels(values, reference, {&state, &state, &state, &state}, {0, 0, 0, 0}, poses);
  return {poses.p_WR(0), {poses.rotations(0).begin(), poses.rotations(0).end()}};
}

FrameState randomState(Generator& generator) {
  FrameState state;
  state.position = randomVector(generator, 3.0);
  state.heading = uniform(generator, -4.0, 4.0);
  state.lean = uniform(generator, -0.3, 0.3);
  return state;
}

Eigen::Quaterniond leant(const FrameState& state) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(
      state.lean, Eigen::Vector3d(-std::sin(state.heading), std::cos(state.heading), 0.0)));
}

TEST(ProjectChannels, IsTheReferenceTurnedByRotationVectorsOnThePathsPointAndHeading) {
  Generator generator(91);
  const std::vector<Eigen::Quaterniond> reference = {
      randomRotation(generator), randomRotation(generator), randomRotation(generator)};
  Eigen::VectorXd channels(12);
  for (double size : {0.5, 3.0}) {  // turns by up to 50 and by up to 300 degrees
    for (double& c : channels) c = uniform(generator, -size, size);
    const FrameState state = randomState(generator);
    const Pose pose = projected(channels, reference, state);
    EXPECT_LT(
        (pose.p_WR - state.position - aboutZ(state.heading) * Eigen::Vector3d(channels.head<3>()))
            .norm(),
        1e-14);
    for (int j = 0; j < 3; ++j) {
      const Eigen::Vector3d v = channels.segment<3>(3 + 3 * j);
      const double angle = v.norm();
      Eigen::Quaterniond expected =
          reference[j] * Eigen::Quaterniond(Eigen::AngleAxisd(angle, v / angle));
      if (j == 0) expected = leant(state) * aboutZ(state.heading) * expected;
      EXPECT_LT((pose.rotations[j].coeffs() - expected.coeffs()).norm(), 2e-15);
    }
  }
}

TEST(ProjectChannels, ZeroChannelsAreTheReferenceItself) {
  FrameState state;
  state.position = {1, 2, 3};
  const std::vector<Eigen::Quaterniond>& reference = defaultLibrary().stand().rotations;
  const Pose pose =
      projected(Eigen::VectorXd::Zero(3 + 3 * defaultLibrary().skeleton.size()), reference, state);
  EXPECT_EQ(pose.p_WR, Eigen::Vector3d(1, 2, 3));
  for (size_t j = 0; j < reference.size(); ++j)
    EXPECT_EQ(pose.rotations[j].coeffs(), reference[j].coeffs());
}

TEST(WalkController, WalkingItIsTheBlendedCycleOnTheRootPath) {
  const FrameState state = walking(0.35);
  const Pose pose = posed(controllerOf(), state);
  Eigen::VectorXd channels;
  blend().evaluate(0.35, 0.3, 0.6, channels);
  const Pose expected = projected(channels, defaultLibrary().stand().rotations, state);
  EXPECT_EQ(pose.p_WR, expected.p_WR);
  for (size_t j = 0; j < pose.rotations.size(); ++j) {
    EXPECT_EQ(pose.rotations[j].coeffs(), expected.rotations[j].coeffs());
  }
}

TEST(WalkController, StandingItDoesNotDependOnTheCycle) {
  FrameState one = walking(0.1), two = walking(0.8);
  two.turn_rate = -1.0;
  two.step_length = 0.3;
  one.posture = two.posture = 1.0;
  const Pose a = posed(controllerOf(), one), b = posed(controllerOf(), two);
  EXPECT_EQ(a.p_WR, b.p_WR);
  EXPECT_NEAR(a.p_WR.z(), one.position.z() + 0.93, 1e-15);
  for (size_t j = 0; j < a.rotations.size(); ++j) {
    EXPECT_EQ(a.rotations[j].coeffs(), b.rotations[j].coeffs());
  }
}

TEST(WalkController, StandingIsMixedInEvenly) {
  FrameState state = walking(0.2);
  const double walk = posed(controllerOf(), state).p_WR.z();
  state.posture = 0.25;
  const double mixed = posed(controllerOf(), state).p_WR.z();
  EXPECT_NEAR(mixed, 0.75 * walk + 0.25 * (state.position.z() + 0.93), 1e-12);
}

TEST(WalkController, CyclesAreBlendedForTheBlendedTurnRateAlone) {
  FrameState state = walking(0.2), turning = state, blended = state;
  turning.turn_rate = 0.4;
  blended.blended_turn_rate = 0.4;
  EXPECT_EQ(posed(controllerOf(), state).p_WR, posed(controllerOf(), turning).p_WR);
  EXPECT_NE(posed(controllerOf(), state).p_WR, posed(controllerOf(), blended).p_WR);
}

TEST(WalkController, SwayMovesTheRootToTheLeft) {
  FrameState state = walking(0.2);
  const Eigen::Vector3d before = posed(controllerOf(), state).p_WR;
  state.sway = 0.03;
  const Eigen::Vector3d moved = posed(controllerOf(), state).p_WR - before;
  EXPECT_LT((moved - aboutZ(state.heading) * Eigen::Vector3d(0, 0.03, 0)).norm(), 1e-12);
}

TEST(WalkController, TheWalkingRootLeadsAndTheStandingOneDoesNot) {
  FrameState state = walking(0.0);
  const Eigen::Vector3d moved =
      posed(controllerOf(0.02), state).p_WR - posed(controllerOf(), state).p_WR;
  EXPECT_LT((moved - aboutZ(state.heading) * Eigen::Vector3d(0.02, 0, 0)).norm(), 1e-12);
  state.posture = 1.0;
  EXPECT_EQ(posed(controllerOf(0.02), state).p_WR, posed(controllerOf(), state).p_WR);
}

}  // namespace
}  // namespace amble
