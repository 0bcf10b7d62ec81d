#include "planner/refinement/walk_proposals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/planner/edge_paths.h"

namespace amble {
namespace {

// The same walk turned about the origin, moved, or seen in a mirror.
struct Seen {
  double turn = 0.0;
  Eigen::Vector2d by{0, 0};
  double side = 1.0;  // -1: in the mirror that swaps left and right

  Eigen::Vector2d operator()(const Eigen::Vector2d& p) const {
    return Eigen::Rotation2Dd(turn) * Eigen::Vector2d(p.x(), side * p.y()) + by;
  }
  double heading(double angle) const { return wrapAngle(side * angle + turn); }
};

EdgePath drawnWalk(std::uint64_t seed, int count = 6, const Seen& seen = {}) {
  std::vector<Waypoint> places = drawnPlaces(seed, count);
  for (Waypoint& place : places) {
    place.stance.position.head<2>() = seen(place.stance.position.head<2>());
    place.stance.heading = seen.heading(place.stance.heading);
  }
  return pathOver(DiscSteering(), places);
}

using Proposals = std::vector<Proposal>;

Proposals allOf(const WalkProposals& proposals, const EdgePath& path) {
  Proposals all = proposals.shortcuts();
  const auto add = [&](const Proposals& more) { all.insert(all.end(), more.begin(), more.end()); };
  for (int i = 0; i < path.last(); ++i) add(proposals.asideOfEdge(i));
  for (int i = 1; i < path.last(); ++i) add(proposals.passings(i));
  for (int i = 1; i < path.last(); ++i) add(proposals.besideNode(i));
  return all;
}

// Whether the stance of one proposal is that of another, as it is seen.
bool isSeenAs(const Proposal& a, const Proposal& b, const Seen& seen) {
  if (a.first != b.first || a.last != b.last || a.between.size() != b.between.size()) return false;
  for (size_t i = 0; i < a.between.size(); ++i) {
    const Stance &one = a.between[i], &two = b.between[i];
    if ((seen(inPlan(one)) - inPlan(two)).norm() > 1e-6 ||
        std::abs(wrapAngle(seen.heading(one.heading) - two.heading)) > 1e-6 ||
        one.pace != two.pace || one.standing != two.standing)
      return false;
  }
  return true;
}

TEST(WalkProposals, EachReplacesAStretchOfTheWalk) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const EdgePath path = drawnWalk(seed);
    WalkProposals proposals(path, seed);
    Proposals all = allOf(proposals, path);
    for (int index = 0; index < 300; ++index)
      if (const auto one = proposals.random(0, index)) all.push_back(*one);
    EXPECT_GT(all.size(), 300u);
    for (const Proposal& proposal : all) {
      EXPECT_GE(proposal.first, 0);
      EXPECT_LT(proposal.first, proposal.last);
      EXPECT_LE(proposal.last, path.last());
      // Something is left out, or something is new.
      EXPECT_TRUE(!proposal.between.empty() || proposal.last - proposal.first >= 2);
      for (const Stance& stance : proposal.between) {
        EXPECT_TRUE(stance.position.allFinite());
        EXPECT_GT(stance.pace, 0.0);
        EXPECT_LE(stance.pace, 1.0);
      }
    }
  }
}

TEST(WalkProposals, ShortcutsJoinEveryTwoNodesTheWidestApartFirst) {
  for (const int count : {2, 3, 5, 8}) {
    const EdgePath path = drawnWalk(4, count);
    const Proposals shortcuts = WalkProposals(path, 4).shortcuts();
    const int last = path.last();
    EXPECT_EQ(static_cast<int>(shortcuts.size()), last * (last - 1) / 2);
    for (size_t i = 0; i < shortcuts.size(); ++i) {
      EXPECT_TRUE(shortcuts[i].between.empty());
      EXPECT_GE(shortcuts[i].last - shortcuts[i].first, 2);
      if (i == 0) continue;
      const auto order = [](const Proposal& p) { return std::pair(p.first - p.last, p.first); };
      EXPECT_LT(order(shortcuts[i - 1]), order(shortcuts[i]));
    }
  }
}

