#include "planner/refinement/edge_path.h"

#include <gtest/gtest.h>

#include "tests/planner/edge_paths.h"

namespace amble {
namespace {

TEST(EdgePath, LengthsAndDurationsAddUpAndEveryNodeIsAnEdgesEnd) {
  for (const std::uint64_t seed : {20, 21}) {
    EdgePath path = pathOver(DiscSteering(), drawnPlaces(seed, 7));
    path.edges[2].from.standing = path.edges[1].to.standing = false;
    double length = 0.0, duration = 0.0;
    for (const WalkEdge& edge : path.edges) {
      length += edge.length;
      duration += edge.duration;
    }
    EXPECT_NEAR(path.length(), length, 1e-12);
    EXPECT_NEAR(path.duration(), duration, 1e-12);
    EXPECT_EQ(path.last(), 6);
    EXPECT_EQ(path.stops(), 4);  // of five nodes between the ends
    for (int i = 0; i < path.last(); ++i) {
      EXPECT_EQ(path.node(i).stance.position, path.edges[i].from.position);
      EXPECT_EQ(path.node(i + 1).stance.position, path.edges[i].to.position);
    }
  }
}

TEST(EdgePath, OfNothingHasNoLengthAndNoStop) {
  const EdgePath nothing;
  EXPECT_EQ(nothing.last(), 0);
  EXPECT_EQ(nothing.length(), 0.0);
  EXPECT_EQ(nothing.duration(), 0.0);
  EXPECT_EQ(nothing.stops(), 0);
}

TEST(EdgePath, ItsEndsAreAsTheyWereAskedAndOthersAreSettled) {
  EdgePath path = pathOver(DiscSteering(), drawnPlaces(22, 4));
  path.start.any_heading = path.goal.any_heading = true;
  EXPECT_TRUE(path.node(0).any_heading);
  EXPECT_TRUE(path.node(path.last()).any_heading);
  for (int i = 1; i < path.last(); ++i) EXPECT_FALSE(path.node(i).any_heading);
}

}  // namespace
}  // namespace amble
