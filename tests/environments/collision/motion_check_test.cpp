#include "environments/collision/motion_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rotation.h"
#include "environments/ground/scene_ground.h"
#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

constexpr double kRadius = 0.1;  // of the ball that flies [m]

/// Distance of a segment to a box about `at`, along the segment by thirds: it is convex there.
double distanceToBox(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                     const Eigen::AlignedBox3d& box) {
  double low = 0.0, high = 1.0;
  const auto off = [&](double t) { return box.exteriorDistance(Eigen::Vector3d(a + t * (b - a))); };
  for (int n = 0; n < 120; ++n) {
    const double u = low + (high - low) / 3.0, v = high - (high - low) / 3.0;
    (off(u) < off(v) ? high : low) = off(u) < off(v) ? v : u;
  }
  return off(0.5 * (low + high));
}

Skeleton oneJoint() {
  Joint joint;
  joint.name = "ball";
  return Skeleton({joint});
}

/// A ball about its only joint: what a motion sweeps is a capsule for each interval.
Body ball() {
  BodyPart part;
  part.name = "ball";
  part.from = part.to = Eigen::Vector3d::Zero();
  part.radius = kRadius;
  return {{part}};
}

/// A few boxes to fly between, high over a floor.
struct BallWorld {
  explicit BallWorld(std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> place(-1.5, 1.5), size(0.05, 0.8);
    scene.objects = {floorSlab()};
    boxes.emplace_back();
    for (int i = 0; i < 6; ++i) {
      const Eigen::Vector3d at(place(generator), place(generator), 4.0 + place(generator));
      const Eigen::Vector3d wide(size(generator), size(generator), size(generator));
      scene.objects.push_back(makeObject("box", Box{wide}, at));
      boxes.emplace_back(at - wide / 2, at + wide / 2);
    }
  }
  PoseArray flight(std::mt19937_64& generator, int frames) const {
    std::uniform_real_distribution<double> place(-2.0, 2.0);
    PoseArray poses(1);
    poses.resize(frames);
    for (int i = 0; i < frames; ++i)
      poses.p_WR(i) = {place(generator), place(generator), 4.0 + place(generator)};
    return poses;
  }
  /// Least distance of the ball's skin to any box between two frames; below 0 it touches [m].
  double gap(const PoseArray& poses, int frame) const {
    double least = HUGE_VAL;
    for (size_t i = 1; i < boxes.size(); ++i)
      least = std::min(least, distanceToBox(poses.p_WR(frame), poses.p_WR(frame + 1), boxes[i]));
    return least - kRadius;
  }

  Scene scene;
  std::vector<Eigen::AlignedBox3d> boxes;  // by object; the floor's is empty
};

class MotionCheckTest : public testing::TestWithParam<int> {
 protected:
  MotionCheck checkOf(const PoseArray& poses) {
    soles.assign(poses.size(), {SolePhase::kSwinging, SolePhase::kSwinging});
    return {model, poses, soles, scratch};
  }
  const BallWorld world{static_cast<std::uint64_t>(GetParam())};
  const SceneGround ground{world.scene, 0.0};
  const CollisionModel model{world.scene, ground, oneJoint(), ball()};
  CollisionScratch scratch{1, 1};
  std::vector<SolePhases> soles;
  std::mt19937_64 generator{static_cast<std::uint64_t>(100 + GetParam())};
};

INSTANTIATE_TEST_SUITE_P(Rooms, MotionCheckTest, testing::Values(1, 2, 3));

TEST_P(MotionCheckTest, AFlyingBallMeetsWhatItsSweptCapsulesMeet) {
  int met = 0, missed = 0;
  for (int n = 0; n < 200; ++n) {
    const PoseArray poses = world.flight(generator, 3);
    const double gap = std::min(world.gap(poses, 0), world.gap(poses, 1));
    if (gap > -1e-5 && gap < 2.0 * kProofGap) continue;  // between touching and what is proved
    for (const bool any : {false, true}) {
      const auto contact = checkOf(poses).all(any);
      EXPECT_EQ(contact.has_value(), gap < 0.0) << gap;
    }
    ++(gap < 0.0 ? met : missed);
  }
  EXPECT_GT(met, 20);
  EXPECT_GT(missed, 20);
}

TEST_P(MotionCheckTest, TheContactIsTheFirstAndThereItTouches) {
  int checked = 0;
  for (int n = 0; n < 200; ++n) {
    const PoseArray poses = world.flight(generator, 4);
    const auto contact = checkOf(poses).all(false);
    if (!contact) continue;
    ++checked;
    for (int frame = 0; frame < contact->frame; ++frame) EXPECT_GT(world.gap(poses, frame), -1e-5);
    const int next = std::min(contact->frame + 1, poses.size() - 1);
    const Eigen::Vector3d at = poses.p_WR(contact->frame) +
                               contact->between * (poses.p_WR(next) - poses.p_WR(contact->frame));
    const double off = world.boxes[contact->object].exteriorDistance(at) - kRadius;
    EXPECT_LT(off, 2.0 * kProofGap);
    EXPECT_LE(contact->gap, kProofGap);
    // Before it, in its own interval, nothing is met but by less than halving finds.
    if (contact->between > 0.01) {
      PoseArray before(1);
      before.resize(2);
      before.p_WR(0) = poses.p_WR(contact->frame);
      before.p_WR(1) = poses.p_WR(contact->frame) +
                       0.45 * contact->between * (poses.p_WR(next) - poses.p_WR(contact->frame));
      EXPECT_TRUE(world.gap(before, 0) > -1e-5 || off < 1e-5);
    }
  }
  EXPECT_GT(checked, 30);
}

