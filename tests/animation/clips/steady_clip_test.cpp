#include "animation/clips/steady_clip.h"

#include <gtest/gtest.h>

#include <random>

#include "animation/captures/capture_checks.h"
#include "base/rotation.h"
#include "tests/animation/person.h"

namespace amble {
namespace {

TEST(SteadyClip, AStillClipStaysToTheDigit) {
  Clip clip = walkingPerson();
  for (int i = 1; i < clip.frames(); ++i) {
    const auto first = clip.poses.rotations(0);
    std::copy(first.begin(), first.end(), clip.poses.rotations(i).begin());
  }
  const Clip steady = steadied(clip);
  for (int i = 0; i < clip.frames(); ++i) {
    for (int j = 0; j < clip.skeleton.size(); ++j) {
      EXPECT_LT(steady.poses.rotations(i)[j].angularDistance(clip.poses.rotations(i)[j]), 1e-7);
    }
  }
}

TEST(SteadyClip, ASwingKeepsItsSizeAndNoiseDoesNot) {
  Clip clip = walkingPerson();
  const int frames = clip.frames();
  for (int i = 0; i < frames; ++i) {
    // Once a second; q and -q are the same turn.
    const double angle = 0.5 * std::sin(2.0 * kPi * i * clip.frame_time);
    for (Eigen::Quaterniond& q : clip.poses.rotations(i)) {
      q = expRotation({angle, 0, 0});
      if (i % 2 == 1) q.coeffs() *= -1.0;
    }
  }
  const Clip steady = steadied(clip, 0.05);
  const double share = std::exp(-0.5 * std::pow(2.0 * kPi * 0.05, 2));
  for (int i = 6; i + 6 < frames; ++i) {
    const double angle = 0.5 * share * std::sin(2.0 * kPi * i * clip.frame_time);
    EXPECT_LT(steady.poses.rotations(i)[3].angularDistance(expRotation({angle, 0, 0})), 0.01);
  }
  std::mt19937_64 generator(1);
  std::normal_distribution<double> noise(0.0, 0.03);
  for (int i = 0; i < frames; ++i) {
    for (Eigen::Quaterniond& q : clip.poses.rotations(i))
      q = q * expRotation({noise(generator), 0, 0});
  }
  EXPECT_LT(jointJitter(steadied(clip)), 0.1 * jointJitter(clip));
}

}  // namespace
}  // namespace amble
