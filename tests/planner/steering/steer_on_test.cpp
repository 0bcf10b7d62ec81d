// WalkSteering's answers to who looks ahead: they are those to who does not, but for edges that
// lead nowhere.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/rotation.h"
#include "base/sample_stream.h"
#include "planner/refine_walk.h"
#include "planner/steering/walk_steering.h"
#include "tests/planner/edge_paths.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

// One that never looks ahead.
class BlindSteering : public WalkSteering {
 public:
  using WalkSteering::WalkSteering;
  SteerResult steerOn(const Waypoint& from, const Waypoint& to, double most, const LeadsOn&,
                      SteeringScratch& scratch) const override {
    return steerWithin(from, to, most, scratch);
  }
  bool mayLead(const Waypoint&, const Waypoint&, double, SteeringScratch&) const override {
    return true;
  }
};

class SteerOn : public testing::Test {
 protected:
  // Not far from the middle of the room, on either side of its wall, standing or walking.
  static Waypoint anywhere(SampleStream& stream) {
    Waypoint at;
    at.stance.position << stream.uniform(0.8, 5.2), stream.uniform(0.6, 3.6), 0.0;
    at.stance.heading = stream.uniform(-kPi, kPi);
    at.stance.standing = stream.uniform() < 0.3;
    at.any_leading = true;
    return at;
  }
  // Headed to within 30 degrees of one another's way, that some edges pass.
  static std::pair<Waypoint, Waypoint> anyPair(SampleStream& stream) {
    std::pair<Waypoint, Waypoint> pair = {anywhere(stream), anywhere(stream)};
    const Eigen::Vector3d way = pair.second.stance.position - pair.first.stance.position;
    for (Waypoint* at : {&pair.first, &pair.second}) {
      at->stance.heading = std::atan2(way.y(), way.x()) + stream.uniform(-30.0, 30.0) * kDegree;
    }
    return pair;
  }
  static double usual(const std::pair<Waypoint, Waypoint>& pair) {
    return (pair.second.stance.position - pair.first.stance.position).norm() / 1.2;
  }

  const FurnishedRoom& room = furnishedRoom();
  const WalkSteering steering{room.synthesizer, room.world, room.ground};
  const SteeringScratchPtr scratch = steering.makeScratch();
};

TEST_F(SteerOn, WhereNothingMayLeadThereIsNoEdge) {
  SampleStream stream(3, 0);
  int none = 0, edges = 0;
  for (int i = 0; i < 200; ++i) {
    const auto pair = anyPair(stream);
    for (const double most : {HUGE_VAL, usual(pair) + 1.0, 0.9 * usual(pair)}) {
      const bool may = steering.mayLead(pair.first, pair.second, most, *scratch);
      const SteerResult result = steering.steerWithin(pair.first, pair.second, most, *scratch);
      EXPECT_TRUE(may || !result.edge) << i;
      none += may ? 0 : 1;
      edges += result.edge ? 1 : 0;
    }
  }
  EXPECT_GT(none, 100);
  EXPECT_GT(edges, 50);
}

// Who can go on from the one foot only is given the edge that ends on it, or told that the edge
// ends on the other.
TEST_F(SteerOn, AnEdgeFromWhichOneCanGoOnIsTheSame) {
  SampleStream stream(5, 0);
  int same = 0, nowhere = 0;
  for (int i = 0; i < 300; ++i) {
    const auto pair = anyPair(stream);
    const SteerResult any = steering.steerWithin(pair.first, pair.second, HUGE_VAL, *scratch);
    for (const Side side : {kLeft, kRight}) {
      double planned = HUGE_VAL;  // the least of all that are
      const Steering::LeadsOn leads_on = [&](const WalkEdge& edge) {
        planned = std::min(planned, edge.duration);
        return edge.to.standing || edge.to.leading == side;
      };
      const SteerResult on =
          steering.steerOn(pair.first, pair.second, HUGE_VAL, leads_on, *scratch);
      if (on.leads_nowhere) {
        ++nowhere;
        EXPECT_FALSE(on.edge) << i;
        EXPECT_TRUE(!any.edge || any.edge->to.leading != side) << i;
        continue;
      }
      ASSERT_EQ(on.edge.has_value(), any.edge.has_value()) << i;
      if (!on.edge) continue;
      ++same;
      EXPECT_EQ(on.edge->cost(), any.edge->cost()) << i;
      EXPECT_EQ(on.edge->to.leading, any.edge->to.leading) << i;
      EXPECT_LE(planned, on.edge->cost() + 1e-9) << i;
    }
  }
  EXPECT_GT(same, 50);
  EXPECT_GT(nowhere, 30);
}

TEST_F(SteerOn, WalksAreRefinedTheSameWithoutLookingAhead) {
  const BlindSteering blind(room.synthesizer, room.world, room.ground);
  const auto at = [](double x, double y, double heading_deg) {
    Waypoint place;
    place.stance.position << x, y, 0.0;
    place.stance.heading = heading_deg * kDegree;
    return place;
  };
  const EdgePath path = pathOver(steering, {at(1.0, 0.8, 90), at(1.2, 3.5, 0), at(4.8, 3.5, 0),
                                            at(5.4, 2.6, -90), at(5.4, 0.8, -90)});
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SearchLimits limits;
    limits.seed = seed;
    SteeringCount ahead, not_ahead;
    const EdgePath one = refineWalk(steering, path, {true, 40}, limits, ahead);
    const EdgePath other = refineWalk(blind, path, {true, 40}, limits, not_ahead);
    ASSERT_EQ(one.edges.size(), other.edges.size());
    for (size_t i = 0; i < one.edges.size(); ++i) {
      EXPECT_EQ(one.edges[i].to.position, other.edges[i].to.position);
      EXPECT_EQ(one.edges[i].to.heading, other.edges[i].to.heading);
      EXPECT_EQ(one.edges[i].to.leading, other.edges[i].to.leading);
      EXPECT_EQ(one.edges[i].cost(), other.edges[i].cost());
    }
    EXPECT_LT(one.duration(), path.duration());
    EXPECT_LT(ahead.poses, not_ahead.poses);
  }
}

}  // namespace
}  // namespace amble
