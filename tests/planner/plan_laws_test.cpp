// What holds of any walk that is planned: it joins its ends, goes along with the room, and gets no
// longer by refinement.
#include <gtest/gtest.h>

#include <cmath>

#include "base/rotation.h"
#include "planner/plan_walk.h"
#include "tests/environments/random_scenes.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

struct PlacedRoom {
  explicit PlacedRoom(const Eigen::Isometry3d& X_WRoom = Eigen::Isometry3d::Identity(),
                      std::vector<SceneObject> objects = furnishedScene().objects)
      : X(X_WRoom), room(sceneOf(movedObjects(std::move(objects), X_WRoom))) {}

  PlanEnd end(double x, double y, std::optional<double> heading = {}) const {
    const double turn = std::atan2(X.linear()(1, 0), X.linear()(0, 0));
    PlanEnd end;
    end.position = X * Eigen::Vector3d(x, y, 0);
    if (heading) end.heading = wrapAngle(*heading + turn);
    return end;
  }
  PlanRequest request(const PlanEnd& start, const PlanEnd& goal) const {
    PlanRequest request;
    request.synthesizer = &room.synthesizer;
    request.world = &room.world;
    request.ground = &room.ground;
    for (const double x : {0.0, 6.0})
      for (const double y : {0.0, 4.0})
        request.bounds.extend((X * Eigen::Vector3d(x, y, 0)).head<2>());
    request.start = start;
    request.goal = goal;
    request.limits.max_failures = 40;
    request.refine.tries = 15;
    return request;
  }

  Eigen::Isometry3d X;
  FurnishedRoom room;
};

// Within the western half of the room, where nothing is; its ends far enough for a walk.
std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> freePairs() {
  return {{{0.8, 0.8}, {2.2, 3.2}}, {{2.2, 0.7}, {0.7, 3.3}}, {{0.6, 2.0}, {2.3, 2.0}}};
}

TEST(PlanLaws, WhereNothingIsBetweenAndHeadingsAreFreeAWalkIsStraight) {
  const PlacedRoom here;
  for (const auto& [a, b] : freePairs()) {
    const PlanOutcome outcome =
        planWalk(here.request(here.end(a.x(), a.y()), here.end(b.x(), b.y())));
    ASSERT_EQ(outcome.status, PlanStatus::kSolved);
    EXPECT_NEAR(outcome.walk.path.length(), (b - a).norm(), 1e-6);
    EXPECT_EQ(outcome.samples, 0);
  }
}

TEST(PlanLaws, AStraightWalkIsTheSameWhereverTheRoomLies) {
  const PlacedRoom here;
  for (const double turn : {0.5 * kPi, 1.1}) {
    const PlacedRoom there(turnedAndMoved(turn, {40, -25, 3}));
    for (const auto& [a, b] : freePairs()) {
      const auto walkIn = [&, from = a, to = b](const PlacedRoom& room) {
        return planWalk(room.request(room.end(from.x(), from.y()), room.end(to.x(), to.y())));
      };
      const PlanOutcome one = walkIn(here), two = walkIn(there);
      ASSERT_EQ(two.status, PlanStatus::kSolved);
      ASSERT_EQ(one.walk.buffer.size(), two.walk.buffer.size());
      for (int i = 0; i < one.walk.buffer.size(); i += 5) {
        EXPECT_LT((there.X * one.walk.buffer.poses.p_WR(i) - two.walk.buffer.poses.p_WR(i)).norm(),
                  1e-6)
            << i;
      }
    }
  }
}

// Around the wall: a search, whose samples go along with the room.
TEST(PlanLaws, AWalkAroundThingsIsHardlyLongerWhereverTheRoomLies) {
  const PlacedRoom here;
  const auto lengthIn = [](const PlacedRoom& room) {
    const PlanOutcome outcome =
        planWalk(room.request(room.end(1, 1, 0.5 * kPi), room.end(5.3, 2.5, -0.5 * kPi)));
    EXPECT_EQ(outcome.status, PlanStatus::kSolved);
    return outcome.walk.path.length();
  };
  const double length = lengthIn(here);
  EXPECT_GT(length, 5.5);
  for (const Eigen::Vector3d& by : {Eigen::Vector3d(16, -8, 0), Eigen::Vector3d(-32, 4, 2)})
    EXPECT_NEAR(lengthIn(PlacedRoom(turnedAndMoved(0.0, by))), length, 0.05 * length);
  EXPECT_NEAR(lengthIn(PlacedRoom(turnedAndMoved(kPi, {0, 0, 0}))), length, 0.15 * length);
}

