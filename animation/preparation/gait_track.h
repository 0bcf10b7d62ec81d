/// A captured walk as seen by its feet and root, at any time between frames: what the preparation
/// of cycles reads.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "animation/analysis/foot_plants.h"
#include "animation/body/clip.h"
#include "animation/body/foot_shape.h"
#include "animation/body/joint_roles.h"

namespace amble {

/// A foot on the ground. One that the clip cuts off is as long as the others.
struct Plant {
  double strike;    ///< [frames]
  double lift_off;  ///< [frames, > strike]
};

class GaitTrack {
 public:
  /// @param plants  of the clip, where they are known; null: they are detected
  GaitTrack(const Clip& level, const JointRoles& roles, const std::array<FootShape, 2>& feet,
            const FootPlants* plants = nullptr);

  const Clip& clip() const { return clip_; }
  const JointRoles& roles() const { return roles_; }
  const std::vector<Plant>& plants(Side side) const { return plants_[side]; }

  /// The pose between two frames, as a player shows it. @pre 0 <= frame <= frames - 1
  void poseAt(double frame, Pose& pose) const;
  /// Joint frames at that time, valid until the next call.
  const std::vector<JointFrame>& jointsAt(double frame) const;
  /// Heading of the pelvis [rad].
  double headingAt(double frame) const;

  /// The foot's sole at mid-stance, where it is flat: its footprint and what the capture's foot
  /// rotation must be turned by to be flat then (marker sets let feet point up by 20 degrees in one
  /// stance and not in the next).
  struct FlatFoot {
    Eigen::Vector3d print;          ///< middle of the sole on the ground [m]
    double heading;                 ///< [rad]
    Eigen::Quaterniond correction;  ///< in the sole frame
  };
  FlatFoot flatFoot(Side side, const Plant& plant) const;

  /// Sole's rotation in World, corrected.
  Eigen::Quaterniond sole(Side side, double frame, const Eigen::Quaterniond& correction) const;
  Eigen::Vector3d ankle(Side side, double frame) const;
  /// From the ankle to the toe joint, in World [m].
  Eigen::Vector3d footBone(Side side, double frame) const;
  /// How far that bone drops below level while the sole is down, in the mean: from a tenth of the
  /// stance, when the fore foot has landed, to half of it, when the heel begins to rise [rad].
  double standingDrop(Side side, const Plant& plant) const;
  static constexpr double kDownFrom = 0.1, kDownUntil = 0.5;  ///< [stances]

 private:
  void takePlants(const FootPlants& found);

  const Clip& clip_;
  JointRoles roles_;
  std::array<FootShape, 2> feet_;
  std::array<std::vector<Plant>, 2> plants_;
  mutable Pose pose_;
  mutable std::vector<JointFrame> joints_;
};

}  // namespace amble
