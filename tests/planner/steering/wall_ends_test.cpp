// Walls that end where the floor does, or nearly.
#include <gtest/gtest.h>

#include "base/rotation.h"
#include "base/sample_stream.h"
#include "planner/steering/body_reach.h"
#include "planner/steering/walk_steering.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

// A floor to the north of y = 0, and more on it.
struct EdgedFloor : FurnishedRoom {
  explicit EdgedFloor(std::vector<SceneObject> objects, const CharacterSettings& settings = {})
      : FurnishedRoom(withFloor(std::move(objects)), settings) {}
  static Scene withFloor(std::vector<SceneObject> objects) {
    Scene scene;
    scene.objects = std::move(objects);
    scene.objects.push_back(boxObject("floor", {8, 4, 0.1}, {0, 2, -0.05}));
    return scene;
  }
  bool isShut() const {
    return steering.shutOff({-3, 2, 0}, {3, 2, 0}, [] { return false; }, {&scratch, 1}).has_value();
  }

  const WalkSteering steering{synthesizer, world, ground};
  const SteeringScratchPtr scratch = steering.makeScratch();
};

SceneObject wallAcross(double south, double north, double thick, double high) {
  return boxObject("wall", {thick, north - south, high}, {0, 0.5 * (south + north), 0.5 * high});
}

TEST(WallEnds, AWallThatEndsWithTheFloorOrBeyondItShutsOff) {
  for (const double height : {0.6, 1.7, 2.1}) {
    CharacterSettings settings;
    settings.height = height;
    for (const double beyond : {0.0, 0.05}) {
      for (const auto& [thick, high] :
           {std::pair(0.05, (BodyReach::kPostHigh + 0.01) * height), {0.4, 2.5}}) {
        const EdgedFloor floor({wallAcross(-beyond, 4 + beyond, thick, high)}, settings);
        EXPECT_TRUE(floor.isShut()) << height << ": " << beyond << ", " << thick;
      }
    }
  }
}

// One end that leaves more ground than the post is broad, and less than legs are.
TEST(WallEnds, WhereMoreGroundIsLeftBesideItOrAStepLeadsOverItNothingIsShutOff) {
  EXPECT_FALSE(EdgedFloor({wallAcross(0.5, 4, 0.1, 2.5)}).isShut());
  EXPECT_FALSE(EdgedFloor({wallAcross(0, 4, 0.1, 0.2)}).isShut());
}

Waypoint besideEdge(SampleStream& stream, double x, double turn) {
  Waypoint at;
  at.stance.position << x, stream.uniform(0.0, 0.2), 0.0;
  at.stance.heading = turn * stream.uniform(-0.3, 1.3);
  at.stance.standing = stream.uniform() < 0.6;
  return at;
}

// Least ground between the edge and walls without thickness, from there on by a direction, that no
// part of the body at these heights touches, of all such walls between both ends of the walk [m].
double leastStrip(const EdgedFloor& floor, const WalkEdge& walk, double direction,
                  const Eigen::AlignedBox1d& heights) {
  constexpr double kWalls = 0.02;  // apart [m]
  const Eigen::Vector2d along(std::cos(direction), std::sin(direction));
  const auto edgeOf = [&](const Eigen::Vector3d& p) {
    return p.x() - p.y() * along.x() / along.y();
  };
  const double margin = 0.1 * floor.synthesizer.stature();
  const double a = edgeOf(walk.from.position), b = edgeOf(walk.to.position);
  const double first = std::min(a, b) + margin, last = std::max(a, b) - margin;
  const int count = first < last ? 1 + static_cast<int>((last - first) / kWalls) : 0;
  std::vector<double> farthest(count, -HUGE_VAL);  // north of the edge, of what is touched
  AnimationBuffer buffer;
  floor.steering.animate(walk, buffer);
  const Skeleton& skeleton = floor.synthesizer.skeleton();
  const std::vector<BodyPart>& parts = floor.body.parts;
  std::vector<JointFrame> joints(skeleton.size());
  std::vector<Eigen::Vector3d> from(parts.size()), to(parts.size());
  for (int frame = 0; frame < buffer.size(); ++frame) {
    forwardKinematics(skeleton, buffer.poses[frame], joints);
    placeBody(floor.body, joints, from, to);
    for (size_t part = 0; part < parts.size(); ++part) {
      const double radius = parts[part].radius;
      const int balls = 1 + static_cast<int>((to[part] - from[part]).norm() / radius);
      for (int k = 0; k <= balls; ++k) {
        const Eigen::Vector3d p = from[part] + (to[part] - from[part]) * k / balls;
        if (!heights.contains(p.tail<1>())) continue;
        const double at = edgeOf(p), reach = radius / along.y();
        const int begin = std::max(0, static_cast<int>(std::ceil((at - reach - first) / kWalls)));
        for (int i = begin; i < count && first + i * kWalls <= at + reach; ++i) {
          const double off = (first + i * kWalls - at) * along.y();
          const double more = std::sqrt(std::max(0.0, radius * radius - off * off));
          // From the wall's line to the ball's middle it is `off`, across.
          const double on_line =
              (p.head<2>() - Eigen::Vector2d(first + i * kWalls, 0.0)).dot(along);
          farthest[i] = std::max(farthest[i], (on_line + more) * along.y());
        }
      }
    }
  }
  return count == 0 ? HUGE_VAL : *std::ranges::min_element(farthest);
}

// The theorem that the post rests on.
TEST(WallEnds, NobodyGetsPastAWallThatLeavesHimAsLittleGroundAsThePostIsBroad) {
  SampleStream stream(41, 0);
  int walked = 0;
  double least = HUGE_VAL;
  for (int i = 0; i < 15; ++i) {
    CharacterSettings settings;
    settings.height = stream.uniform(0.5, 2.2);
    settings.speed =
        std::clamp(stream.uniform(0.3, 1.8) * std::sqrt(settings.height / 1.7), 0.3, 2.0);
    const EdgedFloor floor({}, settings);
    const double stature = floor.synthesizer.stature();
    const Eigen::AlignedBox1d heights(BodyReach::kPostLow * stature,
                                      BodyReach::kPostHigh * stature);
    for (int k = 0; k < 25; ++k) {
      const double far = stream.uniform(0.5, 2.0) * stature;
      const Waypoint from = besideEdge(stream, -2.0, -1.0), to = besideEdge(stream, far - 2.0, 1.0);
      const auto walk = floor.steering.steer(from, to, *floor.scratch).edge;
      if (!walk) continue;
      ++walked;
      for (const double direction : {90.0, 60.0, 120.0, 35.0, 145.0}) {
        const double strip = leastStrip(floor, *walk, direction * kDegree, heights) / stature;
        EXPECT_GT(strip, BodyReach::kPostRadius) << i << ", " << k << ": " << direction;
        least = std::min(least, strip);
      }
    }
  }
  EXPECT_GE(walked, 60);
  EXPECT_LT(least, 0.15) << "some walks lean out";
}

}  // namespace
}  // namespace amble