TEST(WalkProposals, NoShortcutIsLongerThanTwentyMetres) {
  const EdgePath path = drawnWalk(5, 20);  // 34 m
  const Proposals shortcuts = WalkProposals(path, 5).shortcuts();
  int joined_nodes = 0;
  for (int a = 0; a <= path.last(); ++a)
    for (int b = a + 2; b <= path.last(); ++b)
      joined_nodes += (inPlan(path.node(a).stance) - inPlan(path.node(b).stance)).norm() <= 20.0;
  EXPECT_EQ(static_cast<int>(shortcuts.size()), joined_nodes);
  EXPECT_LT(joined_nodes, path.last() * (path.last() - 1) / 2);
}

TEST(WalkProposals, OneWalksByANodeWithinTheCornerThatTheWalkHasThere) {
  for (const std::uint64_t seed : {6, 7, 8}) {
    const EdgePath path = drawnWalk(seed);
    for (int i = 1; i < path.last(); ++i) {
      const Eigen::Vector2d a = inPlan(path.node(i - 1).stance), b = inPlan(path.node(i).stance),
                            c = inPlan(path.node(i + 1).stance);
      Eigen::Matrix2d sides;
      sides << a - b, c - b;
      for (const Proposal& proposal : WalkProposals(path, seed).passings(i)) {
        EXPECT_EQ(proposal.first, i - 1);
        EXPECT_EQ(proposal.last, i + 1);
        for (const Stance& stance : proposal.between) {
          const Eigen::Vector2d share = sides.inverse() * (inPlan(stance) - b);
          EXPECT_GE(share.minCoeff(), -1e-9);
          EXPECT_LE(share.sum(), 1.0 + 1e-9);
        }
      }
    }
  }
}

TEST(WalkProposals, APinnedPlaceIsPassedExactly) {
  EdgePath path = drawnWalk(9);
  path.pinned[2] = true;
  const WalkProposals proposals(path, 9);
  const Eigen::Vector2d place = inPlan(path.node(2).stance);
  const Proposals passings = proposals.passings(2);
  EXPECT_GE(passings.size(), 3u);
  for (const Proposal& proposal : passings) {
    ASSERT_EQ(proposal.between.size(), 1u);
    EXPECT_EQ(inPlan(proposal.between[0]), place);
  }
}

TEST(WalkProposals, StandingAtANodeIsProposedLastTurnedForOneOfItsEdges) {
  const EdgePath path = drawnWalk(10);
  for (int i = 1; i < path.last(); ++i) {
    const Proposals passings = WalkProposals(path, 10).passings(i);
    const size_t count = passings.size();
    for (size_t k = 0; k < count; ++k) {
      for (const Stance& stance : passings[k].between) EXPECT_EQ(stance.standing, k + 2 >= count);
    }
    const auto along = [&](int a, int b) {
      const Eigen::Vector2d way = inPlan(path.node(b).stance) - inPlan(path.node(a).stance);
      return std::atan2(way.y(), way.x());
    };
    EXPECT_EQ(passings[count - 2].between[0].position, path.node(i).stance.position);
    EXPECT_NEAR(passings[count - 2].between[0].heading, along(i - 1, i), 1e-12);
    EXPECT_NEAR(passings[count - 1].between[0].heading, along(i, i + 1), 1e-12);
  }
}

TEST(WalkProposals, WithoutHurryingLessEveryoneWalksAtThePlansSpeed) {
  const EdgePath path = drawnWalk(11);
  WalkProposals proposals(path, 11);
  const auto slowest = [&] {
    double pace = 1.0;
    Proposals all = allOf(proposals, path);
    for (int index = 0; index < 200; ++index)
      if (const auto one = proposals.random(1, index)) all.push_back(*one);
    for (const Proposal& proposal : all)
      for (const Stance& stance : proposal.between) pace = std::min(pace, stance.pace);
    return pace;
  };
  EXPECT_EQ(slowest(), 1.0);
  const size_t usual = proposals.passings(1).size();
  proposals.walkSlower(true);
  EXPECT_LT(slowest(), 1.0);
  EXPECT_GT(proposals.passings(1).size(), usual);
}

