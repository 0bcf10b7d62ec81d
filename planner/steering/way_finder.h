/// Ways from one place to another over a map of the room that the body has (ClearanceMap): where a
/// search may look before it samples.
///
/// A way is the cheapest over the map, A* (Hart, Nilsson and Raphael 1968): its length, and more
/// where there is little room beside the body. Of it remain the places where a walker turns, and
/// stands for that: each sees the next along a straight line with room all along, is as roomy as
/// any near it, and level. Whether they are walked is for steering to say; where it says no the map
/// is told, and the next way leads elsewhere or with more room.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "environments/map/clearance_map.h"
#include "planner/steering/steering.h"

namespace amble {

class WayFinder : public WayGuide {
 public:
  /// Between two places of the map. @param shortest  edge that is walked [m, > 0]
  /// @param stopped  asked now and then: where it says so there are no ways
  WayFinder(
      std::shared_ptr<const ClearanceMap> map, const Eigen::Vector3d& from,
      const Eigen::Vector3d& to, double shortest,
      std::function<bool()> stopped = [] { return false; });

  std::optional<std::vector<Stance>> next() override;
  void avoid(const Eigen::Vector3d& at) override;
  std::optional<Narrow> narrowest() const override;

 private:
  std::vector<double> squaresTo(const Eigen::Vector3d& goal, int axis) const;
  std::vector<int> cheapest() const;
  std::vector<int> widest() const;
  double factor(int place) const;
  double tightest(int place) const;
  bool isNear(int place, int end) const;
  bool isClear(int from, int to, double least, float most) const;
  bool isLevel(int place) const;
  int farthestSeen(const std::vector<int>& way, int here) const;
  int standNear(const std::vector<int>& way, int here, int seen) const;
  std::vector<int> corners(const std::vector<int>& way) const;

  std::shared_ptr<const ClearanceMap> map_;
  int from_, to_;
  double shortest_;
  std::function<bool()> stopped_;
  std::vector<float> penalty_;  // by place: of what was refused near it, in lengths of the way
};

}  // namespace amble
