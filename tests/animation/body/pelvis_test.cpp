#include "animation/body/pelvis.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "tests/animation/puppet.h"

namespace amble {
namespace {

TEST(Pelvis, HeadingsFollowATurnOfManyRoundsWithoutAJump) {
  const Puppet puppet{.speed = 0.5, .turn_rate = 2.5, .duration = 8.0};
  const std::vector<double> headings = pelvisHeadings(puppet.clip(), Puppet::roles());
  for (size_t i = 0; i < headings.size(); ++i) {
    EXPECT_NEAR(headings[i], 2.5 * static_cast<double>(i) / puppet.rate, 1e-9);
  }
  EXPECT_GT(headings.back(), 3.0 * 2.0 * kPi);
}

TEST(Pelvis, IsInTheMiddleOfTheHipJoints) {
  const Puppet puppet{.turn_rate = 0.4};
  const std::vector<Eigen::Vector3d> path = pelvisPath(puppet.clip(), Puppet::roles());
  for (size_t i = 0; i < path.size(); i += 20) {
    EXPECT_LT((path[i] - puppet.pelvis(static_cast<double>(i) / puppet.rate)).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace amble
