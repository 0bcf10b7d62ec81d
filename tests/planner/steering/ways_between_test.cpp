#include "planner/steering/ways_between.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/rotation.h"
#include "base/sample_stream.h"

namespace amble {
namespace {

Waypoint drawnWaypoint(SampleStream& random) {
  Waypoint at;
  at.stance.position << random.uniform(-5, 5), random.uniform(-5, 5), 0.0;
  at.stance.heading = random.uniform(-kPi, kPi);
  at.stance.standing = random.below(2) == 0;
  at.stance.leading = random.below(2) == 0 ? kLeft : kRight;
  at.any_heading = random.below(4) == 0;
  at.any_leading = random.below(2) == 0;
  return at;
}

double ahead(const Waypoint& from, const Waypoint& to) {
  const Eigen::Vector3d way = to.stance.position - from.stance.position;
  return std::atan2(way.y(), way.x());
}

template <typename Visit>
void forDrawnPairs(std::uint64_t seed, Visit visit) {
  SampleStream random(seed, 0);
  for (int n = 0; n < 400; ++n) {
    const Waypoint from = drawnWaypoint(random), to = drawnWaypoint(random);
    visit(from, to);
  }
}

// Who walks leaves and arrives as he is headed; who stands may turn first.
TEST(WaysBetween, TurnOnTheSpotOnlyWhereOneStandsOrIsFree) {
  int ways = 0;
  forDrawnPairs(1, [&](const Waypoint& from, const Waypoint& to) {
    for (const Way& way : waysBetween(from, to)) {
      ++ways;
      if (!from.stance.standing && !from.any_heading) {
        EXPECT_NEAR(wrapAngle(way.leave - from.stance.heading), 0.0, 1e-9);
      }
      if (!to.stance.standing && !to.any_heading) {
        EXPECT_NEAR(wrapAngle(way.arrive - to.stance.heading), 0.0, 1e-9);
      }
    }
  });
  EXPECT_GT(ways, 400);
}

TEST(WaysBetween, BetweenPlacesWhereOneStandsThereIsAlwaysTheStraightOne) {
  forDrawnPairs(2, [](Waypoint from, Waypoint to) {
    from.stance.standing = to.stance.standing = true;
    const std::vector<Way> ways = waysBetween(from, to);
    ASSERT_FALSE(ways.empty());
    EXPECT_NEAR(wrapAngle(ways.back().leave - ahead(from, to)), 0.0, 1e-12);
    EXPECT_NEAR(wrapAngle(ways.back().arrive - ahead(from, to)), 0.0, 1e-12);
    EXPECT_LE(ways.size(), 2u);
  });
}

TEST(WaysBetween, FreeHeadingsAtBothEndsLeadStraightAndNoOtherWay) {
  forDrawnPairs(3, [](Waypoint from, Waypoint to) {
    from.any_heading = to.any_heading = true;
    const std::vector<Way> ways = waysBetween(from, to);
    ASSERT_EQ(ways.size(), 1u);
    const WalkEdge edge = makeEdge(from, to, ways[0]);
    EXPECT_EQ(edge.turn_first, 0.0);
    EXPECT_EQ(edge.turn_last, 0.0);
    EXPECT_NEAR(edge.length, (to.stance.position - from.stance.position).norm(), 1e-9);
  });
}

TEST(WaysBetween, NoCurveIsALoop) {
  forDrawnPairs(4, [](const Waypoint& from, const Waypoint& to) {
    const double straight = ahead(from, to);
    for (const Way& way : waysBetween(from, to)) {
      EXPECT_LE(std::abs(wrapAngle(way.leave - straight)), 100.001 * kDegree);
      EXPECT_LE(std::abs(wrapAngle(way.arrive - straight)), 100.001 * kDegree);
      EXPECT_GE(way.handle, 0.1);
      EXPECT_LE(way.handle, 2.0);
    }
  });
}

// To a place behind one who walks no curve leads.
TEST(WaysBetween, BehindOneWhoWalksAndMayNotTurnThereIsNone) {
  forDrawnPairs(5, [](Waypoint from, Waypoint to) {
    from.stance.standing = to.stance.standing = false;
    from.any_heading = false;
    from.stance.heading = wrapAngle(ahead(from, to) + kPi);
    EXPECT_TRUE(waysBetween(from, to).empty());
  });
}

TEST(WaysBetween, TurnAndMoveWithTheirEnds) {
  SampleStream random(6, 1);
  forDrawnPairs(6, [&](const Waypoint& from, const Waypoint& to) {
    const double turn = random.uniform(-3, 3);
    const Eigen::Vector3d by(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-1, 1));
    const auto elsewhere = [&](Waypoint at) {
      at.stance.position = aboutZ(turn) * at.stance.position + by;
      at.stance.heading = wrapAngle(at.stance.heading + turn);
      return at;
    };
    const auto here = waysBetween(from, to), there = waysBetween(elsewhere(from), elsewhere(to));
    ASSERT_EQ(here.size(), there.size());
    for (size_t i = 0; i < here.size(); ++i) {
      EXPECT_NEAR(wrapAngle(there[i].leave - here[i].leave - turn), 0.0, 1e-9);
      EXPECT_NEAR(wrapAngle(there[i].arrive - here[i].arrive - turn), 0.0, 1e-9);
      EXPECT_NEAR(makeEdge(from, to, here[i]).length,
                  makeEdge(elsewhere(from), elsewhere(to), there[i]).length, 1e-8);
    }
  });
}

TEST(WaysBetween, InAMirrorAreMirrored) {
  forDrawnPairs(7, [](const Waypoint& from, const Waypoint& to) {
    const auto mirrored = [](Waypoint at) {
      at.stance.position.y() *= -1.0;
      at.stance.heading *= -1.0;
      return at;
    };
    const auto here = waysBetween(from, to), there = waysBetween(mirrored(from), mirrored(to));
    ASSERT_EQ(here.size(), there.size());
    for (size_t i = 0; i < here.size(); ++i) {
      EXPECT_NEAR(wrapAngle(there[i].leave + here[i].leave), 0.0, 1e-9);
      EXPECT_NEAR(wrapAngle(there[i].arrive + here[i].arrive), 0.0, 1e-9);
      EXPECT_EQ(there[i].handle, here[i].handle);
    }
  });
}

// Back along the same curve, by the other foot's heading: turned round at both ends.
TEST(WaysBetween, WhereBothStandThereAreAsManyBack) {
  forDrawnPairs(8, [](Waypoint from, Waypoint to) {
    from.stance.standing = to.stance.standing = true;
    from.any_heading = to.any_heading = false;
    const auto round = [](Waypoint at) {
      at.stance.heading = wrapAngle(at.stance.heading + kPi);
      return at;
    };
    const auto there = waysBetween(from, to), back = waysBetween(round(to), round(from));
    ASSERT_EQ(there.size(), back.size());
    for (size_t i = 0; i < there.size(); ++i)
      EXPECT_NEAR(makeEdge(from, to, there[i]).length,
                  makeEdge(round(to), round(from), back[i]).length, 1e-8);
  });
}

TEST(MakeEdge, ItsPathJoinsItsEndsAndItsTurnsMakeUpTheRest) {
  forDrawnPairs(9, [](const Waypoint& from, const Waypoint& to) {
    for (const Way& way : waysBetween(from, to)) {
      const WalkEdge edge = makeEdge(from, to, way);
      EXPECT_EQ(edge.from.position, from.stance.position);
      EXPECT_EQ(edge.to.position, to.stance.position);
      const auto begin = edge.path.at(0.0), end = edge.path.at(edge.length);
      EXPECT_LT((begin.position - from.stance.position.head<2>()).norm(), 1e-8);
      EXPECT_LT((end.position - to.stance.position.head<2>()).norm(), 1e-8);
      EXPECT_NEAR(wrapAngle(edge.from.heading + edge.turn_first - begin.heading), 0.0, 1e-6);
      EXPECT_NEAR(wrapAngle(end.heading + edge.turn_last - edge.to.heading), 0.0, 1e-6);
      EXPECT_LE(std::abs(edge.turn_first), kPi + 1e-12);
      EXPECT_LE(std::abs(edge.turn_last), kPi + 1e-12);
      EXPECT_GE(edge.length, (to.stance.position - from.stance.position).norm() * (1.0 - 1e-9));
      EXPECT_EQ(edge.any_leading, to.any_leading);
    }
  });
}

TEST(MakeEdge, AnEndThatIsNotFreeKeepsItsHeading) {
  forDrawnPairs(10, [](const Waypoint& from, const Waypoint& to) {
    for (const Way& way : waysBetween(from, to)) {
      const WalkEdge edge = makeEdge(from, to, way);
      EXPECT_EQ(edge.from.heading, from.any_heading ? way.leave : from.stance.heading);
      EXPECT_EQ(edge.to.heading, to.any_heading ? way.arrive : to.stance.heading);
    }
  });
}

TEST(MakeTurn, TurnsTheShorterWayFromOneHeadingToTheOther) {
  forDrawnPairs(11, [](const Waypoint& from, const Waypoint& to) {
    const WalkEdge edge = makeTurn(from, to);
    EXPECT_TRUE(edge.path.empty());
    EXPECT_LE(std::abs(edge.turn_first), kPi + 1e-12);
    EXPECT_NEAR(wrapAngle(edge.from.heading + edge.turn_first - edge.to.heading), 0.0, 1e-9);
    if (from.any_heading || to.any_heading) {
      EXPECT_EQ(edge.turn_first, 0.0);
    }
    EXPECT_NEAR(edge.length, (to.stance.position - from.stance.position).norm(), 1e-12);
    const double back = makeTurn(to, from).turn_first;
    EXPECT_NEAR(wrapAngle(edge.turn_first + back), 0.0, 1e-9);
  });
}

TEST(OnOneFloor, IsForTwoWhoStandOnOneLevelAndTheSameBothWays) {
  SampleStream random(12, 1);
  forDrawnPairs(12, [&](const Waypoint& from, Waypoint to) {
    to.stance.position.z() = random.uniform(-0.1, 0.1);
    const bool both_stand = from.stance.standing && to.stance.standing;
    const bool level = std::abs(to.stance.position.z()) < 0.03;
    EXPECT_EQ(onOneFloor(from, to), both_stand && level);
    EXPECT_EQ(onOneFloor(to, from), onOneFloor(from, to));
  });
}

TEST(IsThere, IsForOneWhoWalksByThatHeadingAndThatFoot) {
  forDrawnPairs(13, [](Waypoint from, Waypoint to) {
    to.stance.position = from.stance.position;
    const bool walk = !from.stance.standing && !to.stance.standing;
    const bool free = from.any_heading || to.any_heading;
    const bool foot = to.any_leading || to.stance.leading == from.stance.leading;
    EXPECT_EQ(isThere(from, to), walk && foot && free);
    to.stance.heading = wrapAngle(from.stance.heading + 2 * kPi);
    EXPECT_EQ(isThere(from, to), walk && foot);
  });
}

}  // namespace
}  // namespace amble