// People are not quite the same on both sides.
TEST(PlanLaws, InAMirroredRoomAWalkIsAboutAsLong) {
  const PlacedRoom here,
      mirror(Eigen::Isometry3d::Identity(), mirroredObjects(furnishedScene().objects));
  PlanRequest request = here.request(here.end(1, 1, 0.5 * kPi), here.end(5.3, 2.5, -0.5 * kPi));
  const PlanOutcome one = planWalk(request);
  request = mirror.request(here.end(1, -1, -0.5 * kPi), here.end(5.3, -2.5, 0.5 * kPi));
  request.bounds = {Eigen::Vector2d(0, -4), Eigen::Vector2d(6, 0)};
  const PlanOutcome two = planWalk(request);
  ASSERT_EQ(one.status, PlanStatus::kSolved);
  ASSERT_EQ(two.status, PlanStatus::kSolved);
  EXPECT_NEAR(two.walk.path.length(), one.walk.path.length(), 0.15 * one.walk.path.length());
}

TEST(PlanLaws, TheWalkBeginsAndEndsWhereItWasAskedAndItsNodesFollowItsPath) {
  const PlacedRoom here;
  const std::vector<std::pair<PlanEnd, PlanEnd>> problems = {
      {here.end(1, 1, 0.0), here.end(5.3, 2.5)},
      {here.end(5.3, 2.5), here.end(0.8, 3.2, 2.0)},
      {here.end(3.7, 0.5, -1.0), here.end(2.2, 3.4, 1.0)}};
  for (const auto& [start, goal] : problems) {
    const PlanOutcome outcome = planWalk(here.request(start, goal));
    ASSERT_EQ(outcome.status, PlanStatus::kSolved);
    const Walk& walk = outcome.walk;
    ASSERT_GE(walk.stances.size(), 2u);
    EXPECT_LT((walk.stances.front().position - start.position).norm(), 1e-9);
    EXPECT_LT((walk.stances.back().position - goal.position).norm(), 1e-9);
    if (start.heading) {
      EXPECT_NEAR(wrapAngle(walk.stances.front().heading - *start.heading), 0.0, 1e-9);
    }
    if (goal.heading) {
      EXPECT_NEAR(wrapAngle(walk.stances.back().heading - *goal.heading), 0.0, 1e-9);
    }
    const double length = walk.path.length();
    EXPECT_LT((walk.path.at(0.0).position - start.position.head<2>()).norm(), 1e-8);
    EXPECT_LT((walk.path.at(length).position - goal.position.head<2>()).norm(), 1e-8);
    // From node to node no path is shorter than the straight line.
    double straight = 0.0;
    for (size_t i = 1; i < walk.stances.size(); ++i)
      straight += (walk.stances[i].position - walk.stances[i - 1].position).norm();
    EXPECT_GE(length, straight - 1e-6);
    for (double s = 0.0; s + 0.05 < length; s += 0.05) {
      const Eigen::Vector2d way = walk.path.at(s + 0.05).position - walk.path.at(s).position;
      EXPECT_LE(way.norm(), 0.05 + 1e-6) << s;
    }
  }
}

TEST(PlanLaws, RefinementMakesNoWalkLonger) {
  const PlacedRoom here;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    PlanRequest request = here.request(here.end(1, 1, 0.0), here.end(5.3, 2.5, 1.0));
    request.limits.seed = seed;
    request.comfort = 0.0;  // of an even floor a walk costs its time alone
    std::vector<int> frames;
    for (const RefineSettings& refine :
         {RefineSettings{false, 0}, RefineSettings{true, 0}, RefineSettings{true, 20}}) {
      request.refine = refine;
      const PlanOutcome outcome = planWalk(request);
      ASSERT_EQ(outcome.status, PlanStatus::kSolved);
      frames.push_back(outcome.walk.buffer.size());
    }
    EXPECT_LE(frames[1], frames[0]) << seed;
    EXPECT_LE(frames[2], frames[0]) << seed;
  }
}

TEST(PlanLaws, AViaPointOnTheWalkIsPassedAndOneAsideMakesItLonger) {
  const PlacedRoom here;
  PlanRequest request = here.request(here.end(0.6, 0.6), here.end(2.3, 3.3));
  const double straight = planWalk(request).walk.path.length();
  for (const Eigen::Vector3d& via : {Eigen::Vector3d(0.7, 3.2, 0), Eigen::Vector3d(2.3, 0.8, 0)}) {
    request.via = {via};
    const PlanOutcome outcome = planWalk(request);
    ASSERT_EQ(outcome.status, PlanStatus::kSolved);
    double nearest = HUGE_VAL;
    const double length = outcome.walk.path.length();
    for (double s = 0.0; s <= length; s += 0.002)
      nearest = std::min(nearest, (outcome.walk.path.at(s).position - via.head<2>()).norm());
    EXPECT_LT(nearest, 0.002);
    EXPECT_GE(length,
              (via - request.start.position).norm() + (request.goal.position - via).norm() - 1e-6);
    EXPECT_GT(length, straight);
  }
}

