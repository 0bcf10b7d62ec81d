// Bodies beside walls along the ground's open edges.
#include "planner/steering/edge_reach.h"

#include <gtest/gtest.h>

#include "animation/steps/stride_law.h"
#include "base/rotation.h"
#include "base/sample_stream.h"
#include "planner/steering/body_reach.h"
#include "planner/steering/walk_steering.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

constexpr double kFloorNorth = 4.0, kFloorEast = 6.0;  // its corner, from the origin [m]

struct WalledEdge {
  explicit WalledEdge(std::vector<SceneObject> walls, const CharacterSettings& settings = {})
      : scene(withFloor(std::move(walls))),
        synthesizer(furnishedRoom().library, ground, settings),
        world(scene, ground, synthesizer.skeleton(), body),
        steering(synthesizer, world, ground) {}
  static Scene withFloor(std::vector<SceneObject> walls) {
    Scene scene;
    scene.objects = std::move(walls);
    scene.objects.push_back(boxObject("floor", {kFloorEast, kFloorNorth, 0.1},
                                      {0.5 * kFloorEast, 0.5 * kFloorNorth, -0.05}));
    return scene;
  }
  bool has(const Eigen::Vector2d& p, double around = 0.0) const {
    return near.has(p, around) && (near.isOver(p) || edges.has(p, around));
  }

  const Scene scene;
  const SceneGround ground{scene};
  const WalkSynthesizer synthesizer;
  const Body body = uprightBody(synthesizer);
  const CollisionWorld world;
  const WalkSteering steering;
  const SteeringScratchPtr scratch = steering.makeScratch();
  const double step = StrideLaw::kLongestStep * synthesizer.capturedStep();
  const ReachedGround reached{ground, {3, 2, 0}, step};
  const GroundRange range{ground, reached, 0.5 * synthesizer.stature()};
  const NearGround near{ground, reached, step, BodyReach::kBeyond};
  const EdgeReach edges{ground, near, range, synthesizer.stature(), synthesizer.stature()};
};

SceneObject southWall(double west, double east, double north, double thick, double high = 2.5) {
  return boxObject("wall", {east - west, thick, high},
                   {0.5 * (west + east), north - 0.5 * thick, 0.5 * high});
}

TEST(EdgeReach, BehindAWallAlongAnEdgeItIsWhatIsReachedRoundTheEndsOnly) {
  constexpr double kBehind = -0.2, kDoubt = 0.5;  // squares, and ways across them [m]
  const WalledEdge wall({southWall(-5, 4, 0.0, 0.1)});
  const double way = EdgeReach::kOfBones * wall.synthesizer.stature();
  EXPECT_TRUE(wall.near.has({1, kBehind})) << "it is as near as that";
  for (double x = 0.0; x < 4.0 - std::sqrt(2.0) * way - kDoubt; x += 0.1)
    EXPECT_FALSE(wall.has({x, kBehind}, NearGround::kMostAround)) << x;
  for (double x = 4.05 - way; x < kFloorEast; x += 0.1) EXPECT_TRUE(wall.has({x, kBehind})) << x;
}

// What ends below a head, begins over the floor or is a single surface is no wall.
TEST(EdgeReach, OnlyWhatIsSolidFromTheFloorToOverTheHeadIsAWall) {
  SceneObject over = southWall(-5, 11, 0.0, 0.1);
  over.X_WO.translation().z() += 0.1;
  TriangleMesh sheet;
  sheet.vertices = {{-5, -0.05, 0}, {11, -0.05, 0}, {11, -0.05, 3}};
  sheet.triangles = {{0, 1, 2}};
  SceneObject surface;
  surface.name = "sheet";
  surface.shape = sheet;
  for (const SceneObject& thing : {southWall(-5, 11, 0.0, 0.1, 1.4), over, surface}) {
    const WalledEdge edge({thing});
    for (double x = 0.5; x < kFloorEast; x += 0.5) EXPECT_TRUE(edge.has({x, -0.2})) << x;
  }
  const WalledEdge wall({southWall(-5, 11, 0.0, 0.1)});
  for (double x = 0.5; x < kFloorEast; x += 0.5) EXPECT_FALSE(wall.has({x, -0.2})) << x;
}