TEST(WalkProposals, TheFixedOnesGoAlongWithTheWalk) {
  for (const std::uint64_t seed : {12, 13}) {
    const Seen elsewhere{2.1, {30, -17}};
    const EdgePath here = drawnWalk(seed), there = drawnWalk(seed, 6, elsewhere);
    const Proposals a = allOf(WalkProposals(here, seed), here),
                    b = allOf(WalkProposals(there, seed), there);
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(isSeenAs(a[i], b[i], elsewhere)) << i;
  }
}

// What is tried to the left is tried to the right.
TEST(WalkProposals, OfAMirroredWalkTheFixedOnesAreMirrored) {
  const Seen mirror{0.0, {0, 0}, -1.0};
  const EdgePath here = drawnWalk(14), there = drawnWalk(14, 6, mirror);
  const Proposals a = allOf(WalkProposals(here, 14), here),
                  b = allOf(WalkProposals(there, 14), there);
  ASSERT_EQ(a.size(), b.size());
  for (const Proposal& one : a) {
    EXPECT_TRUE(std::any_of(b.begin(), b.end(),
                            [&](const Proposal& two) { return isSeenAs(one, two, mirror); }));
  }
}

TEST(WalkProposals, RandomOnesGoAlongWithAWalkThatIsMoved) {
  const Seen elsewhere{0.0, {-12, 5}};
  const EdgePath here = drawnWalk(15), there = drawnWalk(15, 6, elsewhere);
  const WalkProposals a(here, 15), b(there, 15);
  for (int index = 0; index < 200; ++index) {
    const auto one = a.random(2, index), two = b.random(2, index);
    ASSERT_EQ(one.has_value(), two.has_value());
    if (one) {
      EXPECT_TRUE(isSeenAs(*one, *two, elsewhere)) << index;
    }
  }
}

TEST(WalkProposals, ARandomOneIsOfItsSeedRoundAndIndexAlone) {
  const EdgePath path = drawnWalk(16);
  const WalkProposals one(path, 16), same(path, 16), other(path, 17);
  int differ_by_seed = 0, differ_by_round = 0, made = 0;
  for (int index = 99; index >= 0; --index) {
    const auto a = one.random(0, index), b = same.random(0, index);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) continue;
    ++made;
    EXPECT_TRUE(isSeenAs(*a, *b, {}));
    const auto by_seed = other.random(0, index), by_round = one.random(1, index);
    differ_by_seed += !by_seed || !isSeenAs(*a, *by_seed, {});
    differ_by_round += !by_round || !isSeenAs(*a, *by_round, {});
  }
  EXPECT_GT(made, 50);
  EXPECT_GT(differ_by_seed, made - 5);
  EXPECT_GT(differ_by_round, made - 5);
}

TEST(WalkProposals, OfAWalkOfOneEdgeNoNodeIsMovedOrLeftOut) {
  const EdgePath path = drawnWalk(18, 2);
  const WalkProposals proposals(path, 18);
  EXPECT_TRUE(proposals.shortcuts().empty());
  for (int index = 0; index < 50; ++index) {
    const auto one = proposals.random(0, index);
    ASSERT_TRUE(one);
    EXPECT_EQ(one->first, 0);
    EXPECT_EQ(one->last, 1);
    EXPECT_EQ(one->between.size(), 1u);
  }
}

TEST(WalkProposals, AsideOfAnEdgeIsBesideItToBothSidesAsFar) {
  const EdgePath path = drawnWalk(19);
  for (int i = 0; i < path.last(); ++i) {
    const Eigen::Vector2d from = inPlan(path.node(i).stance), to = inPlan(path.node(i + 1).stance);
    const Eigen::Vector2d along = (to - from).normalized(), left(-along.y(), along.x());
    double sum = 0.0;
    for (const Proposal& proposal : WalkProposals(path, 19).asideOfEdge(i)) {
      const Eigen::Vector2d off = inPlan(proposal.between.at(0)) - from;
      EXPECT_GT(off.dot(along), 0.0);
      EXPECT_LT(off.dot(along), (to - from).norm());
      EXPECT_GT(std::abs(off.dot(left)), 0.05);
      sum += off.dot(left);
    }
    EXPECT_NEAR(sum, 0.0, 1e-6);
  }
}

}  // namespace
}  // namespace amble
