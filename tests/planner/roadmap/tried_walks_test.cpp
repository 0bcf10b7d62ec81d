#include "planner/roadmap/tried_walks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/sample_stream.h"
#include "tests/planner/disc_steering.h"
#include "tests/planner/search_limits_of.h"

namespace amble {
namespace {

std::vector<SteeringScratchPtr> scratchesOf(const Steering& steering, int threads) {
  std::vector<SteeringScratchPtr> scratches;
  for (int i = 0; i < threads; ++i) scratches.push_back(steering.makeScratch());
  return scratches;
}

std::vector<TriedWalk> passagesOf(const Steering& steering, const std::vector<StancePair>& pairs,
                                  int threads) {
  return tryPassages(steering, pairs, limitsOf(1, 60, threads), scratchesOf(steering, threads));
}

TriedCrossing crossingOf(const Steering& steering, int threads, double heading = 0.0) {
  const WayGuide::Narrow narrow{Eigen::Vector3d(4, 4.5, 0), heading, true};
  return tryCrossing(steering, narrow, limitsOf(1, 60, threads), scratchesOf(steering, threads));
}

void expectSame(const std::vector<TriedWalk>& a, const std::vector<TriedWalk>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].ends.first.position, b[i].ends.first.position);
    EXPECT_EQ(a[i].ends.second.position, b[i].ends.second.position);
    ASSERT_EQ(a[i].there.has_value(), b[i].there.has_value());
    ASSERT_EQ(a[i].back.has_value(), b[i].back.has_value());
    if (a[i].there) {
      EXPECT_EQ(a[i].there->edge.has_value(), b[i].there->edge.has_value());
    }
    if (a[i].back) {
      EXPECT_EQ(a[i].back->edge.has_value(), b[i].back->edge.has_value());
    }
  }
}

TEST(TriedWalks, EachDirectionOfAPassageIsTriedUntilItIsWalked) {
  DiscSteering steering;
  steering.doors = {{{2, -10}, {2, 10}}};  // crossed from its right, where x is more, only
  for (const int threads : {1, 2, 4}) {
    const auto tried =
        passagesOf(steering, {{standing(1, 0).stance, standing(3, 0).stance}}, threads);
    ASSERT_GT(tried.size(), 1u);
    for (size_t i = 0; i < tried.size(); ++i) {
      ASSERT_TRUE(tried[i].there);
      EXPECT_FALSE(tried[i].there->edge);
      EXPECT_EQ(tried[i].back.has_value(), i == 0);
    }
    EXPECT_TRUE(tried[0].back->edge);
  }
}

TEST(TriedWalks, PassagesAreTriedAlikeByAnyNumberOfThreads) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    DiscSteering steering;
    twoRooms(steering, 0.8);
    SampleStream random(seed, 0);
    std::vector<StancePair> pairs;
    for (int i = 0; i < 9; ++i) {
      const auto place = [&] {
        return standing(random.uniform(0, 8), random.uniform(0, 6), random.uniform(-3, 3)).stance;
      };
      pairs.push_back({place(), place()});
    }
    const auto one = passagesOf(steering, pairs, 1);
    const long long asked = steering.asked;
    for (const int threads : {2, 3, 8}) {
      steering.asked = 0;
      expectSame(one, passagesOf(steering, pairs, threads));
      EXPECT_EQ(steering.asked, asked) << "nothing is tried in vain";
    }
  }
}

TEST(TriedWalks, WhereThereIsRoomTheFirstCrossingIsWalked) {
  DiscSteering steering;
  twoRooms(steering, 1.2);
  for (const int threads : {1, 2, 4}) {
    const TriedCrossing crossing = crossingOf(steering, threads);
    EXPECT_EQ(crossing.outcome, TriedCrossing::Outcome::kWalked);
    ASSERT_EQ(crossing.tried.size(), 1u);
    EXPECT_TRUE(crossing.tried[0].isThere());
  }
}

TEST(TriedWalks, OnlyTheLastCrossingThatIsTriedIsWalkedAndItIsTheSameByAnyNumberOfThreads) {
  size_t most = 0;
  for (int i = 0; i <= 20; ++i) {
    DiscSteering steering;
    twoRooms(steering, 0.41);
    const double heading = 0.01 * i;  // of the way there, as far as it is known
    const TriedCrossing one = crossingOf(steering, 1, heading);
    for (const int threads : {2, 3, 8}) {
      const TriedCrossing other = crossingOf(steering, threads, heading);
      EXPECT_EQ(one.outcome, other.outcome);
      expectSame(one.tried, other.tried);
    }
    if (one.outcome != TriedCrossing::Outcome::kWalked) continue;
    for (size_t k = 0; k < one.tried.size(); ++k)
      EXPECT_EQ(one.tried[k].isThere(), k + 1 == one.tried.size());
    most = std::max(most, one.tried.size());
  }
  EXPECT_GT(most, 5u);
}

TEST(TriedWalks, AWallRefusesAndACrannyLeavesItUnknown) {
  DiscSteering wall;
  twoRooms(wall, 0.0);
  const TriedCrossing refused = crossingOf(wall, 2);
  EXPECT_EQ(refused.outcome, TriedCrossing::Outcome::kRefused);
  for (const TriedWalk& walk : refused.tried) EXPECT_FALSE(walk.isThere());
  DiscSteering cranny;
  twoRooms(cranny, 0.0);
  cranny.boxes.push_back(box(4, 0, 8, 6));  // nobody stands beyond
  const TriedCrossing unknown = crossingOf(cranny, 2);
  EXPECT_EQ(unknown.outcome, TriedCrossing::Outcome::kUnknown);
  EXPECT_TRUE(unknown.tried.empty());
}

TEST(TriedWalks, WhoIsStoppedTriesNothing) {
  DiscSteering steering;
  twoRooms(steering, 1.2);
  SearchLimits limits = limitsOf(1);
  limits.interrupted = [] { return true; };
  const auto scratches = scratchesOf(steering, 1);
  EXPECT_TRUE(
      tryPassages(steering, {{standing(1, 0).stance, standing(3, 0).stance}}, limits, scratches)
          .empty());
  const WayGuide::Narrow narrow{Eigen::Vector3d(4, 4.5, 0), 0.0, true};
  const TriedCrossing crossing = tryCrossing(steering, narrow, limits, scratches);
  EXPECT_EQ(crossing.outcome, TriedCrossing::Outcome::kUnknown);
  EXPECT_TRUE(crossing.tried.empty());
  EXPECT_EQ(steering.asked, 0);
}

}  // namespace
}  // namespace amble
