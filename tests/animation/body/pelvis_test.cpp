#include "animation/body/pelvis.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "tests/animation/puppet.h"
#include "tests/animation/random_clip.h"

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

TEST(Pelvis, TurnsWithItsBodyAndIsMirroredWithIt) {
  Generator generator(441);
  const JointRoles roles = Puppet::roles();
  for (int i = 0; i < 100; ++i) {
    std::vector<JointFrame> joints(9), image(9);
    for (int j = 0; j < 9; ++j) joints[j].p_WJ = randomVector(generator, 1.0);
    const double heading = pelvisHeading(joints, roles), turn = uniform(generator, -3.0, 3.0);
    for (int j = 0; j < 9; ++j) {
      const Eigen::Vector3d& p = joints[j < 1 ? 0 : j < 5 ? j + 4 : j - 4].p_WJ;
      image[j].p_WJ = {p.x(), -p.y(), p.z()};
    }
    EXPECT_NEAR(wrapAngle(pelvisHeading(image, roles) + heading), 0.0, 1e-12);
    const Eigen::Vector3d shift = randomVector(generator, 9.0);
    for (JointFrame& joint : joints) joint.p_WJ = aboutZ(turn) * joint.p_WJ + shift;
    EXPECT_NEAR(wrapAngle(pelvisHeading(joints, roles) - heading - turn), 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace amble
