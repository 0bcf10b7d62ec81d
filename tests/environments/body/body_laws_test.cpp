// What holds of a body in any pose: it goes along with its skeleton, has two equal sides, and moves
// between frames no farther than its bounds say.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "environments/body/body_track.h"
#include "tests/environments/random_scenes.h"
#include "tests/environments/test_walker.h"

namespace amble {
namespace {

Pose bentPose(const TestWalker& walker, SampleStream& random, double bent) {
  Pose pose = walker.standing(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-3, 3));
  for (Eigen::Quaterniond& q : pose.rotations) q = q * expRotation(drawnVector(random, bent));
  return pose;
}

/// Poses of a walker, tracked.
struct TrackedPoses {
  explicit TrackedPoses(const std::vector<Pose>& list, const LaneKernel& kernel = lanes())
      : poses(walker.skeleton.size()), track(walker.skeleton, walker.body, kernel) {
    for (const Pose& pose : list) poses.append(pose);
    capsules.resize(list.size() * parts());
    motions.bounds.resize(capsules.size());
    motions.nears.resize(capsules.size());
    std::vector<int> frames(list.size());
    std::iota(frames.begin(), frames.end(), 0);
    BodyTrack::Scratch scratch = track.makeScratch();
    track.place(poses, frames, capsules, scratch);
    track.measure(poses, 0, poses.size() - 1, capsules, motions, scratch);
  }
  size_t parts() const { return walker.body.parts.size(); }
  const Capsule& at(size_t frame, size_t part) const { return capsules[frame * parts() + part]; }
  const PartMotion& motion(size_t frame, size_t part) const {
    return motions.bounds[frame * parts() + part];
  }
  double near(size_t frame, size_t part) const { return motions.nears[frame * parts() + part]; }

