/// Captured turns on the spot of a library (Pettré §4.3), ready for a character: which is taken for
/// an angle, and how the body goes over it.
#pragma once

#include <span>
#include <vector>

#include "animation/library/motion_library.h"

namespace amble {

class CapturedTurns {
 public:
  CapturedTurns() = default;
  /// @param scale  of the character to the captured subject [> 0]
  CapturedTurns(const MotionLibrary& library, double scale);

  /// A turn that is made so many times, one after another, each by the same angle.
  struct Taken {
    int turn = -1;  ///< -1: none is near enough, it is turned by formula (SpotTurnGait)
    int times = 1;  ///< [>= 1]
  };
  /// The nearest by angle, the first foot and how often it has to be made (kOneMore, kOtherFoot).
  /// @param angle  [rad, left positive]
  Taken take(double angle) const;

  int size() const { return static_cast<int>(turns_.size()); }
  const TurnSequence& sequence(int turn) const { return turns_[turn].sequence; }  ///< scaled
  const Motion& motion(int turn) const { return *turns_[turn].motion; }  ///< of the library

  /// How much smaller or larger than captured a turn may be made [1].
  static constexpr double kLeast = 0.5, kMost = 1.5;
  /// What stopping once more, and a first foot that is not the inside one, with which ours begin,
  /// count as: logarithm of a ratio of angles; by choice [1].
  static constexpr double kOneMore = 0.2, kOtherFoot = 0.2;

 private:
  struct Turn {
    const Motion* motion;
    TurnSequence sequence;
  };
  std::vector<Turn> turns_;
};

}  // namespace amble
