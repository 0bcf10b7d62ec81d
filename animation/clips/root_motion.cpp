#include "animation/clips/root_motion.h"

#include <cassert>

#include "animation/body/pelvis.h"
#include "base/rotation.h"

namespace amble {

RootStep RootMotion::step(int i) const {
  const RootPlace &from = places[i], &to = places[i + 1];
  return {Eigen::Rotation2Dd(-from.heading) * (to.at - from.at), to.heading - from.heading};
}

RootMotion rootMotion(const Clip& clip, const JointRoles& roles, int first, int last) {
  assert(first >= 0 && first <= last && last < clip.frames());
  RootMotion motion;
  std::vector<JointFrame> joints(clip.skeleton.size());
  double heading = 0.0;
  for (int i = first; i <= last; ++i) {
    forwardKinematics(clip, i, joints);
    const double faced = pelvisHeading(joints, roles);
    heading = i == first ? faced : heading + wrapAngle(faced - heading);
    const Eigen::Vector3d& p = clip.poses.p_WR(i);
    motion.places.push_back({p.head<2>(), heading});
    motion.carriages.push_back({p.z(), aboutZ(-heading) * clip.poses.rotations(i)[0]});
  }
  return motion;
}

RootPlace advanced(const RootPlace& from, const RootStep& step) {
  return {from.at + Eigen::Rotation2Dd(from.heading) * step.way, from.heading + step.yaw};
}

RootStep mixed(const RootStep& a, const RootStep& b, double weight) {
  return {(1.0 - weight) * a.way + weight * b.way, (1.0 - weight) * a.yaw + weight * b.yaw};
}

RootCarriage mixed(const RootCarriage& a, const RootCarriage& b, double weight) {
  return {(1.0 - weight) * a.height + weight * b.height, a.q_HR.slerp(weight, b.q_HR)};
}

void placeRoot(PoseArray& poses, int frame, const RootPlace& place, const RootCarriage& carriage) {
  poses.p_WR(frame) << place.at, carriage.height;
  poses.rotations(frame)[0] = (aboutZ(place.heading) * carriage.q_HR).normalized();
}

Eigen::Vector3d GroundShift::operator*(const Eigen::Vector3d& p) const {
  Eigen::Vector3d moved = aboutZ(turn) * p;
  moved.head<2>() += shift;
  return moved;
}

JointFrame GroundShift::operator*(const JointFrame& joint) const {
  return {aboutZ(turn) * joint.q_WJ, *this * joint.p_WJ};
}

GroundShift between(const RootPlace& from, const RootPlace& to) {
  const double turn = to.heading - from.heading;
  return {turn, to.at - Eigen::Rotation2Dd(turn) * from.at};
}

void moveRoot(PoseArray& poses, int first, int last, const GroundShift& by) {
  for (int i = first; i <= last; ++i) {
    poses.p_WR(i) = by * poses.p_WR(i);
    poses.rotations(i)[0] = (aboutZ(by.turn) * poses.rotations(i)[0]).normalized();
  }
}

}  // namespace amble
