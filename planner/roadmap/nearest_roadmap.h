/// A directed k-nearest PRM (after Kavraki, Svestka, Latombe and Overmars, IEEE T-RA 12(4), 1996),
/// to compare with: every free sample becomes a node and is connected, in each direction, with its
/// nearest nodes.
///
/// max_failures counts its samples. Nearest is by straight distance. Samples, threads and seeds as
/// in the visibility roadmap.
#pragma once

#include "planner/roadmap/sampled_roadmap.h"

namespace amble {

class NearestRoadmap : public SampledRoadmap {
 public:
  using SampledRoadmap::SampledRoadmap;

  /// By trial: fewer leave a room in pieces, more cost edges.
  static constexpr int kNeighbours = 6;

 protected:
  Verdict judge(Candidate& candidate, SteeringScratch& scratch) const override;
  long long effort() const override { return samples() - samples_before_; }
  void resetEffort() override { samples_before_ = samples(); }

 private:
  long long samples_before_ = 0;  // the region became wider
};

}  // namespace amble
