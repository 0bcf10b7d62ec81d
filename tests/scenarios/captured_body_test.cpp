#include "scenarios/captured_body.h"

#include <gtest/gtest.h>

#include <set>

#include "animation/analysis/foot_plants.h"
#include "animation/body/foot_shape.h"
#include "animation/clips/level_capture.h"
#include "tests/animation/captures.h"

namespace amble {
namespace {

using Eigen::Vector3d;

// The first capture of every folder: of each rig one.
std::vector<std::string> oneOfEachRig() {
  std::vector<std::string> files;
  std::set<std::string> seen;
  for (const Capture& capture : captures())
    if (capture.frames < 2000 && seen.insert(capture.path.substr(0, capture.path.find('/'))).second)
      files.push_back(capture.path);
  return files;
}

struct Standing {
  double under = 0.0;  // of the middle of the soles, below the ankle [m]
  double low = 0.0;    // of the soles' undersides over the floor [m]
  double ahead = 0.0;  // share of the soles' length that is along the pelvis' heading [1]
  int times = 0;
};

// The means over the middles of all plants, of both feet.
Standing standingOf(const LevelCapture& level) {
  const Clip& clip = level.motion.clip;
  const JointRoles& roles = level.motion.roles;
  const Body body = capturedBody(clip, roles, 0.0, statureOf(clip.skeleton, roles));
  const FootPlants plants = detectPlants(clip, roles);
  std::vector<JointFrame> frames(clip.skeleton.size());
  Standing sum;
  for (const Side side : {kLeft, kRight}) {
    for (const FootPlant& plant : plants.plants[side]) {
      forwardKinematics(clip, (plant.first + plant.last) / 2, frames);
      const Vector3d left =
          frames[roles.legs[kLeft].up_leg].p_WJ - frames[roles.legs[kRight].up_leg].p_WJ;
      const Vector3d ahead = left.cross(Vector3d::UnitZ()).normalized();
      for (const BodyPart& part : body.parts) {
        if (part.sole != side || part.joint != roles.legs[side].foot) continue;
        const JointFrame& foot = frames[part.joint];
        const Vector3d from = foot * part.from, to = foot * part.to;
        sum.under += foot.p_WJ.z() - 0.5 * (from + to).z();
        sum.low += std::min(from.z(), to.z()) - part.radius;
        sum.ahead += ahead.dot((to - from).normalized());
        ++sum.times;
      }
    }
  }
  for (double* const value : {&sum.under, &sum.low, &sum.ahead}) *value /= std::max(1, sum.times);
  return sum;
}

// Whatever the feet do in the rig's rest pose: of some their toes hang, and a little back.
TEST(CapturedBody, WhereAFootStandsItsSoleIsBelowItsAnkleOnTheFloorAndAhead) {
  AMBLE_NEEDS_CAPTURES();
  int seen = 0;
  for (const std::string& file : oneOfEachRig()) {
    const LevelCapture level = readLevelCapture(sharedFolder() / "mocap" / file);
    const Standing standing = standingOf(level);
    if (standing.times < 4) continue;
    EXPECT_GT(standing.under, 0.0) << file;
    EXPECT_LT(standing.under, 0.12) << file;
    EXPECT_NEAR(standing.low, 0.0, 0.06) << file;
    EXPECT_GT(standing.ahead, 0.6) << file;
    ++seen;
  }
  EXPECT_GE(seen, 3);
}

}  // namespace
}  // namespace amble
