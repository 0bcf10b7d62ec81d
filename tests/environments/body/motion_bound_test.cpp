#include "environments/body/motion_bound.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "environments/body/body_track.h"
#include "tests/environments/test_walker.h"

namespace amble {
namespace {

struct Ends {
  Eigen::Vector3d from, to;
};

Ends endsAt(const TestWalker& walker, const Pose& a, const Pose& b, double t, int part) {
  Pose pose;
  pose.rotations.resize(walker.skeleton.size());
  interpolatePose(a, b, t, pose);
  std::vector<JointFrame> frames(walker.skeleton.size());
  forwardKinematics(walker.skeleton, pose, frames);
  const BodyPart& p = walker.body.parts[part];
  return {frames[p.joint] * p.from, frames[p.joint] * p.to};
}

double farther(const Ends& a, const Ends& b) {
  return std::max((a.from - b.from).norm(), (a.to - b.to).norm());
}

Pose moved(const Pose& pose, double angle, double way, std::mt19937_64& generator) {
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto direction = [&] {
    return Eigen::Vector3d(number(generator), number(generator), number(generator));
  };
  Pose result = pose;
  result.p_WR += way * direction();
  for (Eigen::Quaterniond& q : result.rotations) q = q * expRotation(angle * direction());
  return result;
}

std::vector<PartMotion> motionsOf(const TestWalker& walker, const Pose& a, const Pose& b) {
  PoseArray poses(walker.skeleton.size());
  poses.append(a);
  poses.append(b);
  const BodyTrack track(walker.skeleton, walker.body);
  BodyTrack::Scratch scratch = track.makeScratch();
  const size_t parts = walker.body.parts.size();
  std::vector<Capsule> capsules(2 * parts);
  BodyTrack::Motions motions{std::vector<PartMotion>(parts), std::vector<double>(parts)};
  track.place(poses, std::array{0, 1}, capsules, scratch);
  track.measure(poses, 0, 1, capsules, motions, scratch);
  return motions.bounds;
}

TEST(MotionBound, HoldsAtEveryMomentOfRandomMotions) {
  const TestWalker walker;
  std::mt19937_64 generator(2);
  for (const double angle : {0.01, 0.1, 1.0, 2.5}) {
    for (int n = 0; n < 20; ++n) {
      const Pose a = moved(walker.standing(0, 0), 1.0, 1.0, generator),
                 b = moved(a, angle, 0.1 * angle, generator);
      const std::vector<PartMotion> motions = motionsOf(walker, a, b);
      for (size_t part = 0; part < motions.size(); ++part) {
        const int i = static_cast<int>(part);
        const Ends e0 = endsAt(walker, a, b, 0.0, i), e1 = endsAt(walker, a, b, 1.0, i);
        const double near = motions[part].near(farther(e0, e1));
        for (double t = 0.0; t <= 1.0; t += 1.0 / 16) {
          const Ends e = endsAt(walker, a, b, t, i);
          EXPECT_LE(std::min(farther(e, e0), farther(e, e1)), near) << walker.body.parts[part].name;
          EXPECT_LE(farther(e, e0), motions[part].path + 1e-9);
          const Ends line{(1 - t) * e0.from + t * e1.from, (1 - t) * e0.to + t * e1.to};
          EXPECT_LE(farther(e, line), motions[part].bend + 1e-9) << walker.body.parts[part].name;
        }
      }
    }
  }
}

TEST(MotionBound, HalvesHoldForHalves) {
  const TestWalker walker;
  std::mt19937_64 generator(3);
  const Pose a = walker.standing(0, 0), b = moved(a, 0.5, 0.1, generator);
  const std::vector<PartMotion> motions = motionsOf(walker, a, b);
  for (size_t part = 0; part < motions.size(); ++part) {
    const int i = static_cast<int>(part);
    const Ends e0 = endsAt(walker, a, b, 0.0, i), e1 = endsAt(walker, a, b, 0.5, i);
    const double near = motions[part].halved().near(farther(e0, e1));
    for (double t = 0.0; t <= 0.5; t += 1.0 / 32) {
      const Ends e = endsAt(walker, a, b, t, i);
      EXPECT_LE(std::min(farther(e, e0), farther(e, e1)), near);
    }
  }
}

TEST(MotionBound, IsTightForATranslationAndForNoMotion) {
  const TestWalker walker;
  const Pose a = walker.standing(0, 0), b = walker.standing(0.3, 0.4);
  for (const PartMotion& motion : motionsOf(walker, a, b)) {
    EXPECT_NEAR(motion.path, 0.5, 1e-12);
    EXPECT_NEAR(motion.bend, 0.0, 1e-12);
  }
  for (const PartMotion& motion : motionsOf(walker, a, a)) EXPECT_EQ(motion.path, 0.0);
}

TEST(MotionBound, AQuaternionAndItsNegativeAreNoMotion) {
  const TestWalker walker;
  const Pose a = walker.standing(0, 0);
  Pose b = a;
  for (Eigen::Quaterniond& q : b.rotations) q.coeffs() *= -1.0;
  for (const PartMotion& motion : motionsOf(walker, a, b)) EXPECT_EQ(motion.path, 0.0);
}

}  // namespace
}  // namespace amble
