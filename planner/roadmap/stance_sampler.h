/// Where samples of a roadmap come from: free standing stances, each of its own random stream.
///
/// Where the ground lies in layers a place of the plane is drawn first and then one of as many
/// floors as there are at most; where it has fewer the draw may miss. So floors are drawn by their
/// area, whichever storey they are on. Stairs and ramps, which are narrow, are in a roadmap before
/// any sample (Steering::passages).
///
/// Samples of even index are uniform, in the bounds and in heading, over the places where the body
/// can stand by any heading: a node is entered and left by turns on the spot. (Along walls lies a
/// strip where a body that faces the right way can stand but not turn. No walk needs it, few edges
/// lead there, and a roadmap that had to cover it would not end.) Those of odd index are drawn by
/// the bridge test (Hsu, Jiang, Reif and Sun, "The bridge test for sampling narrow passages", ICRA
/// 2003): the middle between two places where the body cannot stand, facing along the passage, by
/// which heading alone it must be able to stand. Narrow passages take a small share of a room, and
/// a connector must lie in or in line with one. Where the bridge test finds nothing in its tries
/// the sample is uniform.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>

#include "base/sample_stream.h"
#include "planner/steering/steering.h"

namespace amble {

class StanceSampler {
 public:
  struct Sample {
    Stance stance;
    bool all_round = true;  ///< the body can stand there by any heading
  };

  /// @pre bounds is not empty; steering outlives the sampler.
  StanceSampler(const Steering& steering, const Eigen::AlignedBox2d& bounds)
      : steering_(steering), bounds_(bounds) {}

  /// The free stance of that index, or none where no try was free.
  std::optional<Sample> draw(std::uint64_t seed, std::uint64_t index,
                             SteeringScratch& scratch) const;

  /// The same within a part of the bounds. @pre they meet
  StanceSampler within(const Eigen::AlignedBox2d& part) const {
    return {steering_, bounds_.intersection(part)};
  }

  /// Whether a sample is one that the estimate of coverage may count: uniform.
  static bool isUniform(std::uint64_t index) { return index % 2 == 0; }

  const Steering& steering() const { return steering_; }
  const Eigen::AlignedBox2d& bounds() const { return bounds_; }

 private:
  bool standsAllRound(Stance& stance, SteeringScratch& scratch) const;
  Stance anywhere(SampleStream& stream) const;
  void choose(Stance& stance, SampleStream& stream) const;
  std::optional<Sample> uniform(SampleStream& stream, SteeringScratch& scratch) const;
  std::optional<Sample> bridge(SampleStream& stream, SteeringScratch& scratch) const;

  const Steering& steering_;
  Eigen::AlignedBox2d bounds_;
};

}  // namespace amble
