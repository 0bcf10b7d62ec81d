#include "animation/preparation/bone_pitch.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "tests/animation/default_library.h"

namespace amble {
namespace {

// From the ankle to the toe joint of a sole that is turned, pitched and then rolled so [rad].
Eigen::Vector3d boneOf(const FootShape& shape, double yaw, double pitch, double roll) {
  const Eigen::Vector3d bone(shape.ball_x - shape.ankle_x, 0.0, shape.radius - shape.ankle_height);
  return aboutZ(yaw) * (Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                        (Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()) * bone));
}

TEST(BonePitch, OfASoleThatLiesIsNoneWhicheverWayItPoints) {
  const FootShape shape = defaultLibrary().feet()[kLeft];
  for (const double heading : {-2.0, 0.0, 0.7}) {
    const double down = seenDown(boneOf(shape, heading, 0.0, 0.0), heading);
    EXPECT_NEAR(down, flatDrop(shape), 1e-12);
    EXPECT_NEAR(pitchOfBone(down, 0.0, 0.0, shape), 0.0, 1e-12);
  }
}

// Up to feet that point straight down, and back.
TEST(BonePitch, GivesBackWhatTheSoleWasTurnedBy) {
  for (const Side side : {kLeft, kRight}) {
    const FootShape shape = defaultLibrary().feet()[side];
    for (double pitch = -0.7; pitch < 1.3; pitch += 0.1) {
      for (const double yaw : {-0.4, 0.0, 0.3}) {
        for (const double roll : {-0.3, 0.0, 0.5}) {
          const double heading = 0.9;
          const double down = seenDown(boneOf(shape, heading + yaw, pitch, roll), heading);
          EXPECT_NEAR(pitchOfBone(down, yaw, roll, shape), pitch, 1e-9) << yaw << ' ' << roll;
        }
      }
    }
  }
}

}  // namespace
}  // namespace amble
