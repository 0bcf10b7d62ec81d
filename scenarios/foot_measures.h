/// What feet do on the ground: where each stood, how far it drifted there, how deep it sank.
///
/// A foot rolls over two centres: the heel's while only the heel touches, the ball's once the heel
/// has risen, both while the sole is flat. They are the ends of the sole's capsule on the ankle's
/// joint, so that a centre rests while its end of the foot is planted. A slide is what it does
/// instead: the largest horizontal distance of a centre that touches the ground from the median of
/// its places while it did (QUALITY.md, drift per plant).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "animation/body/step_prints.h"
#include "animation/ground/ground.h"
#include "animation/synthesis/animation_buffer.h"
#include "environments/body/body.h"

namespace amble {

/// A centre touches the ground when the sole's underside below it is no higher [m]. The foot's
/// pitch is then a degree at most, which moves a centre that does not roll by 0.02 mm: less than
/// what is measured.
inline constexpr double kTouchHeight = 0.003;

/// Where the soles of a motion are, frame by frame.
class SoleTracks {
 public:
  /// @pre body's joints are the skeleton's.
  SoleTracks(const Skeleton& skeleton, const Body& body, const PoseArray& poses,
             const Ground& ground);

  int frames() const { return frames_; }
  /// The lowest underside of any of the foot's sole parts over the ground below it; +infinity where
  /// there is no ground [m].
  double height(Side side, int frame) const { return lowest_[side][frame]; }
  /// Undersides of the sole's two ends [m, World].
  SoleEnds ends(Side side, int frame) const;
  /// The frame of [first, last] in which heel and ball are lowest over the ground: the sole is
  /// flat.
  int flattest(Side side, int first, int last) const;
  /// Largest drift of the foot's centres that touch in frames [first, last] [m]; 0 where none does.
  double slide(Side side, int first, int last) const;
  /// Largest depth of any sole below the ground, over all frames [m, >= 0].
  double penetration() const;

 private:
  struct Centre {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();  // its underside
    double height = 0.0;                           // of that over the ground
  };
  int frames_ = 0;
  std::array<std::vector<double>, 2> lowest_;   // [side][frame]
  std::array<std::vector<Centre>, 2> centres_;  // [side][2 * frame + {heel, ball}]
};

/// The placings of a walk of ours, in order: strike, lift-off and slide of all, the step to it of
/// those that the walk swings to.
std::vector<StepMeasure> measureSteps(const AnimationBuffer& walk, const SoleTracks& soles);

}  // namespace amble
