/// A rig like those of captures (y up and facing +z in its rest pose) that walks as a Puppet does:
/// its legs follow the puppet's ankles by inverse kinematics, its chest swings once a cycle and its
/// root bobs twice.
#pragma once

#include <stdexcept>

#include "animation/body/foot_shape.h"
#include "animation/body/two_link.h"
#include "tests/animation/puppet.h"

namespace amble {

struct Rig {
  static constexpr double kThigh = 0.46, kShank = 0.46, kHalfHips = 0.09;  // [m]
  static constexpr double kChestSwing = 0.2;  // about the rest's y [rad]
  static constexpr double kBob = 0.01;        // [m]

  Skeleton skeleton{joints()};
  JointRoles roles = rolesOf();
  std::array<FootShape, 2> feet{shapeOf(kLeft), shapeOf(kRight)};

  static std::vector<Joint> joints() {
    const double ball = kBallHeightOfStature * (kThigh + kShank) / kLegOfStature;
    std::vector<Joint> joints(10);
    joints[0].name = "Hips";
    for (int side : {0, 1}) {
      const std::string name = side == 0 ? "Left" : "Right";
      const std::array<std::string, 4> names = {"UpLeg", "Leg", "Foot", "ToeBase"};
      const std::array<Eigen::Vector3d, 4> offsets = {
          Eigen::Vector3d(side == 0 ? kHalfHips : -kHalfHips, 0, 0), Eigen::Vector3d(0, -kThigh, 0),
          Eigen::Vector3d(0, -kShank, 0), Eigen::Vector3d(0, ball - Puppet::kAnkle, Puppet::kFoot)};
      for (int i = 0; i < 4; ++i) {
        Joint& joint = joints[1 + 4 * side + i];
        joint.name = name + names[i];
        joint.parent = i == 0 ? 0 : 4 * side + i;
        joint.offset = offsets[i];
      }
      joints[4 + 4 * side].end_sites.push_back({0, 0, 0.06});
    }
    joints[9].name = "Chest";
    joints[9].parent = 0;
    joints[9].offset = {0, 0.3, 0};
    return joints;
  }

  static JointRoles rolesOf() {
    JointRoles roles = Puppet::roles();
    roles.chest = 9;
    return roles;
  }

  FootShape shapeOf(Side side) const {
    return makeFootShape(skeleton, roles, side, statureOf(skeleton, roles));
  }
  /// The rest pose's rotations, the root's against the heading: what cycles are relative to.
  std::vector<Eigen::Quaterniond> reference() const {
    std::vector<Eigen::Quaterniond> q(skeleton.size(), Eigen::Quaterniond::Identity());
    q[0] = restToHeading(skeleton, roles);
    return q;
  }

  Clip walk(const Puppet& puppet) const;

 private:
  void placeLeg(Side side, const Puppet& puppet, double t, PoseArray& poses, int frame) const;
};

inline void Rig::placeLeg(Side side, const Puppet& puppet, double t, PoseArray& poses,
                          int frame) const {
  const LegJoints& leg = roles.legs[side];
  std::vector<JointFrame> joint(skeleton.size());
  forwardKinematics(skeleton, poses[frame], joint);
  const auto [p_flat, heading] = puppet.ankle(side, t);
  const double pitch = puppet.pitch != nullptr ? puppet.pitch(puppet.at(side, t)) : 0.0;
  const Eigen::Vector3d p_ankle =
      p_flat + aboutZ(heading) * (rolledAnkle(feet[side], pitch) - rolledAnkle(feet[side], 0.0));
  const TwoLink links{joint[leg.up_leg].p_WJ, joint[leg.leg].p_WJ, joint[leg.foot].p_WJ,
                      joint[0].q_WJ * Eigen::Vector3d::UnitX()};
  const auto solved = solveTwoLink(links, p_ankle);
  if (!solved) throw std::logic_error("the puppet's ankle is out of the rig's reach");
  const Eigen::Quaterniond q_WThigh = solved->thigh * joint[leg.up_leg].q_WJ;
  const Eigen::Quaterniond q_WShank = solved->shank * joint[leg.leg].q_WJ;
  auto q = poses.rotations(frame);
  q[leg.up_leg] = joint[0].q_WJ.conjugate() * q_WThigh;
  q[leg.leg] = q_WThigh.conjugate() * q_WShank;
  q[leg.foot] = q_WShank.conjugate() * aboutZ(heading) *
                Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) * feet[side].q_SF;
}

inline Clip Rig::walk(const Puppet& puppet) const {
  Clip clip;
  clip.name = "rig";
  clip.skeleton = skeleton;
  clip.frame_time = 1.0 / puppet.rate;
  clip.poses = PoseArray(skeleton.size());
  clip.poses.resize(static_cast<int>(std::lround(puppet.duration * puppet.rate)) + 1);
  for (int i = 0; i < clip.frames(); ++i) {
    const double t = i * clip.frame_time, turn = 2.0 * kPi * t / puppet.period;
    clip.poses.p_WR(i) = puppet.pelvis(t) + Eigen::Vector3d(0, 0, kBob * std::cos(2.0 * turn));
    clip.poses.rotations(i)[0] = aboutZ(puppet.heading(t)) * reference()[0];
    clip.poses.rotations(i)[9] = expRotation({0, kChestSwing * std::sin(turn), 0});
    for (const Side side : {kLeft, kRight}) placeLeg(side, puppet, t, clip.poses, i);
  }
  return clip;
}

}  // namespace amble
