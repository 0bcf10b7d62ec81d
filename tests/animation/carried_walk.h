/// Walk cycles by phase: how legs are carried where the walk goes along, to be compared with
/// another's.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <vector>

#include "animation/body/joint_roles.h"
#include "animation/library/fourier.h"
#include "animation/preparation/motion_library_add.h"
#include "animation/synthesis/animation_buffer.h"
#include "base/rotation.h"

namespace amble {

inline constexpr int kCompared = 100;  ///< phases of a cycle

/// What is compared at a phase: flexion of hips, knees and ankles by Side [degrees], the root's
/// height [m].
struct Carried {
  std::array<double, 2> hip, knee, ankle;
  double height;
};

/// Where the walk goes along `heading` [rad].
inline Carried carriedIn(const std::vector<JointFrame>& joints, const JointRoles& roles,
                         double heading) {
  const Eigen::Quaterniond back = aboutZ(-heading);
  Carried c;
  for (const Side side : {kLeft, kRight}) {
    const LegJoints& leg = roles.legs[side];
    const Eigen::Vector3d thigh = back * (joints[leg.leg].p_WJ - joints[leg.up_leg].p_WJ);
    const Eigen::Vector3d shank = back * (joints[leg.foot].p_WJ - joints[leg.leg].p_WJ);
    const Eigen::Vector3d foot = back * (joints[leg.toe].p_WJ - joints[leg.foot].p_WJ);
    c.hip[side] = std::atan2(thigh.x(), -thigh.z()) / kDegree;
    c.knee[side] = std::atan2(thigh.cross(shank).norm(), thigh.dot(shank)) / kDegree;
    c.ankle[side] = (std::atan2(foot.x(), -foot.z()) - std::atan2(shank.x(), -shank.z())) / kDegree;
  }
  c.height = joints[0].p_WJ.z();
  return c;
}

/// The mean of the cycles that a walk of the library was made of, from its capture.
inline std::vector<Carried> carriedInCapture(const MotionLibrary& library, const Motion& motion,
                                             const std::filesystem::path& file) {
  const std::vector<FourierSeries> cycles = capturedCycles(library, motion, file);
  std::vector<JointFrame> joints(library.skeleton.size());
  Pose pose;
  pose.rotations.resize(joints.size());
  std::vector<Carried> carried;
  for (int i = 0; i < kCompared; ++i) {
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(3 + 3 * library.skeleton.size());
    for (const FourierSeries& one : cycles)
      mean +=
          fourierAt(one, static_cast<double>(i) / kCompared) / static_cast<double>(cycles.size());
    pose.p_WR = mean.head<3>();
    for (size_t j = 0; j < joints.size(); ++j)
      pose.rotations[j] = library.stand().rotations[j] * expRotation(mean.segment<3>(3 + 3 * j));
    forwardKinematics(library.skeleton, pose, joints);
    carried.push_back(carriedIn(joints, library.roles, 0.0));
  }
  return carried;
}

/// The fourth cycle of a walk that ends no earlier.
struct CarriedWalk {
  std::vector<Carried> at;                 ///< by phase
  double period = 0.0;                     ///< [s]
  std::array<double, 2> strike, lift_off;  ///< by Side [cycles]
};

inline CarriedWalk carriedWalk(const AnimationBuffer& buffer, const Skeleton& skeleton,
                               const JointRoles& roles) {
  CarriedWalk walk;
  double passed = 0.0;  // cycles
  std::vector<double> phases;
  for (const FrameState& state : buffer.states) {
    if (!phases.empty() && state.phase < phases.back() - passed - 0.5) passed += 1.0;
    phases.push_back(passed + state.phase);
  }
  for (size_t i = 1; i < phases.size(); ++i) {
    for (const Side side : {kLeft, kRight}) {
      const bool before = buffer.states[i - 1].planted[side], now = buffer.states[i].planted[side];
      if (before != now && std::floor(phases[i]) == 3.0) {
        (now ? walk.strike : walk.lift_off)[side] = buffer.states[i].phase;
      }
    }
  }
  std::vector<JointFrame> joints(skeleton.size());
  const auto frameAt = [&](double phase) {
    return std::lower_bound(phases.begin(), phases.end(), phase) - phases.begin();
  };
  walk.period = static_cast<double>(frameAt(4.0) - frameAt(3.0)) * buffer.frame_time;
  for (int i = 0; i < kCompared; ++i) {
    const auto frame = frameAt(3.0 + static_cast<double>(i) / kCompared);
    forwardKinematics(skeleton, buffer.poses[static_cast<int>(frame)], joints);
    walk.at.push_back(carriedIn(joints, roles, buffer.states[frame].heading));
  }
  return walk;
}

/// Root mean square of what two cycles differ by [degrees].
inline double rmsBetween(const std::vector<Carried>& a, const std::vector<Carried>& b,
                         std::array<double, 2> Carried::*angle, Side side) {
  double squares = 0.0;
  for (int i = 0; i < kCompared; ++i)
    squares += std::pow((a[i].*angle)[side] - (b[i].*angle)[side], 2) / kCompared;
  return std::sqrt(squares);
}

inline double leastKnee(const std::vector<Carried>& walk, Side side) {
  double least = 180.0;
  for (const Carried& c : walk) least = std::min(least, c.knee[side]);
  return least;
}

}  // namespace amble
