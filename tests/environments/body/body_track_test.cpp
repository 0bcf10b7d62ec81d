#include "environments/body/body_track.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "tests/environments/test_walker.h"

namespace amble {
namespace {

// A walker that turns every joint a little, and now and then far, from frame to frame.
struct Motion {
  TestWalker walker;
  PoseArray poses{walker.skeleton.size()};
  std::vector<Capsule> capsules;
  BodyTrack::Motions motions;

  explicit Motion(int frames) {
    std::mt19937_64 generator(4);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    const auto direction = [&] {
      return Eigen::Vector3d(number(generator), number(generator), number(generator));
    };
    Pose pose = walker.standing(0, 0);
    for (int i = 0; i < frames; ++i) {
      poses.append(pose);
      pose.p_WR += 0.1 * direction();
      for (Eigen::Quaterniond& q : pose.rotations)
        q = expRotation((i % 5 == 0 ? 1.5 : 0.1) * direction()) * q;
    }
    capsules.resize(static_cast<size_t>(frames) * parts());
    motions.bounds.resize(capsules.size());
    motions.nears.resize(capsules.size());
  }

  int parts() const { return static_cast<int>(walker.body.parts.size()); }

  void track(const LaneKernel& kernel) {
    const BodyTrack track(walker.skeleton, walker.body, kernel);
    BodyTrack::Scratch scratch = track.makeScratch();
    std::vector<int> frames(poses.size());
    std::iota(frames.begin(), frames.end(), 0);
    track.place(poses, frames, capsules, scratch);
    track.measure(poses, 0, poses.size() - 1, capsules, motions, scratch);
  }
};

// As many frames as there are lanes or not.
TEST(BodyTrack, HasCapsulesWhereForwardKinematicsHasThem) {
  for (const int frames : {1, 3, 4, 10}) {
    Motion motion(frames);
    motion.track(lanes());
    std::vector<JointFrame> joints(motion.walker.skeleton.size());
    std::vector<Eigen::Vector3d> from(motion.parts()), to(motion.parts());
    for (int i = 0; i < frames; ++i) {
      forwardKinematics(motion.walker.skeleton, motion.poses[i], joints);
      placeBody(motion.walker.body, joints, from, to);
      for (int part = 0; part < motion.parts(); ++part) {
        const Capsule& capsule = motion.capsules[i * motion.parts() + part];
        EXPECT_LT((capsule.from - from[part]).norm(), 1e-14);
        EXPECT_LT((capsule.to - to[part]).norm(), 1e-14);
        EXPECT_EQ(capsule.radius, motion.walker.body.parts[part].radius);
      }
    }
  }
}

TEST(BodyTrack, IsAsNearToItsPlacesAsBoundAndChordSay) {
  Motion motion(11);
  motion.track(lanes());
  for (int cell = 0; cell < 10 * motion.parts(); ++cell) {
    const Capsule &a = motion.capsules[cell], &b = motion.capsules[cell + motion.parts()];
    const double chord = std::max((b.from - a.from).norm(), (b.to - a.to).norm());
    EXPECT_NEAR(motion.motions.nears[cell], motion.motions.bounds[cell].near(chord), 1e-13);
  }
}

// The plain one on every machine, that of AVX2 where there is such.
TEST(BodyTrack, EveryKernelGivesTheSameBits) {
  if (avx2Lanes() == nullptr) GTEST_SKIP() << "a machine without AVX2";
  Motion plain(23), quick(23);
  plain.track(kPlainLanes);
  quick.track(*avx2Lanes());
  for (size_t i = 0; i < plain.capsules.size(); ++i) {
    EXPECT_EQ(plain.capsules[i].from, quick.capsules[i].from);
    EXPECT_EQ(plain.capsules[i].to, quick.capsules[i].to);
    EXPECT_EQ(plain.motions.bounds[i].path, quick.motions.bounds[i].path);
    EXPECT_EQ(plain.motions.bounds[i].bend, quick.motions.bounds[i].bend);
    EXPECT_EQ(plain.motions.nears[i], quick.motions.nears[i]);
  }
}

}  // namespace
}  // namespace amble
