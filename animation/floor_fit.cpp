#include "animation/floor_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <vector>

#include "animation/foot_shape.h"
#include "animation/rotation.h"

namespace amble {
namespace {

// Slower than this, in leg lengths a second, a foot stands. Walking feet swing at four; found by
// trial.
constexpr double kStandingSpeed = 0.3;
// Weight that holds the tilt towards level, as so many metres of spread squared: less than 0.2 m
// across says nothing.
constexpr double kLevelSpread = 0.2;

struct FootPath {
  std::vector<Eigen::Vector3d> ankle, toe;  // by frame [m]
};

FootPath footPath(const Clip& clip, const LegJoints& leg) {
  FootPath path;
  std::vector<JointFrame> frames(clip.skeleton.size());
  for (int i = 0; i < clip.frames(); ++i) {
    forwardKinematics(clip, i, frames);
    path.ankle.push_back(frames[leg.foot].p_WJ);
    path.toe.push_back(frames[leg.toe >= 0 ? leg.toe : leg.foot].p_WJ);
  }
  return path;
}

std::vector<Eigen::Vector3d> standingAnkles(const Clip& clip, const JointRoles& roles) {
  std::vector<Eigen::Vector3d> standing;
  for (const Side side : {kLeft, kRight}) {
    const FootPath path = footPath(clip, roles.legs[side]);
    const double slow =
        kStandingSpeed * roles.legLength(clip.skeleton, side) * 2.0 * clip.frame_time;
    for (int i = 1; i + 1 < clip.frames(); ++i) {
      if ((path.ankle[i + 1] - path.ankle[i - 1]).norm() < slow &&
          (path.toe[i + 1] - path.toe[i - 1]).norm() < slow) {
        standing.push_back(path.ankle[i]);
      }
    }
  }
  return standing;
}

// Joint of the other side for every joint; a middle joint is its own.
std::vector<int> mirrorJoints(const Skeleton& skeleton, const JointRoles& roles) {
  std::vector<int> mirror(skeleton.size());
  for (int i = 0; i < skeleton.size(); ++i) mirror[i] = i;
  const auto pair = [&](int a, int b) {
    if (a >= 0 && b >= 0) mirror[a] = b, mirror[b] = a;
  };
  const auto& [left_leg, right_leg] = roles.legs;
  const auto& [left_arm, right_arm] = roles.arms;
  pair(left_leg.up_leg, right_leg.up_leg), pair(left_leg.leg, right_leg.leg);
  pair(left_leg.foot, right_leg.foot), pair(left_leg.toe, right_leg.toe);
  pair(left_arm.shoulder, right_arm.shoulder), pair(left_arm.arm, right_arm.arm);
  pair(left_arm.fore_arm, right_arm.fore_arm), pair(left_arm.hand, right_arm.hand);
  return mirror;
}

}  // namespace

FloorFit fitFloor(const Clip& clip, const JointRoles& roles) {
  const std::vector<Eigen::Vector3d> standing = standingAnkles(clip, roles);
  FloorFit fit;
  fit.samples = static_cast<int>(standing.size());
  if (standing.empty()) {
    fit.height = std::numeric_limits<double>::infinity();
    for (const Side side : {kLeft, kRight}) {
      for (const auto& p : footPath(clip, roles.legs[side]).ankle) {
        fit.height = std::min(fit.height, p.z());
      }
    }
    return fit;
  }
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& p : standing) mean += p / static_cast<double>(standing.size());
  Eigen::Matrix2d moments = Eigen::Matrix2d::Identity() * kLevelSpread * kLevelSpread * 0.25 *
                            static_cast<double>(standing.size());
  Eigen::Vector2d rise = Eigen::Vector2d::Zero();
  for (const auto& p : standing) {
    const Eigen::Vector2d d = (p - mean).head<2>();
    moments += d * d.transpose();
    rise += d * (p.z() - mean.z());
  }
  const Eigen::Vector2d slope = moments.ldlt().solve(rise);
  fit.normal = Eigen::Vector3d(-slope.x(), -slope.y(), 1.0).normalized();
  fit.height = fit.normal.dot(mean);
  double squares = 0.0;
  for (const auto& p : standing) squares += std::pow(fit.normal.dot(p) - fit.height, 2);
  fit.residual = std::sqrt(squares / static_cast<double>(standing.size()));
  return fit;
}

Clip levelClip(const Clip& clip, const FloorFit& floor, double ankle_height) {
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond::FromTwoVectors(floor.normal, Eigen::Vector3d::UnitZ());
  Clip level = clip;
  for (int i = 0; i < level.frames(); ++i) {
    level.poses.p_WR(i) = turn * clip.poses.p_WR(i);
    level.poses.p_WR(i).z() += ankle_height - floor.height;
    Eigen::Quaterniond& q_WR = level.poses.rotations(i)[0];
    q_WR = turn * q_WR;
  }
  return level;
}

Clip mirrorClip(const Clip& clip, const JointRoles& roles) {
  // A joint's rotation mirrored in its rest frame's left-right plane; the root's rotation is A^-1
  // .. A of its rest frame's.
  const Eigen::Quaterniond A = restToHeading(clip.skeleton, roles);  // rest frame in heading frame
  const Eigen::Vector3d left = A.conjugate() * Eigen::Vector3d::UnitY();
  const auto reflect = [](const Eigen::Quaterniond& q, const Eigen::Vector3d& n) {
    const Eigen::Vector3d v = 2.0 * q.vec().dot(n) * n - q.vec();
    return Eigen::Quaterniond(q.w(), v.x(), v.y(), v.z());
  };
  const std::vector<int> mirror = mirrorJoints(clip.skeleton, roles);
  Clip mirrored = clip;
  for (int i = 0; i < clip.frames(); ++i) {
    mirrored.poses.p_WR(i).y() *= -1.0;
    const auto from = clip.poses.rotations(i);
    auto to = mirrored.poses.rotations(i);
    to[0] = reflect(from[0] * A.conjugate(), Eigen::Vector3d::UnitY()) * A;
    for (int j = 1; j < clip.skeleton.size(); ++j) to[j] = reflect(from[mirror[j]], left);
  }
  return mirrored;
}

}  // namespace amble
