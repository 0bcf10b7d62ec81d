#include "animation/grafting/arm_leg_phase.h"

#include <cmath>
#include <vector>

#include "animation/body/pelvis.h"
#include "base/statistics.h"

namespace amble {
namespace {

double correlationOf(const std::vector<double>& a, const std::vector<double>& b) {
  const double mean_a = mean(a), mean_b = mean(b);
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean_a) * (b[i] - mean_b);
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
  }
  return aa * bb > 0.0 ? ab / std::sqrt(aa * bb) : 0.0;
}

}  // namespace

std::array<double, 2> armLegPhase(const Clip& clip, const JointRoles& roles, int first, int last) {
  std::array<std::vector<double>, 2> hands, ankles;
  std::vector<JointFrame> frames(clip.skeleton.size());
  for (int i = first; i <= last; ++i) {
    forwardKinematics(clip, i, frames);
    const double heading = pelvisHeading(frames, roles);
    const Eigen::Vector3d ahead(std::cos(heading), std::sin(heading), 0.0);
    const Eigen::Vector3d middle =
        0.5 * (frames[roles.legs[kLeft].up_leg].p_WJ + frames[roles.legs[kRight].up_leg].p_WJ);
    for (const Side side : {kLeft, kRight}) {
      const ArmJoints& arm = roles.arms[side];
      const int hand = arm.hand >= 0 ? arm.hand : arm.fore_arm;
      hands[side].push_back(ahead.dot(frames[hand].p_WJ - frames[arm.arm].p_WJ));
      ankles[side].push_back(ahead.dot(frames[roles.legs[side].foot].p_WJ - middle));
    }
  }
  return {correlationOf(hands[kLeft], ankles[kRight]), correlationOf(hands[kRight], ankles[kLeft])};
}

}  // namespace amble
