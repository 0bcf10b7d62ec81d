// What is shut off stays so: both ways, with more things about, and by a flood of ours over the
// balls that the body holds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <queue>

#include "animation/steps/step_placer.h"
#include "planner/steering/body_reach.h"
#include "planner/steering/straight_walk.h"
#include "tests/environments/random_scenes.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

// The furnished room's floor and walls, two walls across it with a gap each, one of them
// narrow where the seed is odd, and boxes about.
Scene crowdedRoom(std::uint64_t seed, int boxes) {
  Scene scene = furnishedScene();
  scene.objects.resize(5);
  SampleStream random(seed, 0);
  for (const double x : {2.2, 3.8}) {
    const bool narrow = x < 3.0 && seed % 2 == 1;
    const double gap = narrow ? random.uniform(0.02, 0.08) : random.uniform(0.6, 1.0);
    const double low = random.uniform(0.5, 2.5);
    const double high = low + gap;
    scene.objects.push_back(boxObject("south of a gap", {0.1, low, 2}, {x, 0.5 * low, 1}));
    scene.objects.push_back(boxObject("north", {0.1, 4 - high, 2}, {x, 0.5 * (4 + high), 1}));
  }
  for (int i = 0; i < boxes; ++i) {
    const Eigen::Vector3d size(random.uniform(0.1, 0.6), random.uniform(0.3, 1.2),
                               random.uniform(0.3, 1.6));
    const Eigen::Vector3d at(random.uniform(1.5, 4.5), random.uniform(0, 4),
                             random.uniform(0.1, 1.5));
    scene.objects.push_back(boxObject("box " + std::to_string(i), size, at));
  }
  return scene;
}

const std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> kEnds = {
    {{0.6, 2, 0}, {5.4, 2, 0}}, {{0.6, 0.6, 0}, {5.4, 3.4, 0}}, {{0.6, 3.4, 0}, {5.4, 0.6, 0}}};

// With the walker of the furnished room, whose floor it has.
struct Crowded {
  Crowded(std::uint64_t seed, int boxes) : scene(crowdedRoom(seed, boxes)) {}
  bool isShut(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    return barrier(from, to, 1).has_value();
  }
  std::optional<BodyReach::Barrier> barrier(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                            int threads) const {
    std::vector<CollisionScratchPtr> scratches;
    std::vector<CollisionScratch*> each;
    for (int i = 0; i < threads; ++i) {
      scratches.push_back(world.makeScratch());
      each.push_back(scratches.back().get());
    }
    return reach.barrier(from, to, world, ground, each, [] { return false; });
  }

  const FurnishedRoom& home = furnishedRoom();
  Scene scene;
  SceneGround ground{scene, 0.0};
  CollisionWorld world{scene, ground, home.synthesizer.skeleton(), home.body};
  CollisionScratchPtr scratch = world.makeScratch();
  ReachedGround reached{ground, {0.6, 2.0, 0.0}, 1.0};
  NearGround near{ground, reached, 1.0, BodyReach::kLegsBeyond};
  BodyReach reach{
      straightWalk(home.synthesizer),
      home.synthesizer.skeleton(),
      home.synthesizer.roles(),
      home.body,
      home.synthesizer.stature(),
      {ground.settings().limits.highestStep(), 1.0, StepPlacer::kHighestLift,
       home.synthesizer.tooHighToSwingOver(), home.synthesizer.feet()[kLeft].half_width}};
};

TEST(BodyReachLaws, WhatIsShutOffIsSoBothWays) {
  int shut = 0, open = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Crowded crowded(seed, 3);
    for (const auto& [a, b] : kEnds) {
      const bool there = crowded.isShut(a, b);
      EXPECT_EQ(crowded.isShut(b, a), there) << seed;
      (there ? shut : open) += 1;
    }
  }
  EXPECT_GT(shut, 2);
  EXPECT_GT(open, 2);
}

TEST(BodyReachLaws, MoreThingsOpenNothing) {
  int shut_by_few = 0;
  for (std::uint64_t seed = 11; seed <= 13; ++seed) {
    const Crowded few(seed, 1), many(seed, 6);  // the first of the same boxes
    for (const auto& [a, b] : kEnds) {
      if (few.isShut(a, b)) {
        ++shut_by_few;
        EXPECT_TRUE(many.isShut(a, b)) << seed;
      }
    }
  }
  EXPECT_GT(shut_by_few, 0);
}

