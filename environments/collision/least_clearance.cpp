#include "environments/collision/least_clearance.h"

#include "environments/collision/motion_check.h"

namespace amble {

LeastClearance::LeastClearance(const CollisionModel& world, const PoseArray& poses, double limit,
                               CollisionScratch& scratch)
    : world_(world), poses_(poses), scratch_(scratch), best_{limit} {
  scratch_.prepare(poses.size());
  // Coarse frames first: a small distance found early spares most of the exact queries.
  for (int frame = 0; frame < poses.size(); frame += kStrides[0]) measureFrame(frame);
  for (int frame = 0; frame < poses.size(); ++frame)
    if (frame % kStrides[0] != 0) measureFrame(frame);
  const int last = poses.size() - 1;
  if (last < 1) return;
  world_.track.measure(poses, 0, last, scratch_.capsules, scratch_.motions, scratch_.lanes);
  for (int frame = 0; frame < last; ++frame) {
    for (int part = 0; part < world_.parts(); ++part)
      measureBetween({frame, part}, {0.0, scratch_.capsule(frame, part)},
                     {1.0, scratch_.capsule(frame + 1, part)}, scratch_.motion(frame, part));
  }
}

void LeastClearance::measure(const Capsule& capsule, const Piece& piece, double between) {
  const ObstacleSet::Nearest nearest =
      world_.layers.nearestObstacle(capsule, best_.distance, isSole(piece.part), *scratch_.exact);
  if (nearest.object >= 0)
    best_ = {nearest.distance, piece.frame, between, piece.part, nearest.object};
}

void LeastClearance::measureFrame(int frame) {
  const size_t parts = static_cast<size_t>(world_.parts());
  world_.place(poses_[frame], scratch_, {&scratch_.capsule(frame, 0), parts});
  for (int part = 0; part < world_.parts(); ++part)
    measure(scratch_.capsule(frame, part), {frame, part}, 0.0);
}

bool LeastClearance::mayBeNearer(const Capsule& capsule, const Piece& piece, double by) const {
  const double limit = best_.distance + by;
  return world_.layers.nearestObstacle(capsule, limit, isSole(piece.part), *scratch_.exact)
             .object >= 0;
}

void LeastClearance::measureBetween(const Piece& piece, const Moment& a, const Moment& b,
                                    const PartMotion& motion) {
  const double gain = motion.near(chordOf(a.capsule, b.capsule)) - kClearanceGap;
  if (gain <= 0.0 || best_.distance <= 0.0) return;
  if (!mayBeNearer(a.capsule, piece, gain) && !mayBeNearer(b.capsule, piece, gain)) return;
  const double t = 0.5 * (a.t + b.t);
  const Moment middle{t, world_.placeBetween(poses_[piece.frame], poses_[piece.frame + 1], t,
                                             piece.part, scratch_)};
  measure(middle.capsule, piece, middle.t);
  measureBetween(piece, a, middle, motion.halved());
  measureBetween(piece, middle, b, motion.halved());
}

}  // namespace amble
