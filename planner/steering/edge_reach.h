/// Which places beyond the ground's open edges somebody's body may be at who stands on it, past
/// walls.
///
/// Whatever of him is over no ground is borne by a foot that is: from there along his bones, by way
/// of chest, pelvis, thigh, shank and foot, to the middle of that foot's sole, which has ground
/// under it. Seen from above that is a curve no longer than kOfBones, as near to ground as bodies
/// lean out, and as it touches nothing it leads through no wall: by that, what is solid at all
/// heights at which a bone may be there. So places count to which, between walls, so short a way
/// leads from ground. What is behind a wall that stands along an edge is reached round its ends
/// only.
///
/// All doubts are decided for the walker: walls are closed surfaces that are no ground, and of
/// these squares in which a bone, as thick as the thinnest, could not be without touching what is
/// solid over their middles; ways lead across corners, too, and are as much longer as one from
/// square to square may be than the curve that visits them. kOfBones was found by trial (see its
/// test).
#pragma once

#include <Eigen/Geometry>
#include <mutex>
#include <vector>

#include "environments/ground/scene_ground.h"
#include "planner/steering/ground_range.h"
#include "planner/steering/near_ground.h"

namespace amble {

class EdgeReach {
 public:
  /// Of stature: of the way from any point of trunk or leg along the bones to a foot that stands,
  /// in plan, at most; and of the least radius of legs and feet about it.
  static constexpr double kOfBones = 0.65, kThinnest = 0.0135;

  /// @param near  where parts are without walls; @param high  of the highest part that is asked
  /// about over the highest ground around [m]. Cost: nothing before it is asked; then linear in the
  /// squares of the ground's open edges, some hundred nanoseconds each.
  /// @pre ground, near and range outlive it
  EdgeReach(const SceneGround& ground, const NearGround& near, const GroundRange& range,
            double stature, double high);

  /// Whether a place counts that is so far from p at most. Threads may share it.
  /// @pre near.has(p, around); @param around  [m, 0 to NearGround::kMostAround]
  bool has(const Eigen::Vector2d& p, double around) const;

 private:
  struct Hit;
  using Square = Eigen::Vector2i;  // across and up, of all squares
  void spread() const;
  bool isWall(const Eigen::Vector2d& p) const;
  Eigen::Vector2d middle(const Square& square) const;
  float* distanceTo(const Square& square) const;

  const SceneGround& ground_;
  const NearGround& near_;
  const GroundRange& range_;
  double high_;
  double longest_;  // way [m]
  int share_;       // squares along a side of one of near_'s
  double side_;     // [m]
  mutable std::once_flag once_;
  mutable std::vector<int> blocks_;       // of each of near_'s squares, x fastest: its block, or -1
  mutable std::vector<float> distances_;  // of share_ by share_ squares of each block [m]
};

}  // namespace amble
