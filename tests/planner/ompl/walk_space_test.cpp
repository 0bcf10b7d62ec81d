#include "planner/ompl/walk_space.h"

#include <gtest/gtest.h>
#include <ompl/base/MotionValidator.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

#include "tests/planner/disc_steering.h"

namespace amble {
namespace {

class WalkSpaceTest : public testing::Test {
 protected:
  WalkSpaceTest() {
    twoRooms(steering, 0.8);
    steering.counts = true;
  }
  ompl::base::State* stateAt(double x, double y, double heading = 0.0) const {
    ompl::base::State* state = space->allocState();
    setWaypoint(*space, standing(x, y, heading), state);
    return state;  // which the space owns, and frees
  }
  DiscSteering steering;
  const OmplSpacePtr space = makeWalkSpace(steering, kRoom, 1);
};

TEST_F(WalkSpaceTest, AdmitsThatItIsNoMetricAndNotSymmetric) {
  EXPECT_FALSE(space->getStateSpace()->isMetricSpace());
  EXPECT_FALSE(space->getStateSpace()->hasSymmetricDistance());
  EXPECT_FALSE(space->getStateSpace()->hasSymmetricInterpolate());
  EXPECT_EQ(space->getStateSpace()->validSegmentCount(nullptr, nullptr), 1u);
}

TEST_F(WalkSpaceTest, StatesAreValidWhereTheBodyStandsWithinBounds) {
  EXPECT_TRUE(space->isValid(stateAt(1, 1)));
  EXPECT_FALSE(space->isValid(stateAt(4, 1)));   // in the wall
  EXPECT_FALSE(space->isValid(stateAt(20, 1)));  // free, but out of bounds
}

TEST_F(WalkSpaceTest, MotionsAreValidInTheDirectionThatIsWalked) {
  steering.doors = {{{4, 0}, {4, 6}}};  // from right to left only
  const auto *left = stateAt(3, 4.5), *right = stateAt(5, 4.5);
  EXPECT_TRUE(space->checkMotion(right, left));
  EXPECT_FALSE(space->checkMotion(left, right));
  EXPECT_EQ(effortOf(*space).refused.size(), 1u);
}

TEST_F(WalkSpaceTest, AMotionIsSteeredOnceWhateverCopiesAreAsked) {
  const auto *from = stateAt(1, 1), *to = stateAt(3, 2);
  EXPECT_TRUE(space->checkMotion(from, to));
  const long long asked = steering.asked;
  ompl::base::State *copy_from = space->cloneState(from), *copy_to = space->cloneState(to);
  EXPECT_TRUE(space->checkMotion(copy_from, copy_to));
  EXPECT_EQ(motionOf(*space, copy_from, copy_to).edge->to.position, waypointOf(to).stance.position);
  EXPECT_EQ(steering.asked, asked);
  space->checkMotion(to, from);  // the way back is another question
  EXPECT_EQ(steering.asked, asked + 1);
}

TEST_F(WalkSpaceTest, AStateThatIsWrittenAgainIsAnotherPlace) {
  const auto* from = stateAt(1, 1);
  ompl::base::State* to = stateAt(3, 2);
  EXPECT_TRUE(space->checkMotion(from, to));
  setWaypoint(*space, standing(7, 1), to);
  EXPECT_FALSE(space->checkMotion(from, to));
}

TEST_F(WalkSpaceTest, BetweenTwoStatesOneFacesTheWayThere) {
  const auto *a = stateAt(1, 1, 2.0), *b = stateAt(1, 3, 1.0);
  ompl::base::State* between = space->allocState();
  space->getStateSpace()->interpolate(a, b, 0.5, between);
  EXPECT_NEAR(waypointOf(between).stance.heading, 90 * kDegree, 1e-12);
  space->getStateSpace()->interpolate(b, a, 0.5, between);
  EXPECT_NEAR(waypointOf(between).stance.heading, -90 * kDegree, 1e-12);
  space->getStateSpace()->interpolate(a, b, 1.0, between);
  EXPECT_EQ(waypointOf(between).stance.heading, 1.0);
}

TEST_F(WalkSpaceTest, SamplesAreThoseOfTheRoadmapsSampler) {
  const auto sampler = space->allocStateSampler();
  const SteeringScratchPtr scratch = steering.makeScratch();
  ompl::base::State* state = space->allocState();
  for (std::uint64_t index = 0; index < 20; ++index) {
    sampler->sampleUniform(state);
    const auto sample = samplerOf(*space).draw(1, index, *scratch);
    ASSERT_TRUE(sample.has_value());
    EXPECT_EQ(waypointOf(state).stance.position, sample->stance.position);
  }
  EXPECT_EQ(effortOf(*space).samples, 20);
}

TEST_F(WalkSpaceTest, SamplesNearAPlaceLieNearItHeadedFromThere) {
  const auto sampler = space->allocStateSampler();
  const auto* near = stateAt(4, 3);
  ompl::base::State* state = space->allocState();
  for (int i = 0; i < 50; ++i) {
    sampler->sampleUniformNear(state, near, 1.5);
    const Stance& stance = waypointOf(state).stance;
    const Eigen::Vector3d way = stance.position - waypointOf(near).stance.position;
    EXPECT_LE(way.norm(), 1.5);
    EXPECT_NEAR(wrapAngle(stance.heading - std::atan2(way.y(), way.x())), 0.0, 1e-9);
  }
}

TEST_F(WalkSpaceTest, RestartForgetsEdgesAndEffort) {
  const auto *from = stateAt(1, 1), *to = stateAt(3, 2);
  space->checkMotion(from, to);
  restart(*space, 2);
  EXPECT_EQ(effortOf(*space).steering.asked, 0);
  const long long asked = steering.asked;
  space->checkMotion(from, to);
  EXPECT_EQ(steering.asked, asked + 1);
}

TEST_F(WalkSpaceTest, DistanceIsTheWayAndTheTurnAndNeverLessThanTheWay) {
  const auto& states = *space->getStateSpace();
  const auto *a = stateAt(1, 1, 0.3), *b = stateAt(3, 2, -2.0), *turned = stateAt(1, 1, 1.3);
  EXPECT_EQ(states.distance(a, a), 0.0);
  EXPECT_GE(states.distance(a, b), std::sqrt(5.0));
  EXPECT_GT(states.distance(a, turned), 0.0);
  EXPECT_LE(states.distance(a, b), states.getMaximumExtent());
  Waypoint any = standing(3, 2);
  any.any_heading = true;
  ompl::base::State* free = space->allocState();
  setWaypoint(*space, any, free);
  EXPECT_DOUBLE_EQ(states.distance(a, free), std::sqrt(5.0));
  EXPECT_TRUE(states.equalStates(a, stateAt(1, 1, 0.3)));
  EXPECT_FALSE(states.equalStates(a, turned));
}

TEST_F(WalkSpaceTest, WhatIsOutOfBoundsIsBroughtToTheirEdge) {
  for (const auto& [x, y] : {std::pair{20.0, 3.0}, std::pair{-5.0, 9.0}, std::pair{4.0, -1.0}}) {
    ompl::base::State* state = stateAt(x, y, 1.0);
    EXPECT_FALSE(space->satisfiesBounds(state));
    space->enforceBounds(state);
    EXPECT_TRUE(space->satisfiesBounds(state));
    const Eigen::Vector2d p = waypointOf(state).stance.position.head<2>();
    EXPECT_DOUBLE_EQ((p - Eigen::Vector2d(x, y)).norm(),
                     kRoom.exteriorDistance(Eigen::Vector2d(x, y)));
    EXPECT_EQ(waypointOf(state).stance.heading, 1.0);
  }
  ompl::base::State* within = stateAt(2, 2, 0.5);
  const long long asked = steering.asked;
  space->checkMotion(within, stateAt(3, 2));
  space->enforceBounds(within);  // is no other place then
  EXPECT_EQ(waypointOf(within).stance.position, Eigen::Vector3d(2, 2, 0));
  EXPECT_EQ(steering.asked, asked + 1);
}

TEST_F(WalkSpaceTest, OfARefusedMotionTheLastValidStateIsItsBegin) {
  const auto *from = stateAt(1, 1), *to = stateAt(7, 1);
  ompl::base::State* last = space->allocState();
  std::pair<ompl::base::State*, double> end{last, 0.5};
  EXPECT_FALSE(space->getMotionValidator()->checkMotion(from, to, end));
  EXPECT_EQ(end.second, 0.0);
  EXPECT_EQ(waypointOf(last).stance.position, waypointOf(from).stance.position);
  end = {nullptr, 0.5};
  EXPECT_FALSE(space->getMotionValidator()->checkMotion(from, to, end));
  EXPECT_EQ(space->getMotionValidator()->getInvalidMotionCount(), 2u);
}

TEST_F(WalkSpaceTest, AnEdgeThatIsLearntIsNeverAsked) {
  const auto *from = stateAt(1, 1), *to = stateAt(7, 1);  // which steering would refuse
  WalkEdge edge;
  edge.length = 42.0;
  learnEdge(*space, from, to, edge);
  EXPECT_TRUE(space->checkMotion(from, to));
  EXPECT_EQ(motionOf(*space, from, to).edge->length, 42.0);
  EXPECT_EQ(steering.asked, 0);
}

TEST_F(WalkSpaceTest, ASeedSaysWhatIsDrawn) {
  const auto drawn = [&](std::uint64_t seed) {
    restart(*space, seed);
    EXPECT_EQ(seedOf(*space), seed);
    const auto sampler = space->allocStateSampler();
    ompl::base::State* state = space->allocState();
    std::vector<Eigen::Vector3d> places;
    for (int i = 0; i < 10; ++i) {
      sampler->sampleUniform(state);
      places.push_back(waypointOf(state).stance.position);
      EXPECT_TRUE(space->satisfiesBounds(state));
    }
    return places;
  };
  EXPECT_EQ(drawn(5), drawn(5));
  EXPECT_NE(drawn(5), drawn(6));
}

}  // namespace
}  // namespace amble
