#include "animation/captures/step_rhythm.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "animation/body/pelvis.h"
#include "base/rotation.h"
#include "base/statistics.h"

namespace amble {
namespace {

// A foot has passed the other when it is so far in front of where it was behind: far above what
// noise does, far below a step. By trial. [leg lengths]
constexpr double kPassed = 0.12;

// So much less than a step are the ankles apart when both feet are down: the one behind has rolled
// over its ball. Measured on captures [1].
constexpr double kRolled = 0.1;

constexpr double kUsualLeg = 0.83;  // thigh + shank at a stature of 1.7 m (Winter) [m]

/// What the rhythm needs of a clip, by frame.
struct FeetTrack {
  std::vector<double> ahead;  // left foot before the right along the pelvis' heading
  std::vector<double> apart;  // its ball before the right one's; the ankles where a foot has none
  std::vector<double> lower;  // the lower foot before the pelvis
  std::vector<int> side;      // which foot is the lower one
  std::vector<Eigen::Vector3d> pelvis;
};

FeetTrack trackFeet(const Clip& clip, const JointRoles& roles) {
  FeetTrack track;
  std::vector<JointFrame> joints(clip.skeleton.size());
  const bool balls = roles.legs[kLeft].toe >= 0 && roles.legs[kRight].toe >= 0;
  for (int i = 0; i < clip.frames(); ++i) {
    forwardKinematics(clip, i, joints);
    const double heading = pelvisHeading(joints, roles);
    const Eigen::Vector3d forward(std::cos(heading), std::sin(heading), 0.0);
    const Eigen::Vector3d pelvis =
        0.5 * (joints[roles.legs[kLeft].up_leg].p_WJ + joints[roles.legs[kRight].up_leg].p_WJ);
    const Eigen::Vector3d left = joints[roles.legs[kLeft].foot].p_WJ;
    const Eigen::Vector3d right = joints[roles.legs[kRight].foot].p_WJ;
    const bool left_is_lower = left.z() < right.z();
    track.ahead.push_back(forward.dot(left - right));
    track.lower.push_back(forward.dot((left_is_lower ? left : right) - pelvis));
    track.side.push_back(left_is_lower ? kLeft : kRight);
    track.apart.push_back(balls ? forward.dot(joints[roles.legs[kLeft].toe].p_WJ -
                                              joints[roles.legs[kRight].toe].p_WJ)
                                : track.ahead.back() / (1.0 - kRolled));
    track.pelvis.push_back(pelvis);
  }
  return track;
}

/// Frames at which the feet pass one another: `ahead` goes through its mean, by at least `least` on
/// both sides.
std::vector<int> passings(const std::vector<double>& ahead, double least) {
  double mean = 0.0;
  for (const double x : ahead) mean += x / static_cast<double>(ahead.size());
  std::vector<int> frames;
  int last = 0;
  for (size_t i = 0; i < ahead.size(); ++i) {
    const double x = ahead[i] - mean;
    const int side = x > least ? 1 : x < -least ? -1 : 0;
    if (side == 0 || side == last) continue;
    if (last != 0) frames.push_back(static_cast<int>(i));
    last = side;
  }
  return frames;
}

/// Mean length of the steps: how far apart the feet are at most between two passings. Less than 0
/// where the lower foot goes forwards under the pelvis, as of one who walks backwards [file units].
double stepLength(const FeetTrack& track, const std::vector<int>& passed) {
  double sum = 0.0, back = 0.0;
  for (size_t i = 1; i < passed.size(); ++i) {
    double apart = 0.0;
    for (int k = passed[i - 1]; k < passed[i]; ++k) {
      apart = std::max(apart, std::abs(track.apart[k]));
      if (track.side[k] == track.side[k + 1]) back += track.lower[k] - track.lower[k + 1];
    }
    sum += apart;
  }
  return std::copysign(sum / static_cast<double>(passed.size() - 1), back);
}

}  // namespace

StepRhythm stepRhythm(const Clip& clip, const JointRoles& roles) {
  const double leg =
      0.5 * (roles.legLength(clip.skeleton, kLeft) + roles.legLength(clip.skeleton, kRight));
  StepRhythm rhythm;
  if (clip.frames() < 2 || !(leg > 0.0)) return rhythm;
  const FeetTrack track = trackFeet(clip, roles);
  const std::vector<int> passed = passings(track.ahead, kPassed * leg);
  rhythm.steps = static_cast<int>(passed.size());
  if (passed.size() < 2) return rhythm;
  const int first = passed.front(), last = passed.back();
  const double time = (last - first) * clip.frame_time;
  rhythm.cadence = static_cast<double>(passed.size() - 1) / time;
  // From step to step: what sways in between is no way.
  double way = 0.0;
  rhythm.least_step = time;
  for (size_t i = 1; i < passed.size(); ++i) {
    rhythm.least_step = std::min(rhythm.least_step, (passed[i] - passed[i - 1]) * clip.frame_time);
    way += (track.pelvis[passed[i]] - track.pelvis[passed[i - 1]]).head<2>().norm();
  }
  rhythm.speed = way / (time * leg);
  rhythm.ground_speed = stepLength(track, passed) * rhythm.cadence / leg;
  return rhythm;
}

double cadenceOverUsual(const StepRhythm& rhythm, double leg) {
  if (!(rhythm.speed > 0.0)) return 0.0;
  const double usual = 0.743 * std::sqrt(rhythm.speed) * std::pow(kUsualLeg / leg, 0.25);
  return 0.5 * rhythm.cadence / usual;
}

}  // namespace amble