TEST_P(MotionCheckTest, CoarseFindsAFrameThatTouchesWhereItLooksAndNoOther) {
  int found = 0;
  for (int n = 0; n < 80; ++n) {
    const PoseArray poses = world.flight(generator, 40);
    const auto contact = checkOf(poses).coarse();
    bool touches = false;  // at a frame that it looks at
    for (int frame = 0; frame < poses.size(); frame += kStrides.back())
      for (size_t i = 1; i < world.boxes.size(); ++i)
        touches = touches || world.boxes[i].exteriorDistance(poses.p_WR(frame)) < kRadius - 1e-5;
    if (touches) {
      EXPECT_TRUE(contact.has_value());
    }
    if (!contact) continue;
    ++found;
    EXPECT_EQ(contact->between, 0.0);
    EXPECT_EQ(contact->frame % kStrides.back(), 0);
    EXPECT_LT(world.boxes[contact->object].exteriorDistance(poses.p_WR(contact->frame)),
              kRadius + 1e-5);
  }
  EXPECT_GT(found, 3);
}

// A finer clock changes nothing: frames on the straight way between two are no other motion.
TEST_P(MotionCheckTest, MoreFramesOnTheSameWayGiveTheSameVerdict) {
  for (int n = 0; n < 60; ++n) {
    const PoseArray poses = world.flight(generator, 2);
    const double gap = world.gap(poses, 0);
    if (gap > -1e-5 && gap < 2.0 * kProofGap) continue;
    for (const int pieces : {3, 17}) {
      PoseArray fine(1);
      fine.resize(pieces + 1);
      for (int i = 0; i <= pieces; ++i)
        fine.p_WR(i) = poses.p_WR(0) + (poses.p_WR(1) - poses.p_WR(0)) * i / pieces;
      EXPECT_EQ(checkOf(fine).all(false).has_value(), gap < 0.0) << gap;
    }
  }
}

// Frames as near to one another as a walk's, so that spans of them are told at once: the verdict is
// that of each interval by itself, and so is the contact.
TEST_P(MotionCheckTest, ASlowFlightMeetsWhatItsIntervalsMeet) {
  std::uniform_real_distribution<double> turn(0.0, 2.0 * kPi), place(-0.5, 0.5);
  int met = 0, missed = 0;
  for (int n = 0; n < 150; ++n) {
    const double far = 0.5 + turn(generator) / 6.0, begin = turn(generator),
                 rise = place(generator);
    PoseArray poses(1);
    poses.resize(40 + n % 50);
    for (int i = 0; i < poses.size(); ++i) {
      const double at = begin + 0.02 * i;
      poses.p_WR(i) = {far * std::cos(at), far * std::sin(at), 4.0 + rise * std::cos(3.0 * at)};
    }
    double least = HUGE_VAL;
    int first = poses.size();  // interval that touches
    for (int i = poses.size() - 2; i >= 0; --i) {
      const double gap = world.gap(poses, i);
      least = std::min(least, gap);
      if (gap < 2.0 * kProofGap) first = i;
    }
    if (least > -1e-5 && least < 2.0 * kProofGap) continue;
    for (const bool any : {false, true}) {
      const auto contact = checkOf(poses).all(any);
      ASSERT_EQ(contact.has_value(), least < 0.0) << least;
      if (contact) {
        EXPECT_GE(contact->frame, first);
      }
    }
    ++(least < 0.0 ? met : missed);
  }
  EXPECT_GT(met, 10);
  EXPECT_GT(missed, 10);
}

TEST(MotionCheckGround, ABallMayComeDownToTheFloorAndNoDeeper) {
  const Scene scene = sceneOf({floorSlab()});
  const SceneGround ground(scene, 0.0);
  const CollisionModel model(scene, ground, oneJoint(), ball());
  CollisionScratch scratch(1, 1);
  const std::vector<SolePhases> soles(3, {SolePhase::kSwinging, SolePhase::kSwinging});
  for (const double low : {0.01, 0.002, -0.001, -0.05}) {
    PoseArray poses(1);
    poses.resize(3);
    poses.p_WR(0) = {0, 0, 1};
    poses.p_WR(1) = {1, 0, kRadius + low};
    poses.p_WR(2) = {2, 0, 1};
    EXPECT_EQ(MotionCheck(model, poses, soles, scratch).all(false).has_value(), low < 0.0) << low;
  }
}

}  // namespace
}  // namespace amble
