/// What a place offers to a body that is to pass it, measured: how wide a gap is, how high
/// something hangs, how high something lies.
///
/// It is felt with an upright post of 2 cm, to a tenth of a millimetre, at heights that matter to
/// who passes: to the sides from kLowest, since what is lower may be stepped over, to the
/// shoulders.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planner/plan_request.h"
#include "planner/steering/straight_walk.h"

namespace amble {

class PassageProbe {
 public:
  /// What is felt for is in the request's world.
  explicit PassageProbe(const PlanRequest& request);

  struct Side {
    double distance = 0.0;  ///< [m]
    int object = -1;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< of the post that touches it [m, World]
  };
  /// What is nearest to a place on the ground, all around.
  std::optional<Side> nearest(const Eigen::Vector3d& ground) const;

  /// Of a place where the way leads by a heading what is too narrow, too low or too high there, a
  /// little before it and behind it too: that is written into `why`, with what would do.
  /// @return whether there is something
  bool measure(const Eigen::Vector3d& ground, double heading, Obstruction& why) const;

  /// How high the thing over a place is, if it ends below the shoulders [m].
  std::optional<double> topOver(const Eigen::Vector3d& ground, int* object = nullptr) const;

 private:
  struct Gap {
    Side left, right;
    double width = 0.0;    // [m]
    double heading = 0.0;  // of who passes [rad]
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  };
  std::optional<Side> along(const Eigen::Vector3d& ground, double heading, double low) const;
  int touched(const Eigen::Vector3d& ground, double low, double high) const;
  std::optional<Gap> across(const Eigen::Vector3d& ground, double heading) const;
  std::optional<Gap> narrowest(const Eigen::Vector3d& ground, double heading) const;
  double depth(const Gap& gap) const;
  std::optional<double> headroom(const Eigen::Vector3d& ground, int& object) const;
  double neededFor(double depth) const;
  bool measureGap(const Gap& gap, Obstruction& why) const;
  std::vector<Eigen::Vector3d> placesAround(const Eigen::Vector3d& ground, double heading) const;
  bool measureAbove(const std::vector<Eigen::Vector3d>& places, Obstruction& why) const;
  std::string name(int object) const;

  const PlanRequest& request_;
  StraightWalk walk_;
  double stature_, highest_, breadth_ = 0.0;
  CollisionScratchPtr scratch_;
};

}  // namespace amble
