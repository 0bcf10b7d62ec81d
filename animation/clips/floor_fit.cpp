#include "animation/clips/floor_fit.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

#include "animation/body/foot_shape.h"
#include "base/rotation.h"

namespace amble {
namespace {

// Weight that holds the tilt towards level, as so many metres of spread squared: less than 0.2 m
// across says nothing. Rms, from which on a direction's tilt is not ignored.
constexpr double kLevelSpread = 0.2;

// A capture's floor is not tilted by more [rad].
constexpr double kMostTilt = 3.0 * kDegree;
// Fewer places where a foot stood span no plane; what tilt they show is not the floor's, from this
// on [1], [rad].
constexpr int kFewestPlants = 3;
constexpr double kTiltOfFew = 1.5 * kDegree;

std::vector<Eigen::Vector3d> standingAnkles(const FootPaths& paths,
                                            const std::array<double, 2>& legs, double frame_time,
                                            int& plants) {
  std::vector<Eigen::Vector3d> standing;
  for (const Side side : {kLeft, kRight}) {
    const Eigen::MatrixXd& path = paths[side];
    Eigen::Index last = -2;  // the frame in which it last stood
    for (Eigen::Index i = 1; i + 1 < path.rows(); ++i) {
      if (!stands(path, i, legs[side], frame_time)) continue;
      standing.emplace_back(path.row(i).head<3>().transpose());
      plants += i != last + 1;
      last = i;
    }
  }
  return standing;
}

/// The slope of a plane through the samples, by their moments about their mean, where these spread.
Eigen::Vector2d slopeWhereSpread(const Eigen::Matrix2d& moments, const Eigen::Vector2d& rise,
                                 double samples) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(moments);
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  for (int k = 0; k < 2; ++k) {
    const double squares = axes.eigenvalues()[k];
    if (squares < kLevelSpread * kLevelSpread * samples) continue;
    const Eigen::Vector2d axis = axes.eigenvectors().col(k);
    slope += axis * axis.dot(rise) / squares;
  }
  return slope;
}

}  // namespace

FloorFit fitFloor(const Clip& clip, const JointRoles& roles, TiltAcross across) {
  return fitFloor(footPaths(clip, roles), legLengths(clip, roles), clip.frame_time, across);
}

FloorFit fitFloor(const FootPaths& paths, const std::array<double, 2>& legs, double frame_time,
                  TiltAcross across) {
  FloorFit fit;
  const std::vector<Eigen::Vector3d> standing = standingAnkles(paths, legs, frame_time, fit.plants);
  fit.samples = static_cast<int>(standing.size());
  if (standing.empty()) {
    if (paths[kLeft].rows() == 0) return fit;
    fit.height = std::min(paths[kLeft].col(2).minCoeff(), paths[kRight].col(2).minCoeff());
    fit.ankle_mean = fit.height;
    return fit;
  }
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& p : standing) mean += p / static_cast<double>(standing.size());
  const auto samples = static_cast<double>(standing.size());
  Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
  if (across == TiltAcross::kHeld) {
    moments = Eigen::Matrix2d::Identity() * kLevelSpread * kLevelSpread * 0.25 * samples;
  }
  Eigen::Vector2d rise = Eigen::Vector2d::Zero();
  for (const auto& p : standing) {
    const Eigen::Vector2d d = (p - mean).head<2>();
    moments += d * d.transpose();
    rise += d * (p.z() - mean.z());
  }
  const Eigen::Vector2d slope = across == TiltAcross::kHeld
                                    ? Eigen::Vector2d(moments.ldlt().solve(rise))
                                    : slopeWhereSpread(moments, rise, samples);
  fit.normal = Eigen::Vector3d(-slope.x(), -slope.y(), 1.0).normalized();
  fit.height = fit.normal.dot(mean);
  fit.ankle_mean = mean.z();
  double squares = 0.0;
  for (const auto& p : standing) squares += std::pow(fit.normal.dot(p) - fit.height, 2);
  fit.residual = std::sqrt(squares / static_cast<double>(standing.size()));
  return fit;
}

double FloorFit::tilt() const { return std::acos(std::clamp(normal.z(), 0.0, 1.0)); }

std::string doubtOf(const FloorFit& floor) {
  const double degrees = floor.tilt() / kDegree;
  if (floor.tilt() > kMostTilt) {
    return fmt::format("is tilted by {:.1f} degrees, as a ramp: it is left as it is", degrees);
  }
  if (floor.plants < kFewestPlants && floor.tilt() > kTiltOfFew) {
    return fmt::format(
        "looks tilted by {:.1f} degrees from {} places where a foot stood: it is left as it is",
        degrees, floor.plants);
  }
  return "";
}

FloorFit levelPlane(const FloorFit& floor) {
  FloorFit level = floor;
  level.normal = Eigen::Vector3d::UnitZ();
  level.height = floor.ankle_mean;
  return level;
}

Clip levelClip(const Clip& clip, const FloorFit& floor, double ankle_height) {
  const Eigen::Quaterniond turn = turnBetween(floor.normal, Eigen::Vector3d::UnitZ());
  Clip level = clip;
  for (int i = 0; i < level.frames(); ++i) {
    level.poses.p_WR(i) = turn * clip.poses.p_WR(i);
    level.poses.p_WR(i).z() += ankle_height - floor.height;
    Eigen::Quaterniond& q_WR = level.poses.rotations(i)[0];
    q_WR = turn * q_WR;
  }
  return level;
}

}  // namespace amble