TEST(PlanLaws, CountsOfAnOutcomeFitItsRoadmap) {
  const PlacedRoom here;
  const PlanOutcome outcome =
      planWalk(here.request(here.end(1, 1, 0.5 * kPi), here.end(5.3, 2.5, -0.5 * kPi)));
  const int nodes = static_cast<int>(outcome.roadmap.nodes.size());
  EXPECT_EQ(static_cast<int>(outcome.roadmap.edges.size()), outcome.edges);
  const auto count = [&](NodeKind kind) {
    return std::count_if(outcome.roadmap.nodes.begin(), outcome.roadmap.nodes.end(),
                         [&](const RoadmapPicture::Node& node) { return node.kind == kind; });
  };
  EXPECT_EQ(count(NodeKind::kGuard), outcome.guards);
  EXPECT_EQ(count(NodeKind::kConnector), outcome.connectors);
  for (const RoadmapPicture::Edge& edge : outcome.roadmap.edges) {
    ASSERT_TRUE(edge.from >= 0 && edge.from < nodes && edge.to >= 0 && edge.to < nodes);
    if (edge.line.empty()) continue;
    const auto plan = [&](int node) -> Eigen::Vector2d {
      return outcome.roadmap.nodes[node].stance.position.head<2>();
    };
    EXPECT_LT((edge.line.front() - plan(edge.from)).norm(), 1e-6);
    EXPECT_LT((edge.line.back() - plan(edge.to)).norm(), 1e-6);
  }
  EXPECT_GE(outcome.coverage, 0.0);
  EXPECT_LE(outcome.coverage, 1.0);
  EXPECT_LE(static_cast<int>(outcome.roadmap.refused.size()), RoadmapPicture::kMostRefused);
}

// Across an open hall, in lanes: who turns before he walks, and after, needs no room beside them.
TEST(PlanLaws, RootPathsStayWithinWhatTheyMayNotLeave) {
  const PlacedRoom hall(Eigen::Isometry3d::Identity(),
                        {boxObject("floor", {8, 6, 0.1}, {4, 3, -0.05})});
  for (const double half : {0.1, 0.4, 1.0}) {
    for (const double heading_deg : {0.0, 90.0, 180.0, -60.0}) {
      PlanRequest request = hall.request(hall.end(1, 3, heading_deg * kDegree),
                                         hall.end(7, 3 + 0.9 * half, 90 * kDegree));
      request.limits.max_failures = 60;
      request.refine.tries = 40;
      request.bounds = {Eigen::Vector2d(0.9, 3 - half), Eigen::Vector2d(7.1, 3 + half)};
      const auto beyond = [&] {
        const PlanOutcome outcome = planWalk(request);
        EXPECT_EQ(outcome.status, PlanStatus::kSolved) << half << " " << heading_deg;
        double most = 0.0;
        for (const FrameState& state : outcome.walk.buffer.states)
          most = std::max(most, request.bounds.exteriorDistance(state.position.head<2>().eval()));
        return most;
      };
      const double anywhere = beyond();
      if (heading_deg == 90.0 && half < 1.0) {
        EXPECT_GT(anywhere, 0.02) << half;
      }
      request.within = request.bounds;
      EXPECT_LT(beyond(), 1e-8) << half << " " << heading_deg;
    }
  }
}

TEST(PlanLaws, WhatIsInTheWayNowhereNearChangesNoWalk) {
  auto objects = furnishedScene().objects;
  const PlacedRoom here;
  objects.push_back(boxObject("shed", {2, 2, 2}, {40, 40, 1}));
  objects.push_back(boxObject("lamp", {0.3, 0.3, 0.3}, {1.5, 2, 2.4}));
  const PlacedRoom there(Eigen::Isometry3d::Identity(), objects);
  const auto plan = [](const PlacedRoom& room) {
    return planWalk(room.request(room.end(1, 1, 0.0), room.end(0.8, 3.2, 3.0)));
  };
  const PlanOutcome one = plan(here), two = plan(there);
  ASSERT_EQ(one.status, PlanStatus::kSolved);
  ASSERT_EQ(one.walk.buffer.size(), two.walk.buffer.size());
  for (int i = 0; i < one.walk.buffer.size(); ++i)
    ASSERT_EQ(one.walk.buffer.poses.p_WR(i), two.walk.buffer.poses.p_WR(i));
}

}  // namespace
}  // namespace amble
