#include "animation/editing/toe_turn.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rotation.h"
#include "base/sample_stream.h"

namespace amble {
namespace {

constexpr double kToe = 0.07;  // [m]

// A foot that rolls from flat to upright and on, heading one way, its toes bent against it at will.
TEST(ToeTurn, ToesThatHangDownTurnAboutTheAxisAcrossTheirFoot) {
  SampleStream stream(5, 0);
  for (int k = 0; k < 20; ++k) {
    const Eigen::Quaterniond heading = aboutZ(stream.uniform(-kPi, kPi));
    const Eigen::Vector3d across = heading * Eigen::Vector3d(0, -1, 0);
    std::vector<Eigen::Vector3d> bones;
    std::vector<Eigen::Quaterniond> q_WF;
    for (int i = 0; i < 60; ++i) {
      const double pitch = 0.03 * i, bend = stream.uniform(-0.5, 0.2);
      q_WF.push_back(heading * expRotation(Eigen::Vector3d(0, pitch, 0)));
      bones.emplace_back(q_WF.back() * expRotation(Eigen::Vector3d(0, bend, 0)) *
                         Eigen::Vector3d(kToe, 0, 0));
    }
    q_WF.push_back(heading);
    bones.emplace_back(0, 0, -kToe);  // any level axis is across them
    for (const Eigen::Vector3d& axis : toeAxes(bones, q_WF)) {
      EXPECT_LT((axis - across).norm(), 1e-9);
    }
  }
}

TEST(ToeTurn, OfToesThatStandUprightAllTheTimeThereIsNone) {
  const std::vector<Eigen::Vector3d> bones(3, {0, 0, -kToe});
  const std::vector<Eigen::Quaterniond> q_WF(3, Eigen::Quaterniond::Identity());
  for (const Eigen::Vector3d& axis : toeAxes(bones, q_WF)) EXPECT_TRUE(axis.isZero(0.0));
  EXPECT_TRUE(toeAxes({}, {}).empty());
}

TEST(ToeTurn, TurnsTheTipAsMuchHigherAsItIsToBeOrAsHighAsItGets) {
  SampleStream stream(6, 0);
  const Eigen::Vector3d axis(0, -1, 0);
  for (int k = 0; k < 200; ++k) {
    const double pitch = stream.uniform(-0.5 * kPi, 0.4 * kPi);
    const Eigen::Vector3d bone(kToe * std::cos(pitch), 0, kToe * std::sin(pitch));
    const double higher = stream.uniform(0.0, 2.5 * kToe);
    const Eigen::Vector3d turned = Eigen::AngleAxisd(turnUp(bone, axis, higher), axis) * bone;
    EXPECT_NEAR(turned.z(), std::min(bone.z() + higher, kToe), 1e-9);
  }
}

}  // namespace
}  // namespace amble
