#include "animation/body/foot_shape.h"

#include <algorithm>
#include <cmath>

#include "base/rotation.h"

namespace amble {
namespace {

// The axis of the rest pose that points up: shanks and thighs hang down along it.
Eigen::Vector3d restUp(const Skeleton& skeleton, const JointRoles& roles) {
  Eigen::Vector3d down = Eigen::Vector3d::Zero();
  for (const LegJoints& leg : roles.legs) {
    down += skeleton.joint(leg.leg).offset + skeleton.joint(leg.foot).offset;
  }
  Eigen::Index axis = 0;
  down.cwiseAbs().maxCoeff(&axis);
  return Eigen::Vector3d::Unit(axis) * (down[axis] > 0.0 ? -1.0 : 1.0);
}

// Axes of the heading frame, as columns, in the rest pose's frame, when `forward` is seen along the
// ground.
Eigen::Matrix3d headingAxes(const Eigen::Vector3d& up, const Eigen::Vector3d& forward) {
  Eigen::Matrix3d axes;
  axes.col(2) = up;
  axes.col(0) = (forward - forward.dot(up) * up).normalized();
  axes.col(1) = up.cross(axes.col(0));
  return axes;
}

// Of both ankles over the sole [m].
double ankleHeight(const Skeleton& skeleton, const JointRoles& roles, const Eigen::Vector3d& up,
                   double stature) {
  const auto drop = [&](Side side) { return -skeleton.joint(roles.legs[side].toe).offset.dot(up); };
  const double left = drop(kLeft), right = drop(kRight);
  return std::max(0.5 * (left + right) + kBallHeightOfStature * stature,
                  std::max(left, right) + kLowestBallOfStature * stature);
}

}  // namespace

double statureOf(const Skeleton& skeleton, const JointRoles& roles) {
  const double leg = 0.5 * (roles.legLength(skeleton, kLeft) + roles.legLength(skeleton, kRight));
  return leg / kLegOfStature;
}

Eigen::Quaterniond restToHeading(const Skeleton& skeleton, const JointRoles& roles) {
  const Eigen::Vector3d up = restUp(skeleton, roles);
  Eigen::Vector3d forward = Eigen::Vector3d::Zero();
  for (const LegJoints& leg : roles.legs) {
    const Eigen::Vector3d& toe = skeleton.joint(leg.toe).offset;
    forward += (toe - toe.dot(up) * up).normalized();
  }
  return Eigen::Quaterniond(headingAxes(up, forward).transpose()).normalized();
}

Eigen::Quaterniond restToPelvisHeading(const Skeleton& skeleton, const JointRoles& roles) {
  const Eigen::Vector3d up = restUp(skeleton, roles);
  const auto hip = [&](Side side) -> Eigen::Vector3d {  // in the rest pose, from the hips
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    for (int j = roles.legs[side].up_leg; j > 0; j = skeleton.joint(j).parent) {
      p += skeleton.joint(j).offset;
    }
    return p;
  };
  const Eigen::Vector3d forward = (hip(kLeft) - hip(kRight)).cross(up);
  return Eigen::Quaterniond(headingAxes(up, forward).transpose()).normalized();
}

FootShape makeFootShape(const Skeleton& skeleton, const JointRoles& roles, Side side,
                        double stature) {
  const Eigen::Vector3d up = restUp(skeleton, roles);
  const Joint& toe = skeleton.joint(roles.legs[side].toe);
  const Eigen::Matrix3d axes = headingAxes(up, toe.offset);
  const double ball = toe.offset.dot(axes.col(0));  // from the ankle, forwards
  const double length = kFootLengthOfStature * stature;

  FootShape shape;
  shape.ankle_height = ankleHeight(skeleton, roles, up, stature);
  shape.radius = shape.ankle_height + toe.offset.dot(up);
  double tip = toe.end_sites.empty() ? 0.0 : toe.end_sites[0].dot(axes.col(0));
  if (tip < 0.02 * stature) tip = 0.035 * stature;                    // rigs without a toe's tip
  const double back = std::max(length - ball - tip, 0.02 * stature);  // heel behind the ankle
  const double middle = 0.5 * (ball + tip - back);  // of the sole, before the ankle
  shape.ankle_x = -middle;
  shape.heel_x = -back + shape.radius - middle;
  shape.ball_x = ball - middle;
  shape.tip_x = ball + tip - shape.radius - middle;
  shape.half_width = 0.5 * kFootBreadthOfStature * stature;
  shape.q_SF = Eigen::Quaterniond(axes.transpose()).normalized();
  shape.q_FT = Eigen::Quaterniond::Identity();
  shape.lateral_T = axes.col(1);
  return shape;
}

std::array<FootShape, 2> makeFootShapes(const Skeleton& skeleton, const JointRoles& roles,
                                        double stature) {
  return {makeFootShape(skeleton, roles, kLeft, stature),
          makeFootShape(skeleton, roles, kRight, stature)};
}

Eigen::Quaterniond soleFrame(double heading, const Eigen::Vector3d& normal) {
  const Eigen::Quaterniond turned = aboutZ(heading);
  if (normal.x() == 0.0 && normal.y() == 0.0) return turned;
  return turnBetween(Eigen::Vector3d::UnitZ(), normal) * turned;
}

SoleEnds soleEnds(const FootShape& shape, const Eigen::Vector3d& ankle,
                  const Eigen::Quaterniond& q_WF) {
  const Eigen::Quaterniond q_WS = q_WF * shape.q_SF.conjugate();
  const Eigen::Vector3d under(0.0, 0.0, shape.radius);
  const auto end = [&](double x) -> Eigen::Vector3d {
    return ankle +
           q_WS * Eigen::Vector3d(x - shape.ankle_x, 0.0, shape.radius - shape.ankle_height) -
           under;
  };
  return {end(shape.heel_x), end(shape.ball_x)};
}

double heightOver(const SoleEnds& from, const SoleEnds& to, const SoleEnds& sole) {
  const auto over = [](const Eigen::Vector3d& begin, const Eigen::Vector3d& end,
                       const Eigen::Vector3d& at) {
    const Eigen::Vector3d line = end - begin;
    const double span = line.head<2>().squaredNorm();
    const double share = span > 1e-9 ? (at - begin).head<2>().dot(line.head<2>()) / span : 0.0;
    return (at - begin).z() - share * line.z();
  };
  return std::min(over(from.heel, to.heel, sole.heel), over(from.ball, to.ball, sole.ball));
}

Eigen::Vector3d rolledAnkle(const FootShape& shape, double pitch) {
  const double pivot = pitch < 0.0 ? shape.heel_x : shape.ball_x;
  const double x = shape.ankle_x - pivot, z = shape.ankle_height - shape.radius;
  const double c = std::cos(pitch), s = std::sin(pitch);  // about y: +x goes down
  return {pivot + c * x + s * z, 0.0, shape.radius - s * x + c * z};
}

Eigen::Vector3d rolledBall(const FootShape& shape, double toes) {
  const double length = shape.tip_x - shape.ball_x;
  return {length * (1.0 - std::cos(toes)), 0.0, length * std::sin(toes)};
}

}  // namespace amble