  TestWalker walker;
  PoseArray poses;
  BodyTrack track;
  std::vector<Capsule> capsules;
  BodyTrack::Motions motions;
};

double chordOfPart(const TrackedPoses& tracked, size_t a, size_t b, size_t part) {
  const Capsule &first = tracked.at(a, part), &last = tracked.at(b, part);
  return std::max((last.from - first.from).norm(), (last.to - first.to).norm());
}

TEST(BodyLaws, GoesAlongWithItsRootAndKeepsItsShape) {
  SampleStream random(1, 0);
  const TestWalker walker;
  for (int n = 0; n < 60; ++n) {
    const Pose pose = bentPose(walker, random, 1.0);
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.linear() = expRotation(drawnVector(random, 3.0)).toRotationMatrix();
    X.translation() = drawnVector(random, 5.0);
    Pose moved_pose = pose;
    moved_pose.p_WR = X * pose.p_WR;
    moved_pose.rotations[0] = Eigen::Quaterniond(X.linear()) * pose.rotations[0];
    const TrackedPoses tracked({pose, moved_pose});
    for (size_t i = 0; i < tracked.parts(); ++i) {
      EXPECT_LT((X * tracked.at(0, i).from - tracked.at(1, i).from).norm(), 1e-12);
      EXPECT_LT((X * tracked.at(0, i).to - tracked.at(1, i).to).norm(), 1e-12);
      const BodyPart& part = tracked.walker.body.parts[i];
      EXPECT_NEAR((tracked.at(0, i).to - tracked.at(0, i).from).norm(),
                  (part.to - part.from).norm(), 1e-12);
    }
  }
}

// The rest pose is symmetric, so the body in it is.
TEST(BodyLaws, HasTwoEqualSides) {
  const TestWalker walker;
  const TrackedPoses tracked({walker.standing(0, 0)});
  int pairs = 0;
  for (size_t i = 0; i < tracked.parts(); ++i) {
    const std::string& name = walker.body.parts[i].name;
    if (!name.starts_with("left ")) continue;
    const int other = walker.part("right " + name.substr(5));
    ASSERT_GE(other, 0) << name;
    ++pairs;
    const Capsule &left = tracked.at(0, i), &right = tracked.at(0, other);
    EXPECT_NEAR(left.radius, right.radius, 1e-12) << name;
    EXPECT_LT((mirroredPoint(left.from) - right.from).norm(), 1e-9) << name;
    EXPECT_LT((mirroredPoint(left.to) - right.to).norm(), 1e-9) << name;
    EXPECT_EQ(walker.body.parts[i].sole < 0, walker.body.parts[other].sole < 0);
  }
  EXPECT_GE(pairs, 10);
}

TEST(BodyLaws, APartMovesOnlyWithTheJointsOverIt) {
  SampleStream random(2, 0);
  const TestWalker walker;
  for (int joint = 1; joint < walker.skeleton.size(); ++joint) {
    const Pose pose = bentPose(walker, random, 0.5);
    Pose bent = pose;
    bent.rotations[joint] = bent.rotations[joint] * expRotation({0.3, 0.4, 0.5});
    const TrackedPoses tracked({pose, bent});
    for (size_t i = 0; i < tracked.parts(); ++i) {
      bool hangs = false;
      for (int j = walker.body.parts[i].joint; j >= 0; j = walker.skeleton.joint(j).parent)
        hangs |= j == joint;
      if (!hangs) {
        EXPECT_EQ(tracked.at(0, i).from, tracked.at(1, i).from) << walker.body.parts[i].name;
        EXPECT_EQ(tracked.at(0, i).to, tracked.at(1, i).to);
        EXPECT_EQ(tracked.motion(0, i).path, 0.0);
      }
    }
  }
}

// At every moment of the interval, for every point of the axis.
TEST(BodyLaws, BetweenFramesAPointIsAsNearToAnEndAsIsSaid) {
  SampleStream random(3, 0);
  const TestWalker walker;
  for (const double turn : {0.02, 0.2, 1.0}) {
    for (int n = 0; n < 12; ++n) {
      const Pose a = bentPose(walker, random, 0.5);
      Pose b = a;
      b.p_WR += drawnVector(random, turn);
      for (Eigen::Quaterniond& q : b.rotations) q = q * expRotation(drawnVector(random, turn));
      std::vector<Pose> moments;
      constexpr int kMoments = 40;
      for (int i = 0; i <= kMoments; ++i) {
        Pose moment = a;
        interpolatePose(a, b, static_cast<double>(i) / kMoments, moment);
        moments.push_back(moment);
      }
      const TrackedPoses ends({a, b}), dense(moments);
      for (size_t part = 0; part < ends.parts(); ++part) {
        double length = 0.0;
        for (int i = 0; i <= kMoments; ++i) {
          const int nearer = 2 * i <= kMoments ? 0 : kMoments;
          ASSERT_LE(chordOfPart(dense, i, nearer, part), ends.near(0, part) + 1e-12)
              << walker.body.parts[part].name << " " << i;
          if (i > 0) length += chordOfPart(dense, i - 1, i, part);
        }
        // The larger of two ends' ways piece by piece is no longer than their bound.
        ASSERT_LE(length, ends.motion(0, part).path + 1e-9) << walker.body.parts[part].name;
      }
    }
  }
}

TEST(BodyLaws, AtHalfTimeAPointIsWithinTheBendOfTheMiddleOfItsWay) {
  SampleStream random(4, 0);
  const TestWalker walker;
  for (int n = 0; n < 60; ++n) {
    const Pose a = bentPose(walker, random, 0.5);
    Pose b = a;
    for (Eigen::Quaterniond& q : b.rotations) q = q * expRotation(drawnVector(random, 0.6));
    Pose half = a;
    interpolatePose(a, b, 0.5, half);
    const TrackedPoses tracked({a, b, half});
    for (size_t i = 0; i < tracked.parts(); ++i) {
      const Eigen::Vector3d from = 0.5 * (tracked.at(0, i).from + tracked.at(1, i).from),
                            to = 0.5 * (tracked.at(0, i).to + tracked.at(1, i).to);
      EXPECT_LE((tracked.at(2, i).from - from).norm(), tracked.motion(0, i).bend + 1e-9);
      EXPECT_LE((tracked.at(2, i).to - to).norm(), tracked.motion(0, i).bend + 1e-9);
    }
  }
}

TEST(BodyLaws, ThereAndBackAreAsFar) {
  SampleStream random(5, 0);
  const TestWalker walker;
  for (int n = 0; n < 40; ++n) {
    const Pose a = bentPose(walker, random, 0.5), b = bentPose(walker, random, 0.5);
    const TrackedPoses there({a, b}), back({b, a});
    for (size_t i = 0; i < there.parts(); ++i) {
      EXPECT_NEAR(there.motion(0, i).path, back.motion(0, i).path, 1e-12);
      EXPECT_NEAR(there.motion(0, i).bend, back.motion(0, i).bend, 1e-12);
      EXPECT_NEAR(there.near(0, i), back.near(0, i), 1e-12);
    }
  }
}

TEST(BodyLaws, BoundsDoNotDependOnWhereTheMotionIs) {
  SampleStream random(6, 0);
  const TestWalker walker;
  for (int n = 0; n < 40; ++n) {
    std::vector<Pose> poses;
    for (int i = 0; i < 4; ++i) poses.push_back(bentPose(walker, random, 0.4));
    std::vector<Pose> elsewhere = poses;
    const Eigen::Quaterniond turn = aboutZ(random.uniform(-3, 3));
    const Eigen::Vector3d by = drawnVector(random, 8.0);
    for (Pose& pose : elsewhere) {
      pose.p_WR = turn * pose.p_WR + by;
      pose.rotations[0] = turn * pose.rotations[0];
    }
    const TrackedPoses here(poses), there(elsewhere);
    for (size_t frame = 0; frame < 3; ++frame) {
      for (size_t i = 0; i < here.parts(); ++i) {
        EXPECT_NEAR(here.motion(frame, i).path, there.motion(frame, i).path, 1e-9);
        EXPECT_NEAR(here.motion(frame, i).bend, there.motion(frame, i).bend, 1e-9);
        EXPECT_NEAR(here.near(frame, i), there.near(frame, i), 1e-9);
      }
    }
  }
}

// Lanes share a register, frames do not share answers: the ends of a motion are not of four frames.
TEST(BodyLaws, AFrameIsTheSameWhateverStandsBesideIt) {
  SampleStream random(7, 0);
  const TestWalker walker;
  std::vector<Pose> poses;
  for (int i = 0; i < 9; ++i) poses.push_back(bentPose(walker, random, 0.6));
  const TrackedPoses all(poses);
  for (size_t first = 0; first + 1 < poses.size(); ++first) {
    for (size_t count = 2; first + count <= poses.size(); ++count) {
      const TrackedPoses some({poses.begin() + first, poses.begin() + first + count});
      for (size_t i = 0; i < all.parts(); ++i) {
        ASSERT_EQ(some.at(0, i).from, all.at(first, i).from);
        ASSERT_EQ(some.at(count - 1, i).to, all.at(first + count - 1, i).to);
        ASSERT_EQ(some.motion(0, i).path, all.motion(first, i).path);
        ASSERT_EQ(some.near(count - 2, i), all.near(first + count - 2, i));
      }
    }
  }
}

TEST(BodyLaws, AnIntervalOfTwoIsNoLongerThanBoth) {
  SampleStream random(8, 0);
  const TestWalker walker;
  for (int n = 0; n < 40; ++n) {
    const Pose a = bentPose(walker, random, 0.5);
    Pose b = a, middle = a;
    b.p_WR += drawnVector(random, 0.3);
    for (Eigen::Quaterniond& q : b.rotations) q = q * expRotation(drawnVector(random, 0.4));
    interpolatePose(a, b, 0.5, middle);
    const TrackedPoses whole({a, b}), halves({a, middle, b});
    for (size_t i = 0; i < whole.parts(); ++i) {
      const PartMotion half = whole.motion(0, i).halved();
      for (const size_t k : {0, 1}) {
        EXPECT_LE(halves.motion(k, i).path, half.path * (1.0 + 2e-2) + 1e-12);
        EXPECT_LE(halves.motion(k, i).bend, half.bend * (1.0 + 4e-2) + 1e-12);
      }
    }
  }
}

TEST(Capsule, BoundsHoldEveryPointAndTouchIt) {
  SampleStream random(9, 0);
  for (int n = 0; n < 300; ++n) {
    const Capsule capsule{drawnVector(random, 2.0), drawnVector(random, 2.0),
                          random.uniform(0.0, 0.5)};
    const Eigen::AlignedBox3d bounds = capsule.bounds();
    for (int k = 0; k < 20; ++k) {
      const Eigen::Vector3d p = capsule.from + random.uniform() * (capsule.to - capsule.from) +
                                drawnVector(random, capsule.radius);
      EXPECT_LE(bounds.exteriorDistance(p), 1e-12);
      EXPECT_GE(p.z(), capsule.lowest() - 1e-12);
    }
    EXPECT_NEAR(bounds.min().z(), capsule.lowest(), 1e-12);
    const double by = random.uniform(0.0, 0.3);
    const Eigen::AlignedBox3d larger = capsule.inflated(by).bounds();
    EXPECT_LT((bounds.min() - larger.min()).cwiseAbs().maxCoeff() - by, 1e-12);
    EXPECT_NEAR(larger.sizes().sum(), bounds.sizes().sum() + 6.0 * by, 1e-12);
  }
}

TEST(BodyLaws, ATallerBodyIsBroaderInProportionWhateverItsPose) {
  SampleStream random(10, 0);
  const TestWalker walker;
  for (const double factor : {0.6, 1.3}) {
    const Skeleton skeleton = walker.skeleton.scaled(factor);
    const Body body =
        makeBody(skeleton, walker.roles, factor * walker.stature,
                 evenSoles({factor * walker.foot.ankle_height, factor * walker.foot.radius}));
    const Pose pose = bentPose(walker, random, 0.5);
    Pose scaled = pose;
    scaled.p_WR *= factor;
    PoseArray poses(skeleton.size());
    poses.append(scaled);
    const BodyTrack track(skeleton, body);
    BodyTrack::Scratch scratch = track.makeScratch();
    std::vector<Capsule> capsules(body.parts.size());
    track.place(poses, std::array{0}, capsules, scratch);
    const TrackedPoses usual({pose});
    for (size_t i = 0; i < capsules.size(); ++i) {
      EXPECT_LT((capsules[i].from - factor * usual.at(0, i).from).norm(), 1e-9);
      EXPECT_LT((capsules[i].to - factor * usual.at(0, i).to).norm(), 1e-9);
      EXPECT_NEAR(capsules[i].radius, factor * usual.at(0, i).radius, 1e-9);
    }
  }
}

}  // namespace
}  // namespace amble
