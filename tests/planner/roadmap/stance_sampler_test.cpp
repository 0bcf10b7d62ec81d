#include "planner/roadmap/stance_sampler.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/planner/disc_steering.h"

namespace amble {
namespace {

/// Two floors over one another: the lower everywhere, the upper east of x = 4.
class Storeys : public DiscSteering {
 public:
  int layers() const override { return 2; }
  std::vector<double> floors(double x, double) const override {
    return x > 4.0 ? std::vector<double>{0.0, 3.0} : std::vector<double>{0.0};
  }
  bool place(Stance& stance) const override { return stance.position.z() > -1.0; }
  std::optional<SteeringFailure> stand(Stance& stance, SteeringScratch& scratch) const override {
    if (!place(stance)) return SteeringFailure{WalkRule::kNoGround};
    return DiscSteering::stand(stance, scratch);
  }
};

TEST(StanceSampler, SamplesAreFreeWithinBoundsAndRepeat) {
  DiscSteering steering;
  twoRooms(steering, 0.8);
  const StanceSampler sampler(steering, kRoom);
  const SteeringScratchPtr scratch = steering.makeScratch();
  for (std::uint64_t index = 0; index < 200; ++index) {
    auto sample = sampler.draw(7, index, *scratch);
    ASSERT_TRUE(sample.has_value());
    EXPECT_TRUE(kRoom.contains(sample->stance.position.head<2>()));
    EXPECT_FALSE(steering.stand(sample->stance, *scratch));
    EXPECT_EQ(sampler.draw(7, index, *scratch)->stance.position, sample->stance.position);
  }
}

TEST(StanceSampler, UniformSamplesCoverTheRoomEvenly) {
  const DiscSteering empty;
  const StanceSampler sampler(empty, kRoom);
  const SteeringScratchPtr scratch = empty.makeScratch();
  constexpr int kColumns = 4, kRows = 3, kEach = 200;
  std::array<int, kColumns * kRows> count{};
  for (std::uint64_t i = 0; i < kColumns * kRows * kEach; ++i) {
    const Eigen::Vector3d p = sampler.draw(1, 2 * i, *scratch)->stance.position;
    ++count[static_cast<int>(p.x() / 2.0) + kColumns * static_cast<int>(p.y() / 2.0)];
  }
  // A count of a cell has a standard deviation of sqrt(200 * 11/12) = 13.5: five of them.
  for (const int cell : count) EXPECT_NEAR(cell, kEach, 5 * 13.5);
}

TEST(StanceSampler, CoversEveryFloorByItsArea) {
  const Storeys steering;
  const StanceSampler sampler(steering, kRoom);
  const SteeringScratchPtr scratch = steering.makeScratch();
  constexpr int kSamples = 1200;
  int upper = 0, lower_east = 0;
  for (std::uint64_t i = 0; i < kSamples; ++i) {
    const Eigen::Vector3d p = sampler.draw(1, 2 * i, *scratch)->stance.position;
    upper += p.z() == 3.0;
    lower_east += p.z() == 0.0 && p.x() > 4.0;
  }
  // Both are a third of all ground: standard deviation sqrt(1200 * 2/9) = 16.3.
  EXPECT_NEAR(upper, kSamples / 3, 5 * 16.3);
  EXPECT_NEAR(lower_east, kSamples / 3, 5 * 16.3);
}

TEST(StanceSampler, TheBridgeTestFindsThePassageAndFacesAlongIt) {
  DiscSteering steering;
  twoRooms(steering, 0.8);
  const StanceSampler sampler(steering, kRoom);
  const SteeringScratchPtr scratch = steering.makeScratch();
  int within = 0, uniform_within = 0;
  for (std::uint64_t i = 0; i < 300; ++i) {
    const auto in_gap = [](const Stance& stance) {
      return std::abs(stance.position.x() - 4.0) < 0.3 && std::abs(stance.position.y() - 4.5) < 0.4;
    };
    within += in_gap(sampler.draw(3, 2 * i + 1, *scratch)->stance);
    uniform_within += in_gap(sampler.draw(3, 2 * i, *scratch)->stance);
  }
  EXPECT_GT(within, 3 * uniform_within);
}

TEST(StanceSampler, NoFreePlaceIsNoSample) {
  DiscSteering full;
  full.boxes = {box(-1, -1, 9, 7)};
  const SteeringScratchPtr scratch = full.makeScratch();
  EXPECT_FALSE(StanceSampler(full, kRoom).draw(1, 0, *scratch).has_value());
  EXPECT_FALSE(StanceSampler(full, kRoom).draw(1, 1, *scratch).has_value());
}

TEST(StanceSampler, WithinAPartAllSamplesLieInIt) {
  const DiscSteering empty;
  const Eigen::AlignedBox2d part = box(5, -3, 12, 2);
  const StanceSampler sampler = StanceSampler(empty, kRoom).within(part);
  const SteeringScratchPtr scratch = empty.makeScratch();
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Eigen::Vector2d p = sampler.draw(1, i, *scratch)->stance.position.head<2>();
    EXPECT_TRUE(part.contains(p) && kRoom.contains(p));
  }
}

}  // namespace
}  // namespace amble
