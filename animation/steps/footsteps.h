/// Where the feet of a walk stand, and when: whole steps along a root path, from stance to stance.
///
/// Time is counted in steps, as by SpeedProfile. Placing i (i = 1..n) is that of the foot which
/// swings in the i-th step; placings -1 and 0 are where the feet are at the begin, -1 the one that
/// swings first. Placing i is planted from a little before node i to a little after node i + 1
/// (DoubleSupports).
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "animation/steps/foot_state.h"
#include "animation/steps/print_place.h"
#include "animation/steps/root_path.h"
#include "animation/steps/stance.h"
#include "animation/steps/start_and_stop.h"
#include "animation/steps/stride_law.h"

namespace amble {

/// How a character puts down its feet.
struct FootPlacement {
  double walk_width = 0.1;    ///< between left and right footprints while walking [m]
  double stand_width = 0.15;  ///< the same while standing [m]
  double forward = 0.0;       ///< middle of front and rear footprint before the path's point [m]
  /// So much farther forward are left prints while walking, and right ones back, than even steps
  /// would have them [m].
  double stagger = 0.0;
  double step_length = 0.65;  ///< of the straight walk at the plan's speed [m, > 0]
  std::array<double, 2> walk_toe_out = {0.0, 0.0};  ///< by Side, left positive [rad]
  /// While standing, of the left foot; the right's is its mirror image [rad].
  double stand_toe_out = 0.0;
  DoubleSupports supports = DoubleSupports::Constant(0.1);  ///< [steps]
  double slower = 0.0;                            ///< FootState::slower at a walking stance [m/s]
  std::array<EndSwing, 2> first = {}, last = {};  ///< of starts and of stops, by Side of the foot
  SwingKind swings = SwingKind::kWalk;            ///< all but those

  /// While walking straight on.
  PrintPlace print(Side side) const {
    const double sign = side == kLeft ? 1.0 : -1.0;
    return {sign * stagger, 0.5 * sign * walk_width, walk_toe_out[side]};
  }
};

/// A place and heading on the ground that feet are put beside.
struct GroundPoint {
  Eigen::Vector3d position;  ///< [m, World]
  double heading;            ///< [rad]
};

/// A point of the path, going on straight beyond its ends; at height z [m, World].
GroundPoint pathPoint(const RootPath& path, double arc, double z);

class Footsteps {
 public:
  /// Before and after a node [steps].
  using NodeSupport = std::array<double, 2>;

  Footsteps(const FootPlacement& placement, const Stance& from, const Stance& to, int steps,
            Side first);

  /// Placings between the first and the last stance, `print_at(i)` that of a point of the root path
  /// midway between nodes i and i + 1, moved on by `forward`.
  void place(const std::function<FootPlace(int)>& print_at);
  /// The feet of both stances, by Side, as they stand on their ground.
  void setStances(const std::array<FootPlace, 2>& from, const std::array<FootPlace, 2>& to);
  /// The double support around each node 0 to `steps`, a row of DoubleSupports; without it those of
  /// the placement. Where the walk begins or ends walking, the first two and the last two are those
  /// of the stances. @pre as many as nodes
  void setSupports(std::vector<NodeSupport> supports);
  /// All placings, to set heights: -1 first.
  std::vector<FootPlace>& places() { return places_; }
  const std::vector<FootPlace>& places() const { return places_; }
  /// How a placing is come to.
  struct Landing {
    SwingShape swing;
    double strike_roll = 1.0;  ///< FootState::strike_roll [-1, 1]
    /// FootState::turn_rate; 0 of the first and the last two: a stance is that of a straight walk.
    double turn_rate = 0.0;
    double slower = 0.0;  ///< FootState::slower; of stances' placings theirs [m/s, >= 0]
  };
  /// Of all placings, -1 first; nothing swings to placings -1 and 0.
  std::vector<Landing>& landings() { return landings_; }
  const std::vector<Landing>& landings() const { return landings_; }

  int steps() const { return steps_; }
  Side side(int placing) const;  ///< of placing -1, 0, 1, ... n
  /// Both feet at a progress [0, steps]; exact at 0 and at `steps`, where the stances rule.
  std::array<FootState, 2> at(double progress) const;
  /// Both feet in a stance.
  static std::array<FootState, 2> atStance(const FootPlacement& placement, const Stance& stance);

 private:
  const FootPlace& place(int placing) const { return places_[placing + 1]; }
  const NodeSupport& support(int node) const;
  double strikeOf(int placing) const;
  double liftOffOf(int placing) const;
  void setTimes();
  double strike(int placing) const { return strikes_[placing + 1]; }
  double liftOff(int placing) const { return lift_offs_[placing + 1]; }
  void follow(int placing, FootState& foot) const;
  void setState(int placing, double progress, FootState& foot) const;
  const EndSwing& firstSwing() const { return placement_.first[first_]; }
  const EndSwing& lastSwing() const { return placement_.last[side(steps_)]; }

  FootPlacement placement_;
  Stance from_, to_;
  int steps_;
  Side first_;
  std::vector<FootPlace> places_;
  std::vector<Landing> landings_;
  std::vector<NodeSupport> supports_;        // by node
  std::vector<double> strikes_, lift_offs_;  // of all placings, -1 first [steps]
};

/// Of the node at which this foot is in front.
inline Footsteps::NodeSupport nodeSupport(const DoubleSupports& supports, Side front) {
  return {supports(front, 0), supports(front, 1)};
}

/// Where a foot stands beside a point.
FootPlace footBeside(const GroundPoint& point, const PrintPlace& print);

}  // namespace amble
