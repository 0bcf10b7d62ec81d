/// How CollisionWorld measures what is nearest to a motion.
#pragma once

#include "animation/body/pose.h"
#include "environments/body/motion_bound.h"
#include "environments/collision/collision_model.h"
#include "environments/collision/collision_world.h"

namespace amble {

/// The least distance of a body's parts to obstacles, at frames and between them.
///
/// Frames first. Between two of them a point of a part's axis is never farther than `near`
/// (PartMotion) from where it is at the nearer one: where both are farther from everything than the
/// least that is known by that, nothing between them is nearer. Else the interval is halved and its
/// middle measured, until what might be gained is less than kClearanceGap.
class LeastClearance {
 public:
  LeastClearance(const CollisionModel& world, const PoseArray& poses, double limit,
                 CollisionScratch& scratch);

  const Clearance& least() const { return best_; }

 private:
  struct Moment {
    double t;  // [frames, 0 to 1]
    Capsule capsule;
  };
  // A part between two frames.
  struct Piece {
    int frame, part;
  };
  void measure(const Capsule& capsule, const Piece& piece, double between);
  void measureFrame(int frame);
  void measureBetween(const Piece& piece, const Moment& a, const Moment& b,
                      const PartMotion& motion);
  bool mayBeNearer(const Capsule& capsule, const Piece& piece, double by) const;
  bool isSole(int part) const { return world_.body.parts[part].sole >= 0; }

  const CollisionModel& world_;
  const PoseArray& poses_;
  CollisionScratch& scratch_;
  Clearance best_;
};

}  // namespace amble
