#include "planner/legs/planner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <thread>

#include "base/rotation.h"
#include "planner/plan_walk.h"
#include "planner/roadmap/kept_roadmap.h"
#include "planner/steering/walk_steering.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

PlanRequest problemIn(const FurnishedRoom& room) {
  PlanRequest problem;
  problem.synthesizer = &room.synthesizer;
  problem.world = &room.world;
  problem.ground = &room.ground;
  problem.bounds = room.bounds;
  problem.limits.max_failures = 20;
  problem.refine = {false, 0};
  return problem;
}

const Planner& planner() {
  static const PlanRequest problem = problemIn(furnishedRoom());
  static const Planner made(problem);
  return made;
}

PlanEnd at(double x, double y, std::optional<double> heading = {}) {
  return {{x, y, 0}, heading, true};
}

// Through the passage and back, beside the table, within a room, with a via point, too near to
// walk, headings given and free; and what there is no walk for: onto the table, into the wall.
std::vector<PlanQuery> queries() {
  return {{at(1, 1, 90 * kDegree), at(5.3, 2.5, 0.0)},
          {at(5.3, 2.5), at(1, 1)},
          {at(3.7, 0.5, 0.0), at(5.5, 0.6)},
          {at(0.6, 3.4), at(2.2, 0.7, -2.0)},
          {at(1, 3), at(4, 3.2), {{1.5, 0.8, 0}}},
          {at(2, 2, 0.0), at(2.1, 2.05, 0.0)},
          {at(2, 2), at(4.5, 1.2)},
          {at(3, 1), at(1, 1)}};
}

PlanOutcome planAnew(const PlanQuery& query) {
  PlanRequest request = problemIn(furnishedRoom());
  request.start = query.start;
  request.goal = query.goal;
  request.via = query.via;
  return planWalk(request);
}

void expectSame(const PlanOutcome& a, const PlanOutcome& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.poses_checked, b.poses_checked);
  EXPECT_EQ(a.refusals, b.refusals);
  const AnimationBuffer &one = a.walk.buffer, &two = b.walk.buffer;
  ASSERT_EQ(one.size(), two.size());
  for (int i = 0; i < one.size(); ++i) {
    ASSERT_EQ(one.poses.p_WR(i), two.poses.p_WR(i));
    for (int j = 0; j < one.poses.joints(); ++j)
      ASSERT_EQ(one.poses.rotations(i)[j].coeffs(), two.poses.rotations(i)[j].coeffs());
  }
}

TEST(Planner, RefusesWhatCannotBeMeant) {
  EXPECT_THROW(Planner({}, {}), std::invalid_argument);
  KeptRoadmap nowhere;
  nowhere.edges = {{0, 1, 1.0}};
  EXPECT_THROW(Planner(problemIn(furnishedRoom()), nowhere), std::invalid_argument);
  SearchLimits limits = planner().limits();
  limits.threads = 0;
  EXPECT_THROW(planner().plan(queries().front(), limits), std::invalid_argument);
}

TEST(Planner, GivesAWalkWhereverAColdSearchDoesAndIsBlockedByTheSame) {
  for (const PlanQuery& query : queries()) {
    const PlanOutcome kept = planner().plan(query), cold = planAnew(query);
    EXPECT_EQ(kept.status, cold.status);
    EXPECT_EQ(kept.proved, cold.proved);
    ASSERT_EQ(kept.why.has_value(), cold.why.has_value());
    if (kept.why) {
      EXPECT_EQ(kept.why->object, cold.why->object);
    }
  }
}

// A roadmap that knows nothing is one that every query falls through.
TEST(Planner, WhatTheRoadmapDoesNotKnowIsSearchedAsWithoutIt) {
  const Planner empty(problemIn(furnishedRoom()), {});
  const PlanOutcome kept = empty.plan(queries().front()), cold = planAnew(queries().front());
  EXPECT_EQ(kept.status, PlanStatus::kSolved);
  EXPECT_EQ(kept.walk.buffer.size(), cold.walk.buffer.size());
  EXPECT_EQ(kept.guards, cold.guards);
}

TEST(Planner, WalksEndAtTheGoalAndTouchNothing) {
  const FurnishedRoom& room = furnishedRoom();
  const CollisionScratchPtr scratch = room.world.makeScratch();
  for (const PlanQuery& query : queries()) {
    const PlanOutcome outcome = planner().plan(query);
    if (outcome.status != PlanStatus::kSolved) continue;
    const Walk& walk = outcome.walk;
    EXPECT_EQ(walk.stances.back().position, query.goal.position);
    if (query.goal.heading) {
      EXPECT_EQ(walk.stances.back().heading, *query.goal.heading);
    }
    EXPECT_FALSE(room.world.check(walk.buffer.poses, walk.buffer.soles, false, *scratch));
  }
}

TEST(Planner, AnswersOfManyThreadsAreThoseOfEachQueryAlone) {
  const std::vector<PlanQuery> asked = queries();
  const KeptRoadmap roadmap = planner().roadmap();
  std::vector<PlanOutcome> alone;
  for (const PlanQuery& query : asked)
    alone.push_back(Planner(problemIn(furnishedRoom()), roadmap).plan(query));
  const Planner shared(problemIn(furnishedRoom()), roadmap);
  constexpr int kThreads = 4;
  std::vector<std::vector<PlanOutcome>> answers(kThreads, std::vector<PlanOutcome>(asked.size()));
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t) {
    threads.emplace_back([&, t] {  // each in an order of its own
      for (size_t i = 0; i < asked.size(); ++i) {
        const size_t which = (t % 2 == 0 ? i + 2 * t : 2 * asked.size() - 1 - i) % asked.size();
        answers[t][which] = shared.plan(asked[which]);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& list : answers)
    for (size_t i = 0; i < asked.size(); ++i) expectSame(list[i], alone[i]);
}

TEST(Planner, AStopEndsItsOwnQueryOnly) {
  const std::atomic<bool> stop{true};
  SearchLimits limits = planner().limits();
  limits.stop = &stop;
  const PlanOutcome stopped = planner().plan(queries().front(), limits);
  expectSame(planner().plan(queries().front()),
             Planner(problemIn(furnishedRoom()), planner().roadmap()).plan(queries().front()));
  EXPECT_TRUE(stopped.stopped);
}

TEST(Planner, ItsPictureDrawsEdgesFromNodeToNodeAsRootPathsGo) {
  const RoadmapPicture picture = planner().picture();
  int curved = 0;
  for (const RoadmapPicture::Edge& edge : picture.edges) {
    if (edge.line.empty()) continue;  // it only turns
    const auto place = [&](int node) -> Eigen::Vector2d {
      return picture.nodes[node].stance.position.head<2>();
    };
    EXPECT_LT((edge.line.front() - place(edge.from)).norm(), 1e-9);
    EXPECT_LT((edge.line.back() - place(edge.to)).norm(), 1e-6);
    const Eigen::Vector2d along = (place(edge.to) - place(edge.from)).normalized();
    double aside = 0.0;
    for (const Eigen::Vector2d& p : edge.line) {
      const Eigen::Vector2d off = p - place(edge.from);
      aside = std::max(aside, std::abs(along.x() * off.y() - along.y() * off.x()));
    }
    curved += aside > 0.02 ? 1 : 0;
  }
  EXPECT_GT(curved, 0);
}

}  // namespace
}  // namespace amble
