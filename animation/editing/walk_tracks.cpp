#include "animation/editing/walk_tracks.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "animation/clips/foot_paths.h"
#include "animation/editing/knee_hinge.h"
#include "animation/editing/least_curve.h"

namespace amble {
namespace {

// Shares of its length to which a leg may be stretched that was captured shorter: a knee bent by 8
// degrees. Straighter, and it turns by some degrees for each millimetre (synthesis/leg_reach.h).
constexpr double kStraightest = 0.9975;
// A leg that was captured straighter keeps that while its ankle moves by less, seen from its hip
// [m].
constexpr double kSmallChange = 0.005;
// Over which hips go down before a leg is too short, and come up again: half the time of a step, so
// that they do so once a step [s].
constexpr double kDipTime = 0.25;

/// The legs of a frame as they were captured, and where the root was.
struct CapturedFrame {
  std::array<CapturedLeg, 2> legs;
  std::vector<JointFrame> joints;
};

class Follower {
 public:
  Follower(const Clip& clip, const JointRoles& roles)
      : clip_(clip), roles_(roles), hinges_(kneeHinges(clip, roles)) {
    frame_.joints.resize(clip.skeleton.size());
  }

  const CapturedFrame& at(int i) {
    forwardKinematics(clip_, i, frame_.joints);
    for (const Side side : {kLeft, kRight}) {
      const LegJoints& leg = roles_.legs[side];
      const JointFrame& thigh = frame_.joints[leg.up_leg];
      frame_.legs[side] = {thigh.p_WJ, frame_.joints[leg.leg].p_WJ, frame_.joints[leg.foot].p_WJ,
                           thigh.q_WJ * hinges_[side]};
    }
    return frame_;
  }

 private:
  const Clip& clip_;
  const JointRoles& roles_;
  KneeHinges hinges_;
  CapturedFrame frame_;
};

/// How long a leg may be at this frame: as it was captured where nothing is changed.
double longestLeg(const CapturedLeg& leg, const Eigen::Vector3d& way) {
  const double usual = kStraightest * leg.length();
  const double beyond = std::max(0.0, leg.reach() - usual);
  const double changed = (way - (leg.ankle - leg.hip)).norm() / kSmallChange;
  return usual + beyond / (1.0 + changed * changed);
}

/// By how much a hip is too high for its leg [m, >= 0].
double tooHigh(const CapturedLeg& leg, const Eigen::Vector3d& hip, const Eigen::Vector3d& ankle) {
  const Eigen::Vector3d way = ankle - hip;
  const double longest = longestLeg(leg, way);
  if (way.squaredNorm() <= longest * longest) return 0.0;
  const double below = longest * longest - way.head<2>().squaredNorm();
  return std::max(0.0, -way.z() - std::sqrt(std::max(0.0, below)));
}

/// Rotations of a leg's joints, in their parents, after their turns in World.
void turnLeg(const CapturedFrame& frame, const Skeleton& skeleton, const LegJoints& leg,
             const LegChange& change, const Eigen::Quaterniond& q_WF,
             std::span<Eigen::Quaterniond> q) {
  const auto parent = [&](int joint) { return frame.joints[skeleton.joint(joint).parent].q_WJ; };
  q[leg.up_leg] = parent(leg.up_leg).conjugate() * change.thigh * frame.joints[leg.up_leg].q_WJ;
  q[leg.leg] =
      (change.thigh * parent(leg.leg)).conjugate() * change.shank * frame.joints[leg.leg].q_WJ;
  q[leg.foot] = (change.shank * parent(leg.foot)).conjugate() * q_WF;
  for (const int joint : {leg.up_leg, leg.leg, leg.foot}) q[joint].normalize();
}

/// Turns the toes, where they are turned, as their foot was captured.
void turnToes(const CapturedFrame& frame, const Skeleton& skeleton, int toe,
              const Eigen::Quaterniond& turn, std::span<Eigen::Quaterniond> q) {
  if (toe < 0 || turn.vec().isZero(0.0)) return;
  const Eigen::Quaterniond& q_WP = frame.joints[skeleton.joint(toe).parent].q_WJ;
  q[toe] = (q_WP.conjugate() * turn * q_WP * q[toe]).normalized();
}

}  // namespace

WalkTracks tracksOf(const Clip& clip, const JointRoles& roles) {
  WalkTracks tracks;
  std::vector<JointFrame> joints(clip.skeleton.size());
  const FootPaths paths = footPaths(clip, roles);
  for (int i = 0; i < clip.frames(); ++i) {
    forwardKinematics(clip, i, joints);
    tracks.root.push_back(clip.poses.p_WR(i));
    for (const Side side : {kLeft, kRight}) {
      const JointFrame& foot = joints[roles.legs[side].foot];
      tracks.feet[side].ankle.push_back(foot.p_WJ);
      tracks.feet[side].toe.emplace_back(paths[side].block<1, 3>(i, 3).transpose());
      tracks.feet[side].q_WF.push_back(foot.q_WJ);
      tracks.feet[side].toes.push_back(Eigen::Quaterniond::Identity());
    }
  }
  return tracks;
}

Clip followTracks(const Clip& clip, const JointRoles& roles, const WalkTracks& tracks,
                  TrackFit* fit) {
  assert(clip.joint_positions.empty());
  const int frames = clip.frames();
  Clip result = clip;
  Follower captured(clip, roles);
  std::vector<double> missing(frames, 0.0);
  for (int i = 0; i < frames; ++i) {
    const CapturedFrame& frame = captured.at(i);
    const Eigen::Vector3d moved = tracks.root[i] - clip.poses.p_WR(i);
    for (const Side side : {kLeft, kRight}) {
      const double high =
          tooHigh(frame.legs[side], frame.legs[side].hip + moved, tracks.feet[side].ankle[i]);
      if (high > missing[i]) missing[i] = high;
    }
  }
  const std::vector<double> lowered = curveOver(missing, clip.frame_time, kDipTime);
  TrackFit took;
  for (int i = 0; i < frames; ++i) {
    const CapturedFrame& frame = captured.at(i);
    const Eigen::Vector3d root = tracks.root[i] - Eigen::Vector3d(0.0, 0.0, lowered[i]);
    const Eigen::Vector3d moved = root - clip.poses.p_WR(i);
    result.poses.p_WR(i) = root;
    took.lowered = std::max(took.lowered, lowered[i]);
    for (const Side side : {kLeft, kRight}) {
      const CapturedLeg& leg = frame.legs[side];
      const LegChange change = changeLeg(leg, leg.hip + moved, tracks.feet[side].ankle[i]);
      took.missed = std::max(took.missed, change.miss);
      turnLeg(frame, clip.skeleton, roles.legs[side], change, tracks.feet[side].q_WF[i],
              result.poses.rotations(i));
      turnToes(frame, clip.skeleton, roles.legs[side].toe, tracks.feet[side].toes[i],
               result.poses.rotations(i));
    }
  }
  if (fit != nullptr) *fit = took;
  return result;
}

}  // namespace amble
