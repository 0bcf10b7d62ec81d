/// Locomotive motion grafting (Shanbhag's thesis, chapter 5): chains of one clip on the body of
/// another, in step with it.
///
/// Root and legs are the base's to the bit. The grafted joints are the upper clip's (§5.4: the
/// base's signal is masked out), at the frame that goes with each of the base's
/// (plant_correlation.h), and at both ends of the range pass over from the base's own and back, on
/// the shorter way by minimum jerk (the thesis: "blending for the transition interval").
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "animation/grafting/plant_correlation.h"

namespace amble {

struct GraftWishes {
  std::vector<std::string> chains = {"left_arm", "right_arm"};  ///< graftableChains()
  /// Frames of base to graft on, both included; none: its longest stretch of one type.
  std::optional<std::pair<int, int>> range = {};
  /// Frames of upper to graft, both included; none: its longest stretch of one type.
  std::optional<std::pair<int, int>> action = {};
  int alternative = 0;  ///< of GraftPlan::alternatives [>= 0]
  /// Time of each passage [s, >= 0]; none: so long that no grafted joint turns faster or
  /// accelerates more than somewhere in its sources, within kShortestEase and kLongestEase.
  std::optional<double> ease = {};
};

inline constexpr double kShortestEase = 0.2;  ///< people do not turn an arm sooner; by trial [s]
inline constexpr double kLongestEase = 1.2;   ///< longer is a movement of its own [s]

/// What will be grafted where, before anything is made.
struct GraftPlan {
  CorrelationWindows windows;
  std::vector<int> joints;                ///< of base, ascending
  std::vector<Correlation> alternatives;  ///< best first; none where `refusal` says why
  std::string refusal;                    ///< in one line, with the rule; "" for none
};

/// @throws InputError for a chain or frames that a clip does not have, and an alternative that
/// there is not
GraftPlan planGraft(const LocomotiveClip& base, const LocomotiveClip& upper,
                    const GraftWishes& wishes);

struct Graft {
  Clip clip;                        ///< as long as base
  std::vector<int> joints;          ///< that were grafted: those of the plan that follow something
  std::vector<std::string> kept;    ///< joints of the chains that upper has not: base's own
  int first = 0, last = -1;         ///< frames of base that hold something of upper
  double ease_in = 0.0;             ///< [s, >= 0]; 0 where base's motion begins
  double ease_out = 0.0;            ///< the same, where it ends
  std::vector<double> upper_frame;  ///< of upper, by frame from `first` to `last`
  /// Largest angular acceleration of a grafted joint, at base's frames [rad/s^2].
  double acceleration = 0.0;         ///< of the result
  double source_acceleration = 0.0;  ///< of base and of upper, as its turns are taken over
};

/// @pre plan.refusal is ""
Graft makeGraft(const LocomotiveClip& base, const LocomotiveClip& upper, const GraftPlan& plan,
                const GraftWishes& wishes);

/// Graft::acceleration of its clip as it is now.
double accelerationOf(const Graft& graft, const LocomotiveClip& base);

/// How fast a joint turns in its parent, and how much that changes.
struct JointPeak {
  double speed = 0.0;         ///< [rad/s, >= 0]
  double acceleration = 0.0;  ///< [rad/s^2, >= 0]
};
/// The largest of each of these joints about the frames between `first` and `last`, these two
/// aside; one a joint.
std::vector<JointPeak> jointPeaks(const PoseArray& poses, double frame_time,
                                  const std::vector<int>& joints, int first, int last);
/// The largest acceleration of all of them [rad/s^2, >= 0].
double largestAcceleration(const std::vector<JointPeak>& peaks);

}  // namespace amble
