/// A body along a motion: its capsules at frames, and how far they move in the intervals between.
#pragma once

#include <span>
#include <vector>

#include "animation/body/pose.h"
#include "animation/body/skeleton.h"
#include "environments/body/body.h"
#include "environments/body/body_lanes.h"
#include "environments/body/capsule.h"
#include "environments/body/motion_bound.h"

namespace amble {

/// Const after construction: threads may share it, each with its own scratch memory.
class BodyTrack {
 public:
  BodyTrack(const Skeleton& skeleton, const Body& body, const LaneKernel& kernel = lanes());

  using Scratch = std::vector<double>;
  Scratch makeScratch() const { return Scratch(static_cast<size_t>(joints()) * kLaneScratch); }

  /// Capsules of the body in World at these frames, into capsules[frame][part].
  void place(const PoseArray& poses, std::span<const int> frames, std::span<Capsule> capsules,
             Scratch& scratch) const;
  /// How parts move from frame to frame + 1, and PartMotion::near of that [m]; [frame][part].
  struct Motions {
    std::vector<PartMotion> bounds;
    std::vector<double> nears;
  };
  /// Of frames [first, last). @pre frames [first, last] are placed.
  void measure(const PoseArray& poses, int first, int last, std::span<const Capsule> capsules,
               Motions& motions, Scratch& scratch) const;

 private:
  int joints() const { return static_cast<int>(parent_.size()); }
  int parts() const { return static_cast<int>(part_joint_.size()); }
  LaneBody view() const;

  const LaneKernel& kernel_;
  std::vector<int> parent_, part_joint_;
  std::vector<double> offset_, offset_length_, part_from_, part_to_, part_length_, radius_;
};

}  // namespace amble
