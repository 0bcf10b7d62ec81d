#include "animation/captures/motion_guesses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "animation/body/pelvis.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr int kSamples = 64;  // frames that are looked at, spread over the clip [1, >= 1]

// The head is over the feet along an axis that is the vertical: it makes up that much of the way
// from feet to head, as a mean over the clip. By trial; a deep bow has 0.7. [0, 1]
constexpr double kUpright = 0.8;

// A person who only walks about stays within that much along the vertical. [leg lengths]
constexpr double kVerticalRange = 1.5;

// Less travel than that says nothing of a direction. [leg lengths]
constexpr double kTravel = 1.0;

int stepOver(const Clip& clip) { return std::max(1, clip.frames() / kSamples); }

/// From between the feet to the head, as a unit vector, mean over the clip, in the clip's axes.
Eigen::Vector3d meanStanding(const Clip& clip, const JointRoles& roles) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  std::vector<JointFrame> joints(clip.skeleton.size());
  for (int i = 0; i < clip.frames(); i += stepOver(clip), ++count) {
    forwardKinematics(clip, i, joints);
    const Eigen::Vector3d feet =
        0.5 * (joints[roles.legs[kLeft].foot].p_WJ + joints[roles.legs[kRight].foot].p_WJ);
    sum += (joints[roles.head].p_WJ - feet).normalized();
  }
  return sum / std::max(1, count);
}

double rootRange(const Clip& clip, int axis) {
  double low = clip.poses.p_WR(0)[axis], high = low;
  for (int i = 1; i < clip.frames(); ++i) {
    low = std::min(low, clip.poses.p_WR(i)[axis]);
    high = std::max(high, clip.poses.p_WR(i)[axis]);
  }
  return high - low;
}

/// Mean of where the feet point, across the vertical, as seen from the pelvis' heading: x along it,
/// y to its left [1]. Zero where the rig has no toes.
Eigen::Vector2d meanToes(const Clip& clip, const JointRoles& roles,
                         const std::vector<double>& headings) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int count = 0;
  std::vector<JointFrame> joints(clip.skeleton.size());
  for (int i = 0; i < clip.frames(); i += stepOver(clip)) {
    forwardKinematics(clip, i, joints);
    for (const LegJoints& leg : roles.legs) {
      if (leg.toe < 0) continue;
      const Eigen::Vector3d toe = joints[leg.toe].p_WJ - joints[leg.foot].p_WJ;
      const double length = toe.norm();
      if (!(length > 0.0)) continue;
      sum += (aboutZ(-headings[i]) * toe).head<2>() / length;
      ++count;
    }
  }
  return sum / std::max(1, count);
}

/// How far the pelvis goes along and across its heading over the clip [m].
Eigen::Vector2d travel(const Clip& clip, const JointRoles& roles,
                       const std::vector<double>& headings) {
  const std::vector<Eigen::Vector3d> path = pelvisPath(clip, roles);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (size_t i = 1; i < path.size(); ++i) {
    sum += (aboutZ(-headings[i]) * (path[i] - path[i - 1])).head<2>();
  }
  return sum;
}

std::string travelText(const Eigen::Vector2d& way, double leg) {
  if (!(way.norm() > kTravel * leg)) return "stays where it is";
  const double off = std::atan2(way.y(), way.x()) / kDegree;
  const char* const how = std::abs(off) < 45.0    ? "forwards"
                          : std::abs(off) > 135.0 ? "backwards"
                                                  : "sideways";
  return fmt::format("goes {}, {:.0f} degrees off it", how, std::abs(off));
}

}  // namespace

Reading<UpAxis> guessUp(const Clip& clip, const JointRoles& roles) {
  if (clip.frames() == 0) return {UpAxis::kY, true, false, "y, guessed: there are no frames"};
  const Eigen::Vector3d standing = meanStanding(clip, roles);
  const double y = standing.y(), z = standing.z();
  const bool level = rootRange(clip, 2) < kVerticalRange * roles.meanLeg(clip.skeleton);
  if (z > kUpright && level) {
    return {UpAxis::kZ, true, true,
            fmt::format("z, guessed: the head is over the feet ({:.2f})", z)};
  }
  const bool sure = y > kUpright;
  const char* const why = sure ? "guessed: the head is over the feet"
                               : "guessed as the usual one: the head is not over the feet";
  return {UpAxis::kY, true, sure, fmt::format("y, {} ({:.2f})", why, y)};
}

Reading<double> guessFacing(const Clip& clip, const JointRoles& roles) {
  if (clip.frames() == 0) return {0.0, true, false, "0, guessed: there are no frames"};
  const std::vector<double> headings = pelvisHeadings(clip, roles);
  Reading<double> facing{wrapAngle(headings[0]), true, true, ""};
  const Eigen::Vector2d toes = meanToes(clip, roles, headings);
  facing.text =
      fmt::format("{:.1f} degrees, guessed: across the hip joints; {}", facing.value / kDegree,
                  travelText(travel(clip, roles, headings), roles.meanLeg(clip.skeleton)));
  if (toes.x() < 0.0) {
    facing.sure = false;
    facing.text += "; but the feet point the other way: are left and right exchanged?";
  }
  return facing;
}

}  // namespace amble