// Whether a ball gets from one place to the other by places, a few centimetres apart, at which it
// touches nothing; from and to any that are as near to the ends as the body may hold it.
bool ballPasses(const Crowded& crowded, const BodyReach::Ball& ball, const Eigen::Vector3d& from,
                const Eigen::Vector3d& to, CollisionScratch& scratch) {
  constexpr double kApart = 0.04;
  constexpr int kColumns = 150, kRows = 100;
  const auto middle = [](int i, int j) -> Eigen::Vector2d {
    return {kApart * (i + 0.5), kApart * (j + 0.5)};
  };
  // At some height at least of those at which it may be, with all that is over it.
  const auto isStackFree = [&](int i, int j, double lifted) {
    return std::ranges::none_of(ball.stack.balls, [&](const StackedBall& own) {
      Eigen::Vector3d at;
      at << middle(i, j), own.height + lifted;
      return crowded.world.touched(at, at, own.radius, scratch) >= 0;
    });
  };
  const auto isFree = [&](int i, int j) {
    for (int k = 0; k <= 8; ++k) {
      const double highest = BodyReach::kRise + ball.stack.sway;
      const double lifted = highest - (highest + BodyReach::kDip + ball.stack.sway) * k / 8;
      if (!ball.stack.balls.empty() && isStackFree(i, j, lifted)) return true;
      if (!ball.stack.balls.empty()) continue;
      Eigen::Vector3d low, high;
      low << middle(i, j), ball.height + (ball.highest - ball.height) * k / 8;
      high << middle(i, j), low.z() + ball.top - ball.highest;
      if (crowded.world.touched(low, high, ball.radius, scratch) < 0) return true;
    }
    return false;
  };
  std::vector<char> seen(kColumns * kRows, 0);
  std::queue<std::pair<int, int>> open;
  const auto reach = [&](int i, int j) {
    if (i < 0 || j < 0 || i >= kColumns || j >= kRows || seen[j * kColumns + i]) return;
    seen[j * kColumns + i] = 1;
    if (isFree(i, j)) open.emplace(i, j);
  };
  for (int j = 0; j < kRows; ++j)
    for (int i = 0; i < kColumns; ++i)
      if ((middle(i, j) - from.head<2>()).norm() <= ball.aside) reach(i, j);
  while (!open.empty()) {
    const auto [i, j] = open.front();
    open.pop();
    if ((middle(i, j) - to.head<2>()).norm() <= ball.aside) return true;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) reach(i + dx, j + dy);
  }
  return false;
}

TEST(BodyReachLaws, WhatShutsOffIsTheSameAtAnyNumberOfThreads) {
  int shut = 0;
  for (std::uint64_t seed = 31; seed <= 36; ++seed) {
    const Crowded crowded(seed, 6);
    for (const auto& [from, to] : kEnds) {
      const auto one = crowded.barrier(from, to, 1);
      shut += one.has_value();
      for (const int threads : {2, 5}) {
        const auto other = crowded.barrier(from, to, threads);
        ASSERT_EQ(other.has_value(), one.has_value()) << seed;
        if (!one) continue;
        EXPECT_EQ(other->part, one->part);
        EXPECT_EQ(other->object, one->object);
        EXPECT_EQ(other->at, one->at);
        EXPECT_EQ(other->near, one->near);
        EXPECT_EQ(other->far, one->far);
      }
    }
  }
  EXPECT_GT(shut, 2);
}

TEST(BodyReachLaws, WhereEveryBallPassesByAFineFloodNothingIsShutOff) {
  int passable = 0, shut = 0;
  for (std::uint64_t seed = 21; seed <= 24; ++seed) {
    const Crowded crowded(seed, 2);
    const auto& balls = crowded.reach.balls();
    ASSERT_FALSE(balls.empty());
    for (const auto& [a, b] : kEnds) {
      bool passes = true;
      for (const BodyReach::Ball& ball : balls)
        passes = passes && ballPasses(crowded, ball, a, b, *crowded.scratch);
      const bool is_shut = crowded.isShut(a, b);
      shut += is_shut;
      passable += passes;
      if (passes) {
        EXPECT_FALSE(is_shut) << seed;
      }
    }
  }
  EXPECT_GT(passable, 1);
  EXPECT_GT(shut, 1);
}

// What holds every ball, wherever one of them is, between the heights given.
UprightPost postAround(const std::vector<BodyReach::Ball>& balls) {
  UprightPost post{HUGE_VAL, 0.0, 1.0, 0.0, HUGE_VAL};
  for (const BodyReach::Ball& ball : balls) {
    post.low = std::min(post.low, ball.height);
    post.high = std::max(post.high, ball.top);
    post.radius = std::max(post.radius, ball.radius);
    post.aside = std::min(post.aside, ball.aside);
  }
  return post;
}

TEST(BodyReachLaws, WhereTheWayIsOpenEveryBallPassesByAFineFlood) {
  int open = 0, closed = 0;
  for (std::uint64_t seed = 31; seed <= 36; ++seed) {
    const Crowded crowded(seed, 2);
    const auto& balls = crowded.reach.balls();
    ASSERT_FALSE(balls.empty());
    for (const auto& [a, b] : kEnds) {
      const bool is_open =
          isOpenWay(a, b, postAround(balls), 0.1, crowded.world, crowded.ground, crowded.reached,
                    crowded.near, *crowded.scratch, [] { return false; });
      (is_open ? open : closed) += 1;
      if (!is_open) continue;
      for (const BodyReach::Ball& ball : balls)
        EXPECT_TRUE(ballPasses(crowded, ball, a, b, *crowded.scratch)) << seed;
      EXPECT_FALSE(isOpenWay(a, b, postAround(balls), 0.1, crowded.world, crowded.ground,
                             crowded.reached, crowded.near, *crowded.scratch, [] { return true; }))
          << "who is stopped knows nothing";
    }
  }
  EXPECT_GT(open, 2);
  EXPECT_GT(closed, 2);
}

}  // namespace
}  // namespace amble
