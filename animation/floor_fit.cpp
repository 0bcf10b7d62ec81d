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

std::vector<Eigen::Vector3d> standingAnkles(const FootPaths& paths,
                                            const std::array<double, 2>& legs, double frame_time) {
  std::vector<Eigen::Vector3d> standing;
  for (const Side side : {kLeft, kRight}) {
    const Eigen::MatrixXd& path = paths[side];
    const double slow = kStandingSpeed * legs[side] * 2.0 * frame_time, limit = slow * slow;
    for (Eigen::Index i = 1; i + 1 < path.rows(); ++i) {
      const auto way = path.row(i + 1) - path.row(i - 1);
      if (way.head<3>().squaredNorm() < limit && way.tail<3>().squaredNorm() < limit) {
        standing.emplace_back(path.row(i).head<3>().transpose());
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
  return fitFloor(footPaths(clip, roles), legLengths(clip, roles), clip.frame_time);
}

FloorFit fitFloor(const FootPaths& paths, const std::array<double, 2>& legs, double frame_time) {
  const std::vector<Eigen::Vector3d> standing = standingAnkles(paths, legs, frame_time);
  FloorFit fit;
  fit.samples = static_cast<int>(standing.size());
  if (standing.empty()) {
    if (paths[kLeft].rows() == 0) return fit;
    fit.height = std::min(paths[kLeft].col(2).minCoeff(), paths[kRight].col(2).minCoeff());
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
