/// Which frame of one clip goes with which of another, told by foot plants (Shanbhag's thesis,
/// §5.3).
///
/// The thesis takes successive foot plants of both clips in turn and maps the frames between them
/// linearly; plants may be matched in several ways, its alternate correlations (figure 5.5). Here
/// the moments that are matched are the changes from foot to foot (gait_phase.h), which walks and
/// runs have alike: the middle of a double support, or of a flight; of jumps each take-off and
/// landing. Alternatives are a step apart, also those where left meets right; how well the legs
/// agree ranks them. Between moments time is a rising cubic, not the thesis' line: by a line the
/// arm's speed jumps at each plant. A stand has no plants to match: its time just goes on.
#pragma once

#include <vector>

#include "animation/grafting/locomotive_clip.h"
#include "base/cubic_spline.h"

namespace amble {

/// Moments that go together [frames, between frames]; both rise.
struct MatchedMoment {
  double base = 0.0;
  double upper = 0.0;
};

struct Correlation {
  std::vector<MatchedMoment> moments;  ///< in order [>= 2]
  int shift = 0;                       ///< base's n-th moment goes with upper's n + shift
  bool same_foot = true;               ///< left goes with left
  /// Rms over frames of the distance between both clips' ankles, each seen from the middle of the
  /// hips and the pelvis' heading [leg lengths, >= 0].
  double mismatch = 0.0;
  int first = 0, last = -1;  ///< frames of base that may be grafted, both included

  int frames() const { return last - first + 1; }
};

/// What is to be correlated: frames of one type in each clip, both included.
struct CorrelationWindows {
  MotionStretch base;
  MotionStretch upper;
};

/// Best first: those whose legs agree (within kAgreeing of the best), of them the one that most
/// frames may be grafted by, of equals the one with the least mismatch. None where fewer than two
/// moments can be matched.
/// @pre graftRefusal(windows.upper.type, windows.base.type) is ""
std::vector<Correlation> correlate(const LocomotiveClip& base, const LocomotiveClip& upper,
                                   const CorrelationWindows& windows);

/// Legs agree as well as the best when their mismatch is at most so many times its; by trial: half
/// a cycle aside it is three times and more [1].
inline constexpr double kAgreeing = 1.6;

/// Frame of upper at a frame of base.
class TimeWarp {
 public:
  explicit TimeWarp(const Correlation& correlation);
  double at(double base_frame) const { return curve_.at(base_frame); }

 private:
  CubicSpline curve_;
};

}  // namespace amble