// From a joint along the bones to a foot: the length of that seen from above [m].
double wayOfBones(const Skeleton& skeleton, int from, int foot,
                  std::span<const JointFrame> joints) {
  double way = 0.0;
  for (const auto& [end, other] : {std::pair(from, foot), {foot, from}}) {
    for (int joint = end; !skeleton.isAncestor(joint, other); joint = skeleton.joint(joint).parent)
      way += (joints[joint].p_WJ - joints[skeleton.joint(joint).parent].p_WJ).head<2>().norm();
  }
  return way;
}

// Along the edge, or aslant.
std::pair<Waypoint, Waypoint> drawnBesideEdge(SampleStream& stream) {
  Waypoint from, to;
  const double y = stream.uniform(0.05, 0.2), far = stream.uniform(0.6, 2.5);
  from.stance.position << stream.uniform(0.3, 5.4 - far), y, 0.0;
  to.stance.position << from.stance.position.x() + far,
      std::max(0.0, y + stream.uniform(-0.1, 0.2)), 0.0;
  from.stance.heading = stream.uniform(-0.7, 0.7);
  to.stance.heading = stream.uniform(-0.7, 0.7);
  from.stance.standing = stream.uniform() < 0.6;
  to.stance.standing = stream.uniform() < 0.6;
  if (stream.uniform() < 0.5) {
    std::swap(from.stance.position, to.stance.position);
    from.stance.heading += kPi;
    to.stance.heading += kPi;
  }
  return {from, to};
}

// Walls with gaps along the south edge, no farther than bodies lean out; walks beside them.
TEST(EdgeReach, WhereverSomebodyWalksBesideAWalledEdgeHisBonesCountAndAreNoLonger) {
  SampleStream stream(31, 0);
  int walked = 0, beyond = 0;
  double longest = 0.0;
  for (int i = 0; i < 80; ++i) {
    CharacterSettings settings;
    settings.height = stream.uniform(1.4, 2.0);
    settings.speed = stream.uniform(0.6, 1.5);
    std::vector<SceneObject> walls;
    for (double x = stream.uniform(-1.0, 2.0); x < 5.0; x += stream.uniform(0.1, 1.5)) {
      const double end = x + stream.uniform(0.03, 1.0);
      walls.push_back(southWall(x, end, -stream.uniform(0.0, 0.3), stream.uniform(0.02, 0.2)));
      x = end;
    }
    const WalledEdge edge(walls, settings);
    const Skeleton& skeleton = edge.synthesizer.skeleton();
    const JointRoles& roles = edge.synthesizer.roles();
    const auto& legs = roles.legs;
    std::vector<JointFrame> joints(skeleton.size());
    AnimationBuffer buffer;
    for (int k = 0; k < 12; ++k) {
      const auto [a, b] = drawnBesideEdge(stream);
      const auto walk = edge.steering.steer(a, b, *edge.scratch).edge;
      if (!walk) continue;
      ++walked;
      edge.steering.animate(*walk, buffer);
      for (int frame = 0; frame < buffer.size(); ++frame) {
        forwardKinematics(skeleton, buffer.poses[frame], joints);
        for (const int joint : {roles.head, roles.chest, roles.hips, legs[kLeft].up_leg,
                                legs[kRight].up_leg, legs[kLeft].leg, legs[kRight].leg}) {
          const Eigen::Vector2d p = joints[joint].p_WJ.head<2>();
          beyond += p.y() < 0.0;
          EXPECT_TRUE(edge.has(p))
              << i << ", " << skeleton.joint(joint).name << " at " << p.transpose();
          double least = HUGE_VAL;
          for (const Side side : {kLeft, kRight}) {
            if (buffer.states[frame].feet[side].planted())
              least = std::min(least, wayOfBones(skeleton, joint, legs[side].foot, joints));
          }
          if (least < HUGE_VAL) longest = std::max(longest, least / edge.synthesizer.stature());
        }
      }
    }
  }
  EXPECT_GE(walked, 100);
  EXPECT_GE(beyond, 100);
  EXPECT_LT(longest, EdgeReach::kOfBones);
}

}  // namespace
}  // namespace amble
