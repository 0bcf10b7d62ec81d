/// What an edit of a captured walk moves, frame by frame: the root and both feet. Everything else
/// follows: the legs by inverse kinematics, the upper body as it was captured.
#pragma once

#include <array>
#include <vector>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

/// Where a foot is at each frame [World].
struct FootTrack {
  std::vector<Eigen::Vector3d> ankle;  ///< its joint [m]
  std::vector<Eigen::Vector3d> toe;    ///< its toe joint, or what stands for it (foot_paths.h) [m]
  std::vector<Eigen::Quaterniond> q_WF;  ///< of its joint
  /// What its toes turn by, as its foot was captured, in World: the identity but where they give
  /// way.
  std::vector<Eigen::Quaterniond> toes;

  void move(int frame, const Eigen::Vector3d& by) {
    ankle[frame] += by;
    toe[frame] += by;
  }
  /// About the toe.
  void turn(int frame, const Eigen::Quaterniond& by) {
    ankle[frame] = toe[frame] + by * (ankle[frame] - toe[frame]);
    q_WF[frame] = by * q_WF[frame];
  }
};

struct WalkTracks {
  std::vector<Eigen::Vector3d> root;  ///< p_WR at each frame [m]
  std::array<FootTrack, 2> feet;      ///< by Side
};

WalkTracks tracksOf(const Clip& clip, const JointRoles& roles);

/// What it took to follow tracks.
struct TrackFit {
  double lowered = 0.0;  ///< the most that hips went down for legs to reach [m, >= 0]
  double missed = 0.0;   ///< the farthest that an ankle stays from its track [m, >= 0]
};

/// The clip with root and feet where the tracks have them. Where a leg would have to be longer than
/// it was captured at that frame, and than kStraightest of its length, the hips go down: one smooth
/// curve over all that is missing. Joints but the root's place, thighs, shanks, feet and toes that
/// give way keep their rotations to the bit. Tracks as they were captured give the clip back.
/// @pre a row a frame; no joint_positions
Clip followTracks(const Clip& clip, const JointRoles& roles, const WalkTracks& tracks,
                  TrackFit* fit = nullptr);

}  // namespace amble
