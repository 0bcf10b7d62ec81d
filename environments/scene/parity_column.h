/// Inside or outside of many solids along a vertical, asked upwards.
///
/// Parity asks for each point along a ray of its own, all of them a little off the vertical: as
/// many passes over all surfaces as there are points. Here points share a ray for as long as it
/// stays beside the vertical, its crossings sorted once. A point of that ray lies beside the point
/// asked for, at the same height, and where no surface is between the two, both are inside or
/// neither is.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <utility>
#include <vector>

#include "environments/scene/parity.h"

namespace amble {

class ParityColumn {
 public:
  /// @param solids  not null; they outlive the column
  /// @param beside  how far along x and y from the vertical the shared ray may pass [m, >= 0]
  ParityColumn(const Eigen::Vector2d& at, double beside, std::vector<const Parity*> solids);

  /// Whether the point at height z [m] is inside any of the solids.
  /// @pre z is not below what was asked before, and no surface of theirs is at that height within
  /// `beside` of the vertical.
  bool isInside(double z);

 private:
  void castFrom(double z);

  Eigen::Vector2d at_;
  double reach_;  // of a ray, upwards [m]
  std::vector<const Parity*> solids_;
  struct Step {
    double height;
    int solid, change;
  };
  std::vector<Step> steps_;  // lowest first
  std::vector<int> depth_;   // of each solid, below the next step
  int inside_ = 0;           // solids whose depth is above 0
  size_t next_ = 0;          // step
  double last_ = -HUGE_VAL;  // height for which the ray serves [m]
  std::vector<Parity::Crossing> crossings_;
};

}  // namespace amble
