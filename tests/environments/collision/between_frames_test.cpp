/// Walks of the library along random curves, seen at five frames a second, against things that are
/// thinner than what a body moves from one frame to the next.
#include <gtest/gtest.h>

#include <random>

#include "animation/ground/ground.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "environments/collision/collision_world.h"
#include "tests/animation/default_library.h"
#include "tests/animation/walk_paths.h"
#include "tests/environments/test_scenes.h"
#include "tests/environments/test_walker.h"

namespace amble {
namespace {

constexpr int kKept = 12;  // one frame of so many: 60 become five a second

class BetweenFrames : public testing::Test {
 protected:
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }

  /// A walk of the library, from walking to walking, about the origin; too few frames to be smooth.
  PoseArray walk() {
    const WalkSynthesizer& walker = walkers_[static_cast<size_t>(number(0, 2.999))];
    AnimationBuffer all;
    for (;;) {
      const double radius = number(1.5, 6.0) * (number(-1, 1) < 0 ? -1.0 : 1.0);
      const RootPath path = circlePath(radius, number(1.5, 3.0) / radius, number(-kPi, kPi));
      const Stance from = stanceAt(path, false, true), to = stanceAt(path, true, true);
      if (walker.walk(from, to, path, true, all).refused == WalkRule::kNone) break;
    }
    PoseArray kept(walker_.skeleton().size());
    for (int i = 0; i < all.size(); i += kKept) kept.append(all.poses[i]);
    return kept;
  }

  /// The body with these things, half a metre above the ground: feet that so few frames put into it
  /// are no matter here.
  struct World {
    World(const BetweenFrames& test, std::vector<SceneObject> things)
        : scene(sceneOf(std::move(things))),
          world(scene, ground, test.walker_.skeleton(), test.body_) {}
    std::optional<Contact> check(const PoseArray& poses, bool any) {
      return world.check(poses, solesOf(poses.size(), false), any, *scratch);
    }
    Scene scene;
    SceneGround ground{scene, 0.0};
    CollisionWorld world;
    CollisionScratchPtr scratch = world.makeScratch();
  };
  static SceneObject lowFloor() { return makeObject("floor", Box{{1, 1, 0.1}}, {0, 0, -0.5}); }

  Pose between(const PoseArray& poses, int frame, double t) const {
    Pose pose;
    interpolatePose(poses[frame], poses[frame + 1], t, pose);
    return pose;
  }

  std::mt19937_64 generator_{20};
  FlatGround floor_;
  WalkSynthesizer walkers_[3] = {{defaultLibrary(), floor_, {0.0, 0.8}},
                                 {defaultLibrary(), floor_, {0.0, 1.2}},
                                 {defaultLibrary(), floor_, {0.0, 1.6}}};
  const WalkSynthesizer& walker_ = walkers_[1];
  Body body_ =
      makeBody(walker_.skeleton(), walker_.roles(), walker_.stature(), soleHeights(walker_.feet()));
};

TEST_F(BetweenFrames, APlateWhereAPartIsAtSomeMomentIsMet) {
  int unseen_at_frames = 0;
  for (int n = 0; n < 60; ++n) {
    const PoseArray poses = walk();
    const int frame = static_cast<int>(number(0, poses.size() - 1.001));
    const BodyPart& part = body_.parts[static_cast<size_t>(number(0, body_.parts.size() - 0.001))];
    std::vector<JointFrame> joints(walker_.skeleton().size());
    forwardKinematics(walker_.skeleton(), between(poses, frame, number(0.05, 0.95)), joints);
    const double along = number(0, 1);
    const Eigen::Vector3d at = joints[part.joint] * ((1.0 - along) * part.from + along * part.to);
    Eigen::Vector3d size(0.002, 0.002, 0.002);
    size[n % 3] = 0.00005;
    SceneObject plate = makeObject("plate", n % 2 == 0 ? Shape(Box{size}) : Shape(makeBox(size)),
                                   at, Role::kObstacle);
    World world(*this, {lowFloor(), plate});
    bool seen = false;
    for (int i = 0; i < poses.size(); ++i)
      seen = seen || world.world.checkPose(poses[i], *world.scratch).has_value();
    unseen_at_frames += !seen;
    for (const bool any : {false, true}) {
      const std::optional<Contact> contact = world.check(poses, any);
      ASSERT_TRUE(contact) << part.name << " passes a plate after frame " << frame;
      EXPECT_EQ(contact->object, 1);
      if (!any) {
        EXPECT_LE(contact->frame, frame + 1);
      }
    }
  }
  EXPECT_GT(unseen_at_frames, 5);  // else nothing was asked that frames do not tell
}

TEST_F(BetweenFrames, AWalkBesideThinWallsThatIsCalledFreeIsFreeAtEveryMoment) {
  constexpr int kMoments = 40;
  int free = 0, met = 0;
  for (int n = 0; n < 25; ++n) {
    const PoseArray poses = walk();
    std::vector<SceneObject> things = {lowFloor()};
    for (int k = 0; k < 2; ++k) {
      const Eigen::Vector3d root = poses[static_cast<int>(number(0, poses.size() - 0.001))].p_WR;
      Eigen::Vector3d size(number(0.05, 0.6), number(0.05, 0.6), number(0.05, 1.5));
      size[k % 3] = 0.0002;
      const double angle = number(-kPi, kPi), far = number(0.3, 0.9);
      things.push_back(makeObject(
          "wall", makeBox(size),
          root + Eigen::Vector3d(far * std::cos(angle), far * std::sin(angle), number(-0.7, 0.7)),
          Role::kObstacle));
    }
    World world(*this, things);
    if (world.check(poses, true)) {
      ++met;
      continue;
    }
    ++free;
    for (int i = 0; i + 1 < poses.size(); ++i) {
      for (int k = 0; k <= kMoments; ++k) {
        const double t = static_cast<double>(k) / kMoments;
        ASSERT_FALSE(world.world.checkPose(between(poses, i, t), *world.scratch)) << i << " " << t;
      }
    }
  }
  EXPECT_GT(free, 5);
  EXPECT_GT(met, 3);
}

}  // namespace
}  // namespace amble
