#include "animation/synthesis/cycle_lanes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "animation/library/harmonics.h"
#include "base/rotation.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

constexpr int kJoints = 5, kChannels = 3 + 3 * kJoints;

// A straight cycle and two turns of fewer harmonics, and four moments that weigh them.
struct Moments {
  std::vector<double> coefficients[3];
  LanePace paces[3];
  LaneBlend blend;
  LaneRoots roots;
  std::vector<double> reference, values = std::vector<double>(4 * kChannels);
  std::vector<double> position = std::vector<double>(12),
                      rotations = std::vector<double>(16 * kJoints);

  explicit Moments(Generator& generator) {
    constexpr int kHarmonics[3] = {6, 3, kMaxHarmonics / 4};
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < kChannels * (2 * kHarmonics[i] + 1); ++k)
        coefficients[i].push_back(uniform(generator, -0.4, 0.4));
      paces[i] = {coefficients[i].data(), kHarmonics[i], uniform(generator, 0.4, 0.8)};
      blend.paces[i].pace = &paces[i];
    }
    blend.count = 3;
    for (int frame = 0; frame < 4; ++frame) {
      const double share = uniform(generator, 0.0, 1.0);
      blend.paces[0].weight[frame] = 1.0;
      blend.paces[1].weight[frame] = share;
      blend.paces[2].weight[frame] = 1.0 - share;
      blend.phase[frame] = uniform(generator, 0.0, 1.0);
      blend.step_length[frame] = uniform(generator, 0.1, 1.0);
      roots.heading[frame] = uniform(generator, -9.0, 9.0);
      roots.lean[frame] = uniform(generator, -0.3, 0.3);
      for (int k = 0; k < 3; ++k) roots.position[4 * k + frame] = uniform(generator, -5.0, 5.0);
    }
    for (int j = 0; j < kJoints; ++j) {
      const Eigen::Quaterniond q = randomRotation(generator);
      reference.insert(reference.end(), {q.x(), q.y(), q.z(), q.w()});
    }
  }

  void make(const CycleKernel& kernel) {
    kernel.blend(blend, kChannels, values.data());
    double* p[4];
    double* q[4];
    for (int frame = 0; frame < 4; ++frame) {
      p[frame] = &position[3 * frame];
      q[frame] = &rotations[4 * kJoints * frame];
    }
    kernel.project(kJoints, reference.data(), values.data(), roots, p, q);
  }

  // Pettré's eq. 2 and 3, with the C library's cosines.
  double exact(int channel, int frame) const {
    double sum = 0.0;
    for (int i = 0; i < blend.count; ++i) {
      const LaneBlend::Weighed& weighed = blend.paces[i];
      const LanePace& pace = *weighed.pace;
      const double* c = pace.coefficients + channel * (2 * pace.harmonics + 1);
      const double warp = blend.step_length[frame] / pace.step;
      double swings = 0.0;
      for (int k = 1; k <= pace.harmonics; ++k) {
        const double angle = 2.0 * kPi * k * blend.phase[frame];
        swings += c[2 * k - 1] * std::cos(angle) + c[2 * k] * std::sin(angle);
      }
      sum += weighed.weight[frame] * (c[0] + warp * swings);
    }
    return sum;
  }
};

TEST(CycleLanes, BlendedChannelsAreTheSumsOfTheirCycles) {
  Generator generator(41);
  for (int trial = 0; trial < 200; ++trial) {
    Moments moments(generator);
    moments.make(cycleKernel());
    for (int channel = 0; channel < kChannels; ++channel)
      for (int frame = 0; frame < 4; ++frame)
        ASSERT_NEAR(moments.values[4 * channel + frame], moments.exact(channel, frame), 1e-13);
  }
}

// On every machine the same bits: of the edges of a roadmap, and so of walks.
TEST(CycleLanes, EveryInstructionSetMakesTheSamePoses) {
  if (avx2Cycles() == nullptr) GTEST_SKIP() << "a machine without AVX2";
  Generator generator(42);
  for (int trial = 0; trial < 200; ++trial) {
    Moments plain(generator);
    plain.make(kPlainCycles);
    const std::vector<double> values = plain.values, position = plain.position,
                              rotations = plain.rotations;
    plain.make(*avx2Cycles());
    ASSERT_EQ(plain.values, values);
    ASSERT_EQ(plain.position, position);
    ASSERT_EQ(plain.rotations, rotations);
  }
}

TEST(CycleLanes, AFrameIsTheSameWhateverIsMadeBesideIt) {
  Generator generator(43);
  for (int trial = 0; trial < 50; ++trial) {
    Moments moments(generator);
    moments.make(cycleKernel());
    const std::vector<double> alone(moments.rotations.begin(),
                                    moments.rotations.begin() + 4 * kJoints);
    for (int frame = 1; frame < 4; ++frame) {
      moments.blend.phase[frame] = uniform(generator, 0.0, 1.0);
      moments.roots.heading[frame] = uniform(generator, -9.0, 9.0);
      for (LaneBlend::Weighed& pace : moments.blend.paces) pace.weight[frame] = 0.0;
    }
    moments.make(cycleKernel());
    ASSERT_TRUE(std::equal(alone.begin(), alone.end(), moments.rotations.begin()));
  }
}

}  // namespace
}  // namespace amble
